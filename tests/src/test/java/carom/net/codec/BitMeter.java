package carom.net.codec;

/** Counts the bits of a section and stores nothing: a third pass, which only tests need. */
public final class BitMeter implements BitPass {
  private int bits;

  /** Returns the bits counted so far. */
  public int bits() {
    return bits;
  }

  @Override
  public int plain(int value, int count) {
    bits += count;
    return (int) (value & (1L << count) - 1);
  }

  @Override
  public boolean isReading() {
    return false;
  }

  @Override
  public boolean require(boolean holds) {
    if (!holds) {
      throw new AssertionError("a value that the section does not allow, after bits=" + bits);
    }
    return true;
  }
}
