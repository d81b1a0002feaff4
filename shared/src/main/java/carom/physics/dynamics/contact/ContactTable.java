package carom.physics.dynamics.contact;

import carom.physics.collision.Manifold;
import carom.physics.dynamics.body.BodyStore;
import carom.physics.dynamics.body.ShapeTable;
import java.util.Arrays;

/**
 * The pairs of shape parts that are close, from tick to tick, in the order of their {@link
 * ContactKey}. The layout of a row is drawn at {@link ContactColumns}; {@link RowOrder} says how
 * rows come and go.
 *
 * <p>A row lives while the fat boxes of its parts overlap and one of its bodies is awake; for those
 * that sleep see {@link SleepingContacts}. Rows of bodies made static or disabled stay until the
 * next step ends them. A row carries the impulses that the solver starts with, matched from tick to
 * tick by the feature ids of the points. So the rows of touching parts belong to the state. Whether
 * a row of parts that don't touch exists changes nothing.
 *
 * <p>One thread at a time, except that workers may update different rows side by side.
 */
public final class ContactTable extends ContactColumns {
  private static final int NONE = -1;

  private final RowOrder order = new RowOrder(this);
  private final ContactHash hash = new ContactHash();

  /** Makes an empty table. */
  public ContactTable() {}

  /** Returns what adds, removes and moves this table's rows. */
  public RowOrder order() {
    return order;
  }

  // ---------------------------------------------------------------- the manifold of a step

  /** Takes the manifold of this step, handing each point the impulses of its predecessor. */
  public void update(int row, Manifold m) {
    int n = m.count;
    int old = flags[row];
    int kept = old & (SENSOR | IGNORED);
    if (n == 0 && isIdle(row)) {
      // Didn't touch for two steps, as most rows: everything is zero already.
      return;
    }
    int before = ((old & TOUCHING) != 0 ? WAS_TOUCHING : 0) | (pushed(row) ? WAS_PUSHED : 0);
    flags[row] = (byte) ((n > 0 ? TOUCHING : 0) | before | kept);
    int oldPoints = points[row];
    if ((kept & SENSOR) != 0 || (n == 0 && oldPoints == 0)) {
      return;
    }
    // Mostly the same points touch as before, and their impulses stay where they are.
    boolean same = n == oldPoints && m.id0 == id[2 * row] && (n == 1 || m.id1 == id[2 * row + 1]);
    if (!same) {
      inherit(row, m, oldPoints);
    }
    clearTotals(row);
    if (n == 0) {
      roll[row] = 0;
      return;
    }
    float[] c = contact;
    int at = row * CONTACT;
    c[at + NX] = m.normalX;
    c[at + NY] = m.normalY;
    c[at + X0] = m.x0;
    c[at + Y0] = m.y0;
    c[at + GAP0] = m.separation0;
    if (n > 1) {
      c[at + X1] = m.x1;
      c[at + Y1] = m.y1;
      c[at + GAP1] = m.separation1;
    }
  }

  /** Returns whether {@link #update} does nothing with a row if its parts still don't touch. */
  public boolean isIdle(int row) {
    return (flags[row] & ~(SENSOR | IGNORED)) == 0 && points[row] == 0;
  }

  /**
   * Holds the points of a row in reserve, unless its parts touched in the step before: they don't
   * touch, but would if something pushed them together within the step. Returns whether it did.
   */
  public boolean hold(int row) {
    boolean holds = (flags[row] & WAS_TOUCHING) == 0;
    if (holds) {
      flags[row] &= ~TOUCHING;
    }
    return holds;
  }

  /** Returns whether the step before pushed the parts of a row apart. */
  public boolean wasPushed(int row) {
    return (flags[row] & WAS_PUSHED) != 0;
  }

  /** Returns whether the points of a row are held in reserve. */
  public boolean isHeld(int row) {
    return points[row] > 0 && (flags[row] & TOUCHING) == 0;
  }

  /** Makes the parts of a row touch if the step pushed them apart. */
  public void touchIfPushed(int row) {
    if (pushed(row)) {
      flags[row] |= TOUCHING;
    }
  }

  /** Returns whether a row responds, with points of just these ids. */
  public boolean continues(int row, int n, int id0, int id1) {
    return responds(row)
        && points[row] == n
        && id[2 * row] == id0
        && (n == 1 || id[2 * row + 1] == id1);
  }

  /**
   * Marks a row as touching on, after its normal, points and gaps were written: it {@link
   * #responds} and the same points touch as in the step before.
   */
  public void touchOn(int row) {
    flags[row] = (byte) (TOUCHING | WAS_TOUCHING | (pushed(row) ? WAS_PUSHED : 0));
    clearTotals(row);
  }

  private void clearTotals(int row) {
    int at = row * CONTACT;
    contact[at + TOTAL0] = 0;
    contact[at + SLIDE0] = 0;
    contact[at + TOTAL1] = 0;
    contact[at + SLIDE1] = 0;
  }

