package carom.lab.broadphase;

import carom.physics.broadphase.AabbArray;

/**
 * The moving boxes of the broadphase benchmark: half sizes 0.25 to 0.75 m, up to 3 m/s each way,
 * about 0.8 overlapping pairs per box, reflected at the edges of a square.
 *
 * <p>A pure function of its parameters, bit for bit. Not thread-safe.
 */
public final class BroadphaseScene {
  private final AabbArray boxes;
  private final float[] x;
  private final float[] y;
  private final float[] halfX;
  private final float[] halfY;
  private final float[] velocityX;
  private final float[] velocityY;
  private final float[][] limits;
  private final int[] ids;
  private long random = 5;

  /**
   * Creates the scene at time 0.
   *
   * @param n number of boxes, ids 0 to n - 1
   * @param clustered true: nine in ten of the boxes in a hundredth of the area, with the density of
   *     the uniform case
   */
  public BroadphaseScene(int n, boolean clustered) {
    boxes = new AabbArray(n);
    x = new float[n];
    y = new float[n];
    halfX = new float[n];
    halfY = new float[n];
    velocityX = new float[n];
    velocityY = new float[n];
    limits = new float[n][];
    ids = new int[n];
    double side = 1.5 * Math.sqrt(clustered ? 90.0 * n : n);
    float[] everywhere = {0, (float) side};
    float[] cluster = {(float) (0.6 * side), (float) (0.7 * side)};
    for (int i = 0; i < n; i++) {
      ids[i] = i;
      limits[i] = clustered && i < n * 0.9 ? cluster : everywhere;
      x[i] = uniform(limits[i][0], limits[i][1]);
      y[i] = uniform(limits[i][0], limits[i][1]);
      halfX[i] = uniform(0.25, 0.75);
      halfY[i] = uniform(0.25, 0.75);
      velocityX[i] = uniform(-3, 3);
      velocityY[i] = uniform(-3, 3);
    }
    writeBoxes();
  }

  /**
   * Returns the boxes as they are now, always in the same object.
   *
   * @return the boxes, owned by the scene
   */
  public AabbArray boxes() {
    return boxes;
  }

  /**
   * Returns the ids of all boxes.
   *
   * @return 0 to n - 1, owned by the scene
   */
  public int[] ids() {
    return ids;
  }

  /** Moves all boxes by a sixtieth of a second. */
  public void step() {
    float dt = 1f / 60;
    for (int i = 0; i < ids.length; i++) {
      float low = limits[i][0];
      float high = limits[i][1];
      x[i] += velocityX[i] * dt;
      if (x[i] < low || x[i] > high) {
        x[i] = Math.max(low, Math.min(high, x[i]));
        velocityX[i] = -velocityX[i];
      }
      y[i] += velocityY[i] * dt;
      if (y[i] < low || y[i] > high) {
        y[i] = Math.max(low, Math.min(high, y[i]));
        velocityY[i] = -velocityY[i];
      }
    }
    writeBoxes();
  }

  private void writeBoxes() {
    for (int i = 0; i < ids.length; i++) {
      boxes.set(i, x[i] - halfX[i], y[i] - halfY[i], x[i] + halfX[i], y[i] + halfY[i]);
    }
  }

  /** Returns a random float by splitmix64: from [0, 1), scaled in double and rounded once. */
  private float uniform(double low, double high) {
    random += 0x9E3779B97F4A7C15L;
    float unit = (mix(random) >>> 40) * 0x1p-24f;
    return (float) (low + (high - low) * unit);
  }

  /**
   * Returns a number spread over all bits, by the finaliser of splitmix64.
   *
   * @param number any
   * @return another, bijectively
   */
  public static long mix(long number) {
    long z = (number ^ number >>> 30) * 0xBF58476D1CE4E5B9L;
    z = (z ^ z >>> 27) * 0x94D049BB133111EBL;
    return z ^ z >>> 31;
  }
}
