package carom.net.codec;

/**
 * Arithmetic of 16-bit numbers that wrap, such as the sequence numbers of datagrams and the low
 * bits of ticks.
 */
public final class Sequence {

  private Sequence() {}

  /** Returns the successor of a sequence number. */
  public static int next(int sequence) {
    return (sequence + 1) & 0xffff;
  }

  /** Returns how far {@code a} is ahead of {@code b}, -32,768..32,767. */
  public static int difference(int a, int b) {
    return (short) (a - b);
  }

  /** Returns whether {@code a} is newer than {@code b}. */
  public static boolean isNewer(int a, int b) {
    return difference(a, b) > 0;
  }

  /**
   * Returns the full number that is nearest to {@code near} and has the low 16 bits {@code low}.
   */
  public static int expand(int low, int near) {
    return near + (short) (low - near);
  }
}
