package carom.physics.dynamics.contact;

import carom.physics.simd.VectorKernels;
import carom.physics.simd.VectorModule;
import java.util.Arrays;

/**
 * Kernels that hash the rows of a contact table side by side, bit for bit as {@link ContactHash}
 * does one after the other. How many rows go through them shows in no result.
 */
public abstract class ContactHashLanes extends VectorKernels {
  /** The kernels made with the Vector API, null without; see {@link VectorModule}. */
  static final ContactHashLanes FOUND =
      VectorModule.find("carom.physics.dynamics.simd.VectorContactHash", ContactHashLanes.class);

  /** Longs per vector, at most. */
  public static final int SUMS = 8;

  /** Rows a kernel takes at a time: their flags are one word. */
  public static final int ROWS = 8;

  /** Rows of a block. */
  public static final int BLOCK = 32;

  /** Rows per call, at most, so that their factors stay in the nearest cache. */
  static final int PIECE = 256;

  /** Shorter tables gain too little to be worth the calls. */
  private static final int LEAST = 512;

  /** Makes the kernels; they are found by name. */
  protected ContactHashLanes() {}

  /**
   * Finds the factors of rows, zero for those that don't touch, and adds what the rows are called.
   *
   * @param from first row, a multiple of {@link #ROWS}, like the end
   * @param factors receives that of the first row first
   * @param sums {@link #SUMS} that belong together for flags and points, as many for feature ids
   */
  public abstract void names(ContactTable t, int from, int to, long[] factors, long[] sums);

  /**
   * Adds the rows' impulses, multiplied by those factors.
   *
   * @param sums {@link #SUMS}, from the third time as many on
   */
  public abstract void impulses(float[] contact, int from, int to, long[] factors, long[] sums);

  /**
   * Takes the sums of impulses apart.
   *
   * @param sums as {@link #impulses} leaves them
   * @param to receives them from {@link ContactHash#START0} on
   */
  public abstract void gather(long[] sums, long[] to);

  /**
   * Adds the first rows of a table.
   *
   * @param factors scratch, {@link #PIECE}
   * @param lanes scratch, three times {@link #SUMS}
   * @param sums by place, see {@link ContactHash}
   * @return how many were; the rest is left to the caller
   */
  final int rows(ContactTable t, long[] factors, long[] lanes, long[] sums) {
    int rows = t.count();
    int done = rows < LEAST ? 0 : grant(rows / BLOCK, rows) * BLOCK;
    Arrays.fill(lanes, 0);
    for (int at = 0; at < done; at += PIECE) {
      int end = Math.min(at + PIECE, done);
      names(t, at, end, factors, lanes);
      impulses(t.contact, at, end, factors, lanes);
    }
    for (int i = 0; i < SUMS; i++) {
      sums[ContactHash.STATE] += lanes[i];
      sums[ContactHash.IDS] += lanes[SUMS + i];
    }
    gather(lanes, sums);
    return done;
  }
}
