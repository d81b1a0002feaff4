package carom.client.desktop.game;

import carom.client.desktop.hud.Hud;
import carom.client.desktop.hud.HudLayout.Panel;
import carom.client.desktop.hud.PlayerColours;
import carom.client.desktop.paint.Canvas;
import carom.client.desktop.paint.UiColours;
import carom.client.look.HudItem.Place;
import carom.client.view.ClientView;
import carom.client.view.ClientView.Drawn;
import carom.physics.geometry.Convex;
import carom.sim.level.Appearance;
import carom.sim.level.Archetype;
import carom.sim.level.Level;
import com.badlogic.gdx.graphics.Color;
import com.badlogic.gdx.math.MathUtils;
import java.util.List;

/** Draws the whole level with its players, and what the look marks, small. Render thread only. */
final class Minimap {
  private static final float LONGEST = 190;
  private static final float SHORTEST = 50;
  private static final float PAD = 6;
  private static final float DOT = 3;
  private static final float MARK = 4;
  private static final int MAX_CORNERS = 64;

  private final ShownLook look;
  private final Hud hud;
  private final PlayerColours colours;
  private final Canvas canvas;
  private final Panel[] panels = new Panel[Place.values().length];
  private final float[] corners = new float[2 * MAX_CORNERS];
  private final Color color = new Color();

  Minimap(ShownLook look, Hud hud, Canvas canvas, PlayerColours colours) {
    this.look = look;
    this.colours = colours;
    this.hud = hud;
    this.canvas = canvas;
    for (Place place : Place.values()) {
      panels[place.ordinal()] = new Panel(LookHud.spots(place));
    }
  }

  /** Draws it with the pieces of the level. */
  public void draw(ClientView view, List<Scenery> scenery) {
    Place place = look.setup().minimap();
    if (place == null) {
      return;
    }
    Level.Bounds bounds = view.level().bounds();
    float width = bounds.maxX() - bounds.minX();
    float height = bounds.maxY() - bounds.minY();
    float scale = LONGEST / Math.max(width, height);
    float w = Math.max(SHORTEST, width * scale) + 2 * PAD;
    float h = Math.max(SHORTEST, height * scale) + 2 * PAD;
    Panel panel = panels[place.ordinal()];
    if (!hud.layout().placeAnyhow(panel, w, h)) {
      return;
    }
    hud.panel(panel.x(), panel.y(), w, h);
    float x = panel.x() + w / 2 - scale * (bounds.minX() + bounds.maxX()) / 2;
    float y = panel.y() + h / 2 - scale * (bounds.minY() + bounds.maxY()) / 2;
    hud.beginFigures();
    for (int i = 0; i < scenery.size(); i++) {
      if (!scenery.get(i).archetype().sensor()) {
        piece(scenery.get(i), x, y, scale, bounds);
      }
    }
    for (int i = 0; i < view.entityCount(); i++) {
      Drawn body = view.entity(i);
      float dotX = x + scale * MathUtils.clamp(body.x(), bounds.minX(), bounds.maxX());
      float dotY = y + scale * MathUtils.clamp(body.y(), bounds.minY(), bounds.maxY());
      if (look.setup().marks().contains(body.archetype().name())) {
        mark(dotX, dotY, body.archetype().appearance().rgb());
      } else if (body == view.own()
          || body.archetype().appearance().look() == Appearance.Look.PLAYER) {
        if (body == view.own()) {
          canvas.disc(dotX, dotY, DOT + 1.5f, UiColours.TEXT);
        }
        int chosen = colours.rgb(body.ownerId());
        int rgb = chosen < 0 ? body.archetype().appearance().rgb() : chosen;
        canvas.disc(dotX, dotY, DOT, UiColours.shade(rgb, 1, 1, color));
      }
    }
    canvas.end();
  }

  /** Draws a square on its corner, which is no player's dot. */
  private void mark(float x, float y, int rgb) {
    diamond(x, y, MARK + 1.5f, UiColours.TEXT);
    diamond(x, y, MARK, UiColours.shade(rgb, 1, 1, color));
  }

  private void diamond(float x, float y, float r, Color filled) {
    corners[0] = x - r;
    corners[1] = y;
    corners[2] = x;
    corners[3] = y - r;
    corners[4] = x + r;
    corners[5] = y;
    corners[6] = x;
    corners[7] = y + r;
    canvas.convex(corners, 4, filled);
  }

  private void piece(Scenery piece, float x, float y, float scale, Level.Bounds bounds) {
    Archetype kind = piece.archetype();
    UiColours.shade(kind.appearance().rgb(), 1, 1, color);
    for (int s = 0; s < kind.shapes().size(); s++) {
      for (Convex part : kind.shapes().get(s).parts()) {
        int count = Math.min(MAX_CORNERS, part.vertexCount());
        for (int i = 0; i < count; i++) {
          float px = piece.x() + piece.cos() * part.vertexX(i) - piece.sin() * part.vertexY(i);
          float py = piece.y() + piece.sin() * part.vertexX(i) + piece.cos() * part.vertexY(i);
          corners[2 * i] = x + scale * MathUtils.clamp(px, bounds.minX(), bounds.maxX());
          corners[2 * i + 1] = y + scale * MathUtils.clamp(py, bounds.minY(), bounds.maxY());
        }
        if (count > 2) {
          canvas.convex(corners, count, color);
        } else if (count == 2) {
          canvas.line(corners[0], corners[1], corners[2], corners[3], 1.5f, color);
        } else {
          canvas.disc(corners[0], corners[1], scale * part.radius(), color);
        }
      }
    }
  }
}
