package carom.physics;

import carom.physics.dynamics.store.Stamp;
import carom.physics.geometry.MassData;
import java.util.Arrays;

/**
 * The handles of bodies and joints by slot, with the shapes and own masses of the bodies. A world
 * has one such object, and each of its saved states has a copy. A copy is only made anew if a body
 * or joint was created, destroyed or changed.
 */
final class Handles<T> {
  private Object[] bodies = new Object[64];

  /** Shapes of each body. */
  private ShapeDef[][] shapes = new ShapeDef[64][];

  private MassData[] ownMasses = new MassData[64];
  private Object[] joints = new Object[16];

  /** Changes whenever a body is created, destroyed or edited. */
  private final Stamp structure = new Stamp();

  /** Changes whenever a joint is created or destroyed. */
  private final Stamp jointStructure = new Stamp();

  @SuppressWarnings("unchecked")
  Body<T> body(int slot) {
    return slot >= 0 && slot < bodies.length ? (Body<T>) bodies[slot] : null;
  }

  @SuppressWarnings("unchecked")
  Joint<T> joint(int slot) {
    return slot >= 0 && slot < joints.length ? (Joint<T>) joints[slot] : null;
  }

  ShapeDef[] shapes(int slot) {
    return shapes[slot];
  }

  void shapes(int slot, ShapeDef[] changed) {
    shapes[slot] = changed;
  }

  MassData ownMass(int slot) {
    return ownMasses[slot];
  }

  void ownMass(int slot, MassData changed) {
    ownMasses[slot] = changed;
  }

  /** Sets shapes and own mass of a body whose handle follows. */
  void consistsOf(int slot, ShapeDef[] itsShapes, MassData itsOwnMass) {
    ensureBodies(slot + 1);
    shapes[slot] = itsShapes;
    ownMasses[slot] = itsOwnMass;
  }

  /** Sets the handle of a body in a state that was read. */
  void handle(int slot, Body<?> body) {
    bodies[slot] = body;
  }

  /** Sets the handle of a joint in a state that was read. */
  void handle(int slot, Joint<?> joint) {
    ensureJoints(slot + 1);
    joints[slot] = joint;
  }

  /** Marks handles that were read as different from all that were copied from these. */
  void distinguish(Handles<?> read) {
    structure.distinguish(read.structure);
    jointStructure.distinguish(read.jointStructure);
  }

  void put(Body<T> body, ShapeDef[] itsShapes, MassData itsOwnMass) {
    int slot = body.index();
    ensureBodies(slot + 1);
    bodies[slot] = body;
    shapes[slot] = itsShapes;
    ownMasses[slot] = itsOwnMass;
    structure.change();
  }

  void put(Joint<T> joint) {
    ensureJoints(joint.index() + 1);
    joints[joint.index()] = joint;
    jointStructure.change();
  }

  void removeBody(int slot) {
    bodies[slot] = null;
    shapes[slot] = null;
    ownMasses[slot] = null;
    structure.change();
  }

  void removeJoint(int slot) {
    joints[slot] = null;
    jointStructure.change();
  }

  void bodiesChanged() {
    structure.change();
  }

  /** Returns whether no body was created, destroyed or edited since one was copied to the other. */
  boolean sameBodies(Handles<?> other) {
    return structure.same(other.structure);
  }

  /** Copies these handles to others, as far as they differ. */
  void copyTo(Handles<?> to, int slots, int jointSlots) {
    if (!structure.same(to.structure)) {
      to.ensureBodies(slots);
      copy(bodies, to.bodies, slots);
      copy(shapes, to.shapes, slots);
      copy(ownMasses, to.ownMasses, slots);
      structure.copyTo(to.structure);
    }
    if (!jointStructure.same(to.jointStructure)) {
      to.ensureJoints(jointSlots);
      copy(joints, to.joints, jointSlots);
      jointStructure.copyTo(to.jointStructure);
    }
  }

  private static void copy(Object[] from, Object[] to, int count) {
    int n = Math.min(count, from.length); // beyond, there never was anything
    System.arraycopy(from, 0, to, 0, n);
    Arrays.fill(to, n, to.length, null);
  }

  private void ensureBodies(int slots) {
    if (slots > bodies.length) {
      int capacity = Math.max(slots, 2 * bodies.length);
      bodies = Arrays.copyOf(bodies, capacity);
      shapes = Arrays.copyOf(shapes, capacity);
      ownMasses = Arrays.copyOf(ownMasses, capacity);
    }
  }

  private void ensureJoints(int slots) {
    if (slots > joints.length) {
      joints = Arrays.copyOf(joints, Math.max(slots, 2 * joints.length));
    }
  }
}
