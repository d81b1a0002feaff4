package carom.physics;

import java.util.Arrays;

/**
 * The joints that broke in a step, by ascending index; one of the {@link EventLists}. The joints
 * are destroyed: their handles answer {@link Joint#index}, {@link Joint#generation} and {@link
 * Joint#type}. The rest is copied here. Methods throw {@link IndexOutOfBoundsException} for an
 * event that isn't there.
 *
 * @param <T> the user's type of {@link Body#user()}
 */
public final class JointEventList<T> {
  private static final int NUMBERS = 3;

  private static final int OBJECTS = 3;

  /** {@value #OBJECTS} per event: the joint, body A and body B. */
  private Object[] objects = new Object[0];

  /** {@value #NUMBERS} per event: the force and the torque. */
  private float[] numbers = new float[0];

  private int count;

  JointEventList() {}

  /** Returns the number of events. */
  public int count() {
    return count;
  }

  /** Returns the joint, which is destroyed. */
  @SuppressWarnings("unchecked")
  public Joint<T> joint(int i) {
    return (Joint<T>) objects[OBJECTS * check(i)];
  }

  /** Returns body A, null if the world took its place; it may have been destroyed since. */
  @SuppressWarnings("unchecked")
  public Body<T> bodyA(int i) {
    return (Body<T>) objects[OBJECTS * check(i) + 1];
  }

  /** Returns body B; it may have been destroyed since. */
  @SuppressWarnings("unchecked")
  public Body<T> bodyB(int i) {
    return (Body<T>) objects[OBJECTS * check(i) + 2];
  }

  /** Returns the x of the force that the joint bore, N. */
  public float forceX(int i) {
    return numbers[NUMBERS * check(i)];
  }

  /** Returns the y of the force that the joint bore, N. */
  public float forceY(int i) {
    return numbers[NUMBERS * check(i) + 1];
  }

  /** Returns the torque that the joint bore, N m. */
  public float torque(int i) {
    return numbers[NUMBERS * check(i) + 2];
  }

  private int check(int i) {
    if (i < 0 || i >= count) {
      throw new IndexOutOfBoundsException(
          "event=" + i + " is outside 0.." + (count - 1) + "; see count()");
    }
    return i;
  }

  void add(Joint<T> joint) {
    if (NUMBERS * count == numbers.length) {
      int capacity = Math.max(16, 2 * count);
      objects = Arrays.copyOf(objects, OBJECTS * capacity);
      numbers = Arrays.copyOf(numbers, NUMBERS * capacity);
    }
    objects[OBJECTS * count] = joint;
    objects[OBJECTS * count + 1] = joint.bodyA();
    objects[OBJECTS * count + 2] = joint.bodyB();
    numbers[NUMBERS * count] = joint.forceX();
    numbers[NUMBERS * count + 1] = joint.forceY();
    numbers[NUMBERS * count + 2] = joint.torque();
    count++;
  }

  void clear() {
    Arrays.fill(objects, 0, OBJECTS * count, null);
    count = 0;
  }
}
