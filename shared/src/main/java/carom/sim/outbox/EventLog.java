package carom.sim.outbox;

import carom.sim.event.EventKind;
import java.util.function.Consumer;

/**
 * The events of a simulation that have not been drained yet. The places and their objects are
 * reused.
 */
final class EventLog {
  private static final int MASK = Outbox.MAX_EVENTS - 1;

  private final Event[] events = new Event[Outbox.MAX_EVENTS];
  private long made;
  private long taken;
  private long dropped;

  /** Returns the next event to fill in. If the log is full, it drops the oldest one. */
  Event add(EventKind kind, int tick) {
    int at = (int) made++ & MASK;
    if (events[at] == null) {
      events[at] = new Event();
    }
    if (made - taken > events.length) {
      taken++;
      dropped++;
    }
    events[at].begin(kind, tick);
    return events[at];
  }

  /** Passes all events on in the order they were added, and forgets them. */
  void drain(Consumer<Event> consumer) {
    while (taken < made) {
      consumer.accept(events[(int) taken++ & MASK]);
    }
    made = 0; // reuse the first places: a steady tick creates no objects
    taken = 0;
  }

  /** Returns the number of events that were dropped because the log was full. */
  long dropped() {
    return dropped;
  }
}
