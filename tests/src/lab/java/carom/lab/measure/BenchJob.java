package carom.lab.measure;

import java.util.ArrayList;
import java.util.List;

/** Something to measure: one {@code scene} of the table, done by several entrants. */
public interface BenchJob {
  /** Returns the name in flags and tables, small letters, digits and underscores. */
  String name();

  /**
   * Who can do it; the first one's time is what the others' are compared with.
   *
   * @param wanted what the flags ask for
   */
  List<Entrant> entrants(Choice wanted);

  /** Returns whether an entrant must end with the very hash of the first one. */
  default boolean mustAgree(Entrant entrant) {
    return entrant.isCarom();
  }

  /**
   * Measures it in this process.
   *
   * @param entrant one of {@link #entrants}
   * @param measurement how long
   * @throws UnsupportedOperationException if the engine lacks something
   */
  BenchRow run(Entrant entrant, Measurement measurement);

  /**
   * What the flags ask for.
   *
   * @param kernels of the solver: {@code vector}, {@code scalar}
   * @param threads numbers of threads, ascending
   * @param peers other engines by name
   */
  record Choice(List<String> kernels, List<Integer> threads, List<String> peers) {
    /** Carom with each kernel and number of threads, one thread first. */
    public List<Entrant> carom() {
      List<Entrant> all = new ArrayList<>();
      for (String kernel : kernels) {
        for (int count : threads) {
          all.add(new Entrant(Entrant.CAROM, kernel, count));
        }
      }
      return all;
    }
  }
}
