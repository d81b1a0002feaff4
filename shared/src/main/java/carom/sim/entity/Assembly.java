package carom.sim.entity;

import carom.physics.Body;
import carom.physics.BodyDef;
import carom.physics.Joint;
import carom.physics.JointDef;
import carom.physics.World;
import carom.physics.WorldDef;
import carom.physics.math.Limits;
import carom.physics.rows.JointDefRow;
import carom.sim.level.Archetype;
import carom.sim.level.Archetypes;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;

/**
 * Several bodies and joints that belong together: a car, a ragdoll. It is to a group of entities
 * what an {@link Archetype} is to one. Immutable.
 *
 * <p>{@code Simulation.spawn} makes its bodies as entities and its joints. The first body is the
 * root; all have one owner, and are teleported and despawned with the root.
 */
public final class Assembly {
  private final String name;
  private final List<AssemblyDef.Part> parts;
  private final List<AssemblyDef.PartJoint> joints;
  private final List<Archetype> archetypes = new ArrayList<>();
  private final int[] definitions;

  Assembly(AssemblyDef def, Archetypes registered) {
    if (Limits.notNull("def", def).parts.isEmpty()) {
      throw def.wrong("it has no body; add one");
    }
    name = def.name;
    parts = List.copyOf(def.parts);
    joints = List.copyOf(def.joints);
    for (AssemblyDef.Part part : parts) {
      archetypes.add(registered.add(part.archetype()));
    }
    definitions = new int[joints.size() * JointDefRow.INTS];
    define(def);
  }

  /** Makes the joints once, in a world of their own, to learn what they are in bodies' frames. */
  private void define(AssemblyDef def) {
    World<Object> world = new World<>(new WorldDef());
    List<Body<Object>> bodies = new ArrayList<>();
    for (int i = 0; i < parts.size(); i++) {
      AssemblyDef.Part part = parts.get(i);
      BodyDef body = archetypes.get(i).body(part.x(), part.y(), part.angle());
      bodies.add(world.createBody(body, null));
    }
    for (int i = 0; i < joints.size(); i++) {
      AssemblyDef.PartJoint part = joints.get(i);
      JointDef<Object> how = part.how().apply(bodies.get(part.a()), bodies.get(part.b()));
      Joint<Object> joint = world.createJoint(how);
      if (joint.bodyA() != bodies.get(part.a()) || joint.bodyB() != bodies.get(part.b())) {
        throw def.wrong("joint=" + part.name() + " must hold the two bodies it is given");
      }
      world.readJoint(joint, definitions, i * JointDefRow.INTS);
    }
  }

  /** Returns its name. */
  public String name() {
    return name;
  }

  /** Returns the archetypes of its bodies, the root's first; unmodifiable. */
  public List<Archetype> archetypes() {
    return Collections.unmodifiableList(archetypes);
  }

  /** Returns the number of bodies. */
  public int bodyCount() {
    return parts.size();
  }

  /** Returns the number of joints. */
  public int jointCount() {
    return joints.size();
  }

  /**
   * Returns the number of a body.
   *
   * @throws IllegalArgumentException if there is none of that name; the message lists the names
   */
  public int body(String bodyName) {
    for (int i = 0; i < parts.size(); i++) {
      if (parts.get(i).name().equals(bodyName)) {
        return i;
      }
    }
    List<String> names = new ArrayList<>();
    for (AssemblyDef.Part part : parts) {
      names.add(part.name());
    }
    throw unknown("body", bodyName, names);
  }

  /**
   * Returns the number of a joint.
   *
   * @throws IllegalArgumentException if there is none of that name; the message lists the names
   */
  public int joint(String jointName) {
    for (int i = 0; i < joints.size(); i++) {
      if (joints.get(i).name().equals(jointName)) {
        return i;
      }
    }
    List<String> names = new ArrayList<>();
    for (AssemblyDef.PartJoint part : joints) {
      names.add(part.name());
    }
    throw unknown("joint", jointName, names);
  }

  private IllegalArgumentException unknown(String what, String unknown, List<String> names) {
    return new IllegalArgumentException(
        "assembly=" + name + " has no " + what + "=" + unknown + "; it has " + names);
  }

  /** Returns where a body is in the assembly's frame, metres. */
  public float x(int body) {
    return parts.get(body).x();
  }

  /** Returns where a body is in the assembly's frame, metres. */
  public float y(int body) {
    return parts.get(body).y();
  }

  /** Returns the angle of a body in the assembly's frame, radians. */
  public float angle(int body) {
    return parts.get(body).angle();
  }

  /** Returns the number of body A of a joint. */
  public int bodyA(int joint) {
    return joints.get(joint).a();
  }

  /** Returns the number of body B of a joint. */
  public int bodyB(int joint) {
    return joints.get(joint).b();
  }

  /**
   * Returns the definitions of all joints in the assembly's frame, {@link JointDefRow#INTS} ints
   * each: the live array, which must not be changed.
   */
  public int[] definitions() {
    return definitions;
  }

  @Override
  public String toString() {
    return name;
  }
}
