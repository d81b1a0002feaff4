package carom.net.protocol;

/**
 * The first four bits of each datagram: one says whether it carries messages of the game, three are
 * its <i>epoch</i>. An epoch is a link's number of a {@link ServerMessage.Welcome}, modulo 8. It
 * distinguishes datagrams of a match from late ones of the match or room before. It is no secret:
 * sealed frames keep strangers out.
 */
public final class DatagramMark {
  /** Number of bits, the lowest ones of the first byte. */
  public static final int BITS = 4;

  /** Largest epoch. */
  public static final int LAST_EPOCH = 7;

  private static final int MESSAGES = 1;

  private DatagramMark() {}

  /** Returns the epoch after another one: 0..7. */
  public static int nextEpoch(int epoch) {
    return (epoch + 1) & LAST_EPOCH;
  }

  /** Returns whether a number is an epoch. */
  public static boolean isEpoch(int epoch) {
    return epoch >= 0 && epoch <= LAST_EPOCH;
  }

  /**
   * Returns an epoch that is certain to be one.
   *
   * @throws IllegalArgumentException when it is outside 0..7
   */
  public static int checkedEpoch(int epoch) {
    if (!isEpoch(epoch)) {
      throw new IllegalArgumentException("epoch=" + epoch + " is outside 0.." + LAST_EPOCH);
    }
    return epoch;
  }

  /** Returns the mark of inputs and snapshots. */
  public static int ofState(int epoch) {
    return checkedEpoch(epoch) << 1;
  }

  /** Returns the mark of unreliable messages. */
  public static int ofMessages(int epoch) {
    return checkedEpoch(epoch) << 1 | MESSAGES;
  }
}
