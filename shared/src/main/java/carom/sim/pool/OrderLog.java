package carom.sim.pool;

import java.util.Arrays;

/**
 * The orders by which pools are changed from outside, by periods of a tenth of a second. A row
 * holds a period's orders: which spouts are open, and up to {@value #MAX_ORDERS} places where a
 * body stirs the particles, where some are poured, or where they are taken away.
 *
 * <p>The server closes the row of a period {@value #AHEAD} periods before it begins, so that
 * clients have it in time. A row is {@value #WORDS} words, which may hold anything: every order is
 * bounded by its bits. The log remembers {@value #KEPT} rows. One thread; no allocation.
 *
 * <pre>
 *  word 0     number of the period; a row that isn't known has another
 *  word 1     hash of the pools where the period with number - AHEAD begins
 *  word 2     spouts that are open, a bit each
 *  word 3     number of orders
 *  from 4 on  two words for each order:
 *             x in its pool's rectangle, 16 bits; y, 16 bits
 *             kind, 2 bits; pool, 3 bits; radius, 7 bits of 5 cm; vx and vy, 10 bits of 5 cm/s each
 * </pre>
 */
public final class OrderLog {
  /** Periods between the moment that a row is closed and its own beginning. */
  public static final int AHEAD = 4;

  /** Most orders of a period. */
  public static final int MAX_ORDERS = 12;

  /** Words before the orders. */
  private static final int HEAD = 4;

  /** Words of a row. */
  public static final int WORDS = HEAD + 2 * MAX_ORDERS;

  /** Rows that are remembered; a power of two. */
  public static final int KEPT = 64;

  /** Most pools of a level. */
  static final int MAX_POOLS = 8;

  /** A body that moves within the particles, and takes them along. */
  static final int STIR = 1;

  /** A disc that is filled with particles. */
  static final int POUR = 2;

  /** A disc whose particles disappear. */
  static final int TAKE = 3;

  private static final int NUMBER = 0;
  private static final int HASH = 1;
  private static final int OPEN = 2;
  private static final int COUNT = 3;
  private static final float STEP = 0.05f;
  private static final float MOST_RADIUS = 127 * STEP;
  private static final int NO_PERIOD = -1;

  private final int[][] rows = new int[KEPT][WORDS];

  // The order that was read last.
  int kind;
  float x;
  float y;
  float radius;
  float vx;
  float vy;

  OrderLog() {
    clear();
  }

  /** Forgets all rows. */
  void clear() {
    for (int[] row : rows) {
      Arrays.fill(row, 0);
      row[NUMBER] = NO_PERIOD;
    }
  }

  /** Copies another log. */
  void copy(OrderLog from) {
    for (int i = 0; i < KEPT; i++) {
      System.arraycopy(from.rows[i], 0, rows[i], 0, WORDS);
    }
  }

  /** Returns the words of a period's row, or null if the row isn't known. */
  public int[] row(int period) {
    int[] row = rows[period & KEPT - 1];
    return row[NUMBER] == period ? row : null;
  }

  /** Returns whether the known rows of some periods order nothing and leave the spouts as is. */
  boolean isQuiet(int from, int to, int spouts) {
    for (int period = from; period < to; period++) {
      int[] row = row(period);
      if (row != null && (row[COUNT] > 0 || row[OPEN] != spouts)) {
        return false;
      }
    }
    return true;
  }

  /** Mixes the known rows of a period and the {@link #AHEAD} after it into a hash. */
  long hash(long before, int period) {
    long h = before;
    for (int i = 0; i <= AHEAD; i++) {
      int[] row = row(period + i);
      for (int word = 0; row != null && word < WORDS; word++) {
        h = h * 31 + row[word];
      }
    }
    return h;
  }

  /** Returns a place of the log, 0..{@link #KEPT} - 1; its period is negative if it is empty. */
  int[] slot(int index) {
    return rows[index];
  }

  /** Takes over the rows of another log from a period on. */
  void add(OrderLog from, int period) {
    for (int[] row : from.rows) {
      if (row[NUMBER] >= period) {
        take(row);
      }
    }
  }

  /** Copies the orders of a row to one that has none. */
  static void copyOrders(int[] from, int[] to) {
    System.arraycopy(from, COUNT, to, COUNT, WORDS - COUNT);
  }

  /** Begins the row of a period; nothing is ordered yet. */
  int[] begin(int period, int open, int hash) {
    int[] row = rows[period & KEPT - 1];
    Arrays.fill(row, 0);
    row[NUMBER] = period;
    row[OPEN] = open;
    row[HASH] = hash;
    return row;
  }

  /** Takes over a row; its number of orders is bounded. */
  void take(int[] words) {
    int[] row = rows[words[NUMBER] & KEPT - 1];
    System.arraycopy(words, 0, row, 0, WORDS);
    row[COUNT] = Math.max(0, Math.min(MAX_ORDERS, row[COUNT]));
  }

  /** Returns the number of a row's period. */
  public static int period(int[] row) {
    return row[NUMBER];
  }

  static int hash(int[] row) {
    return row[HASH];
  }

  static int open(int[] row) {
    return row[OPEN];
  }

  static int orders(int[] row) {
    return row[COUNT];
  }

  /**
   * Adds an order to a row.
   *
   * @return false if the row is full
   */
  static boolean add(
      int[] row,
      PoolDef.Rectangle in,
      int kind,
      int pool,
      float x,
      float y,
      float r,
      float vx,
      float vy) {
    if (row[COUNT] == MAX_ORDERS) {
      return false;
    }
    int at = HEAD + 2 * row[COUNT]++;
    row[at] = part(x, in.minX(), in.maxX()) << 16 | part(y, in.minY(), in.maxY());
    row[at + 1] =
        kind << 30
            | (pool & MAX_POOLS - 1) << 27
            | Math.round(Math.max(0, Math.min(MOST_RADIUS, r)) / STEP) << 20
            | speed(vx) << 10
            | speed(vy);
    return true;
  }

  private static int part(float value, float min, float max) {
    return Math.max(0, Math.min(0xffff, Math.round((value - min) / (max - min) * 0xffff)));
  }

  private static int speed(float v) {
    return 512 + Math.max(-512, Math.min(511, Math.round(v / STEP)));
  }

  /** Reads an order's pool. */
  static int pool(int[] row, int order) {
    return row[HEAD + 2 * order + 1] >>> 27 & MAX_POOLS - 1;
  }

  /** Reads an order into the fields of this log. */
  void read(int[] row, int order, PoolDef.Rectangle in) {
    int place = row[HEAD + 2 * order];
    int what = row[HEAD + 2 * order + 1];
    kind = what >>> 30;
    radius = (what >>> 20 & 127) * STEP;
    vx = ((what >>> 10 & 1023) - 512) * STEP;
    vy = ((what & 1023) - 512) * STEP;
    x = in.minX() + (place >>> 16) * (in.maxX() - in.minX()) / 0xffff;
    y = in.minY() + (place & 0xffff) * (in.maxY() - in.minY()) / 0xffff;
  }
}
