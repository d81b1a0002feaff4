package carom.physics.dynamics.pairs;

import carom.physics.broadphase.AabbArray;
import carom.physics.dynamics.body.BodyStore;
import carom.physics.dynamics.body.ShapeTable;
import carom.physics.dynamics.contact.ContactTable;
import carom.physics.math.Aabb;
import carom.physics.math.Transform;
import carom.physics.settings.Settings;

/**
 * Computes the two boxes of each part. The tight box is that at the pose of the part's body, with
 * half the speculative distance around. The fat box contains the tight one with a margin, and the
 * trees hold it.
 *
 * <pre>
 *   +--------------- fat -----------------+
 *   |   +--- tight ---+                   |    a fat box is renewed
 *   |   |  /\         |   ticks * v * dt  |    when the tight one leaves it
 *   |   | /__\ part   |------------------&gt;|
 *   |   +-------------+                   |
 *   +--- margin --------------------------+
 * </pre>
 *
 * <p>Any thread may measure and renew a part, as long as no other one does so with the same part.
 */
final class FatBoxes {
  /** Number of pairs per awake body above which the bodies count as a crowd. */
  private static final int CROWDED = 2;

  /** Number of ticks that a fat box is meant to last where pairs are few. */
  private static final int SPARSE_TICKS = 12;

  /**
   * Number of ticks that the box of a slow part is meant to last where pairs are neither few nor
   * many.
   */
  private static final int BUSY_TICKS = 4;

  /** A part is slow if it moves less than this fraction (1 / n) of its width and height a tick. */
  private static final int SLOW = 8;

  /** Relative rounding error of a box's edges, as a fraction of the distance from the origin. */
  private static final float ROUNDING = 0x1p-22f;

  private final Settings settings;
  private final BodyStore bodies;
  private final ShapeTable parts;
  private final ContactTable contacts;

  /** The scratch of the thread that steps. */
  private final Scratch own = new Scratch();

  /** The memory that one thread needs to measure a part. */
  static final class Scratch {
    final Transform pose = new Transform();
    private final Aabb box = new Aabb();
  }

  FatBoxes(Settings settings, BodyStore bodies, ShapeTable parts, ContactTable contacts) {
    this.settings = settings;
    this.bodies = bodies;
    this.parts = parts;
    this.contacts = contacts;
  }

  /** Sets a transform to the pose of a body. */
  void place(int body, Transform pose) {
    pose.set(bodies.x[body], bodies.y[body], bodies.cos[body], bodies.sin[body]);
  }

  /** Measures the tight box of a part at the pose in the scratch. */
  void measure(int part, Scratch s) {
    Transform pose = s.pose;
    Aabb box = s.box;
    parts.convex[part].aabb(pose, box);
    float reach = 0.5f * settings.speculativeDistance();
    reach += ROUNDING * (Math.abs(pose.x) + Math.abs(pose.y));
    parts.tight.set(part, box.minX - reach, box.minY - reach, box.maxX + reach, box.maxY + reach);
  }

  /** Returns whether a part's fat box still contains its tight one. */
  boolean holds(int part) {
    AabbArray t = parts.tight;
    return parts.fat.contains(part, t.minX(part), t.minY(part), t.maxX(part), t.maxY(part));
  }

  /** Returns whether a part's fat box will contain its tight one after some seconds of motion. */
  boolean holdsFor(int part, float seconds) {
    AabbArray t = parts.tight;
    int body = parts.body[part];
    float wayX = seconds * bodies.vx[body];
    float wayY = seconds * bodies.vy[body];
    return parts.fat.contains(
        part, t.minX(part) + wayX, t.minY(part) + wayY, t.maxX(part) + wayX, t.maxY(part) + wayY);
  }

