package carom.testkit;

import carom.sim.level.Level;
import carom.sim.level.LevelException;
import java.nio.charset.StandardCharsets;
import java.util.Locale;
import java.util.SplittableRandom;

/** Builds arena levels with many crates. */
public final class BigWorlds {
  private static final int IN_A_ROW = 10;
  private static final double ROW_METRES = 1.8;

  private BigWorlds() {}

  /**
   * Returns a level with rows of ten crates. Each row has a random place and angle; no crates
   * touch.
   *
   * @param crates number of crates, a multiple of ten
   * @param halfWidth half width of the arena, m; the crates keep clear of the middle
   */
  public static Level crates(int crates, int halfWidth, long seed) {
    SplittableRandom random = new SplittableRandom(seed);
    StringBuilder bodies = new StringBuilder();
    int rows = crates / IN_A_ROW;
    double gap = 2.0 * (halfWidth - 2) / IN_A_ROW;
    for (int i = 0; i < rows; i++) {
      bodies.append(i == 0 ? "" : ",\n");
      bodies.append(
          String.format(
              Locale.ROOT,
              "{\"name\":\"crate\",\"at\":[%.3f,%.3f],\"angle\":%.3f,\"material\":\"crate\","
                  + "\"shape\":{\"type\":\"box\",\"width\":1,\"height\":1},"
                  + "\"linearDamping\":3,\"angularDamping\":3,"
                  + "\"repeat\":{\"columns\":%d,\"step\":[%.3f,0]}}",
              -halfWidth + 2 + random.nextDouble(1, gap - 1),
              20 + ROW_METRES * (i + random.nextDouble(-0.1, 0.1)),
              random.nextDouble(0, 90),
              IN_A_ROW,
              gap));
    }
    String json =
        """
        {"name": "crates", "game": "arena", "gravity": [0, 0],
         "bounds": {"min": [-%d, -%d], "max": [%d, %d]},
         "materials": {"crate": {"density": 0.5, "friction": 0.4, "restitution": 0.2}},
         "spawns": [{"name": "ball", "at": [0, -8]}],
         "zones": [
           {"name": "goal", "team": 1, "min": [-19.5, -1], "max": [-19, 1]},
           {"name": "goal", "team": 2, "min": [19, -1], "max": [19.5, 1]},
           {"name": "home", "team": 1, "min": [-7, -4], "max": [-3, 4]},
           {"name": "home", "team": 2, "min": [3, -4], "max": [7, 4]}],
         "bodies": [%s]}
        """
            .formatted(
                halfWidth, 40, halfWidth, 40 + (int) (ROW_METRES * crates / IN_A_ROW), bodies);
    return parse(json);
  }

  /**
   * Returns a walled field of crates that paddles keep stirring, wider than what one player sees.
   */
  public static Level churn() {
    StringBuilder paddles = new StringBuilder();
    for (int i = 0; i < 10; i++) {
      paddles.append(
          String.format(
              Locale.ROOT,
              ",{\"name\":\"paddle\",\"at\":[%d,%d],\"type\":\"kinematic\",\"spin\":%d,"
                  + "\"shape\":{\"type\":\"box\",\"width\":9,\"height\":0.6}}",
              -36 + 18 * (i % 5),
              i < 5 ? 9 : -9,
              i % 2 == 0 ? 150 : -190));
    }
    return parse(
        """
        {"name": "churn", "game": "arena", "gravity": [0, 0],
         "bounds": {"min": [-50, -20], "max": [50, 20]},
         "materials": {"crate": {"density": 0.5, "friction": 0.4, "restitution": 0.7}},
         "spawns": [{"name": "ball", "at": [0, 0]}],
         "zones": [
           {"name": "goal", "team": 1, "min": [-49.5, -1], "max": [-49, 1]},
           {"name": "goal", "team": 2, "min": [49, -1], "max": [49.5, 1]},
           {"name": "home", "team": 1, "min": [-7, -3], "max": [-3, 3]},
           {"name": "home", "team": 2, "min": [3, -3], "max": [7, 3]}],
         "statics": [
           {"at": [0, -21], "shape": {"type": "box", "width": 104, "height": 2},
            "repeat": {"rows": 2, "step": [0, 42]}},
           {"at": [-51, 0], "shape": {"type": "box", "width": 2, "height": 44},
            "repeat": {"columns": 2, "step": [102, 0]}}],
         "bodies": [
           {"name": "crate", "at": [-46, 5], "material": "crate",
            "shape": {"type": "box", "width": 1, "height": 1},
            "repeat": {"columns": 40, "rows": 4, "step": [2.3, 3]}},
           {"name": "crate", "at": [-46, -5], "material": "crate",
            "shape": {"type": "box", "width": 1, "height": 1},
            "repeat": {"columns": 40, "rows": 4, "step": [2.3, -3]}}%s]}
        """
            .formatted(paddles));
  }

  /** Returns a level of ten crates with so much white space that it packs to about 150 kB. */
  public static Level heavy(long seed) {
    SplittableRandom random = new SplittableRandom(seed);
    StringBuilder json =
        new StringBuilder(new String(crates(10, 20, seed).source(), StandardCharsets.UTF_8));
    for (int i = 0; i < 600_000; i++) {
      json.append(" \n\t\r".charAt(random.nextInt(4)));
    }
    return parse(json.toString());
  }

  private static Level parse(String json) {
    try {
      return Level.parse("crates.json", json.getBytes(StandardCharsets.UTF_8));
    } catch (LevelException e) {
      throw new IllegalStateException(e);
    }
  }
}
