package carom.physics.particles;

import carom.physics.math.Limits;

/**
 * A nozzle that emits particles in rows, side by side, one spacing behind the other. It holds
 * settings only. What it emits in a tick depends only on the tick's number.
 */
public final class Emitter {
  private final float x;
  private final float y;
  private final float dirX;
  private final float dirY;
  private float width;
  private float speed = 5;

  /**
   * Creates a nozzle with the width of one particle and a speed of 5 m/s.
   *
   * @param x x of its centre, m
   * @param y y of its centre, m
   * @param dirX x of its direction; any length but 0
   * @param dirY y of its direction
   */
  public Emitter(float x, float y, float dirX, float dirY) {
    this.x = Limits.position("x", x);
    this.y = Limits.position("y", y);
    Limits.coordinate("dirX", dirX);
    Limits.coordinate("dirY", dirY);
    double length = Math.sqrt((double) dirX * dirX + (double) dirY * dirY);
    if (!(length > 1e-6)) {
      throw new IllegalArgumentException("direction=" + dirX + " " + dirY + " has no length");
    }
    this.dirX = (float) (dirX / length);
    this.dirY = (float) (dirY / length);
  }

  /**
   * Sets the width; default 0, which is one particle.
   *
   * @param metres width, 0 to 1e4 m
   * @return this
   */
  public Emitter width(float metres) {
    width = Limits.range("width", metres, 0, 1e4f);
    return this;
  }

  /**
   * Sets the speed of the particles and with it their number, {@code speed / spacing} rows per
   * second.
   *
   * @param metresPerSecond speed, 0 to 1e3 m/s
   * @return this
   */
  public Emitter speed(float metresPerSecond) {
    speed = Limits.range("speed", metresPerSecond, 0, 1e3f);
    return this;
  }

  /**
   * Adds the particles of a tick. Call it before {@link Particles#step}.
   *
   * @param particles receives the particles
   * @param tick the tick's number, from any start
   * @param dtSeconds length of the tick, s
   * @return the number of particles added
   */
  public int emit(Particles particles, long tick, float dtSeconds) {
    Limits.timeStep(dtSeconds);
    Limits.notNull("particles", particles);
    double rows = (double) speed * dtSeconds / particles.spacing();
    long from = (long) Math.floor(tick * rows);
    long to = (long) Math.floor((tick + 1) * rows);
    int columns = 1 + (int) (width / particles.spacing());
    float across = columns == 1 ? 0 : width / (columns - 1);
    float wide = 0.5f * (columns - 1) * across;
    float far = speed * dtSeconds + particles.spacing();
    Limits.position("x + width", Math.abs(x) + wide * Math.abs(dirY) + far * Math.abs(dirX));
    Limits.position("y + width", Math.abs(y) + wide * Math.abs(dirX) + far * Math.abs(dirY));
    int added = 0;
    for (long row = from; row < to; row++) {
      // A row emitted earlier in the tick is further along its path.
      float ahead = (float) ((tick + 1) * rows - (row + 1)) * particles.spacing();
      for (int column = 0; column < columns; column++) {
        float side = column * across - 0.5f * (columns - 1) * across;
        long id =
            particles.add(
                x + ahead * dirX - side * dirY,
                y + ahead * dirY + side * dirX,
                speed * dirX,
                speed * dirY);
        added += id == Particles.NONE ? 0 : 1;
      }
    }
    return added;
  }
}
