package carom.physics.dynamics.narrow;

import carom.physics.dynamics.body.BodyStore;
import carom.physics.dynamics.body.ShapeTable;
import carom.physics.dynamics.contact.ContactTable;
import carom.physics.geometry.Convex;
import carom.physics.geometry.Segment;
import carom.physics.math.Transform;
import carom.physics.settings.Settings;
import java.util.Arrays;
import java.util.function.IntPredicate;

/**
 * Ends contacts with edges that nothing can reach because the ground goes on beyond them. Such
 * edges are the sides of tiles that lie next to each other, and the ends of chains that others
 * continue.
 *
 * <pre>
 *        the slider --&gt;
 *      +-----------+        n2      The contact with S would push against n = left: its side ends
 *      |           |         |      at v, and v lies on the surface of T, the slider's other contact,
 *   ---+-----------+====v----+---   which goes on to the left of v. The surface of both together has
 *        T              | S         no normal at v that leans to the left.
 * </pre>
 *
 * <p>Looked at are the contacts of one part of a dynamic body with parts that forces don't move:
 * those of one body, or of static bodies. A contact with S ends for another one with T, of normal
 * n2 away from T, if
 *
 * <ol>
 *   <li>the edge of S that n belongs to ends, in the direction of n2, at a corner v on or in T;
 *   <li>none of its points is above v, in the direction of n2;
 *   <li>T goes on from v, along its surface and out of S, and n leans that way.
 * </ol>
 *
 * <p>If n leans but little, and a point isn't on T, as when a box that tilts a bit lies on both,
 * the contact stays and gets the normal n2.
 *
 * <p>That is the Gauss map test of a chain's joints (Catto, "Ghost collisions", box2d.org 2020),
 * for pieces that don't know of each other. Where two contacts end each other, both stay: a narrow
 * body may be held by nothing else. The result depends on poses alone, not on the order of rows.
 */
public final class Seams {
  /** Least tolerance for how well pieces fit, m. */
  private static final float LEAST_TOLERANCE = 1e-4f;

  /** Least length by which a surface must go on beyond a corner, in tolerances. */
  private static final float BEYOND = 4;

  /** Least lean of a normal towards the other surface, as the sine of the angle. */
  private static final float LEAN = 1e-4f;

  /** Most lean of a normal that is set upright, as the sine of the angle. */
  private static final float MOST_LEAN = 0.1f;

  private final Settings settings;
  private final BodyStore bodies;
  private final ShapeTable parts;
  private final ContactTable contacts;

  /** Per part of a dynamic body: its last entry, -1 for none. */
  private int[] head = new int[0];

  /** The parts that have entries. */
  private int[] movers = new int[64];

  private int moverCount;

  // The entries: rows of a dynamic body's part with one that forces don't move.
  private int[] rows = new int[64];
  private int[] next = new int[64];
  private boolean[] ended = new boolean[64];
  private boolean[] settled = new boolean[64];
  private int entries;

  // Scratch: the contact with S, in world axes relative to the body of S.
  private final Transform poseS = new Transform();
  private final Transform poseT = new Transform();
  private float nx;
  private float ny;

  /** True if all points of the last contact that was found covered are covered, too. */
  private boolean allCovered;

  /** Is told which contacts cover others. */
  private NarrowPhase narrow;

  private IntPredicate passes;

  /** Makes the stage of a world without bodies. */
  public Seams(Settings settings, BodyStore bodies, ShapeTable parts, ContactTable contacts) {
    this.settings = settings;
    this.bodies = bodies;
    this.parts = parts;
    this.contacts = contacts;
  }

  /**
   * Ends the contacts with covered edges among the rows just updated.
   *
   * @param narrow says which rows were
   * @param passes tells whether a callback lets the parts of a row pass each other
   * @return how many ended
   */
  public int run(NarrowPhase narrow, IntPredicate passes) {
    this.narrow = narrow;
    this.passes = passes;
    collect();
    int count = 0;
    for (int i = 0; i < moverCount; i++) {
      int first = head[movers[i]];
      head[movers[i]] = -1;
      if (next[first] >= 0) {
        count += endCovered(first);
      }
    }
    return count;
  }

