package carom.sim.entity;

import carom.physics.Body;
import carom.physics.BodyType;
import carom.physics.Joint;
import carom.physics.math.Limits;
import carom.physics.math.Transform;
import carom.sim.field.EntityRef;
import carom.sim.field.FieldValues;
import carom.sim.level.Archetype;
import carom.sim.level.Level;
import carom.sim.spawn.Origin;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.Predicate;

/**
 * An entity as what runs a simulation holds it: with its body, its generation and its values.
 *
 * <p>An entity is a handle that is valid until it is despawned. Its id is then given to another
 * entity, with another generation.
 *
 * <p>A client that predicts {@code Game.input} has entities before the server tells their ids. Such
 * an entity is <em>provisional</em>: its id is its {@link #origin}. When the server tells which of
 * its entities it is, that one takes its place.
 */
public final class HostEntity implements Entity {
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

  @Override
  public int id() {
    return id;
  }

  /**
   * Returns how often the slot was used before, modulo 256. It tells two users of one slot apart.
   */
  public int generation() {
    return generation;
  }

  @Override
  public Archetype archetype() {
    return archetype;
  }

  /** Takes over an archetype, without its tag. The body must be as it says. */
  void archetype(Archetype value) {
    archetype = value;
    table.begunAs(this);
  }

