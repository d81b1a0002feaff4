package carom.physics.dynamics.contact;

import carom.physics.collision.Manifold;
import carom.physics.dynamics.body.BodyStore;
import carom.physics.dynamics.body.ShapeTable;
import carom.physics.dynamics.parallel.ParallelFor;
import carom.physics.dynamics.store.Stamp;
import java.util.Arrays;

/**
 * Pairs of shape parts that are close, from tick to tick, in the order of their {@link ContactKey}.
 *
 * <p>A row lives while the fat boxes of its parts overlap and one of its bodies is awake; of those
 * that sleep see {@link SleepingContacts}. Rows of bodies made static or disabled are here until
 * the next step ends them. A row carries what the solver learns (the impulses, matched from tick to
 * tick by the feature ids of the points), so the rows of touching parts belong to the state.
 * Whether a row of parts that don't touch exists changes nothing.
 *
 * <p>Rows are dense and sorted, so every pass streams through memory in the canonical order. Copies
 * share them ({@link RowArrays}): saving costs nothing, and who writes first pays. New pairs are
 * merged in from the back; no second buffer is needed.
 */
public final class ContactTable {
  /** Flag: the manifold has points. */
  public static final byte TOUCHING = 1;

  /** Flag: a callback refused the response in this step. */
  public static final byte VETOED = 2;

  /** Flag: was touching in the step before. */
  public static final byte WAS_TOUCHING = 4;

  /** Flag: one of the parts is a sensor; there are no points, then, and no response. */
  static final byte SENSOR = 8;

  /** Flag: filters, joints or the bodies' types keep the parts from touching since a change. */
  public static final byte IGNORED = 16;

  /** Flag: the step before pushed the parts apart; only for telling impacts, not in the hash. */
  public static final byte WAS_PUSHED = 64;

  /** Flag: the row came since rows were last updated. */
  public static final byte FRESH = 32;

  /** Flag: neither body is dynamic and awake, so there is nothing to solve. */
  public static final byte DORMANT = -128;

  /** Floats per row in {@link #contact}: as much as a line of the processor's caches. */
  public static final int CONTACT = 16;

  /** Unit normal from A to B. */
  public static final int NX = 0;

  public static final int NY = 1;

  /** Points relative to A's centre of mass, world axes, m; and their gaps, m. */
  public static final int X0 = 2;

  public static final int Y0 = 3;
  public static final int GAP0 = 4;
  public static final int X1 = 5;
  public static final int Y1 = 6;
  public static final int GAP1 = 7;

  /** Of each point: impulses to start the next step with, N s per substep, */
  public static final int NORMAL0 = 8;

  public static final int TANGENT0 = 9;

  /** and those of the whole step, N s, along normal and tangent. */
  public static final int TOTAL0 = 10;

  public static final int SLIDE0 = 11;
  public static final int NORMAL1 = 12;
  public static final int TANGENT1 = 13;
  public static final int TOTAL1 = 14;
  public static final int SLIDE1 = 15;

  /** Floats per row in {@link #material}; they change with the rows only. */
  public static final int MATERIAL = 6;

  public static final int FRICTION = 0;
  public static final int RESTITUTION = 1;

  /** Torque against rolling per normal force, m. */
  public static final int ROLLING = 2;

  /** Speed of both surfaces together, along the normal turned right, m/s. */
  public static final int SURFACE = 3;

  /** Radii of the parts' rounding, m. */
  public static final int ROUND_A = 4;

  public static final int ROUND_B = 5;

  private static final int FIRST_CAPACITY = 128;

  /** Of {@link #pairs}. */
  public long[] key;

  /** Two per row: the part of A, and of B. */
  public int[] part;

  /** Of {@link #touches}. */
  public byte[] flags;

  /** Number of points: 0, 1 or 2. */
  public byte[] points;

  /** Two per row: the feature ids of the points. */
  public int[] id;

