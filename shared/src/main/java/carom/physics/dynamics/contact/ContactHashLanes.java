package carom.physics.dynamics.contact;

import carom.physics.simd.VectorModule;
import java.util.Arrays;

/**
 * Kernels that hash the rows of a contact table side by side, bit for bit as {@link ContactHash}
 * does one after the other. How many rows go through them shows in no result.
 */
public abstract class ContactHashLanes {
  /** The kernels made with the Vector API, null without; see {@link VectorModule}. */
  static final ContactHashLanes FOUND =
      VectorModule.find("carom.physics.dynamics.simd.VectorContactHash", ContactHashLanes.class);

  /** Longs per vector, at most. */
  public static final int SUMS = 8;

  /** Rows a kernel takes at a time: their flags are one word. */
  public static final int ROWS = 8;

  /**
   * Calls of a kernel before everything goes through it: until then the JIT compiler may interpret
   * it, hundreds of times slower.
   */
  private static final int WARM_UP = 1_500;

  /** Pieces per hash until then, and how many numbers or rows they have. */
  private static final int FEW = 8;

  private static final int SMALL = 32;

  /** Rows per call afterwards, so that their factors stay in the nearest cache. */
  static final int PIECE = 256;

  /** Shorter tables gain too little to be worth the calls. */
  private static final int LEAST = 512;

  /** How often the kernels were called. Worlds share this count, which needn't be exact. */
  private int calls;

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
    int whole = t.count() < LEAST ? 0 : t.count() & -ROWS;
    boolean trusted = calls >= WARM_UP;
    int piece = trusted ? PIECE : SMALL;
    int done = trusted ? whole : Math.min(whole, FEW * SMALL);
    Arrays.fill(lanes, 0);
    for (int at = 0; at < done; at += piece) {
      int end = Math.min(at + piece, done);
      names(t, at, end, factors, lanes);
      impulses(t.contact, at, end, factors, lanes);
      calls += trusted ? 0 : 1;
    }
    for (int i = 0; i < SUMS; i++) {
      sums[ContactHash.STATE] += lanes[i];
      sums[ContactHash.IDS] += lanes[SUMS + i];
    }
    gather(lanes, sums);
    return done;
  }
}
