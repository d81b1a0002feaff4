package carom.server.room;

import java.util.Arrays;

/** Numbers that are collected one by one. What is beyond a limit is left out. */
final class Floats {
  private static final int LEAST = 64;

  private final int most;
  private float[] values = new float[LEAST];
  private int count;

  /**
   * Creates an empty list.
   *
   * @param most most values
   */
  Floats(int most) {
    this.most = most;
  }

  /** Forgets all values. */
  Floats clear() {
    count = 0;
    return this;
  }

  /** Adds values that belong together, all or none. */
  void add(float a, float b, float c, float d, float e) {
    if (count + 5 > most) {
      return;
    }
    if (count + 5 > values.length) {
      values = Arrays.copyOf(values, Math.min(most, 2 * values.length + 5));
    }
    values[count++] = a;
    values[count++] = b;
    values[count++] = c;
    values[count++] = d;
    values[count++] = e;
  }

  /** Returns a copy of the values. */
  float[] toArray() {
    return Arrays.copyOf(values, count);
  }
}
