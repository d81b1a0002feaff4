package carom.physics.dynamics;

import carom.physics.collision.Manifold;
import java.util.Arrays;

/**
 * Pairs of shape parts that are close, from tick to tick, in the order of their {@link ContactKey}.
 *
 * <p>A row lives while the fat boxes of its parts overlap and one of its bodies is awake; of those
 * that sleep see {@link SleepingContacts}. It carries what the solver learns (the impulses, matched
 * from tick to tick by the feature ids of the points), so the rows of touching parts belong to the
 * state. Whether a row of parts that don't touch exists changes nothing.
 *
 * <p>Rows are dense and sorted, so every pass streams through memory in the canonical order, and
 * saving is a copy; which parts the rows are of, and their materials, is only copied if a row came
 * or went. New pairs are merged in from the back; no second buffer is needed.
 */
public final class ContactTable {
  /** Flag: the manifold has points. */
  static final byte TOUCHING = 1;

  /** Flag: a callback refused the response in this step. */
  static final byte VETOED = 2;

  /** Flag: was touching in the step before. */
  static final byte WAS_TOUCHING = 4;

  /** Flag: one of the parts is a sensor; there are no points, then, and no response. */
  static final byte SENSOR = 8;

  /** Flag: filters, joints or the bodies' types keep the parts from touching since a change. */
  static final byte IGNORED = 16;

  /** Flag: the step before pushed the parts apart; only for telling impacts, not in the hash. */
  static final byte WAS_PUSHED = 64;

  /** Flag: the row came since rows were last updated. */
  static final byte FRESH = 32;

  /** Flag: neither body is dynamic and awake, so there is nothing to solve. */
  static final byte DORMANT = -128;

  private static final int FIRST_CAPACITY = 128;

  long[] key = new long[FIRST_CAPACITY];
  int[] partA = new int[FIRST_CAPACITY];
  int[] partB = new int[FIRST_CAPACITY];
  byte[] flags = new byte[FIRST_CAPACITY];

  /** Number of points: 0, 1 or 2. */
  byte[] points = new byte[FIRST_CAPACITY];

  /** Feature ids of the points. */
  int[] id0 = new int[FIRST_CAPACITY];

  int[] id1 = new int[FIRST_CAPACITY];

  /** Where the search for the best face ended; changes no result, so it isn't saved. */
  int[] hint = new int[FIRST_CAPACITY];

  /** Manifolds of steps before; change no result, so they aren't saved. */
  final KeptManifolds kept = new KeptManifolds();

  /** Impulses to start the next step with, N s per substep: normal and tangential of each point. */
  float[] normal0 = new float[FIRST_CAPACITY];

  float[] normal1 = new float[FIRST_CAPACITY];
  float[] tangent0 = new float[FIRST_CAPACITY];
  float[] tangent1 = new float[FIRST_CAPACITY];

  /** Impulse against rolling to start the next step with, N m s per substep. */
  float[] roll = new float[FIRST_CAPACITY];

  /** Mixed materials. */
  float[] friction = new float[FIRST_CAPACITY];

  float[] restitution = new float[FIRST_CAPACITY];

  /** Torque against rolling per normal force, m. */
  float[] rolling = new float[FIRST_CAPACITY];

  /** Speed of both surfaces together, along the normal turned right, m/s. */
  float[] surface = new float[FIRST_CAPACITY];

  /** Radii of the parts' rounding, m. */
  float[] roundA = new float[FIRST_CAPACITY];

  float[] roundB = new float[FIRST_CAPACITY];

  /** Unit normal from A to B. */
  float[] nx = new float[FIRST_CAPACITY];

  float[] ny = new float[FIRST_CAPACITY];

  /** Points relative to A's centre of mass, world axes, m; and their gaps. */
  float[] x0 = new float[FIRST_CAPACITY];

  float[] y0 = new float[FIRST_CAPACITY];
  float[] separation0 = new float[FIRST_CAPACITY];
  float[] x1 = new float[FIRST_CAPACITY];
  float[] y1 = new float[FIRST_CAPACITY];
  float[] separation1 = new float[FIRST_CAPACITY];

