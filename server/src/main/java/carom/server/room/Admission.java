package carom.server.room;

import carom.net.transport.Link;
import carom.server.session.Seats;

/**
 * A player whose level is loaded, on the way from the lobby to the room.
 *
 * @param seat claimed by the lobby; the room turns the claim into possession
 * @param link the lobby doesn't touch it any more
 * @param datagramKey the key of this link's Welcome
 * @param match number of the match that it has loaded; perhaps the room plays the next already
 */
public record Admission(Seats.Seat seat, Link link, int datagramKey, int match) {}
