package carom.client.events;

import carom.sim.Entity;
import carom.sim.Event;
import carom.sim.Journal;
import carom.sim.Player;
import carom.sim.Simulation;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;

/**
 * Sees to it that every event fires once.
 *
 * <p>The server tells events reliably and in order. Those of others fire in the order of their
 * ticks when the picture of the others has come to their tick. Those of the own player or body fire
 * at once, because that is drawn in the present, and most of them have fired before: when the
 * prediction computed them. Both are matched by what they are ({@link Event#isLike}) and their
 * ticks, which may be up to a fifth of a second apart, since an input can come late.
 *
 * <p>An event that was foreseen is kept until no replay can come back to its tick. So one that is
 * computed again finds itself and doesn't fire, and neither does one that the server has told
 * already. What the server hasn't told when it has told all up to then and a fifth of a second more
 * is retracted; and nothing foreseen fires for ticks that the server has told all of.
 *
 * <p>Bounded: {@value #FORETOLD} foreseen ones and {@value #WAITING} waiting ones; what is too much
 * isn't foreseen, or fires early. One thread; allocates only to grow.
 */
public final class EventBook implements Journal {
  private static final int FORETOLD = 256;
  private static final int WAITING = 1_024;
  private static final int WAITING_MASK = WAITING - 1;

  /** No replay goes back further than that many ticks. */
  private static final int KEEP_TICKS = 160;

  private static final float TOLERANCE_SECONDS = 0.2f;

  /** One event of the own player: foreseen, told by the server, or both. */
  private static final class Entry {
    private final Event event = new Event(); // as it fired
    private int tick; // as it was computed last
    private boolean used;
    private boolean settled;
    private boolean computed; // in the present run through its tick
  }

  private final int playerId;
  private final boolean predicts;
  private final EventListener listener;
  private final int tolerance;
  private final List<Entry> book = new ArrayList<>(); // at most FORETOLD
  private final Event[] waiting = new Event[WAITING];
  private long first;
  private long next;
  private final Consumer<Event> foresee = this::foresee;
  private int ownKey = Event.NONE;
  private int lastTick = -1;
  private int completeTick = -1;
  private long fired;
  private long foreseen;
  private long confirmed;
  private long retracted;

  /**
   * Opens an empty book.
   *
   * @param playerId the own player's id
   * @param predicts whether the own body is drawn in the present; if not, its events are shown with
   *     those of all others
   * @param tickRate ticks per second
   * @param listener hears what fires
   */
  public EventBook(int playerId, boolean predicts, int tickRate, EventListener listener) {
    this.playerId = playerId;
    this.predicts = predicts;
    this.listener = listener;
    tolerance = Math.max(1, Math.round(TOLERANCE_SECONDS * tickRate));
  }

  // ---- the prediction

  @Override
  public void joining(Simulation s, int id, String name) {}

  @Override
  public void leaving(Simulation s, int id) {}

  @Override
  public void stepping(Simulation s) {
    if (s.tick() != lastTick) { // it has gone back, or the clock has jumped
      for (int i = 0; i < book.size(); i++) {
        Entry e = book.get(i);
        e.computed &= e.tick <= s.tick();
      }
    }
  }

  @Override
  public void stepped(Simulation s) {
    lastTick = s.tick();
    Player own = s.player(playerId);
    Entity body = own == null ? null : own.body();
    ownKey = body == null ? Event.NONE : Event.key(body.id(), body.generation());
    s.drainEvents(foresee);
  }

  private boolean isOwn(Event e) {
    return predicts
        && (e.player() == playerId
            || (ownKey != Event.NONE && (e.first() == ownKey || e.second() == ownKey)));
  }

  private void foresee(Event event) {
    if (!isOwn(event)) {
      return; // what others do is a guess until the server tells
    }
    Entry same = find(event, false);
    if (same != null) {
      same.computed = true;
      same.tick = same.settled ? same.tick : event.tick();
    } else if (event.tick() > completeTick) {
      Entry entry = place(event);
      if (entry != null) {
        entry.computed = true;
        entry.settled = false;
        foreseen++;
        fire(entry.event, true);
      }
    }
  }