  /** Takes the points' ids over, and gives each the impulses of the one that had one of its ids. */
  private void inherit(int row, Manifold m, int oldPoints) {
    int n = m.count;
    int from0 = n > 0 ? predecessor(row, oldPoints, m.id0, m.otherId0) : NONE;
    int from1 = n > 1 ? predecessor(row, oldPoints, m.id1, m.otherId1) : NONE;
    float[] c = contact;
    int at = row * CONTACT;
    float normal0 = from0 == NONE ? 0 : c[at + from0];
    float tangent0 = from0 == NONE ? 0 : c[at + from0 + 1];
    float normal1 = from1 == NONE ? 0 : c[at + from1];
    float tangent1 = from1 == NONE ? 0 : c[at + from1 + 1];
    c[at + NORMAL0] = normal0;
    c[at + TANGENT0] = tangent0;
    c[at + NORMAL1] = normal1;
    c[at + TANGENT1] = tangent1;
    points[row] = (byte) n;
    // What isn't there is zero, for the hash.
    id[2 * row] = n > 0 ? m.id0 : 0;
    id[2 * row + 1] = n > 1 ? m.id1 : 0;
  }

  /**
   * Returns where in a row the impulses are of the point that had an id, or else the other id; or
   * {@link #NONE}.
   */
  private int predecessor(int row, int oldPoints, int wanted, int other) {
    int first = oldPoints > 0 ? id[2 * row] : NONE;
    int second = oldPoints > 1 ? id[2 * row + 1] : NONE;
    if (first == wanted || (first == other && second != wanted)) {
      return NORMAL0;
    }
    return second == wanted || second == other ? NORMAL1 : NONE;
  }

  /** Leaves a row as it is for a step. */
  public void sleepOn(int row) {
    int touched = (flags[row] & TOUCHING) != 0 ? WAS_TOUCHING : 0;
    flags[row] = (byte) ((flags[row] & ~(FRESH | WAS_TOUCHING)) | touched | DORMANT);
  }

  /** Returns whether any row may have restitution. */
  public boolean mightBounce() {
    return bouncy;
  }

  /** Takes the manifold of this step away again: the parts don't touch. */
  public void end(int row) {
    flags[row] &= ~TOUCHING;
    points[row] = 0;
    id[2 * row] = 0;
    id[2 * row + 1] = 0;
    forget(row);
  }

  /** Clears the impulses that a row starts with, because the contact was not solved. */
  public void forget(int row) {
    int at = row * CONTACT;
    contact[at + NORMAL0] = 0;
    contact[at + TANGENT0] = 0;
    contact[at + NORMAL1] = 0;
    contact[at + TANGENT1] = 0;
    roll[row] = 0;
  }

  /** Scales the impulses that a row starts the next step with. */
  public void scale(int row, float share) {
    ownTouches();
    int at = row * CONTACT;
    contact[at + NORMAL0] *= share;
    contact[at + TANGENT0] *= share;
    contact[at + NORMAL1] *= share;
    contact[at + TANGENT1] *= share;
    roll[row] *= share;
  }

  /** Sets whether the parts may touch; if not, what touches ends with the next update. */
  public void ignore(int row, boolean ignored) {
    if (ignored == ((flags[row] & IGNORED) != 0)) {
      return;
    }
    ownTouches();
    flags[row] = (byte) (ignored ? flags[row] | IGNORED : flags[row] & ~IGNORED);
  }

  // ---------------------------------------------------------------- rows of their own

  /** Fills a row in for two parts that were not known to be close. */
  public void start(int row, long k, BodyStore bodies, ShapeTable parts) {
    int a = bodies.firstPart[ContactKey.bodyA(k)] + ContactKey.partA(k);
    int b = bodies.firstPart[ContactKey.bodyB(k)] + ContactKey.partB(k);
    key[row] = k;
    part[2 * row] = a;
    part[2 * row + 1] = b;
    flags[row] = parts.sensor[a] || parts.sensor[b] ? SENSOR | FRESH : FRESH;
    points[row] = 0;
    id[2 * row] = 0;
    id[2 * row + 1] = 0;
    hint[row] = 0;
    roll[row] = 0;
    Arrays.fill(contact, row * CONTACT, (row + 1) * CONTACT, 0);
    kept.forget(row);
    mix(row, parts);
  }

  /** Sets one of the mixed numbers of a row until they are mixed again. */
  public void setMaterial(int row, int place, float value) {
    ownPairs();
    bouncy |= place == RESTITUTION && value != 0;
    material[row * MATERIAL + place] = value;
  }

