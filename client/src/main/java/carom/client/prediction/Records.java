package carom.client.prediction;

import carom.client.interpolation.HistoryStates;
import carom.client.interpolation.Pose;
import carom.client.interpolation.States;
import carom.net.snapshot.EntityHistory;
import carom.net.snapshot.SnapshotDecoder;
import carom.net.snapshot.relay.RelayedInputs;
import carom.sim.Neighbourhood;
import carom.sim.Simulation;
import carom.sim.level.Archetype;

/** What has arrived: who is who, where everybody was, and what the other players did. */
final class Records implements Neighbourhood.Identity {
  /** Longest time a last known state is moved on in a straight line, ticks. */
  private static final int LONGEST_COAST = 9;

  private final Simulation simulation;
  private final HistoryStates states = new HistoryStates();
  private SnapshotDecoder decoder;

  Records(Simulation simulation) {
    this.simulation = simulation;
  }

  /** Reads from this decoder from now on. */
  void of(SnapshotDecoder newDecoder) {
    decoder = newDecoder;
  }

  RelayedInputs inputs() {
    return decoder.inputs();
  }

  @Override
  public Archetype archetype(int id) {
    return simulation.archetypes().get(decoder.history(id).archetype(0));
  }

  @Override
  public int owner(int id) {
    return decoder.history(id).owner(0);
  }

  /** Whether the newest record of a slot is of this entity, and its kind is known. */
  boolean know(int key) {
    EntityHistory history = decoder.history(Neighbourhood.id(key));
    return history != null
        && history.alive()
        && history.generation(0) == Neighbourhood.generation(key)
        && archetype(Neighbourhood.id(key)) != null;
  }

  /** How often an entity was teleported, as far as records tell; else 0. */
  int teleports(int id, int generation) {
    EntityHistory history = decoder.history(id);
    boolean known = history != null && history.alive() && history.generation(0) == generation;
    return known ? history.teleports(0) : 0;
  }

  /** Reads an entity's state after a tick, as far as records tell; false when they don't. */
  boolean pose(int key, int tick, Pose out) {
    int generation = Neighbourhood.generation(key);
    EntityHistory history = decoder.history(Neighbourhood.id(key));
    int index = history.indexAt(tick);
    if (index < 0 || !history.alive(index) || history.generation(index) != generation) {
      index = 0; // it is younger than the tick
    }
    if (!history.alive(index) || history.generation(index) != generation) {
      return false;
    }
    States s = states.of(history);
    int age = Math.max(0, Math.min(LONGEST_COAST, tick - s.tick(index)));
    float seconds = age * simulation.tickSeconds();
    out.set(
        s.x(index) + s.vx(index) * seconds,
        s.y(index) + s.vy(index) * seconds,
        s.angle(index) + s.omega(index) * seconds,
        s.vx(index),
        s.vy(index),
        s.omega(index));
    return true;
  }
}
