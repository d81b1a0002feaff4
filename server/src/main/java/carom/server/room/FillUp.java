package carom.server.room;

/**
 * Fills rooms up, because players want company.
 *
 * @param game name of the wanted game; empty for any
 * @param withFriends whether the other members of a party may follow the newcomer
 */
public record FillUp(String game, boolean withFriends) implements RoomSearch {
  /** Places that a room should have for the friends who follow. */
  private static final int FRIENDS = 3;

  private static final int OF_GAME = 1 << 20; // more than any number of places

  /** Returns more for the wanted game first, then for places for friends, then for company. */
  @Override
  public int fit(RoomOffer room) {
    int left = room.places() - room.taken();
    if (left <= 0) {
      return -1;
    }
    int fit = withFriends && left <= FRIENDS ? left : FRIENDS + 1 + room.taken();
    return room.game().equals(game) ? OF_GAME + fit : fit;
  }
}
