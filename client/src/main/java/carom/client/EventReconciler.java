package carom.client;

import carom.sim.Journal;
import carom.sim.SimulationHost;
import carom.sim.entity.HostEntity;
import carom.sim.entity.HostPlayer;
import carom.sim.outbox.Event;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.IntUnaryOperator;

/**
 * Fires every event once, whether the prediction computes it, the server sends it, or both.
 *
 * <ul>
 *   <li>Events of other players fire when the interpolated picture has come to their tick, in the
 *       order of ticks.
 *   <li>Events of the own player or body fire at once, because the own body is drawn in the
 *       present. Most of them fire when the prediction computes them.
 *   <li>A predicted event and one from the server are the same if they are alike ({@link
 *       Event#isLike}) and at most a fifth of a second apart: an input may arrive late.
 *   <li>A predicted event is kept until no rollback can reach its tick. A resimulation that
 *       computes it again finds it, so it doesn't fire twice.
 *   <li>A predicted event is retracted if the server has sent all events up to a fifth of a second
 *       after it and it was not among them.
 * </ul>
 *
 * <pre>
 *            predicted                      received
 *               │                              │
 *   other: dropped    own: ENTRY ◄── match ──► own: confirmed, or fires     other: QUEUE
 *                          │                                                     │
 *               fires, may be retracted                           fires when the picture is there
 * </pre>
 *
 * <p>Bounded: {@value #MAX_ENTRIES} predicted events and {@value #QUEUE} queued ones. Beyond that
 * an event isn't predicted, or fires early. One thread; allocates only to grow.
 */
public final class EventReconciler implements Journal {
  private static final int MAX_ENTRIES = 256;
  private static final int QUEUE = 1_024;
  private static final int QUEUE_MASK = QUEUE - 1;

  /** Ticks for which a confirmed event is kept; no rollback goes back further. */
  private static final int KEEP_TICKS = 160;

  private static final float TOLERANCE_SECONDS = 0.2f;

  /** One event of the own player: predicted, received from the server, or both. */
  private static final class Entry {
    /** The event as it fired. */
    private final Event event = new Event();

    /** The event's tick as the prediction computed it last. */
    private int tick;

    private boolean used;

    /** True once the server has sent the event. */
    private boolean confirmed;

    /** True if the present run of the simulation through the event's tick has computed it. */
    private boolean computed;
  }

  private final int playerId;
  private boolean predicts;
  private final IntUnaryOperator origins;
  private final EventListener listener;
  private final int tolerance;
  private final List<Entry> entries = new ArrayList<>(); // at most MAX_ENTRIES
  private final Event[] queue = new Event[QUEUE];

  /** Number of the oldest queued event, and of the next one to come. */
  private long first;

  private long next;
  private final Consumer<Event> predict = this::predict;
  private int ownKey = Event.NONE;
  private int lastTick = -1;
  private int completeTick = -1;
  private long fired;
  private long confirmations;
  private long retractions;

  /**
   * Creates a reconciler without events.
   *
   * @param playerId the own player's id
   * @param predicts whether the own body is drawn in the present; if not, its events fire like
   *     those of all others
   * @param origins returns the {@link carom.sim.spawn.Origin} of the entity of a key that the own
   *     input has spawned, as far as the server has told
   * @param tickRate ticks per second
   * @param listener receives what fires
   */
  public EventReconciler(
      int playerId,
      boolean predicts,
      IntUnaryOperator origins,
      int tickRate,
      EventListener listener) {
    this.origins = origins;
    this.playerId = playerId;
    this.predicts = predicts;
    this.listener = listener;
    tolerance = Math.max(1, Math.round(TOLERANCE_SECONDS * tickRate));
  }

  // ---- the prediction

  @Override
  public void stepping(SimulationHost s) {
    if (s.tick() != lastTick) { // a rollback, or the clock has jumped
      for (int i = 0; i < entries.size(); i++) {
        Entry e = entries.get(i);
        e.computed &= e.tick <= s.tick();
      }
    }
  }

  @Override
  public void stepped(SimulationHost s) {
    lastTick = s.tick();
    HostPlayer own = s.player(playerId);
    HostEntity body = own == null ? null : own.entity();
    ownKey = body == null ? Event.NONE : Event.key(body.id(), body.generation());
    s.outbox().drainEvents(predict);
  }

  private boolean isOwn(Event e) {
    return predicts
        && (e.player() == playerId
            || (ownKey != Event.NONE && (e.first() == ownKey || e.second() == ownKey)));
  }

