package carom.sim;

import carom.physics.Body;
import carom.sim.level.Archetype;
import carom.sim.level.Level;

/**
 * One thing in the world: a body with an identity, a kind and perhaps an owner. The static geometry
 * of the level consists of entities too, with the id {@link #LEVEL}.
 *
 * <p>A handle, valid until despawned; its id is then given to another entity with another
 * generation.
 */
public final class Entity {
  /** The id of static level geometry, which never appears in snapshots. */
  public static final int LEVEL = -1;

  /** The owner id of an entity that belongs to no player. */
  public static final int NO_OWNER = Level.NO_OWNER;

  private final int id;
  private final int generation;
  private final Archetype archetype;
  private final int ownerId;
  private final EntityTable table;
  private int tag;
  private int teleports;
  private Body<Entity> body;
  private int bodySlot;

  Entity(EntityTable table, int id, int generation, Archetype archetype, int ownerId) {
    this.table = table;
    this.id = id;
    this.generation = generation;
    this.archetype = archetype;
    this.ownerId = ownerId;
    tag = archetype.tag();
  }

  /** The slot, 0..65534, or {@link #LEVEL}. */
  public int id() {
    return id;
  }

  /** How often the slot has been used before, modulo 256: tells two users of one slot apart. */
  public int generation() {
    return generation;
  }

  /** Its kind. */
  public Archetype archetype() {
    return archetype;
  }

  /** The player it belongs to, or {@link #NO_OWNER}. */
  public int ownerId() {
    return ownerId;
  }

  /** Its body; invalid once the entity is despawned. */
  public Body<Entity> body() {
    return body;
  }

  /** Must be called once, before anybody sees the entity. */
  void body(Body<Entity> made) {
    body = made;
    bodySlot = made.index();
  }

  /** The index of its body, known without looking at that. */
  public int bodySlot() {
    return bodySlot;
  }

  /** Whether this is static level geometry. */
  public boolean isLevel() {
    return id == LEVEL;
  }

  /** A number with a meaning of the game's own; starts as the archetype's tag. */
  public int tag() {
    return tag;
  }

  /**
   * Changes the tag. It is hashed and saved, but not sent: what must look different on the clients
   * needs another archetype.
   */
  public void tag(int value) {
    tag = value;
  }

  /**
   * Puts the body somewhere else, as a respawn or a gate does: clients show it here and then there,
   * and nothing between. {@link Body#setPose} alone says that it moved, fast.
   *
   * @param x origin, metres
   * @param y origin, metres
   * @param angle radians, counter-clockwise
   */
  public void teleport(float x, float y, float angle) {
    body.setPose(x, y, angle);
    teleports++;
    table.noteChange();
  }

  /** How often it was {@linkplain #teleport teleported}. Saved, but decides nothing. */
  public int teleports() {
    return teleports;
  }

  void teleports(int value) {
    teleports = value;
  }

  @Override
  public String toString() {
    return archetype.name() + "(id=" + id + " generation=" + generation + ")";
  }
}
