package carom.sim.entity;

import carom.physics.math.SimRandom;
import java.util.Arrays;

/**
 * The entities that a client has before the server tells them, in the order in which they were
 * spawned. Few at a time; a server has none. Allocates only to grow.
 */
public final class ProvisionalEntities {
  private HostEntity[] entities = {};
  private int count;

  /** Returns the number of provisional entities. */
  public int count() {
    return count;
  }

  /** Returns one by its index, below {@link #count}. */
  public HostEntity at(int index) {
    return entities[index];
  }

  /** Returns the one with an origin, or null. */
  HostEntity get(int origin) {
    for (int i = 0; i < count; i++) {
      if (entities[i].id() == origin) {
        return entities[i];
      }
    }
    return null;
  }

  void add(HostEntity entity) {
    if (count == entities.length) {
      entities = Arrays.copyOf(entities, Math.max(4, 2 * count));
    }
    entities[count++] = entity;
  }

  void remove(HostEntity entity) {
    int at = 0;
    while (entities[at] != entity) {
      at++;
    }
    System.arraycopy(entities, at + 1, entities, at, --count - at);
    entities[count] = null;
  }

  /** Mixes them into a state hash, which stays as it is when there are none. */
  long hash(long hash) {
    long h = hash;
    for (int i = 0; i < count; i++) {
      HostEntity e = entities[i];
      h = SimRandom.mix(e.fieldValues().hash(h), (long) e.id() << 32 | e.bodySlot());
      h = SimRandom.mix(h, e.archetype().index());
    }
    return h;
  }

  /** Copies them behind the other entities of a saved state. */
  void save(SavedEntities s) {
    s.provisionalCount = count;
    for (int i = 0; i < count; i++) {
      s.save(s.capacity + i, entities[i]);
    }
  }

  /** Takes them from a saved state. */
  void restore(SavedEntities s) {
    for (int i = 0; i < s.provisionalCount; i++) {
      if (i >= count) {
        add(s.entities[s.capacity + i]);
      }
      entities[i] = s.entities[s.capacity + i];
      s.restore(s.capacity + i, entities[i]);
    }
    if (count > s.provisionalCount) {
      Arrays.fill(entities, s.provisionalCount, count, null);
      count = s.provisionalCount;
    }
  }
}
