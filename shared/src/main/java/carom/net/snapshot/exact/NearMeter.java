package carom.net.snapshot.exact;

import carom.net.codec.BitCost;

/**
 * Tells how much of a datagram rows of a near update take, before they are sent. One thread, no
 * allocation.
 */
public final class NearMeter {
  private static final int UNIT = 256;

  private final NearRowCodec codec = new NearRowCodec();
  private final BitCost surprise = new BitCost();
  private final int[] row = new int[NearState.STRIDE];

  /** Creates one; call {@link #begin}. */
  public NearMeter() {}

  /**
   * Starts a part without rows.
   *
   * @param own the section that the part belongs to, with its body set; read from until the part
   *     ends
   */
  public void begin(OwnState own) {
    codec.begin(own);
    surprise.reset();
  }

  /**
   * Adds the next row.
   *
   * @param isEntity whether it is an entity's, not a contact's
   * @param from holds it; not changed
   * @param at where it begins
   */
  public void add(boolean isEntity, int[] from, int at) {
    int ints = isEntity ? NearState.ENTITY_INTS : NearState.CONTACT_INTS;
    System.arraycopy(from, at, row, 0, ints);
    codec.row(surprise, isEntity, row, 0);
  }

  /** Bits of all rows since {@link #begin}, to within a few percent. */
  public int bits() {
    return (int) (surprise.sum() / UNIT);
  }
}
