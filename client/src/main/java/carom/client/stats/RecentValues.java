package carom.client.stats;

import java.util.Arrays;

/** The most recent values of a measure, for graphs. A ring of fixed size; one thread. */
public final class RecentValues {
  /** Values kept. */
  public static final int CAPACITY = 256;

  private final float[] values = new float[CAPACITY];
  private int added;

  RecentValues() {}

  /** Adds a value. The oldest one goes when the ring is full. */
  void add(float value) {
    values[added & (CAPACITY - 1)] = value;
    added++;
    if (added < 0) {
      added = CAPACITY;
    }
  }

  /** Returns the number of values held, 0..{@link #CAPACITY}. */
  public int size() {
    return Math.min(added, CAPACITY);
  }

  /** Returns a value by age: 0 is the newest, {@link #size} - 1 the oldest. */
  public float get(int age) {
    if (age < 0 || age >= size()) {
      throw new IndexOutOfBoundsException("age=" + age + " is outside 0.." + (size() - 1));
    }
    return values[(added - 1 - age) & (CAPACITY - 1)];
  }

  /** Returns the newest value, or 0 if there is none. */
  public float newest() {
    return size() == 0 ? 0 : get(0);
  }

  /** Returns the mean of all values held, or 0 if there is none. */
  public float mean() {
    double sum = 0;
    for (int i = 0; i < size(); i++) {
      sum += get(i);
    }
    return size() == 0 ? 0 : (float) (sum / size());
  }

  /**
   * Returns a percentile of the values held, or 0 if there is none.
   *
   * @param share of the values that are not above the result, 0..1
   * @param scratch at least {@link #CAPACITY} long; overwritten
   */
  public float percentile(double share, float[] scratch) {
    int size = size();
    if (size == 0) {
      return 0;
    }
    System.arraycopy(values, 0, scratch, 0, size);
    Arrays.sort(scratch, 0, size);
    return scratch[(int) Math.min(size - 1, Math.floor(share * size))];
  }
}
