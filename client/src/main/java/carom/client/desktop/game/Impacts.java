package carom.client.desktop.game;

import carom.client.desktop.paint.Canvas;
import carom.client.desktop.paint.UiColours;
import carom.client.view.ClientView;
import carom.client.view.ClientView.Drawn;
import carom.sim.level.Appearance.Look;
import carom.sim.level.Archetype;
import com.badlogic.gdx.graphics.Color;
import com.badlogic.gdx.math.MathUtils;
import com.badlogic.gdx.math.Vector2;
import java.util.Arrays;

/**
 * Visual effects of hits: a ring and sparks where a body was struck, sized by the blow, and a glow
 * of the scenery there.
 *
 * <p>A blow is a velocity that changes faster than steering and gravity can change it. Blows are
 * detected in the picture. So own hits show when they are predicted, others when they are drawn,
 * and nothing is sent for them. Render thread only; no allocation per frame in steady state.
 */
final class Impacts {
  /** Least acceleration of a blow, m/s^2: more than gravity, damping and flow cause. */
  private static final float PUSHED_M_S2 = 60;

  /** Least acceleration of a blow to a player's body, m/s^2: more than steering causes. */
  private static final float STEERED_M_S2 = 260;

  /** Least blow that shows, m/s. */
  private static final float LEAST_M_S = 3.5f;

  /** Least loss of speed of a player's body in a blow that shows, m/s. */
  private static final float LEAST_LOSS_M_S = 5;

  /** Blow that is drawn in full size, m/s. */
  private static final float HARD_M_S = 24;

  /**
   * Shortest time in which velocities are compared: a fast screen draws several frames per tick.
   */
  private static final float SHORTEST_FRAME_SECONDS = 1 / 60f;

  private static final float QUIET_SECONDS = 0.12f; // between two blows to one body
  private static final float RING_SECONDS = 0.35f;
  private static final float SPARK_SECONDS = 0.45f;
  private static final float SPARK_METRES = 0.08f; // width of a new one
  private static final float GLOW_M = 0.35f;
  private static final int BLOWS = 32;
  private static final int NO_SPARKS = -1;
  private static final int SPARKS = 256;

  /** The velocity of an entity a frame ago, and before the blow that goes on, m/s. */
  private static final class Flight extends SeenEntities.Seen {
    float lastX;
    float lastY;
    float fromX;
    float fromY;
    boolean struck;
  }

  private final SeenEntities<Flight> entities = new SeenEntities<>(Flight::new);

  private final float[] blowX = new float[BLOWS];
  private final float[] blowY = new float[BLOWS];
  private final float[] blowSize = new float[BLOWS];
  private final float[] blowAge = new float[BLOWS];
  private int nextBlow;

  private final Specks sparks = new Specks(SPARKS, SPARK_SECONDS);

  private final Color color = new Color();
  private final BlowListener listener;
  private double now;

  /** Creates effects; the listener hears of each blow that shows. */
  Impacts(BlowListener listener) {
    this.listener = listener;
    Arrays.fill(blowAge, RING_SECONDS);
  }

  /** Forgets everything, for another level. */
  void clear() {
    entities.clear();
    Arrays.fill(blowAge, RING_SECONDS);
    sparks.clear();
  }

  /** Lets time pass and detects blows; call it once per frame. */
  void update(ClientView view, float seconds) {
    age(view.level().gravityX(), view.level().gravityY(), seconds);
    for (int i = 0; i < view.entityCount(); i++) {
      Drawn d = view.entity(i);
      watch(
          d.id(),
          d.generation(),
          d.archetype(),
          d.x(),
          d.y(),
          d.velocityX(),
          d.velocityY(),
          seconds);
    }
  }

  /** Begins a frame: moves and fades what shows. */
  void age(float gravityX, float gravityY, float seconds) {
    now += seconds;
    entities.nextFrame();
    for (int i = 0; i < BLOWS; i++) {
      blowAge[i] = Math.min(RING_SECONDS, blowAge[i] + seconds);
    }
    sparks.fly(gravityX, gravityY, seconds);
  }

  /**
   * Compares the velocity of an entity with the last frame's.
   *
   * @param id its id in the view
   * @param instance tells it from an earlier entity with the same id
   * @param kind its shapes and colour; the look tells whether a player steers it
   * @param x position, metres
   * @param y position, metres
   * @param vx velocity, m/s
   * @param vy velocity, m/s
   * @param seconds since the last frame
   */
  void watch(
      int id, int instance, Archetype kind, float x, float y, float vx, float vy, float seconds) {
    Flight flight = entities.see(id, instance);
    if (flight.isNew()) {
      flight.struck = false;
    } else {
      boolean steered = kind.appearance().look() == Look.PLAYER;
      float limit =
          (steered ? STEERED_M_S2 : PUSHED_M_S2) * Math.max(seconds, SHORTEST_FRAME_SECONDS);
      if (Vector2.dst2(vx, vy, flight.lastX, flight.lastY) > limit * limit) {
        if (!flight.struck) {
          flight.struck = true;
          flight.fromX = flight.lastX;
          flight.fromY = flight.lastY;
        }
      } else if (flight.struck) {
        flight.struck = false;
        show(id, flight, kind, x, y, steered);
      }
    }
    flight.lastX = vx;
    flight.lastY = vy;
  }

