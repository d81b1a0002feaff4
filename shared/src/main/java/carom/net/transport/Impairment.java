package carom.net.transport;

/**
 * How bad a network is, per direction. Immutable; build one with {@code
 * Impairment.NONE.withLoss(2).withLatency(50, 10)}.
 *
 * @param seed same seed, same traffic and same clock give the same fate for each datagram
 * @param lossPercent 0..100, share of datagrams that never arrive
 * @param burst mean number of datagrams lost in a row, at least 1; 1 = each on its own
 * @param latencyMs one-way delay, milliseconds
 * @param jitterMs one-way delay varies evenly by plus or minus this, milliseconds, never below zero
 * @param jitterReorders whether jitter may let a datagram overtake another; reliable messages never
 *     overtake
 * @param reorderPercent 0..100, share of datagrams that are held back by twice the jitter, at least
 *     25 ms, so that later ones overtake them
 * @param duplicatePercent 0..100, share of datagrams that arrive twice
 * @param bandwidthKbit what the line carries, kbit/s, 1..1,000,000, headers included; 0 = any
 *     amount. What comes faster waits in front of the line, and a datagram that would wait longer
 *     than {@value Lane#MAX_QUEUE_MS} ms is lost
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

  /** Checks the ranges. */
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
  public static final Impairment NONE = new Impairment(1, 0, 1, 0, 0, true, 0, 0, 0);

  /** This, with another seed. */
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

  /** This, with loss of single datagrams. */
  public Impairment withLoss(double lossPercent) {
    return withBursts(lossPercent, 1);
  }

  /** This, with loss in bursts of {@code burst} datagrams on average. */
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

  /** This, with a one-way delay of {@code latencyMs} plus or minus {@code jitterMs}. */
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

  /** This, with or without overtaking by jitter. */
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

  /** This, with reordering and duplicates. */
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

  /** This, over a line that carries {@code bandwidthKbit} kbit/s; 0 = any amount. */
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