  /** Where the search for the best face ended; changes no result, so it isn't saved. */
  public int[] hint = new int[FIRST_CAPACITY];

  /** Manifolds of steps before; change no result, so they aren't saved. */
  public final KeptManifolds kept = new KeptManifolds();

  private final RowMerge merge = new RowMerge(this);

  /** What steps change, {@value #CONTACT} floats per row. */
  public float[] contact;

  /** What the materials of both parts make together, {@value #MATERIAL} floats per row. */
  public float[] material;

  /** Impulse against rolling to start the next step with, N m s per substep. */
  public float[] roll;

  /** Who the rows are of: changes only when rows come or go. Copies share it. */
  private RowArrays pairs =
      new RowArrays(
          FIRST_CAPACITY, new int[] {1, 2, MATERIAL}, new long[0], new int[0], new float[0]);

  /** What a step changes. Copies share it. */
  private RowArrays touches =
      new RowArrays(
          FIRST_CAPACITY,
          new int[] {1, 1, 2, CONTACT, 1},
          new byte[0],
          new byte[0],
          new int[0],
          new float[0],
          new float[0]);

  private final Stamp rows = new Stamp();
  private final RowMoves moves = new RowMoves();
  private int count;
  private int version;

  /** Whether any row ever resisted rolling. */
  private boolean rolls;

  private final ContactHash hash = new ContactHash();

  /** Scratch: numbers of rows. */
  private int[] listed = new int[0];

  public ContactTable() {
    bind();
  }

  /** Must be called when the table has other arrays. */
  private void bind() {
    key = (long[]) pairs.array(0);
    part = (int[]) pairs.array(1);
    material = (float[]) pairs.array(2);
    flags = (byte[]) touches.array(0);
    points = (byte[]) touches.array(1);
    id = (int[]) touches.array(2);
    contact = (float[]) touches.array(3);
    roll = (float[]) touches.array(4);
  }

  private void ownPairs() {
    if (pairs.shared()) {
      pairs = pairs.own(count, pairs.capacity());
      bind();
    }
  }

  private void ownTouches() {
    if (touches.shared()) {
      touches = touches.own(count, touches.capacity());
      bind();
    }
  }

  /**
   * The number of rows.
   *
   * @return rows in use
   */
  public int count() {
    return count;
  }

  /**
   * Tells whether rows came, went or got other numbers.
   *
   * @return another number whenever that happened
   */
  public int version() {
    return version;
  }

  /**
   * The body with the smaller index.
   *
   * @param row which
   * @return its slot
   */
  public int bodyA(int row) {
    return ContactKey.bodyA(key[row]);
  }

  /**
   * The body with the larger index.
   *
   * @param row which
   * @return its slot
   */
  public int bodyB(int row) {
    return ContactKey.bodyB(key[row]);
  }

  /**
   * The part of body A.
   *
   * @param row which
   * @return its number in the shape table
   */
  public int partA(int row) {
    return part[2 * row];
  }

  /**
   * The part of body B.
   *
   * @param row which
   * @return its number in the shape table
   */
  public int partB(int row) {
    return part[2 * row + 1];
  }

  /**
   * Whether one of the parts is a sensor.
   *
   * @param row which
   * @return true if there is no response
   */
  public boolean sensor(int row) {
    return (flags[row] & SENSOR) != 0;
  }

  /**
   * The number of contact points.
   *
   * @param row which
   * @return 0, 1 or 2
   */
  public int points(int row) {
    return points[row];
  }

  /**
   * Unit normal from A to B.
   *
   * @param row which
   * @return x
   */
  public float normalX(int row) {
    return contact[row * CONTACT + NX];
  }

  /**
   * Unit normal from A to B.
   *
   * @param row which
   * @return y
   */
  public float normalY(int row) {
    return contact[row * CONTACT + NY];
  }

  /**
   * Mixed friction.
   *
   * @param row which
   * @return Coulomb coefficient
   */
  public float friction(int row) {
    return material[row * MATERIAL + FRICTION];
  }

