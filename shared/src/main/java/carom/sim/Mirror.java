package carom.sim;

import carom.physics.Joint;
import carom.sim.entity.HostEntity;
import carom.sim.entity.HostPlayer;
import carom.sim.entity.Newcomer;
import carom.sim.field.EntityRef;
import carom.sim.level.Archetype;
import carom.sim.ruling.Rulings;
import carom.sim.spawn.Origin;
import carom.sim.spawn.OwnSpawns;

/**
 * Takes over from the server what a client's simulation can't compute: its tick, players, entities
 * and joints under the server's ids, and what the server says of its rules. For {@link
 * Role#PREDICTION} only. One thread.
 */
public final class Mirror {
  private final SimParts parts;

  Mirror(SimParts parts) {
    this.parts = parts;
  }

  /**
   * Sets the tick of the mirrored state, so that paths of kinematic bodies and timers agree with
   * the server's.
   *
   * @throws IllegalStateException on {@link Role#AUTHORITY}
   */
  public void tick(int value) {
    parts.phases.requirePrediction("tick");
    parts.tick = value;
  }

  /**
   * Sets what is known of the server's rules.
   *
   * @param known asked in every step from now on
   * @throws IllegalStateException on {@link Role#AUTHORITY}
   */
  public void rulings(Rulings known) {
    parts.phases.requirePrediction("rulings");
    parts.rulings = known;
  }

  /**
   * Sets what is known of the entities that the own player's {@link Game#input} spawns. Without it,
   * they live until the end of the call.
   *
   * @throws IllegalStateException on {@link Role#AUTHORITY}
   */
  public void ownSpawns(OwnSpawns known) {
    parts.phases.requirePrediction("ownSpawns");
    parts.ownSpawns = known;
  }

  /**
   * Mirrors a player of the server, usually the client's own. The body follows by {@link #spawn}.
   *
   * @param id 0..1,023, as the server says
   * @param name its name
   * @throws IllegalStateException on {@link Role#AUTHORITY}, or when the id is taken
   */
  public HostPlayer join(int id, String name) {
    parts.phases.requirePrediction("mirror().join");
    parts.players.requireFree(id);
    return parts.players.add(id, Newcomer.stranger(name));
  }

  /**
   * Mirrors an entity of the server under the server's id. An entity under that id with another
   * generation or archetype must be despawned before. If the owner is a player here and has no
   * body, this becomes the body.
   *
   * @param id 0..65534
   * @param generation 0..255
   * @param archetype its archetype
   * @param x position of the body's origin, metres
   * @param y position of the body's origin, metres
   * @param angle radians, counterclockwise
   * @param ownerId a player's id, whether the player is known here or not, or {@link
   *     HostEntity#NO_OWNER}
   * @throws IllegalStateException on {@link Role#AUTHORITY}, or when the id is taken
   * @throws IllegalArgumentException when the id or generation is out of range
   */
  public HostEntity spawn(
      int id, int generation, Archetype archetype, float x, float y, float angle, int ownerId) {
    return spawn(id, generation, archetype, x, y, angle, ownerId, true);
  }

  /**
   * Mirrors an entity of the server as the other {@code spawn}.
   *
   * @param mayBeBody whether it becomes the body of its owner if that has none
   */
  public HostEntity spawn(
      int id,
      int generation,
      Archetype archetype,
      float x,
      float y,
      float angle,
      int ownerId,
      boolean mayBeBody) {
    parts.phases.requirePrediction("mirror().spawn");
    return parts.entities.spawnAs(
        id, generation, archetype, x, y, angle, ownerId, mayBeBody, parts.tick);
  }

  /**
   * Mirrors a joint of the server. Joints must be mirrored in ascending order of their keys.
   *
   * @param key as the server's {@code JointTable} has it
   * @param root id of the root of its assembly, or as {@code JointTable.root} says
   * @param number which joint of it
   * @param a null for the world
   * @param b another entity
   * @param definition what it is made with, see {@code World.createJoint(Body, Body, int[], int)}
   * @param at where that begins
   * @throws IllegalStateException on {@link Role#AUTHORITY}
   * @throws IllegalArgumentException if the definition is damaged; no joint is made then
   */
  public Joint<HostEntity> connect(
      int key, int root, int number, HostEntity a, HostEntity b, int[] definition, int at) {
    parts.phases.requirePrediction("mirror().connect");
    Joint<HostEntity> joint =
        parts.joints.create(
            key, root, number, a == null ? null : a.body(), b.body(), definition, at);
    if (root >= 0) {
      if (a != null) {
        parts.entities.join(root, a);
      }
      parts.entities.join(root, b);
    }
    return joint;
  }

  /**
   * Mirrors which spawn of its owner's {@link Game#input} an entity of the server is. A provisional
   * entity of that origin goes, and fields that mean it mean this one.
   *
   * @param entity an entity that isn't provisional
   * @param origin see {@link HostEntity#origin}; nothing happens if it is none
   * @throws IllegalStateException on {@link Role#AUTHORITY}
   */
  public void identify(HostEntity entity, int origin) {
    parts.phases.requirePrediction("identify");
    if (origin == Origin.NONE) {
      return;
    }
    if (parts.entities.get(origin) != null) {
      parts.entities.despawn(parts.entities.get(origin));
    }
    parts.allFields.replaceEntity(
        EntityRef.word(origin, 0), EntityRef.word(entity.id(), entity.generation()));
    entity.fieldValues().spawner(parts.players.get(entity.ownerId()));
    parts.entities.setOrigin(entity, origin);
  }

  /**
   * Takes the present words of the match and the present bodies as those of one tick of the server:
   * where rules count more in a sensor than there are here, the rest is what this client doesn't
   * have. From now on that counts, too.
   */
  public void anchor() {
    parts.phases.requirePrediction("anchor");
    parts.inside.anchor();
  }

  /** Takes bodies over that were put in place of others: who is in a sensor has not entered it. */
  public void resume() {
    anchor();
    if (parts.triggers != null) {
      parts.triggers.restore();
    }
  }

  /**
   * Returns the number of {@linkplain HostEntity#isProvisional provisional} entities; 0 on {@link
   * Role#AUTHORITY}. They aren't below {@link SimulationHost#entityCapacity}.
   */
  public int provisionalCount() {
    return parts.entities.provisional().count();
  }

  /** Returns a provisional entity, in the order in which they were spawned. */
  public HostEntity provisional(int index) {
    return parts.entities.provisional().at(index);
  }
}