  /** Shows a blow that is over, unless it is weak or follows another one closely. */
  private void show(int id, Flight flight, Archetype kind, float x, float y, boolean steered) {
    float dx = flight.lastX - flight.fromX;
    float dy = flight.lastY - flight.fromY;
    float blow = Vector2.len(dx, dy);
    float loss = Vector2.len(flight.fromX, flight.fromY) - Vector2.len(flight.lastX, flight.lastY);
    // What a player gains is a jump or a dash.
    if (blow < LEAST_M_S || (steered && loss < LEAST_LOSS_M_S) || flight.isQuiet(now)) {
      return;
    }
    flight.quieten(now + QUIET_SECONDS);
    float nx = dx / blow;
    float ny = dy / blow;
    float extent = WorldPainter.extent(kind);
    float hitX = x - nx * extent;
    float hitY = y - ny * extent;
    boolean replaced = listener.blow(id, kind, hitX, hitY, nx, ny, blow);
    add(hitX, hitY, nx, ny, blow, replaced ? NO_SPARKS : kind.appearance().rgb());
  }

  /**
   * Shows a blow.
   *
   * @param x where, metres
   * @param y where, metres
   * @param nx unit vector along which the struck body was pushed
   * @param ny unit vector along which the struck body was pushed
   * @param blow change of velocity, m/s
   * @param rgb colour of the struck body, or {@link #NO_SPARKS}
   */
  private void add(float x, float y, float nx, float ny, float blow, int rgb) {
    float size = MathUtils.clamp(blow / HARD_M_S, 0.2f, 1);
    blowX[nextBlow] = x;
    blowY[nextBlow] = y;
    blowSize[nextBlow] = size;
    blowAge[nextBlow] = 0;
    nextBlow = (nextBlow + 1) % BLOWS;
    int count = rgb == NO_SPARKS ? 0 : 2 + Math.round(8 * size);
    for (int i = 0; i < count; i++) {
      // Mostly along the surface that was hit, some back from it.
      float along = MathUtils.random(-1f, 1f);
      float off = MathUtils.random(0.05f, 0.7f);
      float speed = MathUtils.random(0.4f, 1f) * (3 + 9 * size);
      float vx = (nx * off - ny * along) * speed;
      float vy = (ny * off + nx * along) * speed;
      sparks.add(x, y, vx, vy, SPARK_METRES, MathUtils.random(0, 0.4f), rgb);
    }
  }

  /** Returns how much a shape of this extent glows from blows near it, 0..1. */
  float glow(float x, float y, float extent) {
    float glow = 0;
    float reach = extent + GLOW_M;
    for (int i = 0; i < BLOWS; i++) {
      if (blowAge[i] < RING_SECONDS && Vector2.dst2(x, y, blowX[i], blowY[i]) < reach * reach) {
        glow = Math.max(glow, blowSize[i] * (1 - blowAge[i] / RING_SECONDS));
      }
    }
    return glow;
  }

  /** Returns how many blows still show. */
  int showing() {
    int n = 0;
    for (float age : blowAge) {
      n += age < RING_SECONDS ? 1 : 0;
    }
    return n;
  }

  /** Draws rings and sparks. */
  void draw(Canvas canvas) {
    for (int i = 0; i < BLOWS; i++) {
      float left = 1 - blowAge[i] / RING_SECONDS;
      if (left > 0) {
        float radius = blowSize[i] * (0.25f + 1.1f * (1 - left * left));
        canvas.ring(
            blowX[i],
            blowY[i],
            radius,
            0.16f * blowSize[i] * left + 0.03f,
            UiColours.shade(0xffffff, 1, 0.8f * left * left, color));
      }
    }
    for (int i = 0; i < SPARKS; i++) {
      float left = sparks.left(i);
      if (left > 0) {
        canvas.line(
            sparks.x(i),
            sparks.y(i),
            sparks.x(i) - sparks.velocityX(i) * 0.04f,
            sparks.y(i) - sparks.velocityY(i) * 0.04f,
            SPARK_METRES * (0.375f + 0.625f * left),
            UiColours.shade(sparks.rgb(i), 1.6f, left, color));
      }
    }
  }
}
