package carom.server.room;

import carom.net.field.FieldAgreement;
import carom.net.protocol.ServerMessage.Welcome;
import carom.server.session.LoadedLevel;
import carom.server.session.Seats;
import carom.sim.field.Schema;

/**
 * What a client must know of a room's match to play it. Immutable; any thread.
 *
 * @param number counts the room's matches from 1 on
 * @param game name of the game
 * @param level the level with its download
 * @param seed seed of the match's random numbers
 * @param schema declarations of the game's fields
 */
public record MatchInfo(int number, String game, LoadedLevel level, long seed, Schema schema) {
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
        level.packedSize(),
        schema.digest(),
        FieldAgreement.tell(schema));
  }
}
