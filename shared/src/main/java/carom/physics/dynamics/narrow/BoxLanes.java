package carom.physics.dynamics.narrow;

import carom.physics.simd.VectorKernels;
import carom.physics.simd.VectorModule;

/**
 * A kernel that finds the manifolds of {@link #LANES} pairs of boxes side by side. Its results are
 * bit for bit those of {@code KeptManifolds.collide} for one pair after the other; it keeps no
 * manifolds.
 *
 * <p>All work is on a scratch array that holds one quantity after the other, each for all lanes.
 */
public abstract class BoxLanes extends VectorKernels {
  /** Number of pairs that a kernel computes side by side. */
  public static final int LANES = VectorModule.LANES;

  // Input.

  /** Place of the x of the way from A's position to B's, world axes, m; the y follows. */
  public static final int WAY_X = APART;

  public static final int WAY_Y = WAY_X + LANES;

  /** Place of the cosine of A's angle; A's sine and those of B follow. */
  public static final int COS_A = WAY_Y + LANES;

  public static final int SIN_A = COS_A + LANES;
  public static final int COS_B = SIN_A + LANES;
  public static final int SIN_B = COS_B + LANES;

  /** Place of the largest distance of any point of B from B's position, m. */
  public static final int REACH = SIN_B + LANES;

  /** Place of A's half width; half height and centre, and those of B, follow; body frames, m. */
  public static final int HALF_WIDTH_A = REACH + LANES;

  public static final int HALF_HEIGHT_A = HALF_WIDTH_A + LANES;
  public static final int CENTER_X_A = HALF_HEIGHT_A + LANES;
  public static final int CENTER_Y_A = CENTER_X_A + LANES;
  public static final int HALF_WIDTH_B = CENTER_Y_A + LANES;
  public static final int HALF_HEIGHT_B = HALF_WIDTH_B + LANES;
  public static final int CENTER_X_B = HALF_HEIGHT_B + LANES;
  public static final int CENTER_Y_B = CENTER_X_B + LANES;

  // Output.

  /**
   * Place of the number of points or {@link #CORNERS}, with {@link #LOOK} added if it applies. This
   * and the ids are {@link #integer integers}.
   */
  public static final int COUNT = CENTER_Y_B + LANES;

  /** Place of the x of the normal, world axes; the y follows. */
  public static final int NX = COUNT + LANES;

  public static final int NY = NX + LANES;

  /** Place of point 0's x, relative to A's position, world axes, m; y, gap, m, and id follow. */
  public static final int X0 = NY + LANES;

  static final int Y0 = X0 + LANES;
  public static final int GAP0 = Y0 + LANES;
  public static final int ID0 = GAP0 + LANES;
  public static final int X1 = ID0 + LANES;
  static final int Y1 = X1 + LANES;
  public static final int GAP1 = Y1 + LANES;
  public static final int ID1 = GAP1 + LANES;

  /** Place of the other id of point 0; that of point 1 follows. */
  public static final int OTHER_ID0 = ID1 + LANES;

  public static final int OTHER_ID1 = OTHER_ID0 + LANES;

  /** Place of the smallest gap of all points so far, m; input and output. */
  public static final int LEAST = OTHER_ID1 + LANES;

  /** Place where a kernel's own scratch begins. */
  public static final int OWN = LEAST + LANES;

  /**
   * Number of points that stands for two corners facing each other, a case that no kernel computes.
   */
  public static final int CORNERS = 3;

  /**
   * Number added to the count if the gap is so wide that the tight boxes of the parts may not
   * overlap.
   */
  public static final int LOOK = 4;

  /** The float whose lower bits an integer from 0 to 2^23 fills when it is added. */
  public static final float INTEGER = 1 << 23;

  /**
   * The kernel made with the Vector API, or null if that is missing; see {@link VectorModule}. It
   * is declared after the offsets, because its class reads them when it is loaded.
   */
  public static final BoxLanes FOUND =
      VectorModule.find("carom.physics.dynamics.simd.VectorBoxes", BoxLanes.class);

  /** Makes the kernel, which {@link VectorModule} finds by name. */
  protected BoxLanes() {}

  /** Returns how long a worker's scratch array must be, {@link #APART} at both ends included. */
  public abstract int scratchSize();

  /** Reads an integer in a scratch array. */
  static int integer(float[] scratch, int at) {
    return Float.floatToRawIntBits(scratch[at]) - Float.floatToRawIntBits(INTEGER);
  }

  /**
   * Finds the manifolds.
   *
   * @param scratch in and out
   * @param speculative points up to this far apart are reported, m
   */
  public abstract void collide(float[] scratch, float speculative);
}