  private void predict(Event event) {
    if (!isOwn(event)) {
      return; // events of others are guesses until the server sends them
    }
    Entry same = find(event, false);
    if (same != null) {
      same.computed = true;
      same.tick = same.confirmed ? same.tick : event.tick();
    } else if (event.tick() > completeTick) {
      Entry entry = add(event);
      if (entry != null) {
        entry.computed = true;
        entry.confirmed = false;
        fire(entry.event, true);
      }
    }
  }

  /**
   * Returns the entry nearest in time that may be the same event, or null; of two as near, the
   * earlier. An entry matches only near the tick at which it fired, however far resimulations have
   * moved it since.
   */
  private Entry find(Event event, boolean unconfirmedOnly) {
    Entry nearest = null;
    int best = tolerance + 1;
    for (int i = 0; i < entries.size(); i++) {
      Entry e = entries.get(i);
      boolean open = unconfirmedOnly ? !e.confirmed : !e.computed;
      boolean near = Math.abs(e.event.tick() - event.tick()) <= tolerance;
      if (e.used && open && near && e.event.isLike(event, origins)) {
        int apart = Math.abs(e.tick - event.tick());
        if (apart < best || (apart == best && nearest != null && e.tick < nearest.tick)) {
          best = apart;
          nearest = e;
        }
      }
    }
    return nearest;
  }

  /** Adds an entry in a free place or that of the oldest confirmed one; null if there is none. */
  private Entry add(Event event) {
    Entry oldest = null;
    for (int i = 0; i < entries.size(); i++) {
      Entry e = entries.get(i);
      if (!e.used) {
        oldest = e;
        break;
      }
      if (e.confirmed && (oldest == null || e.tick < oldest.tick)) {
        oldest = e;
      }
    }
    if ((oldest == null || oldest.used) && entries.size() < MAX_ENTRIES) {
      oldest = new Entry();
      entries.add(oldest);
    }
    if (oldest != null) {
      oldest.used = true;
      oldest.event.set(event);
      oldest.tick = event.tick();
    }
    return oldest;
  }

  // ---- the server

  /** Takes in an event from the server. Call it in the order of the server. */
  public void receive(Event event) {
    if (!isOwn(event)) {
      if (next - first == QUEUE) {
        fire(queue[(int) first++ & QUEUE_MASK], false);
      }
      int at = (int) next++ & QUEUE_MASK;
      if (queue[at] == null) {
        queue[at] = new Event();
      }
      queue[at].set(event);
      return;
    }
    Entry entry = find(event, true);
    if (entry != null) {
      entry.confirmed = true;
      confirmations++;
      return;
    }
    entry = add(event);
    if (entry != null) {
      entry.confirmed = true;
      entry.computed = false; // the prediction will find it
    }
    fire(event, false);
  }

  /** Notes that the server has sent all events up to a tick. */
  public void complete(int tick) {
    if (tick <= completeTick) {
      return;
    }
    completeTick = tick;
    for (int i = 0; i < entries.size(); i++) {
      Entry e = entries.get(i);
      if (!e.used) {
        continue;
      }
      if (!e.confirmed && e.tick + tolerance <= tick) {
        e.used = false;
        retractions++;
        listener.retracted(e.event);
      } else if (e.confirmed && e.tick + KEEP_TICKS < tick) {
        e.used = false;
      }
    }
  }

  /** Fires the queued events up to the tick that the interpolated picture has come to. */
  public void advance(double tick) {
    while (first < next && queue[(int) first & QUEUE_MASK].tick() <= tick) {
      fire(queue[(int) first++ & QUEUE_MASK], false);
    }
    if (first == next) {
      first = 0; // reuses the first places: most clients need a few
      next = 0;
    }
  }

  /**
   * Fires own events like those of all others from now on, because the prediction has ended, and
   * retracts those that wait for the server's word.
   */
  public void stopPredicting() {
    predicts = false;
    forget();
  }

  /** Fires all queued events and retracts all unconfirmed ones. */
  public void close() {
    advance(Double.MAX_VALUE);
    forget();
  }

  private void forget() {
    for (int i = 0; i < entries.size(); i++) {
      Entry e = entries.get(i);
      if (e.used && !e.confirmed) {
        retractions++;
        listener.retracted(e.event);
      }
      e.used = false;
    }
  }

  private void fire(Event event, boolean isPredicted) {
    fired++;
    listener.happened(event, isPredicted);
  }

  // ---- for inspection

  /** Returns how many events fired, including those that were retracted later. */
  public long fired() {
    return fired;
  }

  /** Returns how many predicted events the server confirmed. */
  public long confirmed() {
    return confirmations;
  }

  /** Returns how many predicted events were retracted. */
  public long retracted() {
    return retractions;
  }
}
