package carom.physics.particles;

import carom.physics.math.Limits;

/**
 * A nozzle: adds rows of particles that fly off side by side, one spacing after the other. Holds
 * settings only; what it adds in a tick depends on the tick's number alone.
 */
public final class Emitter {
  private final float x;
  private final float y;
  private final float dirX;
  private final float dirY;
  private float width;
  private float speed = 5;

  /**
   * A nozzle of one particle's width and 5 m/s.
   *
   * @param x its middle, m
   * @param y its middle, m
   * @param dirX where it points; any length but 0
   * @param dirY where it points
   */
  public Emitter(float x, float y, float dirX, float dirY) {
    this.x = Limits.coordinate("x", x);
    this.y = Limits.coordinate("y", y);
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
   * Sets the width; default 0, one particle.
   *
   * @param metres m, 0 to 1e4
   * @return this
   */
  public Emitter width(float metres) {
    width = Limits.range("width", metres, 0, 1e4f);
    return this;
  }

  /**
   * Sets how fast particles leave, and with it how many: {@code speed / spacing} rows per second.
   *
   * @param metresPerSecond m/s, 0 to 1e3
   * @return this
   */
  public Emitter speed(float metresPerSecond) {
    speed = Limits.range("speed", metresPerSecond, 0, 1e3f);
    return this;
  }

  /**
   * Adds what leaves in a tick, before {@link Particles#step}.
   *
   * @param particles receives them
   * @param tick the tick's number, from any start
   * @param dtSeconds its length, s
   * @return how many were added
   */
  public int emit(Particles particles, long tick, float dtSeconds) {
    Limits.timeStep(dtSeconds);
    double rows = (double) speed * dtSeconds / particles.spacing();
    long from = (long) Math.floor(tick * rows);
    long to = (long) Math.floor((tick + 1) * rows);
    int columns = 1 + (int) (width / particles.spacing());
    float across = columns == 1 ? 0 : width / (columns - 1);
    int added = 0;
    for (long row = from; row < to; row++) {
      // A row that left earlier in the tick is further on its way.
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
