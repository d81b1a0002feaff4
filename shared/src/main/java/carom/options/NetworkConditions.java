package carom.options;

import carom.net.transport.Impairment;
import java.util.Locale;
import picocli.CommandLine.Option;

/**
 * Flags of every program that simulate a bad network: {@code --network NAME} chooses a preset, and
 * the other flags change single conditions of it. All conditions hold for each direction of each
 * link. Equal seed and traffic give each datagram the same fate.
 */
public final class NetworkConditions {
  private static final double MAX_DELAY_MS = 10_000;
  private static final double MAX_BURST = 1_000;
  private static final double MAX_KBIT = 1_000_000;

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

  @Option(
      names = "--network",
      paramLabel = "NAME",
      description = {
        "Simulate a bad network on every link, each way: ${COMPLETION-CANDIDATES} (none).",
        "The flags that follow change single conditions of it."
      })
  private Preset preset = Preset.NONE;

  @Option(
      names = "--loss",
      paramLabel = "PERCENT",
      description = "Drop this share of the datagrams, 0..100.")
  private Double loss;

  @Option(
      names = "--burst",
      paramLabel = "N",
      description = "Lose that many datagrams in a row on average, 1..1000.")
  private Double burst;

  @Option(
      names = "--latency",
      paramLabel = "MS",
      description = "Delay everything by this, 0..10000.")
  private Double latency;

  @Option(
      names = "--jitter",
      paramLabel = "MS",
      description = "Vary the delay by plus or minus this, 0..10000.")
  private Double jitter;

  @Option(
      names = "--reorder",
      paramLabel = "PERCENT",
      description = "Hold back this share of the datagrams, so that others overtake, 0..100.")
  private Double reorder;

  @Option(
      names = "--duplicate",
      paramLabel = "PERCENT",
      description = "Deliver this share of the datagrams twice, 0..100.")
  private Double duplicate;

  @Option(
      names = "--bandwidth",
      paramLabel = "KBIT",
      description = "Carry that many kbit/s, 1..1000000; 0 = any amount.")
  private Double bandwidth;

  @Option(
      names = "--network-seed",
      paramLabel = "N",
      description = "Start of the bad network's random numbers (${DEFAULT-VALUE}).",
      defaultValue = "1")
  private long seed = 1;

  /** Creates the default flags, which the command line then fills in. */
  public NetworkConditions() {}

  /**
   * Returns what is wrong with the flags, in words that name flag, value and range, or null if
   * nothing is wrong.
   */
  public String problem() {
    String[] problems = {
      outside("--loss", loss, 0, 100),
      outside("--burst", burst, 1, MAX_BURST),
      outside("--latency", latency, 0, MAX_DELAY_MS),
      outside("--jitter", jitter, 0, MAX_DELAY_MS),
      outside("--reorder", reorder, 0, 100),
      outside("--duplicate", duplicate, 0, 100),
      bandwidth != null && bandwidth == 0 ? null : outside("--bandwidth", bandwidth, 1, MAX_KBIT)
    };
    for (String problem : problems) {
      if (problem != null) {
        return problem;
      }
    }
    return null;
  }

  private static String outside(String flag, Double value, double min, double max) {
    return value == null || (value >= min && value <= max)
        ? null
        : String.format(Locale.ROOT, "%s=%s is outside %.0f..%.0f", flag, value, min, max);
  }

  /**
   * Returns the requested network, or {@link Impairment#NONE} with the seed if the flags request
   * none.
   *
   * @throws IllegalArgumentException when there is a {@link #problem}
   */
  public Impairment impairment() {
    Impairment base = preset.impairment();
    return base.withSeed(seed)
        .withBursts(or(loss, base.lossPercent()), or(burst, base.burst()))
        .withLatency(or(latency, base.latencyMs()), or(jitter, base.jitterMs()))
        .withReorder(or(reorder, base.reorderPercent()), or(duplicate, base.duplicatePercent()))
        .withBandwidth(or(bandwidth, base.bandwidthKbit()));
  }

  /** Returns whether the flags request any impairment. */
  public boolean isBad() {
    Impairment asked = impairment();
    return !asked.equals(Impairment.NONE.withSeed(seed).withBursts(0, asked.burst()));
  }

  private static double or(Double value, double otherwise) {
    return value == null ? otherwise : value;
  }
}
