package carom.server.session;

/** Keeps what one player asks about rooms until the room answers. The room's thread. */
final class RoomRequests {
  private boolean wantsList;
  private boolean wantsBest;
  private boolean wantsLevels;
  private String choice;
  private int ticksSinceAnswer = Short.MAX_VALUE; // long ago
  private String room;
  private final PacedMessages answer = new PacedMessages();

  /** Notes that a tick has passed. */
  void tick() {
    ticksSinceAnswer++;
  }

  /** Notes a request for the list of rooms. Requests before the answer are one. */
  void askForList() {
    wantsList = true;
  }

  /** Notes a request for the best lists. Requests before the answer are one. */
  void askForBest() {
    wantsBest = true;
  }

  /** Notes a request for the levels of players. Requests before the answer are one. */
  void askForLevels() {
    wantsLevels = true;
  }

  /** Notes the level of a player that the player wants to play; an empty text for none. */
  void choose(String level) {
    choice = level;
  }

  /** Takes the choice that was made since, or null. */
  String takeChoice() {
    String made = choice;
    choice = null;
    return made;
  }

  /** Takes the request for the levels of players, as {@link #takeListRequest} does. */
  boolean takeLevelsRequest(int ticks) {
    boolean takes = wantsLevels && startsAnswer(ticks);
    wantsLevels &= !takes;
    return takes;
  }

  /**
   * Takes the request for the list of rooms, if there is one.
   *
   * @param ticks number of ticks that must have passed after the last answer
   * @return whether there is one
   */
  boolean takeListRequest(int ticks) {
    boolean takes = wantsList && startsAnswer(ticks);
    wantsList &= !takes;
    return takes;
  }

  /** Takes the request for the best lists, as {@link #takeListRequest} does. */
  boolean takeBestRequest(int ticks) {
    boolean takes = wantsBest && startsAnswer(ticks);
    wantsBest &= !takes;
    return takes;
  }

  private boolean startsAnswer(int ticks) {
    boolean starts = ticksSinceAnswer >= ticks && answer.isSent();
    ticksSinceAnswer = starts ? 0 : ticksSinceAnswer;
    return starts;
  }

  /** Returns the answer that is under way. */
  PacedMessages answer() {
    return answer;
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
