package carom.physics.dynamics.continuous;

import carom.physics.collision.Collider;
import carom.physics.collision.Manifold;
import carom.physics.dynamics.body.BodyStore;
import carom.physics.dynamics.body.ShapeTable;
import carom.physics.dynamics.contact.ContactEvents;
import carom.physics.dynamics.contact.ContactKey;
import carom.physics.dynamics.contact.ContactTable;
import carom.physics.math.Transform;
import java.util.Arrays;

/**
 * Asks callbacks whether a swept body is stopped at a part. What they refuse in a step isn't there
 * for the pair until its end. A pair that had contact points when the step began was asked then.
 *
 * <p>While a callback decides, both bodies are at the place of the impact, with the velocities of
 * the end of the step. One that it puts elsewhere stays there.
 */
final class SweptQuestions {
  private static final int FIRST_CAPACITY = 16;

  /** Gap up to which a manifold is found: beyond any at which a body is stopped, m. */
  private static final float FAR = 1;

  private final BodyStore bodies;
  private final ShapeTable parts;
  private final ContactTable contacts;

  /** A table of one row, the contact that is asked about. */
  private final ContactTable asked = new ContactTable();

  private final Collider collider = new Collider();
  private final Manifold manifold = new Manifold();

  /** Who decides; null for nobody. */
  private ContactEvents events;

  /** The keys of the pairs of this step that pass each other. */
  private long[] refused = new long[FIRST_CAPACITY];

  private int refusedCount;

  /** The keys of the pairs that don't. */
  private long[] accepted = new long[FIRST_CAPACITY];

  private int acceptedCount;
  private boolean elsewhere;
  private final Transform endA = new Transform();
  private final Transform endB = new Transform();

  SweptQuestions(BodyStore bodies, ShapeTable parts, ContactTable contacts) {
    this.bodies = bodies;
    this.parts = parts;
    this.contacts = contacts;
    asked.append();
  }

  /** Begins a step, in which nothing has been asked. */
  void begin(ContactEvents decider) {
    events = decider;
    refusedCount = 0;
    acceptedCount = 0;
  }

  /** Returns the key of two parts of different bodies. */
  private long key(int part, int other) {
    int a = parts.body[part];
    int b = parts.body[other];
    int p = part - bodies.firstPart[a];
    int q = other - bodies.firstPart[b];
    return a < b ? ContactKey.of(a, p, b, q) : ContactKey.of(b, q, a, p);
  }

  /** Returns whether two parts pass each other in this step, because a callback said so. */
  boolean pass(int part, int other) {
    long key = key(part, other);
    int row = contacts.find(key);
    return (row >= 0 && (contacts.flags[row] & ContactTable.VETOED) != 0)
        || holds(refused, refusedCount, key);
  }

  private static boolean holds(long[] keys, int count, long key) {
    for (int i = 0; i < count; i++) {
      if (keys[i] == key) {
        return true;
      }
    }
    return false;
  }

  /** Returns whether the last question put one of the bodies elsewhere. */
  boolean movedAway() {
    return elsewhere;
  }

  /**
   * Returns whether a part is stopped at another one.
   *
   * @param pose of its body at the impact
   * @param otherPose of the other body then
   */
  boolean stops(int part, Transform pose, int other, Transform otherPose) {
    elsewhere = false;
    if (events == null) {
      return true;
    }
    long key = key(part, other);
    int row = contacts.find(key);
    boolean wasAsked =
        row >= 0 && contacts.points[row] > 0 && (contacts.flags[row] & ContactTable.DORMANT) == 0;
    if (wasAsked || holds(accepted, acceptedCount, key)) {
      return true;
    }
    boolean first = parts.body[part] < parts.body[other];
    boolean stops =
        first ? ask(key, part, pose, other, otherPose) : ask(key, other, otherPose, part, pose);
    if (stops) {
      accepted =
          acceptedCount == accepted.length ? Arrays.copyOf(accepted, 2 * acceptedCount) : accepted;
      accepted[acceptedCount++] = key;
    } else {
      refused = refusedCount == refused.length ? Arrays.copyOf(refused, 2 * refusedCount) : refused;
      refused[refusedCount++] = key;
    }
    return stops;
  }

  private boolean ask(long key, int partA, Transform poseA, int partB, Transform poseB) {
    collider.collide(parts.convex[partA], poseA, parts.convex[partB], poseB, FAR, 0, manifold);
    if (manifold.count == 0) {
      setMiddle(poseA, poseB);
    }
    asked.start(0, key, bodies, parts);
    asked.update(0, manifold);
    int a = parts.body[partA];
    int b = parts.body[partB];
    get(a, endA);
    get(b, endB);
    put(a, poseA);
    put(b, poseB);
    boolean accepts = events.preSolveSwept(asked);
    elsewhere = !isAt(a, poseA) || !isAt(b, poseB);
    if (isAt(a, poseA)) {
      put(a, endA);
    }
    if (isAt(b, poseB)) {
      put(b, endB);
    }
    return accepts;
  }

  /**
   * Sets a point midway between two bodies, where the collider finds none: a one-sided segment lets
   * pass what its neighbour stops.
   */
  private void setMiddle(Transform poseA, Transform poseB) {
    float x = poseB.x - poseA.x;
    float y = poseB.y - poseA.y;
    float length = (float) Math.sqrt(x * x + y * y);
    manifold.clear();
    manifold.count = 1;
    manifold.normalX = length > 0 ? x / length : 0;
    manifold.normalY = length > 0 ? y / length : 1;
    manifold.x0 = 0.5f * x;
    manifold.y0 = 0.5f * y;
  }

  private void get(int body, Transform pose) {
    pose.set(bodies.x[body], bodies.y[body], bodies.cos[body], bodies.sin[body]);
  }

  private void put(int body, Transform pose) {
    bodies.x[body] = pose.x;
    bodies.y[body] = pose.y;
    bodies.cos[body] = pose.cos;
    bodies.sin[body] = pose.sin;
  }

  private boolean isAt(int body, Transform pose) {
    return bodies.x[body] == pose.x
        && bodies.y[body] == pose.y
        && bodies.cos[body] == pose.cos
        && bodies.sin[body] == pose.sin;
  }
}
