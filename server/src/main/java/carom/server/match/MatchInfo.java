package carom.server.match;

import carom.net.field.Declarations;
import carom.net.protocol.ServerMessage.Welcome;
import carom.replay.RecordingHeader;
import carom.server.session.LoadedLevel;
import carom.sim.Skill;

/**
 * The facts that a client must know of a room's match to play it. Immutable; any thread.
 *
 * @param room name of the room
 * @param number counts the room's matches from 1 on
 * @param game name of the game
 * @param level the level with its download
 * @param seed seed of the match's random numbers
 * @param declarations of the game's fields and kinds of messages
 * @param gameDigest digest of the game's code
 * @param skill of the game's players, or null
 * @param takesAnyCode whether clients whose code differs may play all the same
 */
public record MatchInfo(
    String room,
    int number,
    String game,
    LoadedLevel level,
    long seed,
    Declarations declarations,
    long gameDigest,
    Skill skill,
    boolean takesAnyCode) {
  /** Returns whether a recording with this header is one of the room's match of a number. */
  boolean isThatOf(RecordingHeader header, int match) {
    return match == number
        && game.equals(header.game())
        && seed == header.seed()
        && level.contentHash() == header.levelHash();
  }

  /**
   * Returns the message that lets a player load and join the match.
   *
   * @param sessionSecret proves the player's identity
   * @param playerId the player's seat
   * @param epoch counts the link's Welcomes, modulo 8
   * @param tick the room's present tick
   * @param claim number by which the server owns the room, 0 without a fleet
   * @param incarnation stands for this run of the room
   * @param courseTick last tick that the room's present course shares with the one that the player
   *     has heard of
   */
  public Welcome welcome(
      long sessionSecret,
      int playerId,
      int epoch,
      int tickRateHz,
      int tick,
      long claim,
      int incarnation,
      int courseTick) {
    return new Welcome(
        sessionSecret,
        epoch,
        playerId,
        tickRateHz,
        room,
        number,
        claim,
        incarnation,
        Math.min(courseTick, tick),
        tick,
        seed,
        game,
        level.level().name(),
        level.contentHash(),
        level.size(),
        level.packedSize(),
        declarations.digest(),
        gameDigest,
        takesAnyCode,
        declarations.lines());
  }
}
