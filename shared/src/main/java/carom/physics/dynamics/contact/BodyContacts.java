package carom.physics.dynamics.contact;

import java.util.Arrays;

/**
 * Answers what one body touches, in canonical order, whether it is awake or not.
 *
 * <p>The rows of the contact table are linked by body at the first question after they changed,
 * which costs time in proportion to the rows. Answers are copies, so their reader may change the
 * world. Several may be open; the last one opened is closed first.
 */
public final class BodyContacts {
  private static final int FIRST_CAPACITY = 32;

  private final ContactTable contacts;
  private final SleepingContacts sleepers;

  /** Per end of a row (2 row of body A, 2 row + 1 of body B): the next of the same body, or -1. */
  private int[] next = new int[2 * FIRST_CAPACITY];

  /** Per body: the first end, -1 for none; and the bodies that have one. */
  private int[] first = new int[0];

  private int[] linked = new int[FIRST_CAPACITY];
  private int linkedCount;
  private int version = -1;

  private int[] sleeping = new int[FIRST_CAPACITY];

  private int[] other = new int[FIRST_CAPACITY];
  private boolean[] sensor = new boolean[FIRST_CAPACITY];
  private float[] nx = new float[FIRST_CAPACITY];
  private float[] ny = new float[FIRST_CAPACITY];
  private float[] impulse = new float[FIRST_CAPACITY];
  private int size;

  /** Makes a look-up in the tables of awake and sleeping bodies. */
  public BodyContacts(ContactTable contacts, SleepingContacts sleepers) {
    this.contacts = contacts;
    this.sleepers = sleepers;
  }

  /**
   * Looks up what a body touches; see {@code Dynamics.bodyContacts}.
   *
   * @param body its slot
   * @return the first entry; the others follow up to {@link #size}
   */
  public int open(int body) {
    if (version != contacts.version()) {
      link();
    }
    int n = 0;
    for (int end = sleepers.first(body); end >= 0; end = sleepers.next(end)) {
      if (n == sleeping.length) {
        sleeping = Arrays.copyOf(sleeping, 2 * n);
      }
      sleeping[n++] = end >> 1;
    }
    ContactTable resting = sleepers.rows;
    resting.sortByKey(sleeping, n);
    int start = size;
    int i = 0;
    int end = body < first.length ? first[body] : -1;
    while (true) {
      while (end >= 0 && (contacts.flags[end >> 1] & ContactTable.TOUCHING) == 0) {
        end = next[end];
      }
      if (end < 0 && i == n) {
        return start;
      }
      if (i == n || (end >= 0 && contacts.key[end >> 1] < resting.key[sleeping[i]])) {
        append(contacts, end >> 1, body);
        end = next[end];
      } else {
        append(resting, sleeping[i++], body);
      }
    }
  }

  /**
   * Returns the first end of a body in the contact table, -1 for none; valid until its rows change.
   * Rows are among them whose parts are near and don't touch.
   */
  public int firstEnd(int body) {
    if (version != contacts.version()) {
      link();
    }
    return body < first.length ? first[body] : -1;
  }

  /** Returns the next end of the same body, -1 for none. */
  public int nextEnd(int end) {
    return next[end];
  }

  /**
   * Returns the number of entries, of all open answers together.
   *
   * @return one more than the last entry of the answer opened last
   */
  public int size() {
    return size;
  }

  /**
   * Forgets an answer.
   *
   * @param start what {@link #open} returned
   */
  public void close(int start) {
    size = start;
  }

  /**
   * Returns the body that is touched.
   *
   * @param entry which
   * @return its slot
   */
  public int other(int entry) {
    return other[entry];
  }

  /**
   * Returns whether one of the touching shapes is a sensor.
   *
   * @param entry which
   * @return true if there are no points
   */
  public boolean sensor(int entry) {
    return sensor[entry];
  }

  /**
   * Returns the unit normal from the body asked about to the other.
   *
   * @param entry which
   * @return x
   */
  public float normalX(int entry) {
    return nx[entry];
  }

  /**
   * Returns the unit normal from the body asked about to the other.
   *
   * @param entry which
   * @return y
   */
  public float normalY(int entry) {
    return ny[entry];
  }

  /**
   * Returns the normal impulse of all points in the last step in which the contact was solved.
   *
   * @param entry which
   * @return N s
   */
  public float impulse(int entry) {
    return impulse[entry];
  }

  private void append(ContactTable t, int row, int body) {
    if (size == other.length) {
      int capacity = 2 * size;
      other = Arrays.copyOf(other, capacity);
      sensor = Arrays.copyOf(sensor, capacity);
      nx = Arrays.copyOf(nx, capacity);
      ny = Arrays.copyOf(ny, capacity);
      impulse = Arrays.copyOf(impulse, capacity);
    }
    boolean isA = t.bodyA(row) == body;
    other[size] = isA ? t.bodyB(row) : t.bodyA(row);
    sensor[size] = t.sensor(row);
    nx[size] = isA ? t.normalX(row) : -t.normalX(row);
    ny[size] = isA ? t.normalY(row) : -t.normalY(row);
    impulse[size] = t.impulse(row, 0) + (t.points[row] > 1 ? t.impulse(row, 1) : 0);
    size++;
  }

  /** Links the rows by body, from the back, so that each list ascends. */
  private void link() {
    for (int i = 0; i < linkedCount; i++) {
      first[linked[i]] = -1;
    }
    linkedCount = 0;
    version = contacts.version();
    if (next.length < 2 * contacts.count()) {
      next = new int[Math.max(2 * contacts.count(), 2 * next.length)];
    }
    for (int row = contacts.count() - 1; row >= 0; row--) {
      link(2 * row, contacts.bodyA(row));
      link(2 * row + 1, contacts.bodyB(row));
    }
  }

  private void link(int end, int body) {
    if (body >= first.length) {
      int old = first.length;
      first = Arrays.copyOf(first, Math.max(body + 1, 2 * old));
      Arrays.fill(first, old, first.length, -1);
    }
    if (first[body] < 0) {
      if (linkedCount == linked.length) {
        linked = Arrays.copyOf(linked, 2 * linkedCount);
      }
      linked[linkedCount++] = body;
    }
    next[end] = first[body];
    first[body] = end;
  }
}
