package carom.physics.dynamics.narrow;

import carom.physics.collision.Manifold;
import carom.physics.dynamics.body.BodyStore;
import carom.physics.dynamics.body.ShapeTable;
import carom.physics.dynamics.contact.ContactKey;
import carom.physics.dynamics.contact.ContactTable;
import carom.physics.dynamics.store.IntList;
import java.util.Arrays;

/**
 * Collects rows of two boxes and updates {@link BoxLanes#LANES} of them at a time: gathers their
 * numbers for a kernel, and writes what the kernel found back to the rows. One per worker.
 */
final class BoxRows {
  private final BodyStore bodies;
  private final ShapeTable parts;
  private final ContactTable contacts;
  private final BoxLanes lanes;
  private final float[] scratch;
  private final Manifold manifold = new Manifold();
  private final int[] rows = new int[BoxLanes.LANES];
  private final IntList gaps;
  private int count;
  private int touching;

  /**
   * Makes it without rows.
   *
   * @param gaps lists the rows whose points all have a gap
   */
  BoxRows(BodyStore bodies, ShapeTable parts, ContactTable contacts, BoxLanes lanes, IntList gaps) {
    this.gaps = gaps;
    this.bodies = bodies;
    this.parts = parts;
    this.contacts = contacts;
    this.lanes = lanes;
    scratch = new float[lanes.scratchSize()];
  }

  /** Begins to count what touches. */
  void begin() {
    touching = 0;
    Arrays.fill(scratch, BoxLanes.LEAST, BoxLanes.LEAST + BoxLanes.LANES, 0);
  }

  /** Returns the number of updated rows that touch now. */
  int touching() {
    return touching;
  }

  /** Returns the deepest overlap of the updated rows, m. */
  float deepest() {
    float least = 0;
    for (int lane = 0; lane < BoxLanes.LANES; lane++) {
      least = Math.min(least, scratch[BoxLanes.LEAST + lane]);
    }
    return -least;
  }

  /** Adds a row; returns whether there is no room for another one. */
  boolean add(int row) {
    int lane = count;
    count = lane + 1;
    rows[lane] = row;
    long key = contacts.key[row];
    gather(ContactKey.bodyA(key), ContactKey.bodyB(key), lane);
    gatherBox(ShapeTable.BOX * contacts.part[2 * row], BoxLanes.HALF_WIDTH_A + lane);
    gatherBox(ShapeTable.BOX * contacts.part[2 * row + 1], BoxLanes.HALF_WIDTH_B + lane);
    return count == BoxLanes.LANES;
  }

  private void gather(int a, int b, int lane) {
    float[] s = scratch;
    BodyStore t = bodies;
    s[BoxLanes.WAY_X + lane] = t.x[b] - t.x[a];
    s[BoxLanes.WAY_Y + lane] = t.y[b] - t.y[a];
    s[BoxLanes.COS_A + lane] = t.cos[a];
    s[BoxLanes.SIN_A + lane] = t.sin[a];
    s[BoxLanes.COS_B + lane] = t.cos[b];
    s[BoxLanes.SIN_B + lane] = t.sin[b];
    s[BoxLanes.REACH + lane] = t.reach[b];
  }

  private void gatherBox(int box, int to) {
    float[] s = scratch;
    float[] boxes = parts.box;
    s[to] = boxes[box];
    s[to + BoxLanes.LANES] = boxes[box + 1];
    s[to + 2 * BoxLanes.LANES] = boxes[box + 2];
    s[to + 3 * BoxLanes.LANES] = boxes[box + 3];
  }

  /** Returns the number of collected rows. */
  int count() {
    return count;
  }

  /** Returns one of the collected rows, or of those that {@link #update} left. */
  int row(int i) {
    return rows[i];
  }

  /** Forgets the rows. */
  void clear() {
    count = 0;
  }

  /**
   * Updates the rows, except those that the kernel can't do, and forgets them all.
   *
   * @param speculative points up to this far apart count, m
   * @return how many are left to do
   */
  int update(float speculative) {
    lanes.collide(scratch, speculative);
    int left = 0;
    for (int lane = 0; lane < count; lane++) {
      int row = rows[lane];
      int points = BoxLanes.integer(scratch, BoxLanes.COUNT + lane);
      if (points == BoxLanes.CORNERS) {
        rows[left++] = row;
        continue;
      }
      if (points >= BoxLanes.LOOK) {
        boolean near = parts.tight.overlaps(contacts.part[2 * row], contacts.part[2 * row + 1]);
        points = near ? points - BoxLanes.LOOK : 0;
      }
      write(row, lane, points);
    }
    count = 0;
    return left;
  }

  private void write(int row, int lane, int points) {
    ContactTable t = contacts;
    float[] s = scratch;
    Manifold m = manifold;
    m.count = points;
    if (points > 0) {
      touching++;
      float gap = s[BoxLanes.GAP0 + lane];
      if ((points == 1 ? gap : Math.min(gap, s[BoxLanes.GAP1 + lane])) > NarrowPhase.TOUCHING) {
        gaps.add(row);
      }
      int id0 = BoxLanes.integer(s, BoxLanes.ID0 + lane);
      int id1 = BoxLanes.integer(s, BoxLanes.ID1 + lane);
      if (t.continues(row, points, id0, id1)) {
        float[] c = t.contact;
        int at = row * ContactTable.CONTACT;
        c[at + ContactTable.NX] = s[BoxLanes.NX + lane];
        c[at + ContactTable.NY] = s[BoxLanes.NY + lane];
        c[at + ContactTable.X0] = s[BoxLanes.X0 + lane];
        c[at + ContactTable.Y0] = s[BoxLanes.Y0 + lane];
        c[at + ContactTable.GAP0] = s[BoxLanes.GAP0 + lane];
        if (points == 2) {
          c[at + ContactTable.X1] = s[BoxLanes.X1 + lane];
          c[at + ContactTable.Y1] = s[BoxLanes.Y1 + lane];
          c[at + ContactTable.GAP1] = s[BoxLanes.GAP1 + lane];
        }
        t.touchOn(row);
        return;
      }
      m.normalX = s[BoxLanes.NX + lane];
      m.normalY = s[BoxLanes.NY + lane];
      m.x0 = s[BoxLanes.X0 + lane];
      m.y0 = s[BoxLanes.Y0 + lane];
      m.separation0 = s[BoxLanes.GAP0 + lane];
      m.id0 = id0;
      m.x1 = s[BoxLanes.X1 + lane];
      m.y1 = s[BoxLanes.Y1 + lane];
      m.separation1 = s[BoxLanes.GAP1 + lane];
      m.id1 = id1;
      m.otherId0 = BoxLanes.integer(s, BoxLanes.OTHER_ID0 + lane);
      m.otherId1 = BoxLanes.integer(s, BoxLanes.OTHER_ID1 + lane);
    }
    t.update(row, m);
  }
}
