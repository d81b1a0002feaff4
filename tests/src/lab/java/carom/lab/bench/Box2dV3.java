package carom.lab.bench;

import carom.lab.measure.BenchRow;
import java.util.Locale;
import java.util.Map;

/**
 * Compares times with Box2D v3, which doesn't run on a JVM. The comparison goes through engines
 * that were measured beside v3 on one machine (AVX2, one thread, CPU time, the same scenes).
 */
final class Box2dV3 {
  /** The times of other engines as multiples of v3's. */
  private record Factor(double gdx, double jbox2d) {}

  private static final Map<String, Factor> FACTORS =
      Map.of(
          "large_pyramid", new Factor(6.9, 17),
          "many_pyramids", new Factor(5.5, 18),
          "tumbler", new Factor(3.3, 9.7),
          "pile_2k", new Factor(6.0, 29),
          "pile_10k", new Factor(6.9, 31),
          "joint_grid", new Factor(1.6, 7.2),
          "smash", new Factor(6.9, 15),
          "gas_1k", new Factor(1.5, 7.1),
          "gas_10k", new Factor(1.2, 7.4),
          "gas_50k", new Factor(4.2, 8.6));

  private Box2dV3() {}

  /**
   * Returns a row's time as a multiple of v3's, carried over by the other engines' rows of the same
   * run.
   *
   * @param row of Carom, with ratios
   * @return for instance {@code 0.83 by gdx-box2d, 0.71 by jbox2d}; empty if it can't be told
   */
  static String multiple(BenchRow row) {
    Factor factor = FACTORS.get(row.scene());
    if (factor == null) {
      return "";
    }
    String gdx = by("gdx-box2d", factor.gdx, row);
    String jbox2d = by("jbox2d", factor.jbox2d, row);
    return gdx + (gdx.isEmpty() || jbox2d.isEmpty() ? "" : ", ") + jbox2d;
  }

  private static String by(String engine, double factor, BenchRow row) {
    Double ratio = row.ratios().get(engine);
    return ratio == null ? "" : String.format(Locale.ROOT, "%.2f by %s", factor / ratio, engine);
  }
}
