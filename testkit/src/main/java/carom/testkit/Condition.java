package carom.testkit;

import carom.net.transport.Impairment;

/**
 * The networks that every scenario should survive. Delays are one way, losses in both directions.
 */
public enum Condition {
  /** A perfect network: no loss, no delay. */
  CLEAN(Impairment.NONE),
  /** An ordinary wireless network. */
  LOSS_2_PERCENT(Impairment.NONE.withLoss(2)),
  /** A bad wireless network. */
  LOSS_10_PERCENT(Impairment.NONE.withLoss(10)),
  /** A network that loses 30 % of the datagrams in bursts of ten. */
  BURSTS_30_PERCENT(Impairment.NONE.withBursts(30, 10)),
  /** A distant network whose delay varies, so that datagrams overtake each other. */
  LATENCY_100_JITTER_50(Impairment.NONE.withLatency(100, 50)),
  /** A connection to the other side of the world by satellite. */
  LATENCY_300(Impairment.NONE.withLatency(300, 0)),
  /** A network on which a fifth of the datagrams is overtaken. */
  REORDER_20_PERCENT(Impairment.NONE.withLatency(30, 10).withReorder(20, 0)),
  /** A network on which a fifth of the datagrams arrives twice. */
  DUPLICATES_20_PERCENT(Impairment.NONE.withLatency(30, 10).withReorder(0, 20)),
  /** A network with a short delay and one second without any datagram; see {@link #hasBlackout}. */
  BLACKOUT_1_S(Impairment.NONE.withLatency(20, 0)),
  /** A network with bursts of losses, a varying delay, overtaking and duplicates. */
  MIXED(Impairment.NONE.withBursts(10, 5).withLatency(60, 30).withReorder(5, 5));

  private final Impairment impairment;

  Condition(Impairment impairment) {
    this.impairment = impairment;
  }

  /** Returns the impairment with a seed. */
  public Impairment impairment(long seed) {
    return impairment.withSeed(seed);
  }

  /** Returns whether the scenario should call {@link SimulatedClient#blackout} once. */
  public boolean hasBlackout() {
    return this == BLACKOUT_1_S;
  }
}
