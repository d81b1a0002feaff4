package carom.sim;

import carom.sim.event.EventKind;
import java.util.function.Consumer;

/** The events of a simulation since somebody took them; one object per place, used again. */
final class EventLog {
  private static final int MASK = Simulation.MAX_EVENTS - 1;

  private final Event[] events = new Event[Simulation.MAX_EVENTS];
  private long made;
  private long taken;
  private long dropped;

  /** The next one to fill in; when nobody takes them, the oldest goes. */
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

  void drain(Consumer<Event> consumer) {
    while (taken < made) {
      consumer.accept(events[(int) taken++ & MASK]);
    }
    made = 0; // the first places again: a steady tick makes no new objects
    taken = 0;
  }

  long dropped() {
    return dropped;
  }
}
