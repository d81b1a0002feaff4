package carom.client;

import java.util.Arrays;

/** The last values of a measure, for graphs. A ring of fixed size; one thread. */
public final class Series {
  /** Values kept. */
  public static final int CAPACITY = 256;

  private final float[] values = new float[CAPACITY];
  private int added;

  Series() {}

  void add(float value) {
    values[added & (CAPACITY - 1)] = value;
    added++;
    if (added < 0) {
      added = CAPACITY;
    }
  }

  /** Values held, 0..{@link #CAPACITY}. */
  public int size() {
    return Math.min(added, CAPACITY);
  }

  /** A value by age: 0 is the newest, {@link #size} - 1 the oldest. */
  public float get(int age) {
    if (age < 0 || age >= size()) {
      throw new IndexOutOfBoundsException("age=" + age + " is outside 0.." + (size() - 1));
    }
    return values[(added - 1 - age) & (CAPACITY - 1)];
  }

  /** The newest value, or 0 when there is none. */
  public float newest() {
    return size() == 0 ? 0 : get(0);
  }

  /** Mean of all values held, or 0 when there is none. */
  public float mean() {
    double sum = 0;
    for (int i = 0; i < size(); i++) {
      sum += get(i);
    }
    return size() == 0 ? 0 : (float) (sum / size());
  }

  /** Largest value held, or 0 when there is none. */
  public float max() {
    float max = 0;
    for (int i = 0; i < size(); i++) {
      max = Math.max(max, get(i));
    }
    return max;
  }

  /** The value that a share of the values held is not above, or 0 when there is none. */
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
