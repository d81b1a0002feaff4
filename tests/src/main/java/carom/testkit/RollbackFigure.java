package carom.testkit;

import carom.client.prediction.Prediction;
import carom.sim.Simulation;
import java.lang.management.ManagementFactory;
import java.util.Arrays;

/**
 * Measures the most expensive correction. The client receives the exact state of its whole island
 * at a past tick, restores that tick, takes the state over, and resimulates the ticks since. The
 * client's own {@link Prediction} does this; its hash must then equal the server's.
 */
public final class RollbackFigure {
  private static final int SETTLING_TICKS = 60;

  /**
   * The result of a measurement.
   *
   * @param bodies number of bodies of the island, the player's included
   * @param ticks number of ticks that each correction resimulates
   * @param contacts number of contacts of the island at the end
   * @param medianMs median CPU time of a correction, restore included, ms
   * @param p95Ms 95th percentile of that time, ms
   * @param exact number of corrections after which the client had the server's state in every bit
   * @param corrections number of corrections measured
   */
  public record Result(
      int bodies,
      int ticks,
      int contacts,
      double medianMs,
      double p95Ms,
      int exact,
      int corrections) {}

  private RollbackFigure() {}

  /**
   * Measures corrections by the CPU time of the calling thread.
   *
   * @param bodies number of crates of the island, rounded down to a multiple of 20, at most 240
   * @param ticks number of ticks to resimulate, 1..100
   * @param warmUp number of corrections before those that are measured
   * @param corrections number of corrections to measure, at least 1
   */
  public static Result measure(int bodies, int ticks, int warmUp, int corrections) {
    var threads = ManagementFactory.getThreadMXBean();
    int crates = bodies / IslandRig.COLUMNS * IslandRig.COLUMNS;
    IslandRig rig = new IslandRig(crates, 1L << 40, threads::getCurrentThreadCpuTime);
    Simulation server = rig.server();
    Prediction client = rig.client();
    for (int i = 0; i < SETTLING_TICKS; i++) {
      server.step();
    }
    rig.tellAll();
    for (int i = 0; i < ticks; i++) {
      client.step(server.tick() + i + 1, 0);
    }
    long[] ns = new long[corrections];
    int exact = 0;
    for (int i = -warmUp; i < corrections; i++) {
      server.step();
      client.step(server.tick() + ticks, 0);
      exact += rig.tellAll() && i >= 0 ? 1 : 0;
      if (client.result().replayedTicks() != ticks || client.replaysCutShort() > 0) {
        throw new IllegalStateException(
            "replayed="
                + client.result().replayedTicks()
                + " must be ticks="
                + ticks
                + " bounds are too tight");
      }
      if (i >= 0) {
        ns[i] = client.result().replayNs();
      }
    }
    Arrays.sort(ns);
    return new Result(
        rig.island().count(),
        ticks,
        rig.island().rows().contacts().count(),
        ns[corrections / 2] / 1e6,
        ns[corrections * 95 / 100] / 1e6,
        exact,
        corrections);
  }

  /** Measures and prints one line. The arguments are bodies, ticks and corrections. */
  public static void main(String[] args) {
    int[] n = {200, 24, 300};
    for (int i = 0; i < Math.min(args.length, n.length); i++) {
      n[i] = Integer.parseInt(args[i]);
    }
    System.out.println(measure(n[0], n[1], n[2], n[2]));
  }
}
