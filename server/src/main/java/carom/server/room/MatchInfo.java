package carom.server.room;

import carom.net.protocol.ServerMessage.Welcome;
import carom.server.session.LoadedLevel;
import carom.server.session.Seats;

/**
 * What a client must know of a room's match to play it. Immutable; any thread.
 *
 * @param number counts the room's matches from 1 on
 * @param game name of the game
 * @param level the level with its download
 * @param seed seed of the match's random numbers
 */
public record MatchInfo(int number, String game, LoadedLevel level, long seed) {
  /**
   * Returns the message that lets a player load and join the match.
   *
   * @param datagramKey key of the link's datagrams from now on
   * @param tick the room's present tick
   */
  public Welcome welcome(Seats.Seat seat, int datagramKey, int tickRateHz, int tick) {
    return new Welcome(
        seat.secret(),
        datagramKey,
        seat.id(),
        tickRateHz,
        number,
        tick,
        seed,
        game,
        level.level().name(),
        level.contentHash(),
        level.size(),
        level.packedSize());
  }
}
