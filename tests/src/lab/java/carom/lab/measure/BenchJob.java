package carom.lab.measure;

import java.util.ArrayList;
import java.util.List;

/** A piece of work to measure: one {@code scene} of the table, done by several entrants. */
public interface BenchJob {
  /** Returns the name in flags and tables, small letters, digits and underscores. */
  String name();

  /**
   * Returns the entrants of this job. The others' times are compared with that of the first.
   *
   * @param wanted the choice of the flags
   */
  List<Entrant> entrants(Choice wanted);

  /** Returns whether an entrant must end with the same hash as the first entrant. */
  default boolean mustAgree(Entrant entrant) {
    return entrant.isCarom();
  }

  /**
   * Measures an entrant in this process.
   *
   * @param entrant one of {@link #entrants}
   * @param measurement how long to measure
   * @throws UnsupportedOperationException if the engine lacks something
   */
  BenchRow run(Entrant entrant, Measurement measurement);

  /**
   * The choice of entrants by the flags.
   *
   * @param kernels kernels of the solver: {@code vector}, {@code scalar}
   * @param threads numbers of threads, ascending
   * @param peers names of other engines
   */
  record Choice(List<String> kernels, List<Integer> threads, List<String> peers) {
    /** Returns Carom with each kernel and number of threads, one thread first. */
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