  /**
   * Mixed restitution.
   *
   * @param row which
   * @return speed after by speed before
   */
  public float restitution(int row) {
    return material[row * MATERIAL + RESTITUTION];
  }

  /**
   * A contact point, relative to A's centre of mass when the step began.
   *
   * @param row which
   * @param point 0 or 1
   * @return x, m
   */
  public float pointX(int row, int point) {
    return contact[row * CONTACT + (point == 0 ? X0 : X1)];
  }

  /**
   * A contact point, relative to A's centre of mass when the step began.
   *
   * @param row which
   * @param point 0 or 1
   * @return y, m
   */
  public float pointY(int row, int point) {
    return contact[row * CONTACT + (point == 0 ? Y0 : Y1)];
  }

  /**
   * Gap at a point when the step began.
   *
   * @param row which
   * @param point 0 or 1
   * @return m, negative when overlapping
   */
  public float separation(int row, int point) {
    return contact[row * CONTACT + (point == 0 ? GAP0 : GAP1)];
  }

  /**
   * Impulse along the normal in the last step.
   *
   * @param row which
   * @param point 0 or 1
   * @return N s
   */
  public float impulse(int row, int point) {
    return contact[row * CONTACT + (point == 0 ? TOTAL0 : TOTAL1)];
  }

  /**
   * Impulse by friction in the last step.
   *
   * @param row which
   * @param point 0 or 1
   * @return N s
   */
  public float slide(int row, int point) {
    return contact[row * CONTACT + (point == 0 ? SLIDE0 : SLIDE1)];
  }

  /**
   * Impulse along the normal with which the next substep starts.
   *
   * @param row which
   * @param point 0 or 1
   * @return N s
   */
  public float warmImpulse(int row, int point) {
    return contact[row * CONTACT + (point == 0 ? NORMAL0 : NORMAL1)];
  }

  /** Speed of both surfaces together, m/s. */
  public float surface(int row) {
    return material[row * MATERIAL + SURFACE];
  }

  /** The row of a pair, negative if there is none. */
  public int find(long pair) {
    return Arrays.binarySearch(key, 0, count, pair);
  }

  /** Whether the last step, or this one once it is solved, pushed the parts apart. */
  public boolean pushed(int row) {
    return contact[row * CONTACT + TOTAL0] > 0 || contact[row * CONTACT + TOTAL1] > 0;
  }

  /**
   * Whether a row stands for nothing; never in the table of awake bodies.
   *
   * @param row which
   * @return true if its numbers mean nothing
   */
  public boolean unused(int row) {
    return key[row] == SleepingContacts.FREE;
  }

  /** Must be called before rows get new flags or other numbers that steps change. */
  public void flagsChange() {
    version++;
    ownTouches();
  }

  /** Must be called before rows come or go. */
  void rowsChange() {
    version++;
    rows.change();
    ownPairs();
    ownTouches();
  }

