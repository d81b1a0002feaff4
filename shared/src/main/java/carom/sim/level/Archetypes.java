package carom.sim.level;

import carom.sim.Game;
import java.util.ArrayList;
import java.util.List;

/**
 * The archetypes of one simulation, in the order they were added: the level's statics and bodies in
 * file order, then what {@link Game#setUp} adds. Closed once set-up is over.
 */
public final class Archetypes {
  /** Most archetypes a simulation can have; an index fits 12 bits. */
  public static final int MAX = 4096;

  private final List<Archetype> list = new ArrayList<>();
  private boolean closed;

  public Archetypes() {}

  /**
   * Registers a kind of entity; call it in {@link Game#setUp} only.
   *
   * @throws IllegalStateException after set-up, or beyond {@value #MAX}
   * @throws IllegalArgumentException when the definition has no shape
   */
  public Archetype add(ArchetypeDef def) {
    if (closed) {
      throw new IllegalStateException(
          "archetype=" + def.name + " comes after set-up; register it in Game.setUp");
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

  /** How many there are. */
  public int size() {
    return list.size();
  }

  /** The archetype at an index in 0..size-1, or null outside: an index may come from the wire. */
  public Archetype get(int index) {
    return index >= 0 && index < list.size() ? list.get(index) : null;
  }

  /** The first archetype of that name, or null. Linear: for set-up, not for every tick. */
  public Archetype find(String name) {
    for (Archetype archetype : list) {
      if (archetype.name().equals(name)) {
        return archetype;
      }
    }
    return null;
  }

  public void close() {
    closed = true;
  }
}
