package carom.sim.entity;

import carom.sim.field.FieldHolder;
import carom.sim.level.Archetype;
import java.util.function.Consumer;
import java.util.function.Predicate;

/**
 * A body with an identity, an archetype and perhaps an owner, as a game holds it. The static
 * geometry of the level consists of entities, too.
 *
 * <p>An entity is a handle that is valid until it is despawned. Positions are in metres, the
 * world's y points up, and angles are in radians counterclockwise. What changes an entity may be
 * called where the game may change it: {@code input} for what its player owns, {@code forces} for
 * the one entity, and all of it in the callbacks that receive a {@code Match}.
 *
 * <p>Clients know a body by its archetype, its motion and what acts on it. So there is no mass, no
 * shape and no filter to be set: let the entity {@link #become} another archetype.
 */
public sealed interface Entity extends FieldHolder<Entity, Player> permits HostEntity {

  // ---- what it is

  /** Returns the id, 0..65534, which is another entity's once this one is despawned. */
  int id();

  /** Returns its archetype, which is another one after {@link #become}. */
  Archetype archetype();

  /** Returns whether this is static geometry of the level, which has no id of its own. */
  boolean isLevel();

  /** Returns whether the body moves by forces: it is neither static nor kinematic. */
  boolean isDynamic();

  /** Returns the player it belongs to, or null. */
  Player owner();

  /** Returns whether it belongs to a player; cheaper than {@link #owner}. */
  boolean isOwned();

  /** Returns whether both belong to the same player. */
  boolean isOfSameOwner(Entity other);

  /**
   * Returns the root of the assembly that the entity belongs to. It is the entity itself if it is
   * the root, belongs to none, or if the root is gone.
   */
  Entity root();

  /**
   * Returns a body of its assembly by its name. Clients know the members by their joints and find
   * none whose joints are all gone.
   *
   * @param name as the {@link carom.sim.entity.AssemblyDef} gives it
   * @return null if it was despawned, or if this client doesn't know it
   * @throws IllegalArgumentException if it has no assembly, or that has no body of that name
   */
  Entity part(String name);

  /**
   * Returns a joint of its assembly by its name.
   *
   * @param name as the {@link carom.sim.entity.AssemblyDef} gives it
   * @return null if it broke or was destroyed, or if this client doesn't simulate it
   * @throws IllegalArgumentException if it has no assembly, or that has no joint of that name
   */
  EntityJoint joint(String name);

  /** Visits its joints; the visitor may destroy the one that it sees. */
  void forEachJoint(Consumer<EntityJoint> visitor);

  /**
   * Makes this an entity of another archetype in its place: a player who crouches, a crate that
   * turns to ice, a ghost. Shapes, mass, type, damping, gravity scale, filter, sensor, materials,
   * locks, area and look are those of the new archetype. The same stay: id, owner, fields, joints,
   * the pose of the body's origin and the velocity there; but a static body is at rest, a kinematic
   * one turns as its archetype spins, and one with a path follows it. Contacts end and begin anew
   * in the next step; what then overlaps is pushed apart, so ask {@code overlaps} first whether
   * there is room to stand up.
   *
   * <p>{@code Game.input} may call it: then clients predict it, for every entity they have. Where
   * only the server calls it, clients are told at which tick it happened. Allocates.
   *
   * @param other of the same simulation; if it is the present one, nothing happens
   * @throws IllegalArgumentException if the simulation doesn't have the archetype
   * @throws IllegalStateException if the entity was despawned, is static geometry of the level, or
   *     the root of an assembly; during the physics, and in {@code Game.forces}
   */
  void become(Archetype other);

  /**
   * Destroys the entity with its joints, and with the root of an assembly all of it. If it was a
   * player's body, the player then has none. Nothing happens when it is gone already.
   *
   * <p>{@code Game.input} may call it. A client predicts it for what belongs to the player and
   * isn't its body. All else stays there until the server's word.
   *
   * @throws IllegalStateException during the physics, and in {@code Game.forces}
   */
  void despawn();

  // ---- where it is and how it moves

  /** Returns x of the body's origin, m. */
  float x();

  /** Returns y of the body's origin, m. */
  float y();

  /** Returns x of the centre of mass, m. */
  float centerX();

  /** Returns y of the centre of mass, m. */
  float centerY();

  /** Returns the angle, -pi..pi. */
  float angle();

