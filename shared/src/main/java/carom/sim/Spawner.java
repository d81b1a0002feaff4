package carom.sim;

import carom.physics.math.Limits;
import carom.sim.entity.EntityTable;
import carom.sim.entity.HostEntity;
import carom.sim.entity.HostPlayer;
import carom.sim.entity.Player;
import carom.sim.entity.ProvisionalEntities;
import carom.sim.level.Archetype;
import carom.sim.phase.Phase;
import carom.sim.phase.Phases;
import carom.sim.spawn.Origin;

/**
 * Creates and destroys entities. While {@link Game#input} of a player runs, that is what both sides
 * compute: a server creates an entity of the next free id, and a client one of the same {@link
 * Origin}, under the server's id if it knows that already.
 */
final class Spawner implements Phases.Listener {
  private final SimParts parts;
  private final EntityTable entities;
  private final ProvisionalEntities provisional;

  /** Number of spawns of the input that runs. */
  private int spawnsOfInput;

  Spawner(SimParts parts) {
    this.parts = parts;
    entities = parts.entities;
    provisional = entities.provisional();
    parts.phases.listen(this, Phase.INPUT);
  }

  @Override
  public void began(Phase phase) {
    spawnsOfInput = 0;
  }

  @Override
  public void ended(Phase phase) {
    if (parts.role == Role.PREDICTION) {
      dropUnpredicted(parts.phases.player());
    }
  }

  /** Removes what a player's input spawned, unless the player is the own one. */
  private void dropUnpredicted(HostPlayer player) {
    boolean predicted = isPredicted(player.id());
    for (int i = provisional.count() - 1; i >= 0 && !predicted; i--) {
      if (provisional.at(i).ownerId() == player.id()) {
        entities.despawn(provisional.at(i));
      }
    }
  }

  private boolean isPredicted(int playerId) {
    return parts.ownSpawns != null && parts.ownSpawns.predicts(playerId);
  }

  /** Creates an entity, as {@link Match#spawn(Archetype, float, float, float, Player)} says. */
  HostEntity spawn(Archetype archetype, float x, float y, float angle, HostPlayer owner) {
    parts.phases.requireOutsideInput("Match.spawn");
    parts.phases.requireAuthority("spawn");
    int ownerId = owner == null ? HostEntity.NO_OWNER : owner.id();
    return entities.spawn(archetype, x, y, angle, ownerId, parts.tick);
  }

  /** Creates what a player fires in its input, as {@link Player#spawn} says. */
  HostEntity fire(Archetype archetype, float x, float y, float angle, HostPlayer owner) {
    Limits.notNull("archetype", archetype);
    HostPlayer inputOf = parts.phases.player();
    if (inputOf == null) {
      throw new IllegalStateException(
          "Player.spawn is for Game.input alone; call Match.spawn in callbacks of the server");
    }
    if (owner != inputOf) {
      throw new IllegalArgumentException(
          "owner="
              + owner
              + " isn't the player whose Game.input runs, "
              + inputOf
              + "; spawn what belongs to others in Game.beforeStep or Game.afterStep");
    }
    if (spawnsOfInput == Origin.MOST_PER_CALL) {
      throw new IllegalStateException(
          "spawns=" + spawnsOfInput + " is the most that one call of Game.input may make");
    }
    int origin = Origin.of(parts.tick, spawnsOfInput++);
    HostEntity entity =
        parts.role == Role.AUTHORITY
            ? entities.spawn(archetype, x, y, angle, owner.id(), parts.tick)
            : predict(origin, archetype, x, y, angle, owner.id());
    entity.fieldValues().spawner(owner);
    entities.setOrigin(entity, origin);
    return entity;
  }

  private HostEntity predict(
      int origin, Archetype archetype, float x, float y, float angle, int ownerId) {
    if (!isPredicted(ownerId)) {
      // It goes with the end of the call. The own player's may have the same origin.
      int id = Origin.passing(origin);
      return entities.spawnProvisional(id, archetype, x, y, angle, ownerId, parts.tick);
    }
    int key = parts.ownSpawns.key(origin);
    HostEntity known = key < 0 ? null : entities.get(key & 0xffff);
    if (known != null && known.generation() == key >>> 16) {
      despawn(known); // the tick is computed again
      known = null;
    }
    if (key < 0 || known != null) {
      return entities.spawnProvisional(origin, archetype, x, y, angle, ownerId, parts.tick);
    }
    int id = key & 0xffff;
    return entities.spawnAs(id, key >>> 16, archetype, x, y, angle, ownerId, false, parts.tick);
  }

  /** Destroys an entity, as {@link SimulationHost#despawn} says. */
  void despawn(HostEntity entity) {
    parts.phases.requireOutsidePhysics("despawn");
    if (!entities.holds(entity) || !mayDespawn(entity)) {
      return;
    }
    if (parts.history != null) {
      parts.history.forget(entity.bodySlot());
    }
    if (entity.isRoot()) {
      for (int i = 0; i < entities.capacity(); i++) {
        HostEntity member = entities.get(i);
        if (member != null && member != entity && member.root() == entity) {
          despawn(member);
        }
      }
    }
    entities.despawn(entity);
  }

  /** Returns false for what a client can't predict: that an input despawns what isn't its own. */
  private boolean mayDespawn(HostEntity entity) {
    if (entity.isOwned() && parts.phases.now() == Phase.RULES) {
      parts.phases.requireOutsideRules("despawn of " + entity + ", which belongs to a player,");
    }
    HostPlayer inputOf = parts.phases.player();
    return inputOf == null
        || parts.role == Role.AUTHORITY
        || (entity.ownerId() == inputOf.id() && entity != inputOf.entity());
  }
}
