package carom.server.prediction;

import carom.sim.SimulationHost;
import carom.sim.entity.HostEntity;
import carom.sim.near.Neighbourhood;
import java.util.Arrays;

/** A list of entities that can be put in the order of the world. Allocates only to grow. */
final class EntityList {
  private HostEntity[] entities = new HostEntity[16];
  private long[] order = new long[16];
  private int count;

  void clear() {
    count = 0;
  }

  void add(HostEntity entity) {
    if (count == entities.length) {
      entities = Arrays.copyOf(entities, 2 * count);
    }
    entities[count++] = entity;
  }

  /** Removes the last entity and returns it. */
  HostEntity removeLast() {
    return entities[--count];
  }

  int count() {
    return count;
  }

  HostEntity get(int index) {
    return entities[index];
  }

  int key(int index) {
    return key(entities[index]);
  }

  static int key(HostEntity entity) {
    return Neighbourhood.key(entity.id(), entity.generation());
  }

  /** Returns the entity of a key; null when it is gone. */
  static HostEntity find(SimulationHost simulation, int key) {
    HostEntity entity = simulation.entity(Neighbourhood.id(key));
    return entity != null && key(entity) == key ? entity : null;
  }

  /** Sorts by the bodies' places in the world. The solver follows that order. */
  void sort(SimulationHost simulation) {
    if (order.length < count) {
      order = new long[entities.length];
    }
    for (int i = 0; i < count; i++) {
      order[i] = (long) entities[i].bodySlot() << Integer.SIZE | entities[i].id();
    }
    Arrays.sort(order, 0, count);
    for (int i = 0; i < count; i++) {
      entities[i] = simulation.entity((int) order[i]);
    }
  }
}
