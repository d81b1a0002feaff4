package carom.sim.pool;

import java.util.Arrays;

/** The hashes of a client's particles after the first tick of each of the last periods. */
final class PeriodHashes {
  private final int[] periods = new int[OrderLog.KEPT];
  private final int[] hashes = new int[OrderLog.KEPT];

  PeriodHashes() {
    forget();
  }

  void forget() {
    Arrays.fill(periods, -1);
  }

  void put(int period, int hash) {
    int at = period & OrderLog.KEPT - 1;
    periods[at] = period;
    hashes[at] = hash;
  }

  /** Returns whether the hash of a period is known and isn't the one that the server told. */
  boolean differs(int period, int told) {
    int at = period & OrderLog.KEPT - 1;
    return periods[at] == period && hashes[at] != told;
  }
}
