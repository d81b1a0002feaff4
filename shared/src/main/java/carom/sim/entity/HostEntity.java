package carom.sim.entity;

import carom.physics.Body;
import carom.physics.math.Transform;
import carom.sim.field.EntityRef;
import carom.sim.field.FieldHolder;
import carom.sim.field.FieldValues;
import carom.sim.joint.JointTable;
import carom.sim.level.Archetype;
import carom.sim.level.Level;
import carom.sim.spawn.Origin;

/**
 * A body with an identity, an archetype and perhaps an owner. The static geometry of the level
 * consists of entities too, with the id {@link #LEVEL}.
 *
 * <p>An entity is a handle that is valid until it is despawned. Its id is then given to another
 * entity, with another generation.
 *
 * <p>A client that predicts {@code Game.input} has entities before the server tells their ids. Such
 * an entity is <em>provisional</em>: its id is its {@link #origin}. When the server tells which of
 * its entities it is, that one takes its place.
 */
public final class HostEntity extends FieldHolder<HostEntity, HostPlayer> {
  /** Id of static level geometry. It never appears in snapshots. */
  public static final int LEVEL = -1;

  /** Owner id of an entity that belongs to no player. */
  public static final int NO_OWNER = Level.NO_OWNER;

  /** Root id of an entity that belongs to no assembly. */
  static final int NO_ROOT = JointTable.NO_ROOT;

  private final int id;
  private final int generation;
  private Archetype archetype;
  private final int ownerId;
  private final EntityTable table;
  private final FieldValues fields;
  private int tag;
  private int teleports;
  private int origin = Origin.NONE;

  /** Id of the root of its assembly, the entity itself if it is the root, or {@link #NO_ROOT}. */
  private int rootId = NO_ROOT;

  private Body<HostEntity> body;
  private int bodySlot;

  HostEntity(EntityTable table, int id, int generation, Archetype archetype, int ownerId) {
    this.table = table;
    this.id = id;
    this.generation = generation;
    this.archetype = archetype;
    this.ownerId = ownerId;
    fields = table.newFields(archetype, id == LEVEL);
    tag = archetype.tag();
  }

  /** Returns the slot, 0..65534, {@link #LEVEL}, or the {@link #origin} of a provisional one. */
  public int id() {
    return id;
  }

  /**
   * Returns how often the slot was used before, modulo 256. It tells two users of one slot apart.
   */
  public int generation() {
    return generation;
  }

  /** Returns its archetype, which is another one after {@link #become}. */
  public Archetype archetype() {
    return archetype;
  }

  /** Takes over an archetype, without its tag. The body must be as it says. */
  void archetype(Archetype value) {
    archetype = value;
    table.begunAs(this);
  }

  /**
   * Makes this an entity of another archetype in its place: a player who crouches, a crate that
   * turns to ice, a ghost. Shapes, mass, type, damping, gravity scale, filter, sensor, materials,
   * locks, area, look and {@link #tag} are those of the new archetype. The same stay: id, owner,
   * fields, joints, the pose of the body's origin and the velocity there; but a static body is at
   * rest, a kinematic one turns as its archetype spins, and one with a path follows it. Contacts
   * end and begin anew in the next step; what then overlaps is pushed apart, so ask {@code
   * World.overlap...} first whether there is room to stand up.
   *
   * <p>{@code Game.input} may call it on both roles: then clients predict it, for every entity they
   * have. Where only the server calls it, clients are told at which tick it happened. Allocates.
   *
   * @param other of the same simulation; if it is the present one, nothing happens
   * @throws IllegalArgumentException if the simulation doesn't have the archetype
   * @throws IllegalStateException if the entity was despawned, is static geometry of the level, or
   *     the root of an assembly; during the physics, and in {@code Game.forces}
   */
  public void become(Archetype other) {
    table.changes().change(this, other);
  }

  /** Returns the id of the player it belongs to, or {@link #NO_OWNER}. */
  public int ownerId() {
    return ownerId;
  }

  /** Returns its body, which becomes invalid when the entity is despawned. */
  public Body<HostEntity> body() {
    return body;
  }

  /** Sets the body. It must be called once, before the entity is used. */
  void body(Body<HostEntity> made) {
    body = made;
    bodySlot = made.index();
  }

  /** Returns the index of its body without access to the body. */
  public int bodySlot() {
    return bodySlot;
  }

  /** Returns whether this is static level geometry. */
  public boolean isLevel() {
    return id == LEVEL;
  }

  /** Returns whether it is a client's own, spawned in {@code Game.input} and not told yet. */
  public boolean isProvisional() {
    return Origin.isProvisional(id);
  }

  /**
   * Returns which spawn of its owner's {@code Game.input} it is, see {@link Origin}; {@link
   * Origin#NONE} if none, or if the owner has {@value Origin#MOST_PER_PLAYER} newer ones.
   */
  public int origin() {
    return origin;
  }

  void origin(int value) {
    origin = value;
  }

  /** Returns a number with a meaning of the game's own. It starts as the archetype's tag. */
  public int tag() {
    return tag;
  }

  /**
   * Sets the tag. It is hashed and saved, but not sent: an entity that must look different on
   * clients needs another archetype.
   */
  public void tag(int value) {
    tag = value;
  }

  /**
   * Returns the root of the {@code assembly} that the entity belongs to. It is the entity itself if
   * it is the root, belongs to none, or if the root is gone.
   */
  public HostEntity root() {
    HostEntity root = rootId == NO_ROOT ? null : table.get(rootId);
    return root == null ? this : root;
  }

  int rootId() {
    return rootId;
  }

  void rootId(int value) {
    rootId = value;
  }

  /** Returns whether it is the root of an assembly. */
  public boolean isRoot() {
    return rootId == id;
  }

  /**
   * Puts the body somewhere else, as a respawn or a gate does. Clients show it here and then there,
   * and nothing between. {@link Body#setPose} alone would look like a fast movement. The root of an
   * assembly takes all of it along, rigidly, with the points over which its pulleys' ropes run. The
   * server makes its gears and pulleys anew, so handles of these end.
   *
   * @param x position of the body's origin, metres
   * @param y position of the body's origin, metres
   * @param angle radians, counterclockwise
   */
  public void teleport(float x, float y, float angle) {
    table.wakeAround(this);
    if (isRoot()) {
      table.moveAssembly(this, x, y, angle);
    } else {
      body.setPose(x, y, angle);
    }
    table.wakeAround(this);
    teleports++;
    table.noteChange();
  }

  /** Moves the body with another one, as if both were one rigid body, and counts as a teleport. */
  void teleportWith(Transform before, Transform after) {
    float dx = body.x() - before.x;
    float dy = body.y() - before.y;
    float c = after.cos * before.cos + after.sin * before.sin;
    float s = after.sin * before.cos - after.cos * before.sin;
    body.setPose(
        after.x + c * dx - s * dy,
        after.y + s * dx + c * dy,
        c * body.cos() - s * body.sin(),
        s * body.cos() + c * body.sin());
    teleports++;
  }

  /**
   * Returns how often it was {@linkplain #teleport teleported}. The number is saved, but not
   * hashed.
   */
  public int teleports() {
    return teleports;
  }

  void teleports(int value) {
    teleports = value;
  }

  @Override
  public FieldValues fieldValues() {
    return fields;
  }

  @Override
  protected int reference() {
    return id == LEVEL ? 0 : EntityRef.word(id, generation);
  }

  @Override
  public String toString() {
    return archetype.name() + "(id=" + id + " generation=" + generation + ")";
  }
}
