package carom.testkit;

import carom.sim.level.Level;
import carom.sim.level.LevelException;
import java.nio.charset.StandardCharsets;

/** Builds small levels in which nothing moves by itself. */
public final class Levels {
  private static final String FOUR_PLAYERS =
      """
      {"name": "player", "at": [-8, 0.8]}, {"name": "player", "at": [8, 0.8]},
           {"name": "player", "at": [-4, 0.8]}, {"name": "player", "at": [4, 0.8]}\
      """;

  private Levels() {}

  /** Returns an arena with walls and a post. The ball lies outside the walls, out of reach. */
  public static Level emptyArena() {
    return arena("empty.json", "[19, 11]");
  }

  /** Returns an arena with walls and a post. The ball lies in the middle, below the post. */
  public static Level arenaWithBall() {
    return arena("ball.json", "[0, -2]");
  }

  private static Level arena(String name, String ball) {
    return parse(
        name,
        """
        {"name": "%s", "game": "arena", "gravity": [0, 0],
         "bounds": {"min": [-20, -12], "max": [20, 12]},
         "materials": {"wall": {"friction": 0.2, "restitution": 0.5}},
         "spawns": [{"name": "ball", "at": %s}],
         "zones": [
           {"name": "goal", "team": 1, "min": [-19.5, -1], "max": [-19, 1]},
           {"name": "goal", "team": 2, "min": [19, -1], "max": [19.5, 1]},
           {"name": "home", "team": 1, "min": [-7, -4], "max": [-3, 4]},
           {"name": "home", "team": 2, "min": [3, -4], "max": [7, 4]}],
         "statics": [
           {"name": "wall", "at": [-9, 0], "material": "wall",
            "shape": {"type": "box", "width": 1, "height": 12}},
           {"name": "wall", "at": [9, 0], "material": "wall",
            "shape": {"type": "box", "width": 1, "height": 12}},
           {"name": "wall", "at": [0, 6], "material": "wall",
            "shape": {"type": "box", "width": 18, "height": 1}},
           {"name": "wall", "at": [0, -6], "material": "wall",
            "shape": {"type": "box", "width": 18, "height": 1}},
           {"name": "post", "at": [0, 3], "material": "wall",
            "shape": {"type": "polygon", "points": [[-1, -1], [1, -1], [0, 1]]}}]}
        """
            .formatted(name, ball));
  }

  /**
   * Returns a platformer level with a floor between walls, a step and a one-way platform. The flag
   * hangs out of reach.
   */
  public static Level emptyPlatformer() {
    return platformer("floor.json", FOUR_PLAYERS, "");
  }

  /** Returns the level of {@link #emptyPlatformer} with a stack of three crates. */
  public static Level platformerWithCrates() {
    return platformer(
        "crates.json",
        FOUR_PLAYERS,
        """
        , "bodies": [{"name": "crate", "at": [0, 0.55], "material": "crate",
          "shape": {"type": "box", "width": 1.1, "height": 1.1},
          "repeat": {"rows": 3, "step": [0, 1.12]}}]
        """);
  }

  /**
   * Returns the level of {@link #emptyPlatformer} with one spawn for players, left of a row of
   * twelve crates that touch each other. A single crate lies right of the row, in slot 12.
   */
  public static Level platformerWithRowOfCrates() {
    return platformer(
        "row.json",
        """
        {"name": "player", "at": [-8, 0.8]}\
        """,
        """
        , "bodies": [
          {"name": "crate", "at": [-6, 0.45], "material": "crate",
           "shape": {"type": "box", "width": 0.9, "height": 0.9},
           "repeat": {"columns": 12, "step": [0.899, 0]}},
          {"name": "crate", "at": [10, 0.45], "material": "crate",
           "shape": {"type": "box", "width": 0.9, "height": 0.9}}]
        """);
  }

  private static Level platformer(String name, String players, String more) {
    return parse(
        name,
        """
        {"name": "%s", "game": "platformer", "gravity": [0, -26],
         "bounds": {"min": [-20, -6], "max": [20, 30]},
         "materials": {"ground": {"friction": 0.7}, "crate": {"density": 0.4, "friction": 0.6}},
         "spawns": [
           %s,
           {"name": "flag", "at": [0, 25]}],
         "statics": [
           {"name": "floor", "at": [0, -1], "material": "ground",
            "shape": {"type": "box", "width": 26, "height": 2}},
           {"name": "wall", "at": [-12.5, 5], "material": "ground",
            "shape": {"type": "box", "width": 1, "height": 12}},
           {"name": "wall", "at": [12.5, 5], "material": "ground",
            "shape": {"type": "box", "width": 1, "height": 12}},
           {"name": "step", "at": [-11, 0.4], "material": "ground",
            "shape": {"type": "box", "width": 2, "height": 0.8}},
           {"name": "shelf", "at": [8, 2.2], "material": "ground", "oneWay": true,
            "shape": {"type": "box", "width": 4, "height": 0.3}}]%s}
        """
            .formatted(name, players, more));
  }

  private static Level parse(String name, String json) {
    try {
      return Level.parse(name, json.getBytes(StandardCharsets.UTF_8));
    } catch (LevelException e) {
      throw new IllegalStateException(e);
    }
  }
}