  /** Takes the manifold of this step, handing each point the impulses of its predecessor. */
  public void update(int row, Manifold m) {
    int n = m.count;
    int old = flags[row];
    int kept = old & (SENSOR | IGNORED);
    if (n == 0 && kept == old) {
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

  /** Whether the parts push each other if they touch. */
  public boolean acts(int row) {
    return (flags[row] & (SENSOR | IGNORED)) == 0;
  }

  /** Whether the parts touch, and push each other. */
  public boolean responds(int row) {
    return (flags[row] & (TOUCHING | SENSOR | IGNORED)) == TOUCHING;
  }

  /** Whether the parts touched, and pushed each other, at so many points of such ids. */
  public boolean continues(int row, int n, int id0, int id1) {
    return responds(row)
        && points[row] == n
        && id[2 * row] == id0
        && (n == 1 || id[2 * row + 1] == id1);
  }

  /**
   * Takes over that the same points of a row that {@link #responds} touch as in the step before,
   * once normal, points and gaps are written.
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

  /** Takes the points' ids over, and gives each the impulses of the one that had its id. */
  private void inherit(int row, Manifold m, int oldPoints) {
    int n = m.count;
    float[] c = contact;
    int at = row * CONTACT;
    float oldNormal0 = c[at + NORMAL0];
    float oldTangent0 = c[at + TANGENT0];
    float oldNormal1 = c[at + NORMAL1];
    float oldTangent1 = c[at + TANGENT1];
    int oldId0 = id[2 * row];
    int oldId1 = id[2 * row + 1];
    points[row] = (byte) n;
    // What isn't there is zero, for the hash.
    id[2 * row] = 0;
    id[2 * row + 1] = 0;
    c[at + NORMAL0] = 0;
    c[at + TANGENT0] = 0;
    c[at + NORMAL1] = 0;
    c[at + TANGENT1] = 0;
    if (n > 0) {
      id[2 * row] = m.id0;
      if (oldPoints > 0 && oldId0 == m.id0) {
        c[at + NORMAL0] = oldNormal0;
        c[at + TANGENT0] = oldTangent0;
      } else if (oldPoints > 1 && oldId1 == m.id0) {
        c[at + NORMAL0] = oldNormal1;
        c[at + TANGENT0] = oldTangent1;
      }
    }
    if (n > 1) {
      id[2 * row + 1] = m.id1;
      if (oldPoints > 1 && oldId1 == m.id1) {
        c[at + NORMAL1] = oldNormal1;
        c[at + TANGENT1] = oldTangent1;
      } else if (oldPoints > 0 && oldId0 == m.id1) {
        c[at + NORMAL1] = oldNormal0;
        c[at + TANGENT1] = oldTangent0;
      }
    }
  }

  /** The smaller gap of the points, m; infinite without any. */
  public float leastSeparation(int row) {
    if (points[row] == 0) {
      return Float.POSITIVE_INFINITY;
    }
    float gap = contact[row * CONTACT + GAP0];
    return points[row] == 1 ? gap : Math.min(gap, contact[row * CONTACT + GAP1]);
  }

  /** Leaves a row as it is for a step. */
  public void sleepOn(int row) {
    int touched = (flags[row] & TOUCHING) != 0 ? WAS_TOUCHING : 0;
    flags[row] = (byte) ((flags[row] & ~(FRESH | WAS_TOUCHING)) | touched | DORMANT);
  }

  /** Starts cold: the contact was not solved. */
  public void forget(int row) {
    int at = row * CONTACT;
    contact[at + NORMAL0] = 0;
    contact[at + TANGENT0] = 0;
    contact[at + NORMAL1] = 0;
    contact[at + TANGENT1] = 0;
    roll[row] = 0;
  }

  /**
   * Drops the rows that neither touch nor have overlapping fat boxes, and merges new pairs in.
   * Every row moves at most once, runs of neighbours together.
   *
   * @param candidates keys in ascending order; those already present and repetitions are skipped;
   *     new ones are brought to the front
   * @param candidateCount number of keys
   * @param all whether to look at every row, or only at those of parts that {@link
   *     ShapeTable#moved}
   * @param parallel does what can be shared
   */
  public void merge(
      long[] candidates,
      int candidateCount,
      BodyStore bodies,
      ShapeTable parts,
      boolean all,
      ParallelFor parallel) {
    version++;
    beginMoves();
    int fresh = merge.find(candidates, candidateCount, parts, all, parallel, moves);
    if (fresh == 0 && merge.rowCount() == count) {
      return;
    }
    moveRows(merge.rowCount(), parallel);
    merge.startNew(fresh, bodies, parallel);
  }

  /** Begins to note how rows move. */
  private void beginMoves() {
    realignManifolds();
    moves.clear(pairs.shared() || touches.shared());
  }

  private void realignManifolds() {
    growCaches(Math.max(count, kept.rowsBefore()));
    kept.realign(key, count, moves);
  }

  /**
   * Moves rows, of which there are then another number, to where they may be written.
   *
   * @param parallel does it, null for the caller alone
   */
  private void moveRows(int newCount, ParallelFor parallel) {
    rows.change();
    growCaches(Math.max(count, newCount));
    pairs = pairs.moved(moves, pairs.room(newCount));
    touches = touches.moved(moves, touches.room(newCount));
    bind();
    moves.plan(hint, hint, 1);
    kept.move(moves);
    moves.carryOut(parallel);
    count = newCount;
  }

  /**
   * Merges rows of another table in, which must not be here yet.
   *
   * @param from where they are
   * @param which their numbers, by ascending key
   * @param n how many
   */
  public void insert(ContactTable from, int[] which, int n) {
    version++;
    beginMoves();
    int next = 0;
    for (int row = 0; row <= count; row++) {
      for (; next < n && (row == count || from.key[which[next]] < key[row]); next++) {
        moves.insert(next, row + next);
      }
      if (row < count) {
        moves.keep(row, row + next);
      }
    }
    moveRows(count + n, null);
    copyRows(from, which, moves.inserted, n);
    for (int i = 0; i < n; i++) {
      int to = moves.inserted[i];
      flags[to] = (byte) ((flags[to] & ~DORMANT) | FRESH);
    }
  }

  /** Sorts row numbers by the rows' keys (Shell's sort: short, and no memory). */
  public void sortByKey(int[] which, int n) {
    for (int gap = n / 2; gap > 0; gap = gap == 2 ? 1 : gap * 5 / 11) {
      for (int i = gap; i < n; i++) {
        int row = which[i];
        int j = i;
        for (; j >= gap && key[which[j - gap]] > key[row]; j -= gap) {
          which[j] = which[j - gap];
        }
        which[j] = row;
      }
    }
  }

  /**
   * Moves the touching rows of bodies that sleep to another store, and drops the others of them.
   */
  public void retire(BodyStore bodies, SleepingContacts to) {
    version++;
    beginMoves();
    int[] retired = listed();
    int gone = 0;
    int kept = 0;
    for (int row = 0; row < count; row++) {
      if (!SleepingContacts.belongs(bodies, bodyA(row), bodyB(row))) {
        moves.keep(row, kept++);
      } else if ((flags[row] & TOUCHING) != 0) {
        retired[gone++] = row;
      }
    }
    to.put(this, retired, gone);
    moveRows(kept, null);
  }

  /** Room for the numbers of all rows. */
  private int[] listed() {
    if (listed.length < count) {
      listed = new int[hint.length];
    }
    return listed;
  }

  /** Drops all rows. */
  public void clear() {
    count = 0;
    rowsChange();
  }

  /** Makes room for one row more, which the caller fills; answers its number. */
  public int append() {
    ensure(count + 1);
    return count++;
  }

  /** Whether the parts may touch; if not, what touches ends with the next update. */
  public void ignore(int row, boolean ignored) {
    if (ignored == ((flags[row] & IGNORED) != 0)) {
      return;
    }
    ownTouches();
    flags[row] = (byte) (ignored ? flags[row] | IGNORED : flags[row] & ~IGNORED);
  }

  /** Drops all rows of a body. */
  public void removeBody(int body) {
    version++;
    beginMoves();
    int kept = 0;
    for (int row = 0; row < count; row++) {
      if (ContactKey.bodyA(key[row]) != body && ContactKey.bodyB(key[row]) != body) {
        moves.keep(row, kept++);
      }
    }
    moveRows(kept, null);
  }

  /** Makes a row of two parts that were not known to be close. */
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

  /** Mixes the materials of a row's parts. */
  private void mix(int row, ShapeTable parts) {
    int a = part[2 * row];
    int b = part[2 * row + 1];
    float roundA = parts.convex[a].radius();
    float roundB = parts.convex[b].radius();
    float rolling = Math.max(parts.rolling[a], parts.rolling[b]) * Math.max(roundA, roundB);
    if (rolling != 0) {
      rolls = true; // not |=, which could undo what another worker did meanwhile
    }
    int at = row * MATERIAL;
    material[at + FRICTION] = (float) Math.sqrt(parts.friction[a] * parts.friction[b]);
    material[at + RESTITUTION] = Math.max(parts.restitution[a], parts.restitution[b]);
    material[at + ROLLING] = rolling;
    material[at + SURFACE] = parts.tangentSpeed[a] + parts.tangentSpeed[b];
    material[at + ROUND_A] = roundA;
    material[at + ROUND_B] = roundB;
  }

  /** Makes room to keep manifolds; where nobody does so none are kept. */
  public void keepManifolds() {
    realignManifolds();
    kept.ensure(hint.length);
  }

  /** Must be called when a body's parts were put elsewhere in its frame. */
  public void forgetManifolds(int body) {
    realignManifolds();
    for (int row = 0; row < count; row++) {
      if (bodyA(row) == body || bodyB(row) == body) {
        kept.forget(row);
      }
    }
  }

  /** Must be called when bodies came, went or got other shapes. */
  public void forgetManifolds() {
    kept.clear();
  }

  /** Must be called when materials of a body changed. */
  public void mixAgain(int body, ShapeTable parts) {
    rowsChange();
    for (int row = 0; row < count; row++) {
      if (bodyA(row) == body || bodyB(row) == body) {
        mix(row, parts);
      }
    }
  }

  /** Holds copies of rows of another table instead of its own. */
  public void take(ContactTable from, int[] which, int n) {
    clear();
    ensure(n);
    count = n;
    int[] all = listed();
    for (int i = 0; i < n; i++) {
      all[i] = i;
    }
    copyRows(from, which, all, n);
  }

  /** Lists the rows that touch; answers how many. */
  public int touching(int[] to) {
    int found = 0;
    for (int row = 0; row < count; row++) {
      if ((flags[row] & TOUCHING) != 0) {
        to[found++] = row;
      }
    }
    return found;
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
  }

  /** Bits of the rows that touch, which are all that influences the future. */
  public long hash(long h) {
    return hash.mix(h, this, rolls);
  }

  /**
   * Makes another table a copy of this. No row is copied: both share them until one of them writes.
   */
  public void copyTo(ContactTable to) {
    touches.share();
    to.touches.release();
    to.touches = touches;
    if (!rows.same(to.rows)) {
      to.kept.rowsReplaced(to.pairs, to.count);
      rows.copyTo(to.rows);
    }
    pairs.share();
    to.pairs.release();
    to.pairs = pairs;
    to.count = count;
    to.bind();
    to.rolls = rolls;
    to.version++;
  }

  /** Makes a copy that was read differ from all that were copied from this. */
  public void distinguish(ContactTable copy) {
    rows.distinguish(copy.rows);
  }

  /** Has so many rows, which the caller fills. */
  void resize(int rowCount) {
    ensure(rowCount);
    count = rowCount;
  }

  /** How many rows there is room for. */
  public int capacity() {
    return hint.length;
  }

  /** Makes room for so many rows before they come. */
  public void reserve(int rowCount) {
    ensure(rowCount);
  }

  private void ensure(int least) {
    if (least > pairs.capacity() || least > touches.capacity()) {
      pairs = pairs.own(count, pairs.room(least));
      touches = touches.own(count, touches.room(least));
      bind();
    }
    growCaches(least);
  }

  /** Makes room for what is known of rows beside their state. */
  private void growCaches(int least) {
    if (least > hint.length) {
      int grown = Math.max(least, 2 * hint.length);
      hint = Arrays.copyOf(hint, grown);
      kept.grow(grown);
      moves.reserve(grown);
    }
  }
}
