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
  public abstract static class Seen {
    private long frame;
    private double quietUntil;
    private boolean isNew;

    /** Creates the knowledge of an entity that hasn't been seen. */
    protected Seen() {}

    /** Returns whether the entity hadn't been seen when it was last asked for. */
    public final boolean isNew() {
      return isNew;
    }

    /** Returns whether the entity's last effect was so recent that it has no other one. */
    public final boolean isQuiet(double now) {
      return now < quietUntil;
    }

    /** Lets the entity have no effect until a moment. */
    public final void quieten(double until) {
      quietUntil = until;
    }
  }

  private final Supplier<T> maker;
  private final LongMap<T> known = new LongMap<>();
  private final ArrayDeque<T> spare = new ArrayDeque<>();
  private long frame;

  /** Creates an empty memory; {@code maker} makes the knowledge of one more entity. */
  public SeenEntities(Supplier<T> maker) {
    this.maker = maker;
  }

  /** Forgets all entities. */
  public void clear() {
    for (T seen : known.values()) {
      spare.add(seen);
    }
    known.clear();
  }

  /** Begins a frame and forgets the entities that the last one lacked. */
  public void nextFrame() {
    Iterator<T> all = known.values();
    while (all.hasNext()) {
      T seen = all.next();
      if (((Seen) seen).frame != frame) {
        all.remove();
        spare.add(seen);
      }
    }
    frame++;
  }

  /** Returns what is known of an entity of this frame. It is the caller's to change. */
  public T see(int id, int generation) {
    long key = (long) generation << 32 | id;
    T seen = known.get(key);
    if (seen == null) {
      seen = spare.isEmpty() ? maker.get() : spare.poll();
      ((Seen) seen).isNew = true;
      ((Seen) seen).quietUntil = 0;
      known.put(key, seen);
    } else {
      ((Seen) seen).isNew = false;
    }
    ((Seen) seen).frame = frame;
    return seen;
  }

  /** Returns the number of entities that are known. */
  public int size() {
    return known.size;
  }
}
