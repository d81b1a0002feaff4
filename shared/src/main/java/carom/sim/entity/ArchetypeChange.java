package carom.sim.entity;

import carom.physics.Body;
import carom.physics.BodyType;
import carom.physics.math.Limits;
import carom.sim.level.Archetype;
import carom.sim.level.Archetypes;
import carom.sim.phase.Phases;

/** Lets entities become other archetypes, see {@link HostEntity#become}. One simulation's. */
final class ArchetypeChange {
  private final EntityTable table;
  private final AreaForces<HostEntity> areas;
  private final Phases<HostPlayer> phases;
  private final Archetypes archetypes;

  ArchetypeChange(
      EntityTable table,
      AreaForces<HostEntity> areas,
      Phases<HostPlayer> phases,
      Archetypes archetypes) {
    this.table = table;
    this.areas = areas;
    this.phases = phases;
    this.archetypes = archetypes;
  }

  /** Makes an entity one of another archetype. */
  void change(HostEntity entity, Archetype other) {
    Limits.notNull("archetype", other);
    phases.requireOutsidePhysics("become");
    check(entity, other);
    if (other == entity.archetype()) {
      return;
    }
    Body<HostEntity> body = entity.body();
    areas.go(entity.id());
    body.become(other.body(0, 0, 0));
    if (other.type() == BodyType.KINEMATIC) {
      body.setAngularVelocity(other.spin());
    }
    entity.archetype(other);
    entity.tag(other.tag());
    areas.come(entity.id(), body, other);
    table.noteChange();
  }

  private void check(HostEntity entity, Archetype other) {
    if (archetypes.get(other.index()) != other) {
      throw new IllegalArgumentException(
          "archetype="
              + other
              + " isn't one of this simulation; register it by archetypes().add in Game.setUp");
    }
    if (entity.isLevel()) {
      throw new IllegalStateException(
          "entity="
              + entity
              + " is static geometry of the level, which stays as it is; place it in the level's"
              + " \"bodies\", or spawn it");
    }
    if (!table.holds(entity)) {
      throw new IllegalStateException("entity=" + entity + " was despawned; ask Simulation.entity");
    }
    if (entity.isRoot()) {
      throw new IllegalStateException(
          "entity="
              + entity
              + " is the root of an assembly, which is known by its archetype; change one of its"
              + " other parts");
    }
  }
}
