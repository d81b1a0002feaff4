package carom.sim.outbox;

import carom.physics.math.Limits;

/**
 * The match that a room plays after the present one, as a game asks for it by {@code
 * Simulation.playNext}. Players keep their ids and names. Team and score begin at 0 unless they are
 * kept.
 *
 * @param game name of the game; empty for the one that the level is made for
 * @param level file or name of the level; empty for the default level of the game. If both are
 *     empty, the next level of the room's rotation
 * @param keepsTeams whether each player keeps the team
 * @param keepsScores whether each player keeps the score
 */
public record NextMatch(String game, String level, boolean keepsTeams, boolean keepsScores) {
  /** The next level of the room's rotation. */
  public static final NextMatch OF_ROTATION = new NextMatch("", "", false, false);

  /** Checks that the names are there. */
  public NextMatch {
    Limits.notNull("game", game);
    Limits.notNull("level", level);
  }

  /** Returns a match in a level, of the game that the level is made for. */
  public static NextMatch level(String level) {
    return new NextMatch("", level, false, false);
  }

  /** Returns a match of a game in its default level. */
  public static NextMatch game(String game) {
    return new NextMatch(game, "", false, false);
  }

  /** Returns a copy in which each player keeps the team. */
  public NextMatch keepingTeams() {
    return new NextMatch(game, level, true, keepsScores);
  }

  /** Returns a copy in which each player keeps the score. */
  public NextMatch keepingScores() {
    return new NextMatch(game, level, keepsTeams, true);
  }

  /** Returns whether the room's rotation chooses the level. */
  public boolean isOfRotation() {
    return game.isEmpty() && level.isEmpty();
  }
}
