package carom.client;

import carom.client.prediction.Prediction;
import carom.client.stats.NetStatsRecorder;
import carom.net.codec.Quantizer;
import carom.net.snapshot.frame.EventInbox;
import carom.net.snapshot.frame.EventRecord;
import carom.sim.SimulationHost;
import carom.sim.event.EventKind;
import carom.sim.outbox.Event;
import carom.sim.spawn.Origin;

/**
 * Passes the events of snapshots to the {@link EventReconciler}: drops repeated ones, looks up
 * their kinds, and converts their units. One stay's; one thread.
 */
final class EventReceiver {
  private final SimulationHost simulation;
  private final RepeatedEventFilter repeats;
  private final NetStatsRecorder stats;
  private final EventReconciler reconciler;
  private final Event event = new Event();

  /**
   * Creates a receiver for a new link.
   *
   * @param repeats outlives the link
   * @param prediction of the own body; null if it isn't predicted
   * @param listener receives each event once
   */
  EventReceiver(
      SimulationHost simulation,
      int playerId,
      Prediction prediction,
      RepeatedEventFilter repeats,
      NetStatsRecorder stats,
      EventListener listener) {
    this.simulation = simulation;
    this.repeats = repeats;
    this.stats = stats;
    reconciler =
        new EventReconciler(
            playerId,
            prediction != null,
            prediction == null ? key -> Origin.NONE : prediction.spawns()::origin,
            simulation.tickRate(),
            listener);
    simulation.addJournal(reconciler);
  }

  /** Takes in the events that the last snapshot completed. */
  void receive(EventInbox inbox) {
    for (EventRecord r; (r = inbox.poll()) != null; ) {
      if (!repeats.accept(r.tick, inbox.missed())) {
        continue;
      }
      EventKind kind = simulation.eventKinds().get(r.kind);
      if (kind == null) {
        stats.malformed();
        continue;
      }
      reconciler.receive(
          event.set(
              kind,
              r.tick,
              r.player,
              r.first,
              r.second,
              Quantizer.positionOf(r.x),
              Quantizer.positionOf(r.y),
              r.strengthOf(),
              r.data));
    }
    reconciler.complete(inbox.completeTick());
    stats.eventsMissed(inbox.missed());
  }

  /** Fires the events up to the tick that is drawn. */
  void advance(double renderTick) {
    reconciler.advance(renderTick);
  }

  /** Fires the own events, too, when the server tells them, as nothing is predicted any more. */
  void stopPredicting() {
    reconciler.stopPredicting();
  }

  /** Fires what waits, and retracts what isn't confirmed. */
  void close() {
    reconciler.close();
  }
}
