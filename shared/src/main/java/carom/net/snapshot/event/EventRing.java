package carom.net.snapshot.event;

/**
 * The last {@value #SIZE} events of a room, numbered from 0 in the order they happened; shared by
 * all sessions. One thread; allocates nothing once it was full.
 */
public final class EventRing {
  /** Events kept. */
  public static final int SIZE = 1 << 12;

  private final EventRecord[] events = new EventRecord[SIZE];
  private final int[] audience = new int[SIZE];
  private long limit;

  /** Creates an empty ring. */
  public EventRing() {}

  /**
   * Takes an event; the oldest goes.
   *
   * @param event copied; its tick isn't before the last one's
   * @param whom who is told, a number of the caller's
   */
  public void add(EventRecord event, int whom) {
    int at = (int) limit & (SIZE - 1);
    if (events[at] == null) {
      events[at] = new EventRecord();
    }
    events[at].set(event);
    audience[at] = whom;
    limit++;
  }

  /** All numbers are below. */
  public long limit() {
    return limit;
  }

  /** Whether an event is still kept. */
  public boolean holds(long number) {
    return number >= 0 && number < limit && number >= limit - SIZE;
  }

  /** A kept event, for reading. */
  public EventRecord at(long number) {
    return events[(int) number & (SIZE - 1)];
  }

  /** Who is told of a kept event, as {@link #add} was told. */
  public int audience(long number) {
    return audience[(int) number & (SIZE - 1)];
  }
}
