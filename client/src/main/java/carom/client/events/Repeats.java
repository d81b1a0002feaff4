package carom.client.events;

/**
 * Tells events apart that a new link repeats: what the server doesn't know to have arrived over the
 * lost one it tells again, from the first event of a tick on, in the same order. If the new link
 * loses events before the repeat is through, nobody knows which: the rest of that tick isn't heard.
 * One thread; no allocation.
 */
public final class Repeats {
  private int tick = -1;

  /** Events of {@link #tick} so far, and how many of them are to be told again. */
  private int count;

  private int repeated;

  /** Creates one that has heard of nothing. */
  public Repeats() {}

  /**
   * A link begins.
   *
   * @param serverTick the server's tick; before the last event's it is another server
   */
  public void linkBegins(int serverTick) {
    if (serverTick < tick) {
      tick = -1;
      count = 0;
    }
    repeated = count;
  }

  /**
   * Whether the next event that the server tells, of this tick, wasn't told by an earlier link.
   *
   * @param missed events that this link has lost so far
   */
  public boolean isNew(int eventTick, long missed) {
    if (eventTick < tick) {
      return false;
    }
    if (eventTick > tick) {
      tick = eventTick;
      count = 0;
      repeated = 0;
    }
    if (repeated > 0) {
      repeated = missed > 0 ? Integer.MAX_VALUE : repeated - 1;
      return false;
    }
    count++;
    return true;
  }
}
