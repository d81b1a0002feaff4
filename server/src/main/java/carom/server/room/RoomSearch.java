package carom.server.room;

/**
 * The search of a newcomer who names no room. Every server of a fleet compares rooms by it.
 *
 * @param game name of the wanted game; empty for any
 * @param withFriends whether the other members of a party may follow the newcomer
 */
public record RoomSearch(String game, boolean withFriends) {
  /** Places that a room should have for the friends who follow. */
  private static final int FRIENDS = 3;

  private static final int OF_GAME = 1 << 20; // more than any number of places

  /**
   * Returns how well a room suits: larger is better, -1 is a room without a place. The wanted game
   * counts most, then places for friends, then company.
   *
   * @param plays name of the game that the room plays
   * @param taken seats that are taken
   * @param places number of seats
   */
  public int fit(String plays, int taken, int places) {
    int left = places - taken;
    if (left <= 0) {
      return -1;
    }
    int fit = withFriends && left <= FRIENDS ? left : FRIENDS + 1 + taken;
    return plays.equals(game) ? OF_GAME + fit : fit;
  }

  /** Returns how well a room suits, as {@link #fit(String, int, int)}. */
  public int fit(Room room) {
    return fit(room.match().game(), room.seats().takenCount(), room.seats().count());
  }
}
