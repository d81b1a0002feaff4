package carom.client.desktop.game;

import carom.client.look.Particles;
import com.badlogic.gdx.math.MathUtils;

/**
 * The particles of a game's look that fly. A new one takes the place of the oldest. Render thread
 * only; allocates nothing after it was created.
 */
final class Sparks {
  /** Most particles at a time. */
  static final int MOST = 3_000;

  private final Particles[] kind = new Particles[MOST];
  private final float[] x = new float[MOST];
  private final float[] y = new float[MOST];
  private final float[] vx = new float[MOST];
  private final float[] vy = new float[MOST];
  private final float[] age = new float[MOST];
  private final float[] life = new float[MOST];
  private final int[] rgb = new int[MOST];
  private int next;

  /** Ends all particles. */
  void clear() {
    for (int i = 0; i < MOST; i++) {
      kind[i] = null;
    }
  }

  /**
   * Adds a burst.
   *
   * @param share of its count, 0..1
   * @param way the middle of its cone, radians
   * @param ofCause colour of the event or body, 0xRRGGBB
   */
  void burst(Particles of, float atX, float atY, float way, float share, int ofCause) {
    int count = Math.max(1, Math.round(of.count() * share));
    for (int i = 0; i < count; i++) {
      add(of, atX, atY, way, (float) (0.5 + 0.5 * share), ofCause);
    }
  }

  /**
   * Adds the part of a stream that a moving body leaves in a picture's time.
   *
   * @param speedX of the body, m/s
   * @param speedY of the body, m/s
   */
  void stream(
      Particles of, float atX, float atY, float speedX, float speedY, float seconds, int ofCause) {
    float due = of.count() * Math.min(seconds, 0.1f) + MathUtils.random();
    float way = MathUtils.atan2(-speedY, -speedX);
    for (int i = 0; i < (int) due; i++) {
      float ago = seconds * MathUtils.random();
      add(of, atX - speedX * ago, atY - speedY * ago, way, 1, ofCause);
    }
  }

  private void add(Particles of, float atX, float atY, float way, float hard, int ofCause) {
    float angle = way + of.spread() * MathUtils.random(-1f, 1f);
    float speed = hard * of.speed(MathUtils.random());
    kind[next] = of;
    x[next] = atX;
    y[next] = atY;
    vx[next] = speed * MathUtils.cos(angle);
    vy[next] = speed * MathUtils.sin(angle);
    age[next] = 0;
    life[next] = of.seconds(MathUtils.random());
    rgb[next] = ofCause;
    next = (next + 1) % MOST;
  }

  /** Moves and ages all particles. */
  void fly(float gravityX, float gravityY, float seconds) {
    for (int i = 0; i < MOST; i++) {
      Particles of = kind[i];
      if (of == null) {
        continue;
      }
      age[i] += seconds;
      if (age[i] >= life[i]) {
        kind[i] = null;
        continue;
      }
      float kept = 1 / (1 + of.drag() * seconds);
      vx[i] = (vx[i] + of.gravity() * gravityX * seconds) * kept;
      vy[i] = (vy[i] + of.gravity() * gravityY * seconds) * kept;
      x[i] += vx[i] * seconds;
      y[i] += vy[i] * seconds;
    }
  }

  /** Returns the kind of a particle by its place, or null if none flies there. */
  Particles kind(int i) {
    return kind[i];
  }

  float x(int i) {
    return x[i];
  }

  float y(int i) {
    return y[i];
  }

  /** Returns the share of its life that is over, 0..1. */
  float over(int i) {
    return age[i] / life[i];
  }

  /** Returns the colour of what caused it, 0xRRGGBB. */
  int rgb(int i) {
    return rgb[i];
  }

  /** Returns the number of particles that fly. */
  int flying() {
    int n = 0;
    for (Particles of : kind) {
      n += of == null ? 0 : 1;
    }
    return n;
  }
}