  /**
   * The entry nearest in time that may be the same; of two as near, the earlier. However often it
   * was computed again, a little later each time, it is the same only near the tick as which it
   * fired.
   */
  private Entry find(Event event, boolean unsettledOnly) {
    Entry nearest = null;
    int best = tolerance + 1;
    for (int i = 0; i < book.size(); i++) {
      Entry e = book.get(i);
      boolean open = unsettledOnly ? !e.settled : !e.computed;
      boolean near = Math.abs(e.event.tick() - event.tick()) <= tolerance;
      if (e.used && open && near && e.event.isLike(event)) {
        int apart = Math.abs(e.tick - event.tick());
        if (apart < best || (apart == best && nearest != null && e.tick < nearest.tick)) {
          best = apart;
          nearest = e;
        }
      }
    }
    return nearest;
  }

  /** A free place, or that of the oldest settled one; null when all are unsettled. */
  private Entry place(Event event) {
    Entry oldest = null;
    for (int i = 0; i < book.size(); i++) {
      Entry e = book.get(i);
      if (!e.used) {
        oldest = e;
        break;
      }
      if (e.settled && (oldest == null || e.tick < oldest.tick)) {
        oldest = e;
      }
    }
    if ((oldest == null || oldest.used) && book.size() < FORETOLD) {
      oldest = new Entry();
      book.add(oldest);
    }
    if (oldest != null) {
      oldest.used = true;
      oldest.event.set(event);
      oldest.tick = event.tick();
    }
    return oldest;
  }

  // ---- the server

  /** The server tells an event; call it in the order of the server. */
  public void told(Event event) {
    if (!isOwn(event)) {
      if (next - first == WAITING) {
        fire(waiting[(int) first++ & WAITING_MASK], false);
      }
      int at = (int) next++ & WAITING_MASK;
      if (waiting[at] == null) {
        waiting[at] = new Event();
      }
      waiting[at].set(event);
      return;
    }
    Entry entry = find(event, true);
    if (entry != null) {
      entry.settled = true;
      confirmed++;
      return;
    }
    entry = place(event);
    if (entry != null) {
      entry.settled = true;
      entry.computed = false; // whoever computes it finds it
    }
    fire(event, false);
  }

  /** The server has told all events up to a tick. */
  public void complete(int tick) {
    if (tick <= completeTick) {
      return;
    }
    completeTick = tick;
    for (int i = 0; i < book.size(); i++) {
      Entry e = book.get(i);
      if (!e.used) {
        continue;
      }
      if (!e.settled && e.tick + tolerance <= tick) {
        e.used = false;
        retracted++;
        listener.retracted(e.event);
      } else if (e.settled && e.tick + KEEP_TICKS < tick) {
        e.used = false;
      }
    }
  }

  /** The picture of the others has come to a tick. */
  public void advance(double tick) {
    while (first < next && waiting[(int) first & WAITING_MASK].tick() <= tick) {
      fire(waiting[(int) first++ & WAITING_MASK], false);
    }
    if (first == next) {
      first = 0; // the first places again: most clients need a few
      next = 0;
    }
  }

  /** Ends it: what waits fires, what isn't confirmed is retracted. */
  public void close() {
    advance(Double.MAX_VALUE);
    for (int i = 0; i < book.size(); i++) {
      Entry e = book.get(i);
      if (e.used && !e.settled) {
        retracted++;
        listener.retracted(e.event);
      }
      e.used = false;
    }
  }

  private void fire(Event event, boolean isForeseen) {
    fired++;
    listener.happened(event, isForeseen);
  }

  // ---- for inspection

  /** Events fired, those that were retracted later included. */
  public long fired() {
    return fired;
  }

  /** Events fired because they were foreseen. */
  public long foreseen() {
    return foreseen;
  }

  /** Foreseen events that the server told, too. */
  public long confirmed() {
    return confirmed;
  }

  /** Foreseen events that the server never told. */
  public long retracted() {
    return retracted;
  }
}
