package carom.lab.measure;

/**
 * An engine or a method with its set-up, which the benchmark measures.
 *
 * @param engine {@code carom}, another engine's name, or a method like {@code kd_rebuild}
 * @param kernels {@code vector} or {@code scalar} for the solver of Carom, else empty
 * @param threads number of threads that step the world
 */
public record Entrant(String engine, String kernels, int threads) {
  /** Prefix of the names of methods that no server or client uses. */
  private static final String LAB = "lab_";

  /** The engine of this project, as {@link #engine}. */
  public static final String CAROM = "carom";

  /** Returns an entrant without kernels, with one thread. */
  public static Entrant of(String engine) {
    return new Entrant(engine, "", 1);
  }

  /** Returns whether this is a method that no server or client uses. */
  public boolean isLab() {
    return engine.startsWith(LAB);
  }

  /** Returns whether this is Carom in any set-up. */
  public boolean isCarom() {
    return engine.equals(CAROM);
  }

  /** Returns the text for tables, like {@code carom vector x2}. */
  @Override
  public String toString() {
    return engine + (kernels.isEmpty() ? "" : " " + kernels) + (threads == 1 ? "" : " x" + threads);
  }
}