  /** Mixes the materials of a row's parts. The arrays must be this table's own. */
  public void mix(int row, ShapeTable parts) {
    int a = part[2 * row];
    int b = part[2 * row + 1];
    float roundA = parts.convex[a].radius();
    float roundB = parts.convex[b].radius();
    float rolling = Math.max(parts.rolling[a], parts.rolling[b]) * Math.max(roundA, roundB);
    if (rolling != 0) {
      rolls = true; // not |=, which could undo what another worker did meanwhile
    }
    float restitution =
        parts.mixing.restitution(a, b).mix(parts.restitution[a], parts.restitution[b]);
    if (restitution != 0) {
      bouncy = true; // not |=, as above
    }
    int at = row * MATERIAL;
    material[at + FRICTION] = parts.mixing.friction(a, b).mix(parts.friction[a], parts.friction[b]);
    material[at + RESTITUTION] = restitution;
    material[at + ROLLING] = rolling;
    material[at + SURFACE] = parts.tangentSpeed[a] + parts.tangentSpeed[b];
    material[at + ROUND_A] = roundA;
    material[at + ROUND_B] = roundB;
  }

  /** Returns whether a row is of a part of a body with a number from one on, to before another. */
  public boolean isOfParts(int row, int body, int from, int to) {
    int number;
    if (bodyA(row) == body) {
      number = ContactKey.partA(key[row]);
    } else if (bodyB(row) == body) {
      number = ContactKey.partB(key[row]);
    } else {
      return false;
    }
    return from <= number && number < to;
  }

  /** Mixes the materials of a body's rows anew, after they changed. */
  public void mixAgain(int body, ShapeTable parts) {
    beginRowChange();
    for (int row = 0; row < count(); row++) {
      if (bodyA(row) == body || bodyB(row) == body) {
        mix(row, parts);
      }
    }
  }

  /**
   * Makes the rows of a body follow its parts, which were given other places and numbers. Their
   * order stays, because numbers are only moved up or down together.
   *
   * @param from the first number that changes, of those before the change
   * @param shift added to it and to all above
   */
  public void renumberParts(int body, int from, int shift, BodyStore bodies) {
    beginRowChange();
    int first = bodies.firstPart[body];
    for (int row = 0; row < count(); row++) {
      long k = key[row];
      if (bodyA(row) == body) {
        int number = renumbered(ContactKey.partA(k), from, shift);
        key[row] = ContactKey.of(body, number, bodyB(row), ContactKey.partB(k));
        part[2 * row] = first + number;
      } else if (bodyB(row) == body) {
        int number = renumbered(ContactKey.partB(k), from, shift);
        key[row] = ContactKey.of(bodyA(row), ContactKey.partA(k), body, number);
        part[2 * row + 1] = first + number;
      }
    }
  }

  private static int renumbered(int number, int from, int shift) {
    return number < from ? number : number + shift;
  }

  /** Holds copies of rows of another table instead of its own. */
  public void take(ContactTable from, int[] which, int n) {
    clear();
    resize(n);
    int[] all = rowNumbers();
    for (int i = 0; i < n; i++) {
      all[i] = i;
    }
    copyRows(from, which, all, n);
  }

  /** Returns scratch with room for the numbers of all rows, until rows are inserted. */
  int[] rowNumbers() {
    shifts.reserve(capacity());
    return shifts.inserted;
  }

  /**
   * Overwrites rows by those of another table.
   *
   * @param from the other table
   * @param which rows of it
   * @param to the rows they overwrite, in the same order
   * @param n how many
   */
  void copyRows(ContactTable from, int[] which, int[] to, int n) {
    ownPairs();
    ownTouches();
    for (int i = 0; i < n; i++) {
      int then = which[i];
      int now = to[i];
      key[now] = from.key[then];
      flags[now] = from.flags[then];
      points[now] = from.points[then];
      hint[now] = 0;
      roll[now] = from.roll[then];
      System.arraycopy(from.part, 2 * then, part, 2 * now, 2);
      System.arraycopy(from.id, 2 * then, id, 2 * now, 2);
      System.arraycopy(from.contact, CONTACT * then, contact, CONTACT * now, CONTACT);
      System.arraycopy(from.material, MATERIAL * then, material, MATERIAL * now, MATERIAL);
      kept.forget(now);
    }
    rolls |= from.rolls;
    bouncy |= from.bouncy;
  }

  // ---------------------------------------------------------------- kept manifolds

  /** Makes room to keep manifolds; a table that never calls this keeps none. */
  public void keepManifolds() {
    realignManifolds();
    kept.ensure(capacity());
  }

  /** Forgets the kept manifolds of a body, whose parts were put elsewhere in its frame. */
  public void forgetManifolds(int body) {
    realignManifolds();
    for (int row = 0; row < count(); row++) {
      if (bodyA(row) == body || bodyB(row) == body) {
        kept.forget(row);
      }
    }
  }

  /** Forgets all kept manifolds, because bodies came, went or got other shapes. */
  public void forgetManifolds() {
    kept.rows().clear();
  }

  /** Adds the rows that touch, which are all that influences the future, to a hash. */
  public long hash(long h) {
    return hash.mix(h, this, rolls);
  }
}
