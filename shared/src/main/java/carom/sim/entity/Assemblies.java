package carom.sim.entity;

import carom.sim.level.Archetype;
import carom.sim.level.Archetypes;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.Collections;
import java.util.List;

/** The assemblies of one simulation, in the order they were added in {@code Game.setUp}. */
public final class Assemblies {
  private final Archetypes archetypes;

  /** By index of an archetype: whether bodies of an assembly other than its root have it. */
  private final BitSet parts = new BitSet();

  private final List<Assembly> list = new ArrayList<>();

  /** By index of an archetype: the assembly whose root has it, or null. */
  private final List<Assembly> byRoot = new ArrayList<>();

  /** Creates an empty list, whose bodies' archetypes are registered with others. */
  public Assemblies(Archetypes archetypes) {
    this.archetypes = archetypes;
  }

  /**
   * Registers an assembly and the archetypes of its bodies. Call it in {@code Game.setUp} only.
   *
   * @throws IllegalStateException after set-up
   * @throws IllegalArgumentException if it has no body, or a joint that holds others than it is
   *     given
   */
  public Assembly add(AssemblyDef def) {
    Assembly assembly = new Assembly(def, archetypes);
    int root = assembly.archetypes().get(0).index();
    while (byRoot.size() <= root) {
      byRoot.add(null);
    }
    byRoot.set(root, assembly);
    for (Archetype archetype : assembly.archetypes()) {
      parts.set(archetype.index(), archetype.index() != root);
    }
    list.add(assembly);
    return assembly;
  }

  /** Returns all assemblies; unmodifiable. */
  public List<Assembly> all() {
    return Collections.unmodifiableList(list);
  }

  /** Returns whether an archetype is that of a body of an assembly that isn't the root. */
  public boolean isPart(Archetype archetype) {
    return parts.get(archetype.index());
  }

  /** Returns the assembly whose root has an archetype, or null. */
  public Assembly of(Archetype root) {
    return root.index() < byRoot.size() ? byRoot.get(root.index()) : null;
  }
}
