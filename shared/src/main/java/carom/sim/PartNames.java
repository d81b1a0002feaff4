package carom.sim;

import carom.physics.Joint;
import carom.sim.entity.Assemblies;
import carom.sim.entity.Assembly;
import carom.sim.entity.EntityTable;
import carom.sim.entity.HostEntity;
import carom.sim.entity.JointTable;
import carom.sim.level.Archetype;
import carom.sim.level.Level;

/** Finds the joints of a level, and the joints and bodies of assemblies, by their names. */
final class PartNames {
  private final Level level;
  private final Assemblies assemblies;
  private final EntityTable entities;
  private final JointTable<HostEntity> joints;

  /** Creates the names of a simulation's parts. */
  public PartNames(
      Level level, Assemblies assemblies, EntityTable entities, JointTable<HostEntity> joints) {
    this.level = level;
    this.assemblies = assemblies;
    this.entities = entities;
    this.joints = joints;
  }

  /**
   * Returns a joint of the level, or null if it is gone.
   *
   * @throws IllegalArgumentException if the level has no joint of that name
   */
  public Joint<HostEntity> joint(String name) {
    for (int i = 0; i < level.joints().size(); i++) {
      if (level.joints().get(i).name().equals(name)) {
        return joints.find(JointTable.LEVEL, i);
      }
    }
    throw new IllegalArgumentException(
        "level=" + level.name() + " has no joint with \"name\": \"" + name + "\"");
  }

  /**
   * Returns a joint of an entity's assembly, or null if it is gone.
   *
   * @throws IllegalArgumentException if the assembly has no joint of that name
   */
  public Joint<HostEntity> joint(HostEntity member, String name) {
    HostEntity root = member.root();
    return joints.find(root.id(), assembly(root).joint(name));
  }

  /**
   * Returns a body of an entity's assembly, or null if it is gone.
   *
   * @throws IllegalArgumentException if the assembly has no body of that name
   */
  public HostEntity body(HostEntity member, String name) {
    HostEntity root = member.root();
    Assembly assembly = assembly(root);
    Archetype archetype = assembly.archetypes().get(assembly.body(name));
    for (int i = 0; i < entities.capacity(); i++) {
      HostEntity e = entities.get(i);
      if (e != null && e.root() == root && e.archetype() == archetype) {
        return e;
      }
    }
    return null;
  }

  private Assembly assembly(HostEntity root) {
    Assembly assembly = assemblies.of(root.archetype());
    if (assembly == null) {
      throw new IllegalArgumentException(
          root + " is no assembly; spawn it by spawn(Assembly, ...)");
    }
    return assembly;
  }
}
