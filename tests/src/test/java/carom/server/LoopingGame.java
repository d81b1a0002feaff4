package carom.server;

import carom.fixtures.PlainGame;
import carom.sim.Match;
import java.util.concurrent.locks.LockSupport;

/**
 * A game that never comes back from its tenth tick in a room, or already when a server begins, for
 * a server that is a process of its own.
 */
public final class LoopingGame extends PlainGame {
  private static final String AT_START = "at start";

  /** Creates the game. */
  public LoopingGame() {
    super("looping");
  }

  /** Returns the text of a level for it. */
  static String level(boolean atStart) {
    return """
    {
      "name": "%s", "game": "looping", "gravity": [0, 0],
      "bounds": { "min": [-10, -10], "max": [10, 10] },
      "spawns": [ { "name": "player", "at": [0, 0] } ]
    }
    """
        .formatted(atStart ? AT_START : "in the room");
  }

  @Override
  public void beforeStep(Match s) {
    boolean inRoom = Thread.currentThread().getName().startsWith("carom-room");
    while (s.level().name().equals(AT_START) || inRoom && s.tick() >= 9) {
      LockSupport.parkNanos(1_000_000); // its process ends later, and others want the processor
    }
  }
}
