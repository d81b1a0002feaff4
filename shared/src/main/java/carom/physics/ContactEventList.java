package carom.physics;

import java.util.Arrays;

/**
 * The contacts to which something happened in a step, in the canonical order of contacts; one of
 * the {@link EventLists}. Each event is a copy: it doesn't change when bodies move on.
 *
 * <p>Self is the body with the smaller {@link Body#index()}. Methods throw {@link
 * IndexOutOfBoundsException} for an event that isn't there.
 *
 * @param <T> the user's type of {@link Body#user()}
 */
public final class ContactEventList<T> {
  private static final int NUMBERS = 6;

  /** Two per event: self and the other body. */
  private Object[] bodies = new Object[0];

  /** Two per event: the number of the shape of self, and that of the other body. */
  private int[] shapes = new int[0];

  /** {@value #NUMBERS} per event: normal, place, speed, impulse. */
  private float[] numbers = new float[0];

  private int count;

  ContactEventList() {}

  /** Returns the number of events. */
  public int count() {
    return count;
  }

  /** Returns the body with the smaller index; it may have been destroyed since. */
  @SuppressWarnings("unchecked")
  public Body<T> self(int i) {
    return (Body<T>) bodies[2 * check(i)];
  }

  /** Returns the body with the larger index; it may have been destroyed since. */
  @SuppressWarnings("unchecked")
  public Body<T> other(int i) {
    return (Body<T>) bodies[2 * check(i) + 1];
  }

  /** Returns the number of the shape of self, see {@link Body#shape}. */
  public int selfShape(int i) {
    return shapes[2 * check(i)];
  }

  /** Returns the number of the shape of the other body, see {@link Body#shape}. */
  public int otherShape(int i) {
    return shapes[2 * check(i) + 1];
  }

  /** Returns the x of the unit normal from self to other; 0 for ends and sensors. */
  public float normalX(int i) {
    return numbers[NUMBERS * check(i)];
  }

  /** Returns the y of the unit normal from self to other; 0 for ends and sensors. */
  public float normalY(int i) {
    return numbers[NUMBERS * check(i) + 1];
  }

  /**
   * Returns the x of the place, m: of a hit {@link Collision#hitX}, of a begin the first contact
   * point, 0 for ends and sensors.
   */
  public float x(int i) {
    return numbers[NUMBERS * check(i) + 2];
  }

  /**
   * Returns the y of the place, m: of a hit {@link Collision#hitY}, of a begin the first contact
   * point, 0 for ends and sensors.
   */
  public float y(int i) {
    return numbers[NUMBERS * check(i) + 3];
  }

  /** Returns the speed of approach, m/s, see {@link Collision#hitSpeed}; 0 unless it is a hit. */
  public float speed(int i) {
    return numbers[NUMBERS * check(i) + 4];
  }

  /** Returns the impulse along the normal, N s; 0 unless it is a hit. */
  public float impulse(int i) {
    return numbers[NUMBERS * check(i) + 5];
  }

  private int check(int i) {
    if (i < 0 || i >= count) {
      throw new IndexOutOfBoundsException(
          "event=" + i + " is outside 0.." + (count - 1) + "; see count()");
    }
    return i;
  }

  /**
   * Adds a copy of what a listener sees.
   *
   * @param placed whether it has a place and a normal
   */
  void add(Collision<T> c, boolean placed) {
    ensureCapacity(count + 1);
    bodies[2 * count] = c.self();
    bodies[2 * count + 1] = c.other();
    shapes[2 * count] = c.selfShapeIndex();
    shapes[2 * count + 1] = c.otherShapeIndex();
    int at = NUMBERS * count;
    if (!placed) {
      Arrays.fill(numbers, at, at + NUMBERS, 0);
    } else {
      numbers[at] = c.normalX();
      numbers[at + 1] = c.normalY();
      boolean hit = c.hitSpeed() > 0;
      numbers[at + 2] = hit ? c.hitX() : c.pointX(0);
      numbers[at + 3] = hit ? c.hitY() : c.pointY(0);
      numbers[at + 4] = c.hitSpeed();
      numbers[at + 5] = hit ? c.impulse() : 0;
    }
    count++;
  }

  /** Moves all events of another list to the end of this one. */
  void takeAll(ContactEventList<T> from) {
    ensureCapacity(count + from.count);
    System.arraycopy(from.bodies, 0, bodies, 2 * count, 2 * from.count);
    System.arraycopy(from.shapes, 0, shapes, 2 * count, 2 * from.count);
    System.arraycopy(from.numbers, 0, numbers, NUMBERS * count, NUMBERS * from.count);
    count += from.count;
    from.clear();
  }

  /** Removes all events; the bodies may be collected. */
  void clear() {
    Arrays.fill(bodies, 0, 2 * count, null);
    count = 0;
  }

  private void ensureCapacity(int least) {
    if (NUMBERS * least > numbers.length) {
      int capacity = Math.max(16, 2 * least);
      bodies = Arrays.copyOf(bodies, 2 * capacity);
      shapes = Arrays.copyOf(shapes, 2 * capacity);
      numbers = Arrays.copyOf(numbers, NUMBERS * capacity);
    }
  }
}