  /**
   * Gives a part a new fat box around its tight one, for some ticks of motion. Where pairs are few,
   * a roomy box saves searches. In a crowd a needless pair costs more than a search, so the box of
   * a fast part is hardly larger than the part. In between, slow parts get some room, and fast ones
   * that of one tick.
   *
   * @param dt length of a tick, s
   * @param activeCount number of awake bodies
   */
  void renew(int part, float dt, int activeCount) {
    int body = parts.body[part];
    float wayX = dt * bodies.vx[body];
    float wayY = dt * bodies.vy[body];
    float margin = settings.aabbMargin();
    if (isCrowd(activeCount)) {
      fatten(part, Math.abs(wayX) + Math.abs(wayY) > margin ? 0 : margin, 0, 0);
      return;
    }
    float turn = dt * Math.abs(bodies.w[body]) * bodies.reach[body];
    float ticks = SPARSE_TICKS;
    if (!isSparse(activeCount)) {
      AabbArray t = parts.tight;
      float size = t.maxX(part) - t.minX(part) + (t.maxY(part) - t.minY(part));
      if (SLOW * (Math.abs(wayX) + Math.abs(wayY) + turn) > size) {
        fatten(part, margin, wayX, wayY);
        return;
      }
      ticks = BUSY_TICKS;
    }
    fatten(part, margin, ticks * wayX, ticks * wayY);
    letTurn(part, ticks * turn, margin, ticks * wayX, ticks * wayY);
  }

  /**
   * Widens a fat box by how far a part's points may get by turning, but not beyond the circle that
   * its body never leaves. A disc gets no wider.
   */
  private void letTurn(int part, float turn, float margin, float wayX, float wayY) {
    AabbArray fat = parts.fat;
    int body = parts.body[part];
    float x = bodies.x[body];
    float y = bodies.y[body];
    float reach = bodies.reach[body] + 0.5f * settings.speculativeDistance() + margin;
    float minX = fat.minX(part);
    float minY = fat.minY(part);
    float maxX = fat.maxX(part);
    float maxY = fat.maxY(part);
    fat.set(
        part,
        Math.min(minX, Math.max(minX - turn, x - reach + Math.min(wayX, 0))),
        Math.min(minY, Math.max(minY - turn, y - reach + Math.min(wayY, 0))),
        Math.max(maxX, Math.min(maxX + turn, x + reach + Math.max(wayX, 0))),
        Math.max(maxY, Math.min(maxY + turn, y + reach + Math.max(wayY, 0))));
  }

  /** Returns whether there are so many pairs that needless ones cost more than searches. */
  boolean isCrowd(int activeCount) {
    return contacts.count() > CROWDED * activeCount;
  }

  /** Returns whether there are so few pairs that roomy boxes save more than they cost. */
  boolean isSparse(int activeCount) {
    return 2 * contacts.count() <= activeCount;
  }

  /** Gives a part of a body that doesn't move a fat box without a margin. */
  void setResting(int body, int part) {
    place(body, own.pose);
    measure(part, own);
    fatten(part, 0, 0, 0);
  }

  /** Gives a part of a new active body an empty box, so that the next refresh renews it. */
  void setEmpty(int body, int part) {
    parts.fat.set(part, bodies.x[body], bodies.y[body], bodies.x[body], bodies.y[body]);
  }

  /** Renews the fat boxes of a body that fell asleep, where they no longer hold. */
  void settle(int body, MovedParts moved) {
    place(body, own.pose);
    int first = bodies.firstPart[body];
    for (int part = first; part < first + bodies.partCount[body]; part++) {
      measure(part, own);
      if (!holds(part)) {
        fatten(part, settings.aabbMargin(), 0, 0);
        moved.mark(part);
      }
    }
  }

  /** Sets a part's fat box to the tight one with a margin and room for a way. */
  private void fatten(int part, float margin, float wayX, float wayY) {
    AabbArray tight = parts.tight;
    parts.fat.set(
        part,
        tight.minX(part) - margin + Math.min(wayX, 0),
        tight.minY(part) - margin + Math.min(wayY, 0),
        tight.maxX(part) + margin + Math.max(wayX, 0),
        tight.maxY(part) + margin + Math.max(wayY, 0));
  }

  /** Widens a part's fat box until it contains another box; returns whether it changed. */
  boolean cover(int part, Aabb other) {
    AabbArray fat = parts.fat;
    if (fat.contains(part, other.minX, other.minY, other.maxX, other.maxY)) {
      return false;
    }
    fat.set(
        part,
        Math.min(fat.minX(part), other.minX),
        Math.min(fat.minY(part), other.minY),
        Math.max(fat.maxX(part), other.maxX),
        Math.max(fat.maxY(part), other.maxY));
    return true;
  }

  /** Computes the box of a part at the pose of its body now, without any margin. */
  void tightBox(int part, Aabb out) {
    place(parts.body[part], own.pose);
    parts.convex[part].aabb(own.pose, out);
  }
}
