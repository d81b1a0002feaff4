package carom.net.transport;

/**
 * Quality of a simulated network in one direction. It is immutable; start from {@link #NONE}, as in
 * {@code Impairment.NONE.withLoss(2).withLatency(50, 10)}.
 *
 * @param seed start of the random numbers; equal seed, traffic and clock give each datagram the
 *     same fate
 * @param lossPercent share of datagrams that never arrive, 0..100
 * @param burst mean number of datagrams lost in a row, 1..10,000; 1 loses each one independently
 * @param latencyMs one-way delay, 0..60,000 ms
 * @param jitterMs largest deviation of the one-way delay, uniformly distributed, 0..60,000 ms; the
 *     delay is never below zero
 * @param jitterReorders true if jitter may let a datagram overtake another; reliable messages never
 *     overtake
 * @param reorderPercent share of datagrams held back by twice the jitter, at least 25 ms, so that
 *     later ones overtake them, 0..100
 * @param duplicatePercent share of datagrams that arrive twice, 0..100
 * @param bandwidthKbit bandwidth of the line, 1..1,000,000 kbit/s, headers included; 0 is
 *     unlimited. Excess traffic queues in front of the line, and a datagram that would wait longer
 *     than {@value ImpairedDirection#MAX_QUEUE_MS} ms is lost
 */
public record Impairment(
    long seed,
    double lossPercent,
    double burst,
    double latencyMs,
    double jitterMs,
    boolean jitterReorders,
    double reorderPercent,
    double duplicatePercent,
    double bandwidthKbit) {

  /**
   * Checks the ranges.
   *
   * @throws IllegalArgumentException when a value is outside its range; the message names value and
   *     range
   */
  public Impairment {
    check("lossPercent", lossPercent, 0, 100);
    check("burst", burst, 1, 10_000);
    check("latencyMs", latencyMs, 0, 60_000);
    check("jitterMs", jitterMs, 0, 60_000);
    check("reorderPercent", reorderPercent, 0, 100);
    check("duplicatePercent", duplicatePercent, 0, 100);
    if (bandwidthKbit != 0) {
      check("bandwidthKbit", bandwidthKbit, 1, 1_000_000);
    }
  }

  /** Impairment of a perfect network. */
  public static final Impairment NONE =
      new Impairment(
          /* seed= */ 1,
          /* lossPercent= */ 0,
          /* burst= */ 1,
          /* latencyMs= */ 0,
          /* jitterMs= */ 0,
          /* jitterReorders= */ true,
          /* reorderPercent= */ 0,
          /* duplicatePercent= */ 0,
          /* bandwidthKbit= */ 0);

  /** Returns whether it leaves a perfect network as it is, whatever its seed. */
  public boolean isNone() {
    return withSeed(NONE.seed).equals(NONE);
  }

  /** Returns a copy with another seed. */
  public Impairment withSeed(long seed) {
    return new Impairment(
        seed,
        lossPercent,
        burst,
        latencyMs,
        jitterMs,
        jitterReorders,
        reorderPercent,
        duplicatePercent,
        bandwidthKbit);
  }

  /** Returns a copy that loses datagrams independently of each other. */
  public Impairment withLoss(double lossPercent) {
    return withBursts(lossPercent, 1);
  }

  /** Returns a copy that loses datagrams in bursts of {@code burst} datagrams on average. */
  public Impairment withBursts(double lossPercent, double burst) {
    return new Impairment(
        seed,
        lossPercent,
        burst,
        latencyMs,
        jitterMs,
        jitterReorders,
        reorderPercent,
        duplicatePercent,
        bandwidthKbit);
  }

  /** Returns a copy with a one-way delay of {@code latencyMs} plus or minus {@code jitterMs}. */
  public Impairment withLatency(double latencyMs, double jitterMs) {
    return new Impairment(
        seed,
        lossPercent,
        burst,
        latencyMs,
        jitterMs,
        jitterReorders,
        reorderPercent,
        duplicatePercent,
        bandwidthKbit);
  }

  /** Returns a copy in which jitter may, or may not, let a datagram overtake another. */
  public Impairment withJitterReorders(boolean jitterReorders) {
    return new Impairment(
        seed,
        lossPercent,
        burst,
        latencyMs,
        jitterMs,
        jitterReorders,
        reorderPercent,
        duplicatePercent,
        bandwidthKbit);
  }

  /** Returns a copy that reorders and duplicates datagrams. */
  public Impairment withReorder(double reorderPercent, double duplicatePercent) {
    return new Impairment(
        seed,
        lossPercent,
        burst,
        latencyMs,
        jitterMs,
        jitterReorders,
        reorderPercent,
        duplicatePercent,
        bandwidthKbit);
  }

  /** Returns a copy with a line of this bandwidth, kbit/s; 0 is unlimited. */
  public Impairment withBandwidth(double bandwidthKbit) {
    return new Impairment(
        seed,
        lossPercent,
        burst,
        latencyMs,
        jitterMs,
        jitterReorders,
        reorderPercent,
        duplicatePercent,
        bandwidthKbit);
  }

  private static void check(String name, double value, double min, double max) {
    if (!(value >= min && value <= max)) {
      throw new IllegalArgumentException(name + "=" + value + " is outside " + min + ".." + max);
    }
  }
}
