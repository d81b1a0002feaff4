package carom.client.prediction;

import carom.net.snapshot.exact.SpawnList;
import carom.physics.rows.BodyRow;
import carom.sim.SimulationHost;
import carom.sim.entity.HostEntity;
import carom.sim.field.Scope;
import carom.sim.near.Neighbourhood;

/**
 * Settles what becomes of provisional entities once the server's state of a tick is known. Those
 * that it lists become its entities, in exactly their state, as soon as these are near. Those that
 * it doesn't list go. One prediction's; allocates nothing but entities.
 */
final class SpawnSettler {
  private final SimulationHost simulation;
  private final SnapshotRecords records;
  private final int[] row = new int[BodyRow.INTS];
  private final int[] words;

  SpawnSettler(SimulationHost simulation, SnapshotRecords records) {
    this.simulation = simulation;
    this.records = records;
    words = new int[simulation.schema().words(Scope.ENTITY)];
  }

  /**
   * Returns whether there is something to settle about a provisional entity.
   *
   * @param told the server's entities at a tick that isn't before the origin's
   */
  boolean isDue(int origin, SpawnList told) {
    return key(told, origin) < 0 || records.spawns().key(origin) >= 0;
  }

  /**
   * Settles the provisional entities of the simulation, which stands at a tick.
   *
   * @param told the server's entities at that tick
   */
  void settle(SpawnList told) {
    for (int i = simulation.mirror().provisionalCount() - 1; i >= 0; i--) {
      HostEntity entity = simulation.mirror().provisional(i);
      int key = key(told, entity.origin());
      if (key < 0 || !isSameKind(entity, key)) {
        simulation.despawn(entity);
      } else if (records.spawns().key(entity.origin()) == key) {
        become(entity, key);
      }
    }
  }

  private static int key(SpawnList told, int origin) {
    for (int i = 0; i < told.count(); i++) {
      if (told.origin(i) == origin) {
        return told.key(i);
      }
    }
    return -1;
  }

  private boolean isSameKind(HostEntity entity, int key) {
    return !records.isKnown(key) || records.archetype(Neighbourhood.id(key)) == entity.archetype();
  }

  private void become(HostEntity entity, int key) {
    int id = Neighbourhood.id(key);
    HostEntity known = simulation.entity(id);
    boolean isThere = known != null && known.generation() == Neighbourhood.generation(key);
    if (known != null && !isThere) {
      simulation.despawn(known); // the server has given its id to this one
    }
    if (isThere) {
      simulation.mirror().identify(known, entity.origin());
      return;
    }
    records.spawns().settle(key, entity.ownerId()); // its first record may still be on the way
    entity.body().readRow(row, 0);
    entity.fieldValues().copyTo(words, 0);
    HostEntity real =
        simulation
            .mirror()
            .spawn(
                id,
                Neighbourhood.generation(key),
                entity.archetype(),
                0,
                0,
                0,
                entity.ownerId(),
                false);
    real.body().writeRow(row, 0);
    real.fieldValues().copyFrom(words, 0);
    simulation.mirror().identify(real, entity.origin());
  }

  /** Removes all provisional entities, because the own body has changed. */
  void clear() {
    while (simulation.mirror().provisionalCount() > 0) {
      simulation.despawn(simulation.mirror().provisional(0));
    }
  }
}
