package carom.client.desktop.game;

import carom.client.desktop.paint.Canvas;
import carom.client.desktop.paint.UiColours;
import carom.client.view.ClientView;
import carom.client.view.ClientView.Drawn;
import carom.physics.BodyType;
import carom.physics.particles.ParticleDef;
import carom.sim.level.Archetype;
import carom.sim.level.Area;
import carom.sim.pool.Pool;
import carom.sim.pool.PoolDef;
import com.badlogic.gdx.graphics.Color;
import com.badlogic.gdx.math.MathUtils;
import com.badlogic.gdx.math.Vector2;

/**
 * Spray where bodies hit water, in pools and in areas of the level. It belongs to the picture
 * alone: it begins with the frame that shows the hit, while a pool's particles are stirred 0.4 s
 * later, and nothing is sent for it. Render thread only; no allocation per frame in steady state.
 */
final class Splashes {
  /** Says where water is. */
  @FunctionalInterface
  interface WaterMap {
    /** Returns the colour of the water at a point, 0xRRGGBB, or {@link #NONE}. */
    int rgbAt(float x, float y);
  }

  /** Answer where there is no water. */
  static final int NONE = -1;

  /** Least speed of a hit that shows, m/s. */
  private static final float LEAST_M_S = 3;

  /** Fullness of a pool from which it counts as water. */
  private static final float FULL = 0.5f;

  private static final float QUIET_SECONDS = 0.35f; // between two hits of one body
  private static final float DROP_SECONDS = 1.1f;
  private static final float LEAST_DROP_SECONDS = 0.2f; // before water takes a drop back
  private static final int DROPS = 400;
  private static final int MOST_OF_A_HIT = 48;

  private final Specks drops = new Specks(DROPS, DROP_SECONDS);

  /** An entity that knows whether its front was in water a frame ago. */
  private static final class Front extends SeenEntities.Seen {
    boolean wet;
  }

  private final SeenEntities<Front> entities = new SeenEntities<>(Front::new);

  private final Color color = new Color();
  private final WaterMap ofView = this::waterOfView;
  private ClientView seen;
  private float upX;
  private float upY;
  private double now;

  /** Forgets everything, for another level. */
  void clear() {
    entities.clear();
    drops.clear();
  }

  /** Lets time pass and detects hits; call it once per frame. */
  void update(ClientView view, float seconds) {
    seen = view;
    age(ofView, view.level().gravityX(), view.level().gravityY(), seconds);
    for (int i = 0; i < view.entityCount() && hasWater(view); i++) {
      Drawn d = view.entity(i);
      Archetype kind = d.archetype();
      if (!kind.sensor() && kind.type() != BodyType.STATIC) {
        float extent = WorldPainter.extent(kind);
        watch(ofView, d.id(), d.generation(), extent, d.x(), d.y(), d.velocityX(), d.velocityY());
      }
    }
    seen = null;
  }

  private static boolean hasWater(ClientView view) {
    return (view.pools() != null && view.pools().count() > 0) || !view.level().areas().isEmpty();
  }

  private int waterOfView(float x, float y) {
    for (int i = 0; seen.pools() != null && i < seen.pools().count(); i++) {
      Pool pool = seen.pools().get(i);
      if (pool.def().kind() == ParticleDef.Kind.WATER
          && isIn(pool.def().box(), x, y)
          && pool.fullness(x, y) > FULL) {
        return pool.def().rgb();
      }
    }
    for (int i = 0; i < seen.level().areas().size(); i++) {
      Area area = seen.level().areas().get(i);
      if (area.kind() == Area.Kind.WATER
          && x > area.minX()
          && x < area.maxX()
          && y > area.minY()
          && y < area.maxY()) {
        return area.rgb();
      }
    }
    return NONE;
  }

  private static boolean isIn(PoolDef.Rectangle box, float x, float y) {
    return x >= box.minX() && x <= box.maxX() && y >= box.minY() && y <= box.maxY();
  }

  /** Begins a frame: moves the drops. Those that fall back into water are gone. */
  void age(WaterMap water, float gravityX, float gravityY, float seconds) {
    now += seconds;
    entities.nextFrame();
    float gravity = Vector2.len(gravityX, gravityY);
    upX = gravity == 0 ? 0 : -gravityX / gravity;
    upY = gravity == 0 ? 0 : -gravityY / gravity;
    drops.fly(gravityX, gravityY, seconds);
    for (int i = 0; i < DROPS; i++) {
      if (drops.lives(i)
          && drops.seconds(i) > LEAST_DROP_SECONDS
          && drops.velocityX(i) * upX + drops.velocityY(i) * upY < 0
          && water.rgbAt(drops.x(i), drops.y(i)) != NONE) {
        drops.end(i);
      }
    }
  }

  /**
   * Compares whether an entity's front is in water with the last frame.
   *
   * @param id its id in the view
   * @param instance tells it from an earlier entity with the same id
   * @param extent radius of its shapes, metres
   * @param x position, metres
   * @param y position, metres
   * @param vx velocity, m/s
   * @param vy velocity, m/s
   */
  void watch(
      WaterMap water, int id, int instance, float extent, float x, float y, float vx, float vy) {
    float speed = Vector2.len(vx, vy);
    float ahead = speed == 0 ? 0 : 0.7f * extent / speed;
    int rgb = water.rgbAt(x + vx * ahead, y + vy * ahead);
    Front front = entities.see(id, instance);
    boolean entered = !front.isNew() && rgb != NONE && !front.wet;
    if (entered && speed > LEAST_M_S && !front.isQuiet(now)) {
      front.quieten(now + QUIET_SECONDS);
      splash(x + vx * ahead, y + vy * ahead, vx, vy, speed, extent, rgb);
    }
    front.wet = rgb != NONE;
  }

  /** Throws drops up, wider than the body, most of them low. */
  private void splash(float x, float y, float vx, float vy, float speed, float extent, int rgb) {
    int count = Math.min(MOST_OF_A_HIT, 6 + Math.round(4 * extent * speed));
    float along = -upY * vx + upX * vy; // along the surface
    for (int i = 0; i < count; i++) {
      float aside = MathUtils.random(-1f, 1f);
      float out = aside * 0.55f * speed + 0.3f * along;
      float rise = (1.1f - Math.abs(aside)) * MathUtils.random(0.25f, 0.95f) * speed;
      drops.add(
          x - upY * aside * extent,
          y + upX * aside * extent,
          upX * rise - upY * out,
          upY * rise + upX * out,
          MathUtils.random(0.05f, 0.13f),
          MathUtils.random(0, 0.3f),
          rgb);
    }
  }

  /** Returns how many drops show. */
  int showing() {
    return drops.living();
  }

  /** Draws the drops. */
  void draw(Canvas canvas) {
    for (int i = 0; i < DROPS; i++) {
      float left = drops.left(i);
      if (left > 0) {
        UiColours.shade(drops.rgb(i), 1, Math.min(1, 2.5f * left), color);
        color.lerp(1, 1, 1, color.a, 0.55f);
        canvas.disc(drops.x(i), drops.y(i), drops.size(i) * (0.4f + 0.6f * left), color);
      }
    }
  }
}
