package carom.client.desktop.paint;

import carom.game.Games;
import carom.physics.Body;
import carom.physics.geometry.Shape;
import carom.physics.particles.Particles;
import carom.sim.Game;
import carom.sim.Role;
import carom.sim.SimulationHost;
import carom.sim.entity.HostEntity;
import carom.sim.level.Appearance;
import carom.sim.level.Area;
import carom.sim.level.Level;
import carom.sim.pool.Pool;
import carom.sim.pool.Pools;
import com.badlogic.gdx.graphics.Color;
import com.badlogic.gdx.graphics.Pixmap;
import com.badlogic.gdx.graphics.Texture.TextureFilter;
import com.badlogic.gdx.graphics.g2d.TextureRegion;
import com.badlogic.gdx.graphics.glutils.FrameBuffer;
import com.badlogic.gdx.utils.Disposable;
import java.util.HashMap;
import java.util.Map;

/**
 * Small pictures of levels as they begin, for people who choose one. Each is drawn once, from the
 * level alone. Render thread only, outside of other figures and texts.
 */
public final class LevelPictures implements Disposable {
  private static final int WIDTH = 480;
  private static final int HEIGHT = 270;
  private static final float EDGE_PX = 1.5f;

  /** A picture, and the same the right way up. */
  private static final class Picture {
    final FrameBuffer buffer;
    final TextureRegion region;

    Picture(FrameBuffer buffer) {
      this.buffer = buffer;
      region = new TextureRegion(buffer.getColorBufferTexture());
      region.flip(false, true);
    }
  }

  private final Canvas canvas;
  private final ShapePainter shapes;
  private final ViewCamera camera = new ViewCamera();
  private final Map<Long, Picture> drawn = new HashMap<>();
  private final Color fill = new Color();
  private final Color edge = new Color();

  /** Creates pictures of no level yet. The canvas stays the property of the caller. */
  public LevelPictures(Canvas canvas) {
    this.canvas = canvas;
    shapes = new ShapePainter(canvas);
  }

  /** Returns whether a level's picture is drawn already. */
  public boolean has(Level level) {
    return drawn.containsKey(level.contentHash());
  }

  /**
   * Returns the picture of a level, 16:9, which the first call draws in some milliseconds. If the
   * level's game is missing here or refuses it, only the level's ground shows.
   */
  public TextureRegion of(Level level) {
    return drawn.computeIfAbsent(level.contentHash(), hash -> new Picture(draw(level))).region;
  }

  private FrameBuffer draw(Level level) {
    FrameBuffer picture = new FrameBuffer(Pixmap.Format.RGBA8888, WIDTH, HEIGHT, false);
    picture.getColorBufferTexture().setFilter(TextureFilter.Linear, TextureFilter.Linear);
    Level.Bounds b = level.bounds();
    float width = b.maxX() - b.minX();
    float height = b.maxY() - b.minY();
    camera.fit((b.minX() + b.maxX()) / 2, (b.minY() + b.maxY()) / 2, width, height, WIDTH, HEIGHT);
    float pixelsPerMetre = camera.pixelsPerMetre(HEIGHT);
    picture.begin();
    canvas.begin(camera.gdx().combined, pixelsPerMetre);
    ground(level);
    try {
      Game game = Games.create(level.gameName());
      SimulationHost begun = new SimulationHost(game, level, 0, 60, Role.AUTHORITY);
      begun.world().forEachBody(body -> body(body, EDGE_PX / pixelsPerMetre));
      pools(begun.pools());
    } catch (RuntimeException | LinkageError | AssertionError | StackOverflowError refused) {
      // Its ground is better than nothing: the player may choose it all the same.
    }
    canvas.end();
    picture.end();
    return picture;
  }

  private void ground(Level level) {
    float w = camera.gdx().viewportWidth;
    float h = camera.gdx().viewportHeight;
    canvas.gradient(
        camera.gdx().position.x - w / 2,
        camera.gdx().position.y - h / 2,
        w,
        h,
        UiColours.shade(level.theme().background(), 1, 1, fill),
        UiColours.shade(level.theme().sky(), 1, 1, edge));
    for (Level.Zone zone : level.zones()) {
      if (zone.rgb() >= 0) {
        UiColours.shade(zone.rgb(), 1, 0.35f, fill);
        rect(zone.minX(), zone.minY(), zone.maxX(), zone.maxY());
      }
    }
    for (Area area : level.areas()) {
      UiColours.shade(area.rgb(), 1, 0.3f, fill);
      rect(area.minX(), area.minY(), area.maxX(), area.maxY());
    }
  }

  private void rect(float minX, float minY, float maxX, float maxY) {
    canvas.rect(minX, minY, maxX - minX, maxY - minY, fill);
  }

  private void body(Body<HostEntity> body, float edgeWidth) {
    Appearance look = body.user().archetype().appearance();
    float alpha = body.user().archetype().sensor() ? 0.5f : 1;
    shapes.pose(body.x(), body.y(), body.cos(), body.sin());
    UiColours.shade(look.rgb(), 1, alpha, fill);
    UiColours.shade(look.outlineRgb(), 1, alpha, edge);
    for (Shape shape : body.user().archetype().shapes()) {
      shapes.paint(shape, fill, edgeWidth, edge);
    }
  }

  private void pools(Pools pools) {
    for (int i = 0; i < pools.count(); i++) {
      Pool pool = pools.get(i);
      Particles all = pool.particles();
      float size = 1.6f * all.spacing();
      UiColours.shade(pool.def().rgb(), 1, 1, fill);
      for (int k = 0; k < all.count(); k++) {
        canvas.rect(all.x(k) - size / 2, all.y(k) - size / 2, size, size, fill);
      }
    }
  }

  @Override
  public void dispose() {
    drawn.values().forEach(picture -> picture.buffer.dispose());
  }
}
