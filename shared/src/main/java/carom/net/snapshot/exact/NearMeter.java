package carom.net.snapshot.exact;

import carom.net.codec.BitCost;
import carom.physics.rows.RowKind;
import carom.physics.rows.Rows;

/**
 * Measures how many bits of a datagram the rows of a near update take, before they are sent. One
 * thread, no allocation.
 */
final class NearMeter {
  private static final int UNIT = 256;

  private final NearRowCodec codec = new NearRowCodec();
  private final BitCost cost = new BitCost();

  /** Copy of the row being measured, because coding writes to it. */
  private final Rows row = Rows.mixed();

  /** Creates a meter; call {@link #begin} before use. */
  public NearMeter() {}

  /**
   * Starts a part without rows.
   *
   * @param own the section that the part belongs to, with its body set; read from until the part
   *     ends
   */
  public void begin(OwnState own) {
    codec.begin(own);
    cost.reset();
  }

  /**
   * Adds the next row.
   *
   * @param from array that holds the row; not changed
   * @param at index at which the row begins
   */
  public void add(RowKind kind, int[] from, int at) {
    row.clear();
    row.add(kind, from, at);
    codec.row(cost, kind, row.ints(), 0);
  }

  /** Returns the bits of all rows added since {@link #begin}, to within a few percent. */
  public int bits() {
    return (int) (cost.sum() / UNIT);
  }
}
