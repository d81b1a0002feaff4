package carom.physics.geometry;

import java.util.Arrays;

/** Looks whether a line crosses itself or turns back on itself, which a chain must not. */
final class ChainCrossings {
  /** Most comparisons for one line, 0.3 s; ground of 200,000 segments needs a hundredth. */
  private static final long MOST_WORK = 100_000_000;

  private final float[] xy;
  private final boolean loop;
  private final int count;

  /** Looks at a line of 2 points or more. */
  public ChainCrossings(float[] xy, boolean loop) {
    this.xy = xy;
    this.loop = loop;
    count = loop ? xy.length / 2 : xy.length / 2 - 1;
  }

  /** Refuses a line that crosses itself or turns back on itself. */
  public void refuse() {
    int points = xy.length / 2;
    for (int i = 0; i < count; i++) {
      int next = i + 1 < count || loop ? (i + 1) % count : i;
      int middle = (i + 1) % points;
      int after = (i + 2) % points;
      if (next != i && side(i, middle, after) == 0 && ahead(i, middle, after) < 0) {
        throw new IllegalArgumentException(
            "chain segment=" + next + " turns back on segment=" + i + "; leave a gap between them");
      }
    }
    // Only segments that overlap along the longer axis can cross, and on a line of ground few do.
    int axis = extent(0) >= extent(1) ? 0 : 1;
    long[] byLowEnd = new long[count];
    for (int i = 0; i < count; i++) {
      int bits = Float.floatToIntBits(low(i, axis) + 0f); // turns minus zero into zero
      byLowEnd[i] = (long) (bits ^ (bits >> 31 & Integer.MAX_VALUE)) << 32 | i;
    }
    Arrays.sort(byLowEnd);
    float[] from = new float[count];
    float[] low = new float[count];
    float[] high = new float[count];
    for (int k = 0; k < count; k++) {
      from[k] = low((int) byLowEnd[k], axis);
      low[k] = low((int) byLowEnd[k], 1 - axis);
      high[k] = high((int) byLowEnd[k], 1 - axis);
    }
    long work = 0;
    for (int k = 0; k < count; k++) {
      int i = (int) byLowEnd[k];
      float to = high(i, axis);
      int l = k + 1;
      for (; l < count && from[l] <= to; l++) {
        if (low[k] <= high[l] && low[l] <= high[k]) {
          int j = (int) byLowEnd[l];
          refuseCrossing(Math.min(i, j), Math.max(i, j));
          work += 8; // as long as a pair takes
        }
      }
      work += l - k;
      if (work > MOST_WORK) {
        throw new IllegalArgumentException(
            "chain segments=" + count + " lie side by side too often; make it several chains");
      }
    }
  }

  private void refuseCrossing(int i, int j) {
    int points = xy.length / 2;
    int middle = (i + 1) % points;
    int end = (j + 1) % points;
    if (j > i + 1
        && side(i, middle, j) * side(i, middle, end) < 0
        && side(j, end, i) * side(j, end, middle) < 0) {
      throw new IllegalArgumentException(
          "chain segment=" + i + " crosses segment=" + j + "; make it two chains");
    }
  }

  private float low(int segment, int axis) {
    int next = (segment + 1) % (xy.length / 2);
    return Math.min(xy[2 * segment + axis], xy[2 * next + axis]);
  }

  private float high(int segment, int axis) {
    int next = (segment + 1) % (xy.length / 2);
    return Math.max(xy[2 * segment + axis], xy[2 * next + axis]);
  }

  /** Returns the extent of the points along an axis, metres. */
  private float extent(int axis) {
    float least = Float.POSITIVE_INFINITY;
    float most = Float.NEGATIVE_INFINITY;
    for (int at = axis; at < xy.length; at += 2) {
      least = Math.min(least, xy[at]);
      most = Math.max(most, xy[at]);
    }
    return most - least;
  }

  /**
   * Returns a positive number if a point is to the left of the line through two others, and a
   * negative one if it is to the right.
   */
  private double side(int from, int to, int point) {
    double ux = (double) xy[2 * to] - xy[2 * from];
    double uy = (double) xy[2 * to + 1] - xy[2 * from + 1];
    double px = (double) xy[2 * point] - xy[2 * from];
    double py = (double) xy[2 * point + 1] - xy[2 * from + 1];
    return Math.signum(ux * py - uy * px);
  }

  /**
   * Returns a positive number if the way from a middle point leads on, and a negative one if it
   * leads back.
   */
  private double ahead(int from, int middle, int to) {
    double ux = (double) xy[2 * middle] - xy[2 * from];
    double uy = (double) xy[2 * middle + 1] - xy[2 * from + 1];
    double px = (double) xy[2 * to] - xy[2 * middle];
    double py = (double) xy[2 * to + 1] - xy[2 * middle + 1];
    return ux * px + uy * py;
  }
}
