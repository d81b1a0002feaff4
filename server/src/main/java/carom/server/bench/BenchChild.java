package carom.server.bench;

import java.io.PrintStream;
import java.util.ArrayList;
import java.util.List;
import java.util.ServiceLoader;

/**
 * The process in which one engine is measured on one scene: what another engine compiled or
 * collected never matters. Its last line of standard output is the row.
 */
final class BenchChild {
  private BenchChild() {}

  /**
   * Measures.
   *
   * @param args engine, kernels, job, seconds of warm-up, seconds of the cap, whether quick
   */
  public static void main(String[] args) {
    String engine = args[0];
    String kernels = args[1];
    BenchJob job = BenchJob.of(args[2]);
    Measurement measurement =
        new Measurement(Double.parseDouble(args[3]), Double.parseDouble(args[4]));
    boolean quick = Boolean.parseBoolean(args[5]);
    PrintStream out = System.out;
    BenchRow row;
    try {
      row = job.run(engine, kernels, measurement, quick);
    } catch (UnsupportedOperationException e) {
      row = BenchRow.failed(job.name(), engine, kernels, "not possible: " + e.getMessage());
    }
    out.println();
    out.println(row.toJson());
    out.flush();
  }

  /** The names of the other engines on the class path, sorted. */
  static List<String> peers() {
    List<String> names = new ArrayList<>();
    ServiceLoader.load(BenchEngine.class).forEach(peer -> names.add(peer.name()));
    names.sort(null);
    return names;
  }

  /**
   * The engine of a name.
   *
   * @throws IllegalArgumentException if it isn't on the class path
   */
  static BenchEngine engine(String name) {
    if (name.equals(CaromEngine.NAME)) {
      return new CaromEngine();
    }
    for (BenchEngine peer : ServiceLoader.load(BenchEngine.class)) {
      if (peer.name().equals(name)) {
        return peer;
      }
    }
    throw new IllegalArgumentException("unknown engine=" + name);
  }
}