  /** Returns the cosine of the angle. */
  float cos();

  /** Returns the sine of the angle. */
  float sin();

  /** Returns x of the velocity of the centre of mass, m/s. */
  float velocityX();

  /** Returns y of the velocity of the centre of mass, m/s. */
  float velocityY();

  /** Returns the angular velocity, rad/s. */
  float angularVelocity();

  /** Returns x of the velocity of a point of the world that moves with the body, m/s. */
  float velocityAtX(float worldX, float worldY);

  /** Returns y of the velocity of a point of the world that moves with the body, m/s. */
  float velocityAtY(float worldX, float worldY);

  /** Returns x in the world of a point of the body's frame, m. */
  float worldPointX(float localX, float localY);

  /** Returns y in the world of a point of the body's frame, m. */
  float worldPointY(float localX, float localY);

  /** Returns x in the body's frame of a point of the world, m. */
  float localPointX(float worldX, float worldY);

  /** Returns y in the body's frame of a point of the world, m. */
  float localPointY(float worldX, float worldY);

  /** Returns the mass, kg; 0 unless it {@link #isDynamic}. */
  float mass();

  /** Returns the moment of inertia about the centre of mass, kg m^2; 0 if it can't turn. */
  float inertia();

  /** Returns whether the body is simulated; what rests for half a second falls asleep. */
  boolean isAwake();

  // ---- what moves it

  /**
   * Pushes towards a velocity by the force {@code rate * mass * (goal - velocity)}, in the next
   * step. No rate makes it overshoot.
   *
   * @param goalX m/s
   * @param goalY m/s
   * @param rate how fast it gets there, 1/s; two thirds of the way in {@code 1 / rate} s
   */
  void seekVelocity(float goalX, float goalY, float rate);

  /** Pushes at the centre of mass in the next step, N, and wakes the body. */
  void applyForce(float fx, float fy);

  /** Pushes at a point of the world in the next step, N and m, and wakes the body. */
  void applyForce(float fx, float fy, float px, float py);

  /**
   * Pushes and turns in the next step without waking the body, N and N m: wind, water. A body that
   * only such forces act on may fall asleep.
   */
  void applyAmbientForce(float fx, float fy, float torque);

  /** Turns in the next step, N m. */
  void applyTorque(float torque);

  /** Pushes by a blow at the centre of mass, N s: the velocity changes as the next step begins. */
  void applyImpulse(float jx, float jy);

  /** Pushes by a blow at a point of the world as the next step begins, N s and m. */
  void applyImpulse(float jx, float jy, float px, float py);

  /** Changes the angular velocity as the next step begins, N m s. */
  void applyAngularImpulse(float j);

  /** Sets the velocity of the centre of mass, m/s. */
  void setVelocity(float vx, float vy);

  /** Sets the angular velocity, rad/s. */
  void setAngularVelocity(float radPerSecond);

  /** Gives a kinematic body the velocity that takes it to a pose within the next step. */
  void moveTo(float x, float y, float angle);

  /**
   * Puts the body somewhere else, as a respawn or a gate does. Clients show it here and then there,
   * and nothing between. The root of an assembly takes all of it along, rigidly, with the points
   * over which its pulleys' ropes run. The server makes its gears and pulleys anew, so handles of
   * these end.
   *
   * @param x position of the body's origin, metres
   * @param y position of the body's origin, metres
   * @param angle radians, counterclockwise
   */
  void teleport(float x, float y, float angle);

  /** Wakes the body. */
  void wake();

  // ---- what it touches

  /**
   * Visits the contacts of the last step.
   *
   * @param visitor a field of the game's, so that nothing is allocated; it must not spawn, despawn
   *     or change anything
   */
  void forEachContact(EntityContactVisitor visitor);

  /**
   * Visits what overlapped its sensors in the last step, or the sensors in which it was.
   *
   * @param visitor returns false to stop; it must change nothing
   */
  void forEachOverlap(Predicate<Entity> visitor);

  /**
   * Returns what the body stands on. Where it touches several, that is the one that bears most.
   *
   * @return valid until the next call of this method for any entity
   */
  Ground ground();

  /**
   * Returns whether it overlaps or touches a sensor of the level. It follows from where the entity
   * is now.
   *
   * @param sensor the name of {@code statics} of the level that are sensors
   * @throws IllegalArgumentException if the level has none of that name
   */
  boolean isInside(String sensor);
}