  /** Impulses of the whole step, N s. */
  float[] total0 = new float[FIRST_CAPACITY];

  float[] total1 = new float[FIRST_CAPACITY];
  float[] slide0 = new float[FIRST_CAPACITY];
  float[] slide1 = new float[FIRST_CAPACITY];

  private float[][] floats = gather();

  /** The first of the float arrays change with the rows only. */
  private static final int COLD = 6;

  private final Stamp rows = new Stamp();
  private final RowMoves moves = new RowMoves();
  private int count;
  private int version;

  /** Whether any row ever resisted rolling. */
  private boolean rolls;

  private final RecordHash records = new RecordHash();

  ContactTable() {}

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
    return partA[row];
  }

  /**
   * The part of body B.
   *
   * @param row which
   * @return its number in the shape table
   */
  public int partB(int row) {
    return partB[row];
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
    return nx[row];
  }

  /**
   * Unit normal from A to B.
   *
   * @param row which
   * @return y
   */
  public float normalY(int row) {
    return ny[row];
  }

  /**
   * Mixed friction.
   *
   * @param row which
   * @return Coulomb coefficient
   */
  public float friction(int row) {
    return friction[row];
  }

  /**
   * Mixed restitution.
   *
   * @param row which
   * @return speed after by speed before
   */
  public float restitution(int row) {
    return restitution[row];
  }

  /**
   * A contact point, relative to A's centre of mass when the step began.
   *
   * @param row which
   * @param point 0 or 1
   * @return x, m
   */
  public float pointX(int row, int point) {
    return point == 0 ? x0[row] : x1[row];
  }

  /**
   * A contact point, relative to A's centre of mass when the step began.
   *
   * @param row which
   * @param point 0 or 1
   * @return y, m
   */
  public float pointY(int row, int point) {
    return point == 0 ? y0[row] : y1[row];
  }

  /**
   * Gap at a point when the step began.
   *
   * @param row which
   * @param point 0 or 1
   * @return m, negative when overlapping
   */
  public float separation(int row, int point) {
    return point == 0 ? separation0[row] : separation1[row];
  }

  /**
   * Impulse along the normal in the last step.
   *
   * @param row which
   * @param point 0 or 1
   * @return N s
   */
  public float impulse(int row, int point) {
    return point == 0 ? total0[row] : total1[row];
  }

  /**
   * Impulse by friction in the last step.
   *
   * @param row which
   * @param point 0 or 1
   * @return N s
   */
  public float slide(int row, int point) {
    return point == 0 ? slide0[row] : slide1[row];
  }

  /**
   * Impulse along the normal with which the next substep starts.
   *
   * @param row which
   * @param point 0 or 1
   * @return N s
   */
  public float warmImpulse(int row, int point) {
    return point == 0 ? normal0[row] : normal1[row];
  }

  /** The row of a pair, negative if there is none. */
  int find(long pair) {
    return Arrays.binarySearch(key, 0, count, pair);
  }

  /** Whether the last step, or this one once it is solved, pushed the parts apart. */
  boolean pushed(int row) {
    return total0[row] > 0 || total1[row] > 0;
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

  /** Must be called when rows get new flags. */
  void flagsChanged() {
    version++;
  }

  /** Must be called when rows come or go. */
  void rowsChanged() {
    version++;
    rows.change();
  }

  /** Takes the manifold of this step, handing each point the impulses of its predecessor. */
  void update(int row, Manifold m) {
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
    boolean same = n == oldPoints && m.id0 == id0[row] && (n == 1 || m.id1 == id1[row]);
    if (!same) {
      inherit(row, m, oldPoints);
    }
    total0[row] = 0;
    total1[row] = 0;
    slide0[row] = 0;
    slide1[row] = 0;
    if (n == 0) {
      roll[row] = 0;
      return;
    }
    nx[row] = m.normalX;
    ny[row] = m.normalY;
    x0[row] = m.x0;
    y0[row] = m.y0;
    separation0[row] = m.separation0;
    if (n > 1) {
      x1[row] = m.x1;
      y1[row] = m.y1;
      separation1[row] = m.separation1;
    }
  }

  /** Takes the points' ids over, and gives each the impulses of the one that had its id. */
  private void inherit(int row, Manifold m, int oldPoints) {
    int n = m.count;
    float oldNormal0 = normal0[row];
    float oldTangent0 = tangent0[row];
    float oldNormal1 = normal1[row];
    float oldTangent1 = tangent1[row];
    int oldId0 = id0[row];
    int oldId1 = id1[row];
    points[row] = (byte) n;
    normal0[row] = 0;
    tangent0[row] = 0;
    normal1[row] = 0;
    tangent1[row] = 0;
    if (n > 0) {
      id0[row] = m.id0;
      if (oldPoints > 0 && oldId0 == m.id0) {
        normal0[row] = oldNormal0;
        tangent0[row] = oldTangent0;
      } else if (oldPoints > 1 && oldId1 == m.id0) {
        normal0[row] = oldNormal1;
        tangent0[row] = oldTangent1;
      }
    }
    if (n > 1) {
      id1[row] = m.id1;
      if (oldPoints > 1 && oldId1 == m.id1) {
        normal1[row] = oldNormal1;
        tangent1[row] = oldTangent1;
      } else if (oldPoints > 0 && oldId0 == m.id1) {
        normal1[row] = oldNormal0;
        tangent1[row] = oldTangent0;
      }
    }
  }

  /** The smaller gap of the points, m; infinite without any. */
  float leastSeparation(int row) {
    if (points[row] == 0) {
      return Float.POSITIVE_INFINITY;
    }
    return points[row] == 1 ? separation0[row] : Math.min(separation0[row], separation1[row]);
  }

  /** Leaves a row as it is for a step. */
  void sleepOn(int row) {
    int touched = (flags[row] & TOUCHING) != 0 ? WAS_TOUCHING : 0;
    flags[row] = (byte) ((flags[row] & ~(FRESH | WAS_TOUCHING)) | touched | DORMANT);
  }

  /** Starts cold: the contact was not solved. */
  void forget(int row) {
    normal0[row] = 0;
    normal1[row] = 0;
    tangent0[row] = 0;
    tangent1[row] = 0;
    roll[row] = 0;
  }

  /**
   * Drops the rows that neither touch nor have overlapping fat boxes, and merges new pairs in.
   * Every row moves at most once, runs of neighbours together.
   *
   * @param candidates keys in ascending order; those already present and repetitions are skipped
   * @param candidateCount number of keys
   * @param all whether to look at every row, or only at those of parts that {@link
   *     ShapeTable#moved}
   */
  void merge(
      long[] candidates, int candidateCount, BodyStore bodies, ShapeTable parts, boolean all) {
    version++;
    RowMoves m = moves;
    m.clear();
    int to = 0;
    int next = 0;
    int fresh = 0;
    for (int row = 0; row <= count; row++) {
      long own = row < count ? key[row] : Long.MAX_VALUE;
      for (; next < candidateCount && candidates[next] <= own; next++) {
        long k = candidates[next];
        if (k != own && (fresh == 0 || candidates[fresh - 1] != k)) {
          candidates[fresh] = k;
          m.insert(fresh++, to++);
        }
      }
      if (row < count && stays(row, parts, all)) {
        m.keep(row, to++);
      }
    }
    if (fresh == 0 && to == count) {
      return;
    }
    rows.change();
    ensure(to);
    count = to;
    moveRows();
    for (int i = 0; i < fresh; i++) {
      start(m.inserted[i], candidates[i], bodies, parts);
    }
  }

  private boolean stays(int row, ShapeTable parts, boolean all) {
    if ((flags[row] & TOUCHING) != 0) {
      return true;
    }
    if ((flags[row] & IGNORED) != 0) {
      return false;
    }
    int a = partA[row];
    int b = partB[row];
    return !(all || parts.moved[a] || parts.moved[b]) || parts.fat.overlaps(a, b);
  }

  private void moveRows() {
    if (moves.count() == 0) {
      return;
    }
    moves.apply(key);
    moves.apply(partA);
    moves.apply(partB);
    moves.apply(flags);
    moves.apply(points);
    moves.apply(id0);
    moves.apply(id1);
    moves.apply(hint);
    kept.move(moves);
    for (float[] field : floats) {
      moves.apply(field);
    }
  }

  /**
   * Merges rows of another table in, which must not be here yet.
   *
   * @param from where they are
   * @param which their numbers, by ascending key
   * @param n how many
   */
  void insert(ContactTable from, int[] which, int n) {
    rowsChanged();
    moves.clear();
    int next = 0;
    for (int row = 0; row <= count; row++) {
      for (; next < n && (row == count || from.key[which[next]] < key[row]); next++) {
        moves.insert(next, row + next);
      }
      if (row < count) {
        moves.keep(row, row + next);
      }
    }
    ensure(count + n);
    count += n;
    moveRows();
    copyRows(from, which, moves.inserted, n);
    for (int i = 0; i < n; i++) {
      int to = moves.inserted[i];
      flags[to] = (byte) ((flags[to] & ~DORMANT) | FRESH);
    }
  }

  /** Sorts row numbers by the rows' keys (Shell's sort: short, and no memory). */
  void sortByKey(int[] which, int n) {
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

  /** Moves the touching rows without an awake body to another store, and drops the others. */
  void retire(int[] activeIndex, SleepingContacts to) {
    rowsChanged();
    moves.clear();
    int[] retired = records.list(count);
    int gone = 0;
    int kept = 0;
    for (int row = 0; row < count; row++) {
      if (activeIndex[bodyA(row)] >= 0 || activeIndex[bodyB(row)] >= 0) {
        moves.keep(row, kept++);
      } else if ((flags[row] & TOUCHING) != 0) {
        retired[gone++] = row;
      }
    }
    to.put(this, retired, gone);
    moveRows();
    count = kept;
  }

  /** Drops all rows. */
  void clear() {
    rowsChanged();
    count = 0;
  }

  /** Makes room for one row more, which the caller fills; answers its number. */
  int append() {
    ensure(count + 1);
    return count++;
  }

  /** Whether the parts may touch; if not, what touches ends with the next update. */
  void ignore(int row, boolean ignored) {
    flags[row] = (byte) (ignored ? flags[row] | IGNORED : flags[row] & ~IGNORED);
  }

  /** Drops all rows of a body. */
  void removeBody(int body) {
    moves.clear();
    int kept = 0;
    for (int row = 0; row < count; row++) {
      if (ContactKey.bodyA(key[row]) != body && ContactKey.bodyB(key[row]) != body) {
        moves.keep(row, kept++);
      }
    }
    rowsChanged();
    moveRows();
    count = kept;
  }

  /** Makes a row of two parts that were not known to be close. */
  void start(int row, long k, BodyStore bodies, ShapeTable parts) {
    int a = bodies.firstPart[ContactKey.bodyA(k)] + ContactKey.partA(k);
    int b = bodies.firstPart[ContactKey.bodyB(k)] + ContactKey.partB(k);
    for (float[] field : floats) {
      field[row] = 0;
    }
    key[row] = k;
    partA[row] = a;
    partB[row] = b;
    flags[row] = parts.sensor[a] || parts.sensor[b] ? SENSOR | FRESH : FRESH;
    points[row] = 0;
    id0[row] = 0;
    id1[row] = 0;
    hint[row] = 0;
    kept.forget(row);
    mix(row, parts);
  }

  /** Mixes the materials of a row's parts. */
  private void mix(int row, ShapeTable parts) {
    int a = partA[row];
    int b = partB[row];
    friction[row] = (float) Math.sqrt(parts.friction[a] * parts.friction[b]);
    restitution[row] = Math.max(parts.restitution[a], parts.restitution[b]);
    roundA[row] = parts.convex[a].radius();
    roundB[row] = parts.convex[b].radius();
    float radius = Math.max(roundA[row], roundB[row]);
    rolling[row] = Math.max(parts.rolling[a], parts.rolling[b]) * radius;
    rolls |= rolling[row] != 0;
    surface[row] = parts.tangentSpeed[a] + parts.tangentSpeed[b];
  }

  /** Makes room to keep manifolds; where nobody does so none are kept. */
  void keepManifolds() {
    kept.ensure(key.length);
  }

  /** Must be called when a body's parts were put elsewhere in its frame. */
  void forgetManifolds(int body) {
    for (int row = 0; row < count; row++) {
      if (bodyA(row) == body || bodyB(row) == body) {
        kept.forget(row);
      }
    }
  }

  /** Must be called when materials of a body changed. */
  void mixAgain(int body, ShapeTable parts) {
    rowsChanged();
    for (int row = 0; row < count; row++) {
      if (bodyA(row) == body || bodyB(row) == body) {
        mix(row, parts);
      }
    }
  }

  /**
   * Overwrites rows by those of another table, array by array: row by row, each would touch some
   * thirty places in memory.
   *
   * @param from the other table
   * @param which rows of it
   * @param to the rows they overwrite, in the same order
   * @param n how many
   */
  void copyRows(ContactTable from, int[] which, int[] to, int n) {
    for (int i = 0; i < n; i++) {
      key[to[i]] = from.key[which[i]];
    }
    copy(from.partA, which, partA, to, n);
    copy(from.partB, which, partB, to, n);
    copy(from.flags, which, flags, to, n);
    copy(from.points, which, points, to, n);
    copy(from.id0, which, id0, to, n);
    copy(from.id1, which, id1, to, n);
    copy(from.hint, which, hint, to, n);
    for (int f = 0; f < floats.length; f++) {
      copy(from.floats[f], which, floats[f], to, n);
    }
    for (int i = 0; i < n; i++) {
      kept.forget(to[i]);
    }
    rolls |= from.rolls;
  }

  private static void copy(int[] from, int[] which, int[] target, int[] to, int n) {
    for (int i = 0; i < n; i++) {
      target[to[i]] = from[which[i]];
    }
  }

  private static void copy(byte[] from, int[] which, byte[] target, int[] to, int n) {
    for (int i = 0; i < n; i++) {
      target[to[i]] = from[which[i]];
    }
  }

  private static void copy(float[] from, int[] which, float[] target, int[] to, int n) {
    for (int i = 0; i < n; i++) {
      target[to[i]] = from[which[i]];
    }
  }

  /** Bits of the rows that touch, which are all that influences the future. */
  long hash() {
    int[] list = records.list(count);
    int found = 0;
    for (int row = 0; row < count; row++) {
      list[found] = row;
      found += flags[row] & TOUCHING;
    }
    return hash(found);
  }

  /** Bits of the rows that stand for something; the others mean nothing. */
  long hashUsed() {
    int[] list = records.list(count);
    int found = 0;
    for (int row = 0; row < count; row++) {
      list[found] = row;
      found += unused(row) ? 0 : 1;
    }
    return hash(found);
  }

  /**
   * Bits of the listed rows. Normals and sliding impulses of the whole step aren't in it: they
   * follow from the state before the step, and nothing in a step reads them.
   */
  private long hash(int listed) {
    records.begin(listed);
    for (int i = 0; i < listed; i++) {
      int row = records.record(i);
      int state = flags[row] & 0xff & ~(FRESH | WAS_PUSHED);
      records.add(i, 0, key[row]);
      records.add(i, 1, (long) points[row] << 40 | (long) state << 32 | id0[row] & 0xffffffffL);
    }
    records.add(2, normal0, tangent0);
    records.add(4, total0);
    if (rolls) {
      records.add(5, roll);
    }
    int two = 0;
    int[] list = records.list(listed);
    for (int i = 0; i < listed; i++) {
      list[two] = list[i];
      two += points[list[i]] >> 1;
    }
    long sum = records.finish();
    records.begin(two);
    for (int i = 0; i < two; i++) {
      int row = records.record(i);
      records.add(i, 6, key[row]);
      records.add(i, 7, id1[row]);
    }
    records.add(8, normal1, tangent1);
    records.add(10, total1);
    return sum + records.finish();
  }

  /**
   * Copies everything into another table, which grows as needed; allocates only then.
   *
   * @return the bytes that were copied
   */
  long copyTo(ContactTable to) {
    to.ensure(count);
    System.arraycopy(flags, 0, to.flags, 0, count);
    System.arraycopy(points, 0, to.points, 0, count);
    System.arraycopy(id0, 0, to.id0, 0, count);
    System.arraycopy(id1, 0, to.id1, 0, count);
    for (int f = COLD; f < floats.length; f++) {
      System.arraycopy(floats[f], 0, to.floats[f], 0, count);
    }
    int perRow = 2 + 2 * Integer.BYTES + Float.BYTES * (floats.length - COLD);
    if (!rows.same(to.rows)) {
      System.arraycopy(key, 0, to.key, 0, count);
      System.arraycopy(partA, 0, to.partA, 0, count);
      System.arraycopy(partB, 0, to.partB, 0, count);
      for (int f = 0; f < COLD; f++) {
        System.arraycopy(floats[f], 0, to.floats[f], 0, count);
      }
      to.count = count;
      to.kept.clear();
      rows.copyTo(to.rows);
      perRow += Long.BYTES + 2 * Integer.BYTES + Float.BYTES * COLD;
    }
    to.rolls = rolls;
    to.version++;
    return (long) count * perRow;
  }

  /** Makes room for so many rows before they come. */
  void reserve(int rowCount) {
    ensure(rowCount);
  }

  private void ensure(int capacity) {
    if (capacity <= key.length) {
      return;
    }
    int grown = Math.max(capacity, key.length * 2);
    kept.grow(grown);
    key = Arrays.copyOf(key, grown);
    partA = Arrays.copyOf(partA, grown);
    partB = Arrays.copyOf(partB, grown);
    flags = Arrays.copyOf(flags, grown);
    points = Arrays.copyOf(points, grown);
    id0 = Arrays.copyOf(id0, grown);
    id1 = Arrays.copyOf(id1, grown);
    hint = Arrays.copyOf(hint, grown);
    normal0 = Arrays.copyOf(normal0, grown);
    normal1 = Arrays.copyOf(normal1, grown);
    tangent0 = Arrays.copyOf(tangent0, grown);
    tangent1 = Arrays.copyOf(tangent1, grown);
    roll = Arrays.copyOf(roll, grown);
    friction = Arrays.copyOf(friction, grown);
    restitution = Arrays.copyOf(restitution, grown);
    rolling = Arrays.copyOf(rolling, grown);
    surface = Arrays.copyOf(surface, grown);
    roundA = Arrays.copyOf(roundA, grown);
    roundB = Arrays.copyOf(roundB, grown);
    nx = Arrays.copyOf(nx, grown);
    ny = Arrays.copyOf(ny, grown);
    x0 = Arrays.copyOf(x0, grown);
    y0 = Arrays.copyOf(y0, grown);
    separation0 = Arrays.copyOf(separation0, grown);
    x1 = Arrays.copyOf(x1, grown);
    y1 = Arrays.copyOf(y1, grown);
    separation1 = Arrays.copyOf(separation1, grown);
    total0 = Arrays.copyOf(total0, grown);
    total1 = Arrays.copyOf(total1, grown);
    slide0 = Arrays.copyOf(slide0, grown);
    slide1 = Arrays.copyOf(slide1, grown);
    floats = gather();
  }

  private float[][] gather() {
    return new float[][] {
      friction,
      restitution,
      rolling,
      surface,
      roundA,
      roundB,
      normal0,
      normal1,
      tangent0,
      tangent1,
      roll,
      nx,
      ny,
      x0,
      y0,
      separation0,
      x1,
      y1,
      separation1,
      total0,
      total1,
      slide0,
      slide1
    };
  }
}
