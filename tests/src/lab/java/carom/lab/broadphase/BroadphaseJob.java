package carom.lab.broadphase;

import carom.lab.broadphase.BroadphaseBench.Method;
import carom.lab.measure.BenchJob;
import carom.lab.measure.BenchRow;
import carom.lab.measure.Entrant;
import carom.lab.measure.Measurement;
import carom.lab.measure.Times;
import java.util.ArrayList;
import java.util.List;

/**
 * The job that measures broadphase structures alone: all boxes move, and the structure reports
 * every overlapping pair. The row with the engine's name is its tree; {@link PairSearchJob}
 * measures the engine's own search.
 *
 * @param name like {@code bp_uniform_10k}
 * @param boxes how many
 * @param clustered whether nine in ten of them are in a hundredth of the area
 */
public record BroadphaseJob(String name, int boxes, boolean clustered) implements BenchJob {
  private static final int[] THOUSANDS = {1, 10, 100, 1000};

  /** Most boxes of the brute-force row. Testing all pairs of 100,000 boxes takes a second. */
  private static final int MOST_BRUTE = 10_000;

  /** Returns all jobs of this kind in the order of the table. */
  public static List<BenchJob> all() {
    List<BenchJob> jobs = new ArrayList<>();
    for (boolean clustered : new boolean[] {false, true}) {
      for (int k : THOUSANDS) {
        String size = k == 1000 ? "1m" : k + "k";
        String name = "bp" + (clustered ? "_clustered_" : "_uniform_") + size;
        jobs.add(new BroadphaseJob(name, 1000 * k, clustered));
      }
    }
    return jobs;
  }

  /** Returns the entrants: first the engine's tree, under the engine's name. */
  @Override
  public List<Entrant> entrants(Choice wanted) {
    List<Entrant> all = new ArrayList<>();
    all.add(Entrant.of(Entrant.CAROM));
    for (Method method : Method.values()) {
      if (method != Method.KD_REFIT && (method != Method.BRUTE_FORCE || boxes <= MOST_BRUTE)) {
        all.add(Entrant.of(method.toString()));
      }
    }
    return all;
  }

  /** Returns true, because all structures must find the same pairs. */
  @Override
  public boolean mustAgree(Entrant entrant) {
    return true;
  }

  @Override
  public BenchRow run(Entrant entrant, Measurement measurement) {
    Method method = Method.KD_REFIT;
    for (Method each : Method.values()) {
      method = each.toString().equals(entrant.engine()) ? each : method;
    }
    BroadphaseBench.Row row =
        BroadphaseBench.run(
            method, boxes, clustered, measurement.warmUpSeconds(), measurement.turns()::pass);
    double msPerNs = boxes * 1e-6;
    double median = row.sumNs() * msPerNs;
    Times times =
        new Times(row.ticks(), median, row.p99Ns() * msPerNs, Double.NaN, row.allocatedBytes());
    return BenchRow.of(name, entrant, boxes, times).withHash(row.hash());
  }
}
