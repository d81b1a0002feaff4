package carom.server.room;

/**
 * The rule by which a newcomer who names no room is sent to one. Every server of a fleet compares
 * rooms by it.
 */
public interface RoomSearch {
  /**
   * Returns how well a room suits: larger is better, -1 is a room to which the newcomer doesn't go.
   */
  int fit(RoomOffer room);
}
