package carom.lab.measure;

import carom.lab.bench.CaromEngine;

/**
 * Who is measured: an engine or a method, and how it was set up.
 *
 * @param engine {@code carom}, another engine's name, or a method like {@code kd_rebuild}
 * @param kernels {@code vector} or {@code scalar} for the solver of Carom, else empty
 * @param threads how many threads step the world
 */
record Entrant(String engine, String kernels, int threads) {
  /** An engine or a method that knows neither kernels nor threads. */
  static Entrant of(String engine) {
    return new Entrant(engine, "", 1);
  }

  boolean isCarom() {
    return engine.equals(CaromEngine.NAME);
  }

  /** As tables have it: {@code carom vector x2}. */
  @Override
  public String toString() {
    return engine + (kernels.isEmpty() ? "" : " " + kernels) + (threads == 1 ? "" : " x" + threads);
  }
}
