package carom.client.stats;

/**
 * Share of lost snapshot datagrams among the last {@value #SIZE}. Reads the acknowledgements as the
 * client sends them. One thread; allocates nothing.
 */
final class LossWindow {
  /** Datagrams that count; a power of two. */
  static final int SIZE = 256;

  /** A datagram that is missing so many sequence numbers later counts as lost. */
  private static final int SETTLED = 16;

  private final boolean[] received = new boolean[SIZE];
  private boolean started;
  private int settled;
  private int count;

  /** Number of lost ones among those that count. */
  private int lost;

  /** Forgets everything: another link numbers its datagrams anew. */
  void reset() {
    started = false;
    count = 0;
    lost = 0;
  }

  /**
   * Takes in the newest acknowledgement.
   *
   * @param sequence newest datagram received
   * @param bits bit n is set if datagram {@code sequence - 1 - n} was received
   */
  void acks(int sequence, long bits) {
    if (!started) {
      started = true;
      settled = sequence - 1;
      return;
    }
    int ahead = (short) (sequence - SETTLED - settled);
    for (int i = 0; i < ahead; i++) {
      settled++;
      int age = (short) (sequence - settled) - 1;
      boolean arrived = age < 64 && (bits >>> age & 1) != 0;
      int at = count & (SIZE - 1);
      lost += (arrived ? 0 : 1) - (count < SIZE || received[at] ? 0 : 1);
      received[at] = arrived;
      count++;
    }
  }

  /** Returns the share of lost datagrams, percent; 0 before the first. */
  double percent() {
    int considered = Math.min(count, SIZE);
    return considered == 0 ? 0 : 100.0 * lost / considered;
  }
}
