package carom.sim.ruling;

import carom.physics.Body;
import carom.physics.Joint;
import carom.sim.entity.HostEntity;
import java.util.Arrays;
import java.util.function.Consumer;

/**
 * The settings of the joints of one body, to be compared later. A joint of two bodies of one owner
 * is its body A's. One thread; allocates only to grow.
 */
final class JointNotes {
  private final Consumer<Joint<HostEntity>> add = this::add;
  private HostEntity entity;
  private int[] slots = {};
  private int[] settings = {};
  private int count;

  JointNotes() {}

  /** Notes the joints of a body as they are now. */
  void read(HostEntity of) {
    entity = of;
    count = 0;
    of.body().forEachJoint(add);
  }

  private void add(Joint<HostEntity> joint) {
    Body<HostEntity> a = joint.bodyA();
    boolean isA = a == entity.body();
    if (!isA && a != null && a.user().ownerId() == entity.ownerId()) {
      return;
    }
    if (count == slots.length) {
      slots = Arrays.copyOf(slots, 2 * count + 2);
      settings = Arrays.copyOf(settings, slots.length * JointSettings.INTS);
    }
    slots[count] = joint.index();
    JointSettings.read(joint, settings, count * JointSettings.INTS);
    count++;
  }

  /** Returns the number of joints. */
  int count() {
    return count;
  }

  /** Returns the world's index of a joint. */
  int slot(int number) {
    return slots[number];
  }

  /** Returns whether both have notes of the same joints, in the same order. */
  boolean areOfSame(JointNotes other) {
    return Arrays.equals(slots, 0, count, other.slots, 0, other.count);
  }

  /**
   * Makes a ruling the difference to later settings of a joint.
   *
   * @param index of the joint in the table of joints
   */
  void compare(int number, JointNotes later, int index, Ruling out) {
    int at = number * JointSettings.INTS;
    out.setDifference(index, settings, later.settings, at);
  }
}