  @Override
  public void become(Archetype other) {
    table.changing(this);
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

  @Override
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

  @Override
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

  @Override
  public void teleport(float x, float y, float angle) {
    if (isLevel()) {
      throw new IllegalStateException(
          this
              + " can't be teleported: clients know static geometry by the level alone; move an"
              + " entity of a static archetype");
    }
    Limits.position("x", x);
    Limits.position("y", y);
    Limits.range("angle", angle, -1e5f, 1e5f);
    table.changing(this);
    if (isRoot()) {
      table.moveAssembly(this, x, y, angle);
    } else {
      table.wakeAround(this);
      body.setPose(x, y, angle);
    }
    table.wakeAround(this);
    teleports++;
    table.noteChange();
  }

  /** Moves the body with another one, as if both were one rigid body, and counts as a teleport. */
  void teleportWith(Transform before, Transform after) {
    float c = after.cos * before.cos + after.sin * before.sin;
    float s = after.sin * before.cos - after.cos * before.sin;
    body.setPose(
        xWith(before, after),
        yWith(before, after),
        c * body.cos() - s * body.sin(),
        s * body.cos() + c * body.sin());
    teleports++;
  }

  /** Checks that {@link #teleportWith} may take the body there. */
  void requireRoom(Transform before, Transform after) {
    Limits.position("x", xWith(before, after));
    Limits.position("y", yWith(before, after));
  }

  private float xWith(Transform before, Transform after) {
    float c = after.cos * before.cos + after.sin * before.sin;
    float s = after.sin * before.cos - after.cos * before.sin;
    return after.x + c * (body.x() - before.x) - s * (body.y() - before.y);
  }

  private float yWith(Transform before, Transform after) {
    float c = after.cos * before.cos + after.sin * before.sin;
    float s = after.sin * before.cos - after.cos * before.sin;
    return after.y + s * (body.x() - before.x) + c * (body.y() - before.y);
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

  // ---- the face of games

  @Override
  public float x() {
    return body.x();
  }

  @Override
  public float y() {
    return body.y();
  }

  @Override
  public float centerX() {
    return body.centerX();
  }

  @Override
  public float centerY() {
    return body.centerY();
  }

  @Override
  public float angle() {
    return body.angle();
  }

  @Override
  public float cos() {
    return body.cos();
  }

  @Override
  public float sin() {
    return body.sin();
  }

  @Override
  public float velocityX() {
    return body.velocityX();
  }

  @Override
  public float velocityY() {
    return body.velocityY();
  }

  @Override
  public float angularVelocity() {
    return body.angularVelocity();
  }

  @Override
  public float velocityAtX(float worldX, float worldY) {
    return body.velocityAtX(worldX, worldY);
  }

  @Override
  public float velocityAtY(float worldX, float worldY) {
    return body.velocityAtY(worldX, worldY);
  }

  @Override
  public float worldPointX(float localX, float localY) {
    return body.worldPointX(localX, localY);
  }

  @Override
  public float worldPointY(float localX, float localY) {
    return body.worldPointY(localX, localY);
  }

  @Override
  public float localPointX(float worldX, float worldY) {
    return body.localPointX(worldX, worldY);
  }

  @Override
  public float localPointY(float worldX, float worldY) {
    return body.localPointY(worldX, worldY);
  }

  @Override
  public float mass() {
    return body.mass();
  }

  @Override
  public float inertia() {
    return body.inertia();
  }

  @Override
  public void applyForce(float fx, float fy) {
    changing().applyForce(fx, fy);
  }

  @Override
  public void applyForce(float fx, float fy, float px, float py) {
    changing().applyForce(fx, fy, px, py);
  }

  @Override
  public void applyAmbientForce(float fx, float fy, float torque) {
    changing().applyAmbientForce(fx, fy, torque);
  }

  @Override
  public void applyTorque(float torque) {
    changing().applyTorque(torque);
  }

  @Override
  public void applyImpulse(float jx, float jy) {
    changing().applyImpulse(jx, jy);
  }

  @Override
  public void applyImpulse(float jx, float jy, float px, float py) {
    changing().applyImpulse(jx, jy, px, py);
  }

  @Override
  public void applyAngularImpulse(float j) {
    changing().applyAngularImpulse(j);
  }

  @Override
  public void setVelocity(float vx, float vy) {
    changing().setVelocity(vx, vy);
  }

  @Override
  public void setAngularVelocity(float radPerSecond) {
    changing().setAngularVelocity(radPerSecond);
  }

  @Override
  public void wake() {
    changing().wake();
  }

  @Override
  public boolean isAwake() {
    return body.awake();
  }

  @Override
  public boolean isDynamic() {
    return body.type() == BodyType.DYNAMIC;
  }

  @Override
  public void seekVelocity(float goalX, float goalY, float rate) {
    changing().seekVelocity(goalX, goalY, rate * body.mass());
  }

  @Override
  public void moveTo(float x, float y, float angle) {
    changing().moveTo(x, y, angle, 1f / table.tickRate());
  }

  @Override
  public HostPlayer owner() {
    return table.players().get(ownerId);
  }

  @Override
  public boolean isOwned() {
    return ownerId != NO_OWNER;
  }

  @Override
  public boolean isOfSameOwner(Entity other) {
    return ownerId != NO_OWNER && ownerId == ((HostEntity) Limits.notNull("other", other)).ownerId;
  }

  @Override
  public HostEntity part(String name) {
    return table.answers().part(this, name);
  }

  @Override
  public EntityJoint joint(String name) {
    return table.answers().joint(this, name);
  }

  @Override
  public void forEachJoint(Consumer<EntityJoint> visitor) {
    Limits.notNull("visitor", visitor);
    List<Joint<HostEntity>> joints = new ArrayList<>();
    body.forEachJoint(joints::add);
    joints.forEach(joint -> visitor.accept(table.face(joint)));
  }

  void destroy(Joint<HostEntity> joint) {
    table.destroy(joint);
  }

  /** Returns the body, which the game changes now. */
  private Body<HostEntity> changing() {
    table.changing(this);
    return body;
  }

  @Override
  public void despawn() {
    table.despawning(this);
    table.answers().despawn(this);
  }

  @Override
  public boolean isInside(String sensor) {
    return table.answers().isInside(this, sensor);
  }

  @Override
  public void forEachContact(EntityContactVisitor visitor) {
    table.forEachContact(body, Limits.notNull("visitor", visitor));
  }

  @Override
  public void forEachOverlap(Predicate<Entity> visitor) {
    table.forEachOverlap(this, Limits.notNull("visitor", visitor));
  }

  @Override
  public Ground ground() {
    return table.ground().find(body);
  }

  @Override
  public FieldValues fieldValues() {
    return fields;
  }

  @Override
  public int reference() {
    return id == LEVEL ? 0 : EntityRef.word(id, generation);
  }

  @Override
  public String toString() {
    return archetype.name() + "(id=" + id + " generation=" + generation + ")";
  }
}
