package carom.physics.math;

/**
 * Ranges of the numbers that a world accepts, and checks that refuse others. A check's message
 * names the value as the caller does.
 *
 * <p>Every number that enters a world passes one of these checks, so a world has no NaNs and no
 * values whose products overflow. Programs may use the same limits for their own input.
 */
public final class Limits {
  /** Largest coordinate of anything but a body or particle, m, such as the end of a ray. */
  public static final float MAX_COORDINATE = 1e7f;

  /**
   * Largest coordinate of a body or particle, m. Floats are 2 mm apart just below, and 4 mm above.
   * A step adds what its float can hold: beyond, a body of 0.1 m/s would stand still.
   */
  public static final float MAX_POSITION = 32_768;

  /** Largest speed that a program may request, m/s or rad/s. */
  public static final float MAX_VELOCITY = 1e5f;

  /** Largest force, torque or impulse that a program may request, N, N m, N s. */
  public static final float MAX_FORCE = 1e20f;

  /** Largest frequency of a joint's spring, 1/s. */
  public static final float MAX_HERTZ = 1e3f;

  /** Largest damping ratio of a joint's spring. */
  public static final float MAX_DAMPING_RATIO = 100;

  /** Largest ratio of gears, racks and pulleys. */
  public static final float MAX_RATIO = 1e4f;

  /** Largest damping of a body, 1/s. */
  public static final float MAX_DAMPING = 1e4f;

  /** Largest factor on the world's gravity. */
  public static final float MAX_GRAVITY_SCALE = 1e3f;

  /** Largest speed below which a body may count as at rest, m/s. */
  public static final float MAX_SLEEP_SPEED = 1e3f;

  /** Longest time step, s. */
  public static final float MAX_TIME_STEP = 0.1f;

  private Limits() {}

  /**
   * Checks a closed range.
   *
   * @param name name of the value, for messages
   * @param value the value
   * @param min smallest allowed
   * @param max largest allowed
   * @return the value
   * @throws IllegalArgumentException if it is NaN or outside
   */
  public static float range(String name, float value, float min, float max) {
    if (!(value >= min && value <= max)) {
      throw refused(name, value, min + ".." + max);
    }
    return value;
  }

  /**
   * Checks a coordinate in metres.
   *
   * @param name name of the value, for messages
   * @param value the value
   * @return the value
   */
  public static float coordinate(String name, float value) {
    return magnitude(name, value, MAX_COORDINATE);
  }

  /**
   * Checks a coordinate of a body or particle in metres.
   *
   * @param name name of the value, for messages
   * @param value the value
   * @return the value
   */
  public static float position(String name, float value) {
    if (!(Math.abs(value) <= MAX_POSITION)) {
      throw new IllegalArgumentException(
          name
              + "="
              + value
              + " is outside -32768..32768 m, where floats are too coarse for slow motion;"
              + " put the world nearer to its origin");
    }
    return value;
  }

  /**
   * Checks a velocity component, m/s or rad/s.
   *
   * @param name name of the value, for messages
   * @param value the value
   * @return the value
   */
  public static float velocity(String name, float value) {
    return magnitude(name, value, MAX_VELOCITY);
  }

  /**
   * Checks a force, torque or impulse.
   *
   * @param name name of the value, for messages
   * @param value the value
   * @return the value
   */
  public static float force(String name, float value) {
    return magnitude(name, value, MAX_FORCE);
  }

  /**
   * Checks a time step, which must be more than 0 and at most {@link #MAX_TIME_STEP}.
   *
   * @param seconds the time step, s
   * @return the time step
   */
  public static float timeStep(float seconds) {
    if (!(seconds > 0 && seconds <= MAX_TIME_STEP)) {
      throw new IllegalArgumentException(
          "dtSeconds="
              + seconds
              + " is outside 0 (exclusive).."
              + MAX_TIME_STEP
              + "; step more often instead of further");
    }
    return seconds;
  }

  /**
   * Refuses null.
   *
   * @param name name of the value, for messages
   * @param value the value
   * @param <V> its type
   * @return the value
   * @throws NullPointerException if it is null
   */
  public static <V> V notNull(String name, V value) {
    if (value == null) {
      throw new NullPointerException(name + "=null is not possible; give one");
    }
    return value;
  }

  /**
   * Checks the number of an element.
   *
   * @param name name of the value, for messages
   * @param value the value
   * @param count how many elements there are
   * @return the value
   * @throws IndexOutOfBoundsException if it is outside 0..count - 1
   */
  public static int index(String name, int value, int count) {
    if (value < 0 || value >= count) {
      throw new IndexOutOfBoundsException(name + "=" + value + " is outside 0.." + (count - 1));
    }
    return value;
  }

  /**
   * Checks that a stretch lies within an array.
   *
   * @param name name of the array, for messages
   * @param length how long the array is
   * @param from where the stretch begins
   * @param count how long it is
   * @throws IndexOutOfBoundsException if it begins before the array, or ends after it
   */
  public static void stretch(String name, int length, int from, int count) {
    if (from < 0 || count < 0 || from > length - count) {
      throw new IndexOutOfBoundsException(
          name + ".length=" + length + " has no room for count=" + count + " from=" + from);
    }
  }

  private static float magnitude(String name, float value, float limit) {
    if (!(Math.abs(value) <= limit)) {
      throw refused(name, value, -limit + ".." + limit);
    }
    return value;
  }

  private static IllegalArgumentException refused(String name, float value, String range) {
    return new IllegalArgumentException(name + "=" + value + " is outside " + range);
  }
}
