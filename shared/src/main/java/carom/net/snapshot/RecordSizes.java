package carom.net.snapshot;

/**
 * Expected sizes of records: running means of what was written to one client. The encoder uses them
 * to predict how many records fit a budget.
 */
final class RecordSizes {
  /** Sizes assumed before any record was written, bits. */
  private static final float FIRST_DELTA_BITS = 44;

  private static final float FIRST_ABSOLUTE_BITS = 96;
  private static final float FAREWELL_BITS = 12;

  /** Share of a new size in the running mean. */
  private static final float NEW_SHARE = 1f / 32;

  private float deltaBits = FIRST_DELTA_BITS;
  private float absoluteBits = FIRST_ABSOLUTE_BITS;

  /** Creates the sizes expected of a client that was sent nothing. */
  public RecordSizes() {}

  /** Returns the expected size of a delta, bits. */
  public float deltaBits() {
    return deltaBits;
  }

  /** Returns the expected size of an absolute record, bits. */
  public float absoluteBits() {
    return absoluteBits;
  }

  /** Returns the size of a record that says "gone" or "out of sight", bits. */
  public float farewellBits() {
    return FAREWELL_BITS;
  }

  /** Takes the size of an absolute record that was written. */
  public void wroteAbsolute(int bits) {
    absoluteBits += (bits - absoluteBits) * NEW_SHARE;
  }

  /** Takes the size of a run of deltas that was written. */
  public void wroteRun(int deltas, int bits) {
    deltaBits += ((float) bits / deltas - deltaBits) * Math.min(1, deltas * NEW_SHARE);
  }
}
