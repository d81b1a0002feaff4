package carom.client.desktop.game;

import com.badlogic.gdx.utils.LongMap;
import java.util.ArrayDeque;
import java.util.Iterator;
import java.util.function.Supplier;

/**
 * Remembers what an effect knows of each entity in the picture, from frame to frame. An entity that
 * a frame lacks is forgotten. Memory follows the number of entities, never their ids: those of
 * predicted spawns begin at 2^30. Render thread only; allocates only for more entities than before.
 *
 * @param <T> what the effect knows of an entity
 */
final class SeenEntities<T extends SeenEntities.Seen> {
  /** The part of an effect's knowledge of an entity that all effects have in common. */
  abstract static class Seen {
    long frame;
    double quietUntil;
    boolean isNew;

    /** Returns whether the entity hadn't been seen when it was last asked for. */
    final boolean isNew() {
      return isNew;
    }

    /** Returns whether the entity's last effect was so recent that it has no other one. */
    final boolean isQuiet(double now) {
      return now < quietUntil;
    }

    /** Lets the entity have no effect until a moment. */
    final void quieten(double until) {
      quietUntil = until;
    }
  }

  private final Supplier<T> maker;
  private final LongMap<T> known = new LongMap<>();
  private final ArrayDeque<T> spare = new ArrayDeque<>();
  private long frame;

  /** Creates an empty memory; {@code maker} makes the knowledge of one more entity. */
  SeenEntities(Supplier<T> maker) {
    this.maker = maker;
  }

  /** Forgets all entities. */
  void clear() {
    for (T seen : known.values()) {
      spare.add(seen);
    }
    known.clear();
  }

  /** Begins a frame and forgets the entities that the last one lacked. */
  void nextFrame() {
    Iterator<T> all = known.values();
    while (all.hasNext()) {
      T seen = all.next();
      if (seen.frame != frame) {
        all.remove();
        spare.add(seen);
      }
    }
    frame++;
  }

  /** Returns what is known of an entity of this frame. It is the caller's to change. */
  T see(int id, int generation) {
    long key = (long) generation << 32 | id;
    T seen = known.get(key);
    if (seen == null) {
      seen = spare.isEmpty() ? maker.get() : spare.poll();
      seen.isNew = true;
      seen.quietUntil = 0;
      known.put(key, seen);
    } else {
      seen.isNew = false;
    }
    seen.frame = frame;
    return seen;
  }

  /** Returns the number of entities that are known. */
  int size() {
    return known.size;
  }
}
