package carom.physics.particles;

import java.util.Arrays;

/**
 * Pairs of neighbouring particles, found on a grid without a table. A radix sort orders the
 * particles by cell, row after row. The cells around a particle are then ranges of this order,
 * which advance with the particle, so the cost doesn't depend on the size of the world.
 *
 * <p>Pairs are listed by their first particle. Its partners, all later in the order, are {@code
 * partner[start[i]]} to {@code partner[start[i + 1] - 1]}.
 */
final class Neighbours {
  private static final int DIGIT = 11;
  private static final int BUCKETS = 1 << DIGIT;

  private long[] key = new long[0];
  private long[] otherKey = new long[0];
  private int[] order = new int[0];
  private int[] otherOrder = new int[0];
  private final int[] bucket = new int[BUCKETS];

  /** Positions of the particles in the middle of the step, in the new order. */
  float[] x = new float[0];

  float[] y = new float[0];
  int[] start = new int[1];
  int[] partner = new int[64];

  private float[] floats = new float[0];
  private int[] ints = new int[0];
  private long width;

  private void reserve(int capacity) {
    if (order.length < capacity) {
      key = new long[capacity];
      otherKey = new long[capacity];
      order = new int[capacity];
      otherOrder = new int[capacity];
      x = new float[capacity];
      y = new float[capacity];
      start = new int[capacity + 1];
      floats = new float[capacity];
      ints = new int[capacity];
    }
  }

  /**
   * Sorts the particles by their positions after some time, and lists the pairs that are within a
   * radius then.
   */
  void find(ParticleStore p, float seconds, float radius) {
    reserve(p.capacity());
    sort(p, seconds, radius);
    p.permute(order, floats, ints);
    for (int i = 0; i < p.count; i++) {
      x[i] = p.x[i] + seconds * p.vx[i];
      y[i] = p.y[i] + seconds * p.vy[i];
    }
    pair(p.count, radius * radius);
  }

  private void sort(ParticleStore p, float seconds, float radius) {
    int n = p.count;
    double cells = 1.0 / radius;
    long minX = Long.MAX_VALUE;
    long minY = Long.MAX_VALUE;
    long maxX = Long.MIN_VALUE;
    long maxY = Long.MIN_VALUE;
    for (int i = 0; i < n; i++) {
      long cx = cell(p.x[i] + seconds * p.vx[i], cells);
      long cy = cell(p.y[i] + seconds * p.vy[i], cells);
      minX = Math.min(minX, cx);
      minY = Math.min(minY, cy);
      maxX = Math.max(maxX, cx);
      maxY = Math.max(maxY, cy);
    }
    // Two columns more than needed, so that the last cell of a row isn't a neighbour of the first
    // cell of the next.
    width = maxX - minX + 3;
    for (int i = 0; i < n; i++) {
      long cx = cell(p.x[i] + seconds * p.vx[i], cells);
      long cy = cell(p.y[i] + seconds * p.vy[i], cells);
      key[i] = (cy - minY) * width + (cx - minX);
      order[i] = i;
    }
    long most = (maxY - minY) * width + (maxX - minX);
    for (int shift = 0; shift < 63 && most >>> shift != 0; shift += DIGIT) {
      sortDigit(n, shift);
    }
  }

  private static long cell(float at, double cells) {
    return (long) Math.floor(at * cells);
  }

  private void sortDigit(int n, int shift) {
    Arrays.fill(bucket, 0);
    for (int i = 0; i < n; i++) {
      bucket[(int) (key[i] >>> shift) & (BUCKETS - 1)]++;
    }
    int sum = 0;
    for (int b = 0; b < BUCKETS; b++) {
      int size = bucket[b];
      bucket[b] = sum;
      sum += size;
    }
    for (int i = 0; i < n; i++) {
      int to = bucket[(int) (key[i] >>> shift) & (BUCKETS - 1)]++;
      otherKey[to] = key[i];
      otherOrder[to] = order[i];
    }
    long[] keys = key;
    key = otherKey;
    otherKey = keys;
    int[] orders = order;
    order = otherOrder;
    otherOrder = orders;
  }

  /**
   * Lists the pairs. Each particle meets the rest of its cell, the cell to the right, and three
   * cells of the row above.
   */
  private void pair(int n, float squared) {
    int pairs = 0;
    int low = 0;
    int high = 0;
    for (int i = 0; i < n; i++) {
      start[i] = pairs;
      long k = key[i];
      int right = i + 1;
      while (right < n && key[right] <= k + 1) {
        right++;
      }
      long left = k + width - 1;
      while (low < n && key[low] < left) {
        low++;
      }
      if (high < low) {
        high = low;
      }
      while (high < n && key[high] <= left + 2) {
        high++;
      }
      int most = pairs + right - i + high - low;
      if (most > partner.length) {
        partner = Arrays.copyOf(partner, Math.max(most, partner.length * 2));
      }
      float px = x[i];
      float py = y[i];
      for (int j = i + 1; j < right; j++) {
        float dx = px - x[j];
        float dy = py - y[j];
        partner[pairs] = j;
        pairs += dx * dx + dy * dy < squared ? 1 : 0;
      }
      for (int j = low; j < high; j++) {
        float dx = px - x[j];
        float dy = py - y[j];
        partner[pairs] = j;
        pairs += dx * dx + dy * dy < squared ? 1 : 0;
      }
    }
    start[n] = pairs;
  }

  int pairs(int n) {
    return start[n];
  }
}