  private void collect() {
    if (head.length < parts.used()) {
      head = new int[parts.used() + parts.used() / 2];
      Arrays.fill(head, -1);
    }
    moverCount = 0;
    entries = 0;
    byte[] type = bodies.type;
    int count = contacts.count();
    int last = lastFixed();
    // Rows are in the order of their first body. Mostly what is fixed was made before the rest.
    for (int row = 0; row < count && contacts.bodyA(row) <= last; row++) {
      boolean dynamicA = type[contacts.bodyA(row)] == BodyStore.DYNAMIC;
      boolean dynamicB = type[contacts.bodyB(row)] == BodyStore.DYNAMIC;
      if (dynamicA != dynamicB && contacts.points[row] > 0 && !narrow.isLeft(row)) {
        add(row, contacts.part[2 * row + (dynamicA ? 0 : 1)]);
      }
    }
  }

  /** Returns the last slot of a body that forces don't move. */
  private int lastFixed() {
    int slot = bodies.slots() - 1;
    while (slot >= 0
        && bodies.type[slot] != BodyStore.STATIC
        && bodies.type[slot] != BodyStore.KINEMATIC) {
      slot--;
    }
    return slot;
  }

  private void add(int row, int mover) {
    if (entries == rows.length) {
      rows = Arrays.copyOf(rows, 2 * entries);
      next = Arrays.copyOf(next, 2 * entries);
      ended = Arrays.copyOf(ended, 2 * entries);
      settled = Arrays.copyOf(settled, 2 * entries);
    }
    if (head[mover] < 0) {
      if (moverCount == movers.length) {
        movers = Arrays.copyOf(movers, 2 * moverCount);
      }
      movers[moverCount++] = mover;
    }
    rows[entries] = row;
    next[entries] = head[mover];
    head[mover] = entries++;
  }

  /** Ends contacts of one part that others cover which aren't covered themselves. */
  private int endCovered(int first) {
    for (int i = first; i >= 0; i = next[i]) {
      ended[i] = false;
      for (int j = first; j >= 0 && !ended[i]; j = next[j]) {
        ended[i] = i != j && covers(rows[j], rows[i]) && allCovered;
      }
    }
    int count = 0;
    for (int i = first; i >= 0; i = next[i]) {
      settled[i] = !ended[i];
      for (int j = first; j >= 0; j = next[j]) {
        if (i != j && !ended[j] && covers(rows[j], rows[i])) {
          count += finish(rows[i], rows[j]);
          settled[i] = true;
          break;
        }
      }
    }
    return count + endBeyond(first);
  }

  /**
   * Ends contacts that only ended ones cover: a ground of small tiles goes on from one that holds,
   * tile by tile. Those that end each other in a circle stay.
   */
  private int endBeyond(int first) {
    int count = 0;
    boolean more = true;
    while (more) {
      more = false;
      for (int i = first; i >= 0; i = next[i]) {
        for (int j = first; j >= 0 && !settled[i]; j = next[j]) {
          if (settled[j] && covers(rows[j], rows[i]) && allCovered) {
            count += end(rows[i], rows[j]);
            settled[i] = true;
            more = true;
          }
        }
      }
    }
    return count;
  }

  /**
   * Ends a contact, or sets its normal upright if it still holds the body; returns how many ended.
   */
  private int finish(int rowOfS, int rowOfT) {
    if (allCovered) {
      return end(rowOfS, rowOfT);
    }
    boolean same = isFixedFirst(rowOfS) == isFixedFirst(rowOfT);
    float x = contacts.normalX(rowOfT);
    float y = contacts.normalY(rowOfT);
    int at = rowOfS * ContactTable.CONTACT;
    contacts.contact[at + ContactTable.NX] = same ? x : -x;
    contacts.contact[at + ContactTable.NY] = same ? y : -y;
    return 0;
  }

  /** Ends a contact that another one covers; returns how many that touched ended. */
  private int end(int row, int cover) {
    int count = contacts.touches(row) ? 1 : 0;
    narrow.noteCover(row, cover);
    contacts.end(row);
    return count;
  }

