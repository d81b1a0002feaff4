package carom.client;

/**
 * Drops the events that a new link repeats. The server sends again what it doesn't know to have
 * arrived over the lost link: whole ticks, in the same order. If the new link loses events before
 * the repetition is through, which ones can't be known; the rest of that tick is dropped. One
 * thread; no allocation.
 */
public final class RepeatedEventFilter {
  private String room = "";
  private int match;
  private int incarnation;
  private int tick = -1;

  /** Events of {@link #tick} that were accepted. */
  private int count;

  /** Events of {@link #tick} that the new link still has to repeat. */
  private int toRepeat;

  /** Creates a filter that has seen no event. */
  public RepeatedEventFilter() {}

  /**
   * Notes that a link begins.
   *
   * @param serverRoom name of the room
   * @param serverMatch number of the room's match, in which ticks begin at 0
   * @param serverIncarnation stands for this run of the room
   * @param courseTick in another run, the last tick that still happened as it was heard of
   */
  public void beginLink(String serverRoom, int serverMatch, int serverIncarnation, int courseTick) {
    if (!serverRoom.equals(room) || serverMatch != match) {
      room = serverRoom;
      match = serverMatch;
      tick = -1;
      count = 0;
    } else if (serverIncarnation != incarnation && courseTick < tick) {
      tick = courseTick; // all of its events were heard, as some of later ticks were
      count = Integer.MAX_VALUE;
    }
    incarnation = serverIncarnation;
    toRepeat = count;
  }

  /**
   * Takes in the next event that the server sends.
   *
   * @param eventTick its tick
   * @param missed events that this link has lost so far
   * @return whether the event is new; false if an earlier link has brought it
   */
  public boolean accept(int eventTick, long missed) {
    if (eventTick < tick) {
      return false;
    }
    if (eventTick > tick) {
      tick = eventTick;
      count = 0;
      toRepeat = 0;
    }
    if (toRepeat > 0) {
      toRepeat = missed > 0 ? Integer.MAX_VALUE : toRepeat - 1;
      return false;
    }
    count++;
    return true;
  }
}
