package carom.server.session;

import carom.net.transport.Link;

/**
 * A player on the way to a room: from the lobby, with the level loaded, or from another room.
 *
 * @param seat claimed for the player; the room turns the claim into possession
 * @param link no other code touches it any more
 * @param epoch that of this link's last Welcome
 * @param match number of the match that it has loaded; perhaps the room plays the next already.
 *     {@link #NO_MATCH} for none
 * @param bot whether a bot comes, to a seat of its own or to that of a player who is away
 */
public record Admission(Seats.Seat seat, Link link, int epoch, int match, boolean bot) {
  /** Stands for the match of a player who has loaded none of the room's. */
  public static final int NO_MATCH = 0;

  /** Returns the same player over another link. */
  public Admission over(Link other) {
    return new Admission(seat, other, epoch, match, bot);
  }
}
