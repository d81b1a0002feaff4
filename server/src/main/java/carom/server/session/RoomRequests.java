package carom.server.session;

/** Keeps what one player asks about other rooms until the room answers. The room's thread. */
final class RoomRequests {
  private boolean wantsList;
  private int ticksSinceList = Short.MAX_VALUE; // long ago
  private String room;
  private final PacedMessages list = new PacedMessages();

  /** Notes that a tick has passed. */
  void tick() {
    ticksSinceList++;
  }

  /** Notes a request for the list of rooms. Requests before the answer are one. */
  void askForList() {
    wantsList = true;
  }

  /**
   * Takes the request for the list of rooms, if there is one.
   *
   * @param ticks number of ticks that must have passed after the last one
   * @return whether there is one
   */
  boolean takeListRequest(int ticks) {
    boolean takes = wantsList && ticksSinceList >= ticks && list.isSent();
    if (takes) {
      wantsList = false;
      ticksSinceList = 0;
    }
    return takes;
  }

  /** Returns the list of rooms that is under way. */
  PacedMessages list() {
    return list;
  }

  /** Notes that the player wants to go to another room. */
  void goTo(String name) {
    room = name;
  }

  /** Returns the name of the room that the player wants to go to, or null. */
  String room() {
    return room;
  }

  /** Forgets the room that the player wanted to go to. */
  void clearRoom() {
    room = null;
  }
}