  /**
   * Returns whether the T of one row covers the edge of S that another row is about. What was let
   * pass covers nothing.
   */
  private boolean covers(int rowOfT, int rowOfS) {
    boolean firstS = isFixedFirst(rowOfS);
    boolean firstT = isFixedFirst(rowOfT);
    int bodyS = firstS ? contacts.bodyA(rowOfS) : contacts.bodyB(rowOfS);
    int bodyT = firstT ? contacts.bodyA(rowOfT) : contacts.bodyB(rowOfT);
    if (bodyS != bodyT
        && (bodies.type[bodyS] != BodyStore.STATIC || bodies.type[bodyT] != BodyStore.STATIC)) {
      return false;
    }
    nx = firstS ? contacts.normalX(rowOfS) : -contacts.normalX(rowOfS);
    ny = firstS ? contacts.normalY(rowOfS) : -contacts.normalY(rowOfS);
    float upX = firstT ? contacts.normalX(rowOfT) : -contacts.normalX(rowOfT);
    float upY = firstT ? contacts.normalY(rowOfT) : -contacts.normalY(rowOfT);
    if (nx * upX + ny * upY > 1 - 0.5f * LEAN * LEAN) {
      return false;
    }
    Convex s = parts.convex[contacts.part[2 * rowOfS + (firstS ? 0 : 1)]];
    Convex t = parts.convex[contacts.part[2 * rowOfT + (firstT ? 0 : 1)]];
    if (!isFaceted(s) || !isFaceted(t)) {
      return false;
    }
    place(bodyS, poseS);
    place(bodyT, poseT);
    boolean covers =
        s instanceof Segment
            ? endIsCovered(rowOfS, s, t, upX, upY)
            : edgeIsCovered(rowOfS, s, t, upX, upY);
    return covers && !passes.test(rowOfT);
  }

  /**
   * Looks at the one or two edges of a polygon whose normals are nearest to that of the contact.
   */
  private boolean edgeIsCovered(int rowOfS, Convex s, Convex t, float upX, float upY) {
    float localX = poseS.cos * nx + poseS.sin * ny;
    float localY = poseS.cos * ny - poseS.sin * nx;
    int n = s.vertexCount();
    for (int i = 0; i < n; i++) {
      if (!isNeighbour(s, i, localX, localY)) {
        continue;
      }
      float outX = poseS.rotateX(s.normalX(i), s.normalY(i));
      float outY = poseS.rotateY(s.normalX(i), s.normalY(i));
      // Along the edge, counter-clockwise, is the normal turned left.
      float rise = upX * -outY + upY * outX;
      int v = rise > 0 ? (i + 1 == n ? 0 : i + 1) : i;
      if (Math.abs(rise) > LEAN && isCovered(rowOfS, s, v, t, upX, upY, outX, outY)) {
        return true;
      }
    }
    return false;
  }

  /** Returns whether a direction is an edge's normal, or between it and that of a neighbour. */
  private static boolean isNeighbour(Convex s, int i, float x, float y) {
    int n = s.vertexCount();
    float side = s.normalX(i) * y - s.normalY(i) * x;
    if (Math.abs(side) <= LEAN) {
      return s.normalX(i) * x + s.normalY(i) * y > 0;
    }
    int other = side > 0 ? (i + 1 == n ? 0 : i + 1) : i == 0 ? n - 1 : i - 1;
    float rest = s.normalX(other) * y - s.normalY(other) * x;
    return side > 0 ? rest < -LEAN : rest > LEAN;
  }

  /** Looks at the end of a line that the contact is at. */
  private boolean endIsCovered(int rowOfS, Convex s, Convex t, float upX, float upY) {
    for (int v = 0; v < 2; v++) {
      float dx = s.vertexX(v) - s.vertexX(1 - v);
      float dy = s.vertexY(v) - s.vertexY(1 - v);
      float inverse = 1 / (float) Math.sqrt(dx * dx + dy * dy);
      float outX = poseS.rotateX(dx, dy) * inverse;
      float outY = poseS.rotateY(dx, dy) * inverse;
      if (nx * outX + ny * outY > LEAN && isCovered(rowOfS, s, v, t, upX, upY, outX, outY)) {
        return true;
      }
    }
    return false;
  }

