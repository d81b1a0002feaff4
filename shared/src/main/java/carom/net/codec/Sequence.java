package carom.net.codec;

/** Arithmetic of 16-bit numbers that wrap: sequence numbers of datagrams, low bits of ticks. */
public final class Sequence {

  private Sequence() {}

  /** The number after this one. */
  public static int next(int sequence) {
    return (sequence + 1) & 0xffff;
  }

  /** How far {@code a} is ahead of {@code b}: -32,768..32,767. */
  public static int difference(int a, int b) {
    return (short) (a - b);
  }

  /** Whether {@code a} is newer than {@code b}. */
  public static boolean isNewer(int a, int b) {
    return difference(a, b) > 0;
  }

  /** The full number nearest to {@code near} whose low 16 bits are {@code low}. */
  public static int expand(int low, int near) {
    return near + (short) (low - near);
  }
}
