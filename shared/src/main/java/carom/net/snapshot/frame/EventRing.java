package carom.net.snapshot.frame;

/**
 * Keeps the last {@value #SIZE} events of a room, numbered from 0 in the order they happened;
 * shared by all sessions. One thread; allocates nothing once it was full.
 */
public final class EventRing {
  /** Number of events kept. */
  public static final int SIZE = 1 << 12;

  private final EventRecord[] events = new EventRecord[SIZE];
  private final int[] audience = new int[SIZE];
  private long limit;

  /** Creates an empty ring. */
  public EventRing() {}

  /**
   * Adds an event and drops the oldest.
   *
   * @param event copied; its tick isn't before the last one's
   * @param audience a number of the caller's that stands for the clients that are told
   */
  public void add(EventRecord event, int audience) {
    int at = (int) limit & (SIZE - 1);
    if (events[at] == null) {
      events[at] = new EventRecord();
    }
    events[at].set(event);
    this.audience[at] = audience;
    limit++;
  }

  /** Returns the number that the next event gets. */
  public long limit() {
    return limit;
  }

  /** Returns whether an event is still kept. */
  public boolean holds(long number) {
    return number >= 0 && number < limit && number >= limit - SIZE;
  }

  /** Returns a kept event, for reading. */
  public EventRecord at(long number) {
    return events[(int) number & (SIZE - 1)];
  }

  /** Returns the audience of a kept event, as {@link #add} got it. */
  public int audience(long number) {
    return audience[(int) number & (SIZE - 1)];
  }
}