  /**
   * Returns whether the corner v of S is on or in T, and T's surface goes on beyond v, out of S,
   * where the contact's normal leans to.
   */
  private boolean isCovered(
      int rowOfS, Convex s, int v, Convex t, float upX, float upY, float outX, float outY) {
    float onX = -upY;
    float onY = upX;
    if (onX * outX + onY * outY < 0) {
      onX = -onX;
      onY = -onY;
    }
    float lean = nx * onX + ny * onY;
    if (lean <= LEAN) {
      return false;
    }
    float tolerance = Math.max(settings.slop(), LEAST_TOLERANCE);
    float apartX = poseS.x - poseT.x;
    float apartY = poseS.y - poseT.y;
    float cornerX = poseS.rotateX(s.vertexX(v), s.vertexY(v)) + apartX;
    float cornerY = poseS.rotateY(s.vertexX(v), s.vertexY(v)) + apartY;
    float far = BEYOND * tolerance;
    if (!isWithin(t, cornerX, cornerY, tolerance)
        || !isWithin(t, cornerX + far * onX, cornerY + far * onY, tolerance)) {
      return false;
    }
    boolean two = contacts.points[rowOfS] > 1;
    boolean first = isPointWithin(t, rowOfS, ContactTable.X0, tolerance);
    boolean second = two ? isPointWithin(t, rowOfS, ContactTable.X1, tolerance) : first;
    allCovered = first && second || lean > MOST_LEAN;
    float above = cornerX * upX + cornerY * upY + tolerance;
    return isBelow(rowOfS, ContactTable.X0, upX, upY, above)
        && (!two || isBelow(rowOfS, ContactTable.X1, upX, upY, above));
  }

  /** Returns whether a contact's point is no higher than a height over the body of T. */
  private boolean isBelow(int rowOfS, int point, float upX, float upY, float height) {
    return upX * pointX(rowOfS, point) + upY * pointY(rowOfS, point) <= height;
  }

  /** Returns whether the place on S of a contact's point is on or in T. */
  private boolean isPointWithin(Convex t, int rowOfS, int point, float tolerance) {
    return isWithin(t, pointX(rowOfS, point), pointY(rowOfS, point), tolerance);
  }

  /** Returns where a contact's point is on S, relative to the body of T. */
  private float pointX(int rowOfS, int point) {
    int at = rowOfS * ContactTable.CONTACT + point;
    float half = 0.5f * contacts.contact[at + ContactTable.GAP0 - ContactTable.X0];
    return contacts.contact[at] + (bodies.x[contacts.bodyA(rowOfS)] - poseT.x) - half * nx;
  }

  private float pointY(int rowOfS, int point) {
    int at = rowOfS * ContactTable.CONTACT + point;
    float half = 0.5f * contacts.contact[at + ContactTable.GAP0 - ContactTable.X0];
    return contacts.contact[at + 1] + (bodies.y[contacts.bodyA(rowOfS)] - poseT.y) - half * ny;
  }

  /** Returns whether a place relative to the body of T, in world axes, is on or in T. */
  private boolean isWithin(Convex t, float worldX, float worldY, float tolerance) {
    float x = poseT.cos * worldX + poseT.sin * worldY;
    float y = poseT.cos * worldY - poseT.sin * worldX;
    for (int i = 0; i < t.vertexCount(); i++) {
      float above = t.normalX(i) * (x - t.vertexX(i)) + t.normalY(i) * (y - t.vertexY(i));
      if (above > tolerance) {
        return false;
      }
    }
    if (t instanceof Segment) {
      float dx = t.vertexX(1) - t.vertexX(0);
      float dy = t.vertexY(1) - t.vertexY(0);
      float length = (float) Math.sqrt(dx * dx + dy * dy);
      float along = (dx * (x - t.vertexX(0)) + dy * (y - t.vertexY(0))) / length;
      return along >= -tolerance && along <= length + tolerance;
    }
    return true;
  }

  private boolean isFixedFirst(int row) {
    return bodies.type[contacts.bodyA(row)] != BodyStore.DYNAMIC;
  }

  /** Returns whether a shape has edges and sharp corners. */
  private static boolean isFaceted(Convex c) {
    return c.radius() == 0;
  }

  private void place(int body, Transform pose) {
    pose.set(bodies.x[body], bodies.y[body], bodies.cos[body], bodies.sin[body]);
  }
}
