package carom.net.transport;

import carom.values.Records;

/**
 * How bad a network is, per direction. Immutable; start from {@link #NONE}, as in {@code
 * Impairment.NONE.withLoss(2).withLatency(50, 10)}.
 *
 * @param seed start of the random numbers; the same seed, traffic and clock give the same fate for
 *     each datagram
 * @param lossPercent share of datagrams that never arrive, 0..100
 * @param burst mean number of datagrams lost in a row, 1..10,000; 1 = each on its own
 * @param latencyMs one-way delay, 0..60,000 ms
 * @param jitterMs the one-way delay varies evenly by plus or minus this, 0..60,000 ms; it is never
 *     below zero
 * @param jitterReorders whether jitter may let a datagram overtake another; reliable messages never
 *     overtake
 * @param reorderPercent share of datagrams that are held back by twice the jitter, at least 25 ms,
 *     so that later ones overtake them, 0..100
 * @param duplicatePercent share of datagrams that arrive twice, 0..100
 * @param bandwidthKbit bandwidth of the line, 1..1,000,000 kbit/s, headers included; 0 = any.
 *     Faster traffic waits in front of the line, and a datagram that would wait longer than {@value
 *     Lane#MAX_QUEUE_MS} ms is lost
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
   * @throws IllegalArgumentException names value and range
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

  /** A perfect network. */
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

  /** Returns a copy with this seed. */
  public Impairment withSeed(long seed) {
    return Records.with(this, "seed", seed);
  }

  /** Returns a copy that loses single datagrams. */
  public Impairment withLoss(double lossPercent) {
    return withBursts(lossPercent, 1);
  }

  /** Returns a copy that loses datagrams in bursts of {@code burst} on average. */
  public Impairment withBursts(double lossPercent, double burst) {
    return Records.with(this, "lossPercent", lossPercent, "burst", burst);
  }

  /** Returns a copy with a one-way delay of {@code latencyMs} plus or minus {@code jitterMs}. */
  public Impairment withLatency(double latencyMs, double jitterMs) {
    return Records.with(this, "latencyMs", latencyMs, "jitterMs", jitterMs);
  }

  /** Returns a copy in which jitter may let a datagram overtake another, or not. */
  public Impairment withJitterReorders(boolean jitterReorders) {
    return Records.with(this, "jitterReorders", jitterReorders);
  }

  /** Returns a copy that reorders and duplicates datagrams. */
  public Impairment withReorder(double reorderPercent, double duplicatePercent) {
    return Records.with(
        this, "reorderPercent", reorderPercent, "duplicatePercent", duplicatePercent);
  }

  /** Returns a copy over a line of this bandwidth, kbit/s; 0 = any. */
  public Impairment withBandwidth(double bandwidthKbit) {
    return Records.with(this, "bandwidthKbit", bandwidthKbit);
  }

  private static void check(String name, double value, double min, double max) {
    if (!(value >= min && value <= max)) {
      throw new IllegalArgumentException(name + "=" + value + " is outside " + min + ".." + max);
    }
  }
}
