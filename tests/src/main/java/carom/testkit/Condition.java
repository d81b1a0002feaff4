package carom.testkit;

import carom.net.transport.Impairment;

/** The networks every scenario should survive; delays are one way, losses in both directions. */
public enum Condition {
  /** Nothing is lost, nothing takes time. */
  CLEAN(Impairment.NONE),
  /** An ordinary wireless network. */
  LOSS_2_PERCENT(Impairment.NONE.withLoss(2)),
  /** A bad one. */
  LOSS_10_PERCENT(Impairment.NONE.withLoss(10)),
  /** Almost a third lost, ten datagrams in a row. */
  BURSTS_30_PERCENT(Impairment.NONE.withBursts(30, 10)),
  /** Far and wobbling: datagrams overtake each other. */
  LATENCY_100_JITTER_50(Impairment.NONE.withLatency(100, 50)),
  /** The other side of the world, and back through a satellite. */
  LATENCY_300(Impairment.NONE.withLatency(300, 0)),
  /** A fifth of the datagrams is overtaken. */
  REORDER_20_PERCENT(Impairment.NONE.withLatency(30, 10).withReorder(20, 0)),
  /** A fifth of the datagrams comes twice. */
  DUPLICATES_20_PERCENT(Impairment.NONE.withLatency(30, 10).withReorder(0, 20)),
  /** Clean but for one second without any datagram; see {@link #hasBlackout}. */
  BLACKOUT_1_S(Impairment.NONE.withLatency(20, 0)),
  /** A bit of everything. */
  MIXED(Impairment.NONE.withBursts(10, 5).withLatency(60, 30).withReorder(5, 5));

  private final Impairment impairment;

  Condition(Impairment impairment) {
    this.impairment = impairment;
  }

  /** Returns the impairment, with a seed. */
  public Impairment impairment(long seed) {
    return impairment.withSeed(seed);
  }

  /** Returns whether the scenario should call {@link SimulatedClient#blackout} once. */
  public boolean hasBlackout() {
    return this == BLACKOUT_1_S;
  }
}
