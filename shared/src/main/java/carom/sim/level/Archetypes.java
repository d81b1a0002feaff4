package carom.sim.level;

import carom.physics.math.Limits;
import java.util.ArrayList;
import java.util.List;

/**
 * The archetypes of one simulation, in the order they were added: the level's statics and bodies in
 * file order, then those that {@code Game.setUp} adds. No archetype can be added after set-up.
 */
public final class Archetypes {
  /** Most archetypes of a simulation. An index fits 12 bits. */
  public static final int MAX = 4096;

  private final List<Archetype> list = new ArrayList<>();
  private boolean closed;

  /** Creates an empty list. */
  public Archetypes() {}

  /**
   * Registers an archetype. Call it in {@code Game.setUp} only.
   *
   * @throws IllegalStateException after set-up, or beyond {@value #MAX}
   * @throws IllegalArgumentException when the definition has no shape
   */
  public Archetype add(ArchetypeDef def) {
    Limits.notNull("def", def);
    if (closed) {
      throw new IllegalStateException(
          "archetype=" + def.name + " is registered after set-up; register it in Game.setUp");
    }
    if (list.size() == MAX) {
      throw new IllegalStateException("archetype=" + def.name + " exceeds the limit of " + MAX);
    }
    if (def.shapes.isEmpty()) {
      throw new IllegalArgumentException("archetype=" + def.name + " has no shape; add one");
    }
    Archetype archetype = new Archetype(list.size(), def);
    list.add(archetype);
    return archetype;
  }

  /** Returns the number of archetypes. */
  public int size() {
    return list.size();
  }

  /**
   * Returns the archetype at an index, or null if there is none. The index may come from the wire.
   */
  public Archetype get(int index) {
    return index >= 0 && index < list.size() ? list.get(index) : null;
  }

  /**
   * Returns the first archetype of a name, or null. The search is linear: for set-up, not for every
   * tick.
   */
  public Archetype find(String name) {
    for (Archetype archetype : list) {
      if (archetype.name().equals(name)) {
        return archetype;
      }
    }
    return null;
  }

  /** Closes the list: no archetype can be added any more. */
  public void close() {
    closed = true;
  }
}
