package carom.client.desktop.hud;

import carom.client.desktop.paint.Canvas;
import carom.client.desktop.paint.Fonts;
import carom.client.desktop.paint.UiColours;
import carom.client.desktop.paint.ViewCamera;
import carom.client.view.ClientView;
import carom.client.view.ClientView.Drawn;
import carom.sim.entity.HostEntity;
import carom.sim.level.Appearance;
import carom.sim.level.Level;
import com.badlogic.gdx.graphics.Color;
import com.badlogic.gdx.math.Vector3;
import java.util.List;

/**
 * Arrows to balls and goals that are outside of the picture, with the distance, on an ellipse
 * around its middle. Render thread only.
 */
public final class Pointers {
  private static final float ELLIPSE = 0.33f;
  private static final float LENGTH = 16;

  private final Hud hud;
  private final Canvas canvas;
  private final Fonts fonts;
  private final ShownGame game;
  private final Color color = new Color();
  private final float[] corners = new float[6];

  /** Creates arrows. The arguments stay the property of the caller. */
  public Pointers(Hud hud, Canvas canvas, Fonts fonts, ShownGame game) {
    this.hud = hud;
    this.canvas = canvas;
    this.fonts = fonts;
    this.game = game;
  }

  /** Draws the arrows of what the picture doesn't show. */
  public void draw(ClientView view, ViewCamera camera) {
    for (int i = 0; i < view.entityCount(); i++) {
      Drawn ball = view.entity(i);
      Appearance look = ball.archetype().appearance();
      if (look.look() == Appearance.Look.BALL && ball.ownerId() == HostEntity.NO_OWNER) {
        point(camera, ball.x(), ball.y(), "", UiColours.shade(look.rgb(), 1, 1, color));
      }
    }
    List<Level.Zone> zones = view.level().zones();
    for (int i = 0; i < zones.size(); i++) {
      Level.Zone zone = zones.get(i);
      if (zone.name().equals("goal") && zone.team() >= 1 && zone.team() <= game.teamCount()) {
        float x = (zone.minX() + zone.maxX()) / 2;
        float y = (zone.minY() + zone.maxY()) / 2;
        color.set(game.teamColor(zone.team()));
        point(camera, x, y, game.team(zone.team()) + " goal  ", color);
      }
    }
  }

  private void point(ViewCamera camera, float x, float y, String what, Color tint) {
    Vector3 at = hud.at(camera, x, y);
    float middleX = hud.windowWidth() / 2;
    float middleY = hud.height() / 2;
    float dx = at.x - middleX;
    float dy = at.y - middleY;
    if (Math.abs(dx) < middleX && Math.abs(dy) < middleY) {
      return; // it is seen
    }
    float length = (float) Math.sqrt(dx * dx + dy * dy);
    float wayX = dx / length;
    float wayY = dy / length;
    float tipX = middleX + ELLIPSE * hud.windowWidth() * wayX;
    float tipY = middleY + ELLIPSE * hud.height() * wayY;
    corners[0] = tipX;
    corners[1] = tipY;
    corners[2] = tipX - LENGTH * wayX - LENGTH / 2 * wayY;
    corners[3] = tipY - LENGTH * wayY + LENGTH / 2 * wayX;
    corners[4] = tipX - LENGTH * wayX + LENGTH / 2 * wayY;
    corners[5] = tipY - LENGTH * wayY - LENGTH / 2 * wayX;
    hud.beginFigures();
    canvas.convex(corners, 3, tint);
    canvas.end();
    float metresX = x - camera.gdx().position.x;
    float metresY = y - camera.gdx().position.y;
    long metres = Math.round(Math.sqrt(metresX * metresX + metresY * metresY));
    hud.begin();
    float textY = tipY + (wayY > 0.3f ? -LENGTH - 4 : LENGTH + 12); // beside the arrow
    hud.centred(fonts.small(), what + metres + " m", tipX - LENGTH * wayX, textY, tint);
    hud.end();
  }
}
