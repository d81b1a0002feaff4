package carom.lab.measure;

/**
 * Who is measured: an engine or a method, and how it was set up.
 *
 * @param engine {@code carom}, another engine's name, or a method like {@code kd_rebuild}
 * @param kernels {@code vector} or {@code scalar} for the solver of Carom, else empty
 * @param threads how many threads step the world
 */
public record Entrant(String engine, String kernels, int threads) {
  /** What the names of methods begin with that no server or client uses. */
  private static final String LAB = "lab_";

  /** The engine of this project, as {@link #engine}. */
  public static final String CAROM = "carom";

  /** Returns an engine or a method that knows neither kernels nor threads. */
  public static Entrant of(String engine) {
    return new Entrant(engine, "", 1);
  }

  /** Returns whether it is a method that no server or client uses. */
  public boolean isLab() {
    return engine.startsWith(LAB);
  }

  /** Returns whether it is Carom, however set up. */
  public boolean isCarom() {
    return engine.equals(CAROM);
  }

  /** As tables have it: {@code carom vector x2}. */
  @Override
  public String toString() {
    return engine + (kernels.isEmpty() ? "" : " " + kernels) + (threads == 1 ? "" : " x" + threads);
  }
}
