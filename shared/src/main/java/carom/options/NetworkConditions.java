package carom.options;

import carom.net.transport.Impairment;
import java.util.Locale;

/**
 * Flags of every program that simulate a bad network: {@code --network NAME} chooses a preset, and
 * the other flags change single conditions of it. All conditions hold for each direction of each
 * link. Equal seed and traffic give each datagram the same fate.
 */
public final class NetworkConditions {
  /** The flags. */
  public static final Rows ROWS = Rows.ofFlags();

  /** A typical network. Delays and losses are one way. */
  public enum Preset {
    /** The network as it is, without simulated impairment. */
    NONE(Impairment.NONE),
    /** A busy wireless network at home. */
    WIFI(
        Impairment.NONE
            .withBursts(1, 3)
            .withLatency(8, 6)
            .withReorder(0.5, 0.2)
            .withBandwidth(20_000)),
    /** A mobile phone on the move. */
    MOBILE(
        Impairment.NONE
            .withBursts(2, 4)
            .withLatency(45, 20)
            .withReorder(1, 0.5)
            .withBandwidth(2_000)),
    /** A good line from Europe to America. */
    TRANSATLANTIC(
        Impairment.NONE.withLoss(0.5).withLatency(50, 4).withReorder(0.1, 0).withBandwidth(10_000)),
    /** The worst network that a player still puts up with. */
    BAD(
        Impairment.NONE
            .withBursts(10, 5)
            .withLatency(100, 50)
            .withReorder(5, 2)
            .withBandwidth(512));

    private final Impairment impairment;

    Preset(Impairment impairment) {
      this.impairment = impairment;
    }

    /** Returns the conditions of this network, with seed 1. */
    public Impairment impairment() {
      return impairment;
    }

    @Override
    public String toString() {
      return name().toLowerCase(Locale.ROOT);
    }
  }

  static final Setting<Preset> NETWORK =
      ROWS.choice("network", "NAME", Preset.NONE)
          .text(
              "Simulate a bad network on every link, each way: {choices} ({default}). The flags"
                  + " that follow change single conditions of it.");

  static final Setting<Double> LOSS =
      ROWS.number("loss", "PERCENT", 0, 100, null)
          .text("Drop this share of the datagrams, {range}.");

  static final Setting<Double> BURST =
      ROWS.number("burst", "N", 1, 1000, null)
          .text("Lose that many datagrams in a row on average, {range}.");

  static final Setting<Double> LATENCY =
      ROWS.number("latency", "MS", 0, 10000, null).text("Delay everything by this, {range}.");

  static final Setting<Double> JITTER =
      ROWS.number("jitter", "MS", 0, 10000, null)
          .text("Vary the delay by plus or minus this, {range}.");

  static final Setting<Double> REORDER =
      ROWS.number("reorder", "PERCENT", 0, 100, null)
          .text("Hold back this share of the datagrams, so that others overtake, {range}.");

  static final Setting<Double> DUPLICATE =
      ROWS.number("duplicate", "PERCENT", 0, 100, null)
          .text("Deliver this share of the datagrams twice, {range}.");

  static final Setting<Double> BANDWIDTH =
      ROWS.number("bandwidth", "KBIT", 0, 1000000, null)
          .text("Carry that many kbit/s, 1..1000000; 0 = any amount.")
          .checked(rate -> rate > 0 && rate < 1 ? "is outside 1..1000000 kbit" : null);

  static final Setting<Long> NETWORK_SEED =
      ROWS.seed("network-seed", 1).text("Start of the bad network's random numbers ({default}).");

  private NetworkConditions() {}

  /**
   * Returns the requested network, or {@link Impairment#NONE} with the seed if the flags request
   * none.
   */
  public static Impairment impairment(Settings<?> flags) {
    Impairment base = flags.get(NETWORK).impairment();
    return base.withSeed(flags.get(NETWORK_SEED))
        .withBursts(flags.get(LOSS, base.lossPercent()), flags.get(BURST, base.burst()))
        .withLatency(flags.get(LATENCY, base.latencyMs()), flags.get(JITTER, base.jitterMs()))
        .withReorder(
            flags.get(REORDER, base.reorderPercent()),
            flags.get(DUPLICATE, base.duplicatePercent()))
        .withBandwidth(flags.get(BANDWIDTH, base.bandwidthKbit()));
  }

  /** Returns whether the flags request any impairment. */
  public static boolean isBad(Settings<?> flags) {
    Impairment asked = impairment(flags);
    return !asked.equals(Impairment.NONE.withSeed(asked.seed()).withBursts(0, asked.burst()));
  }
}
