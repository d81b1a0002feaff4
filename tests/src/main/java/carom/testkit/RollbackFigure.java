package carom.testkit;

import carom.client.prediction.Prediction;
import carom.sim.Simulation;
import java.lang.management.ManagementFactory;
import java.util.Arrays;

/**
 * What the dearest correction costs: a client is told the exact state of its whole island at a tick
 * some ticks ago, returns to it, takes everything over, and computes as many ticks again. The
 * client's own {@link Prediction} does it, whose hash must then be the server's.
 */
public final class RollbackFigure {
  private static final int SETTLING_TICKS = 60;

  /**
   * A measurement.
   *
   * @param bodies of the island, the own one included
   * @param ticks computed again, each time
   * @param contacts of the island at the end
   * @param medianMs CPU time of one correction, restore included
   * @param p95Ms CPU time that 95 % of the corrections stay below
   * @param exact corrections after which the client had the server's state in every bit
   * @param corrections how many were measured
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
   * Measures on the calling thread, by its CPU time.
   *
   * @param bodies of the island: a multiple of 20, at most 240, and the own one
   * @param ticks to compute again, 1..100
   * @param warmUp corrections before those that are measured
   * @param corrections how many are measured, at least 1
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

  /** Prints one line; arguments: bodies, ticks, corrections. */
  public static void main(String[] args) {
    int[] n = {200, 24, 300};
    for (int i = 0; i < Math.min(args.length, n.length); i++) {
      n[i] = Integer.parseInt(args[i]);
    }
    System.out.println(measure(n[0], n[1], n[2], n[2]));
  }
}
