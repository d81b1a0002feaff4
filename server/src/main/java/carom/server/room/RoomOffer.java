package carom.server.room;

import carom.server.session.RoomSkill;

/**
 * The facts about a room by which newcomers are sent there. Immutable.
 *
 * @param game name of the game that it plays
 * @param taken seats that are taken
 * @param places number of seats
 * @param skill of its players, or null if the game names none
 */
public record RoomOffer(String game, int taken, int places, RoomSkill skill) {}
