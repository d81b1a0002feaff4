package carom.physics.dynamics.narrow;

import carom.physics.collision.Collider;
import carom.physics.collision.Manifold;
import carom.physics.collision.TimeOfImpact;
import carom.physics.dynamics.body.BodyStore;
import carom.physics.dynamics.body.ShapeTable;
import carom.physics.dynamics.contact.ContactTable;
import carom.physics.dynamics.contact.KeptManifolds;
import carom.physics.dynamics.store.IntList;
import carom.physics.dynamics.store.ParallelFor;
import carom.physics.math.Transform;
import carom.physics.settings.Settings;
import java.util.Arrays;
import java.util.function.IntPredicate;

/**
 * The narrow phase: updates the rows of the contact table, one manifold per pair of parts.
 *
 * <p>Each row depends on the poses and on what it said before, and writes to itself alone. So the
 * order doesn't matter, and workers may share the rows. Within a block of {@value #BLOCK} rows,
 * which stay in the nearest cache, those that are kept come first; then pairs of the same kinds of
 * shapes follow each other: the processor guesses most branches right, then, which in a pile of
 * mixed shapes saves a quarter of the time. Where boxes move so that little is kept, a kernel does
 * many rows of boxes at once ({@link BoxRows}), and keeps nothing.
 */
public final class NarrowPhase {
  private static final int BLOCK = 128;

  /** Number of rows in a group. The first block of a group tells whether to keep manifolds. */
  private static final int GROUP = 8 * BLOCK;

  /** A group goes to the kernel if more than one of so many manifolds was made anew, of boxes. */
  private static final int KEPT = 8;

  /** Number of rows of boxes below which the kernel would be idle in too many lanes. */
  private static final int FEW_BOXES = 4;

  /** Largest gap of shapes that count as touching at any speed, m. */
  static final float TOUCHING = TimeOfImpact.MIN_TARGET;

  /** Number of rows in a piece of a worker's work. */
  private static final int GRAIN = 64;

  private final Settings settings;
  private final BodyStore bodies;
  private final ShapeTable parts;
  private final ContactTable contacts;
  private final ParallelFor parallel;
  private final BoxLanes lanes = BoxLanes.FOUND;
  private final ParallelFor.Range updating = this::update;

  /** Mark: the row stays as it is. */
  private static final int LEFT = 1;

  /** Mark: the row covers others. */
  private static final int COVERS = 2;

  /** Per row: its marks, added up. */
  private byte[] marks = new byte[0];

  /**
   * Per group of rows: whether many manifolds of its first block were made anew. Decides about
   * speed alone, so workers needn't agree on it.
   */
  private boolean[] restless = new boolean[0];

  private Scratch[] scratches = new Scratch[0];

  /**
   * The rows that others cover, each followed by the one that does, and by its points until then.
   */
  private final IntList covered = new IntList();

  /** Rows that miss, but cover others. */
  private final IntList missing = new IntList();

  /** The memory that one worker needs, and what it counts. */
  private static final class Scratch {
    private final Collider collider = new Collider();
    private final KeptManifolds.Scratch keeping = new KeptManifolds.Scratch();
    private final Manifold manifold = new Manifold();
    private final Transform poseA = new Transform();
    private final Transform poseB = new Transform();

    /** The rows of a block that respond. */
    private final int[] responding = new int[BLOCK];

    private int respondingCount;

    /** The rows of a block that don't, but may do so now. */
    private final int[] others = new int[BLOCK];

    private int otherCount;

    /** The rows of a block that are left to do, and the same in the order of kinds. */
    private final int[] rest = new int[BLOCK];

    private final int[] rows = new int[BLOCK];
    private final byte[] kinds = new byte[BLOCK];
    private final int[] next = new int[ShapeTable.KINDS * ShapeTable.KINDS];

    /** The updated rows whose points all have a gap that might be closed. */
    private final IntList gaps = new IntList();

    /** Number of them that are done. */
    private int looked;

    /** The rows of the step that have points in reserve. */
    private final IntList reserve = new IntList();

    private MissFinder misses;

    /** Rows of boxes that wait until there are enough; null without a kernel for them. */
    private BoxRows boxes;

    /** Number of times that the kernel may be used in this step; {@link #used} counts them. */
    private int granted;

    private int used;

    private int touching;
    private boolean overlaps;

    void begin(int kernelRuns) {
      touching = 0;
      overlaps = false;
      granted = boxes == null ? 0 : kernelRuns;
      used = 0;
      if (boxes != null) {
        boxes.begin();
      }
    }

    void end(float slop) {
      if (boxes != null) {
        touching += boxes.touching();
        overlaps |= boxes.deepest() > slop;
      }
    }

    /** Counts what a row that responds became. */
    void note(int row, Manifold m, float slop) {
      if (m.count > 0) {
        touching++;
        float least = m.minSeparation();
        overlaps |= -least > slop;
        if (least > TOUCHING) {
          gaps.add(row);
        }
      }
    }
  }

  /** Makes the narrow phase of a world without bodies. */
  public NarrowPhase(
      Settings settings,
      BodyStore bodies,
      ShapeTable parts,
      ContactTable contacts,
      ParallelFor parallel) {
    this.settings = settings;
    this.bodies = bodies;
    this.parts = parts;
    this.contacts = contacts;
    this.parallel = parallel;
  }

  /**
   * Begins an update of all rows, from which {@link #leave} excepts some.
   *
   * @param first whether it is the first one of the step
   * @param dt length of the step, s
   */
  public void begin(boolean first, float dt) {
    ensureCapacity();
    covered.count = 0;
    missing.count = 0;
    covered.ensureRoom(3 * contacts.capacity());
    for (Scratch scratch : scratches) {
      scratch.misses.begin(dt);
      scratch.reserve.count = 0;
      scratch.reserve.ensureRoom(contacts.capacity());
      scratch.gaps.ensureRoom(contacts.capacity());
    }
    for (int row = 0; !first && row < contacts.count(); row++) { // rows have moved since
      if (contacts.isHeld(row)) {
        scratches[0].reserve.add(row);
      }
    }
    int count = contacts.count();
    if (marks.length < contacts.capacity()) {
      marks = new byte[contacts.capacity()];
      restless = Arrays.copyOf(restless, marks.length / GROUP + 1);
    }
    Arrays.fill(marks, 0, count, (byte) 0);
    contacts.keepManifolds();
  }

  /** Excepts a row from the update. */
  public void leave(int row) {
    marks[row] |= LEFT;
  }

  /** Returns whether a row is, or was, excepted from the update. */
  public boolean isLeft(int row) {
    return (marks[row] & LEFT) != 0;
  }

  /** Updates the rows; returns how many of them have contact points. */
  public int run() {
    int rows = contacts.count();
    int blocks = rows / BoxLanes.LANES;
    int granted = lanes == null || !isRestless() ? 0 : lanes.grant(blocks, rows);
    for (Scratch scratch : scratches) {
      scratch.begin(granted < blocks ? granted / scratches.length : Integer.MAX_VALUE);
    }
    parallel.run(0, contacts.count(), GRAIN, updating);
    int touching = 0;
    for (Scratch scratch : scratches) {
      scratch.end(settings.slop());
      touching += scratch.touching;
    }
    return touching;
  }

  /**
   * Returns whether half of the groups had many manifolds made anew in the step before. Where fewer
   * have, the kernel gains nothing, and until it is compiled it allocates.
   */
  private boolean isRestless() {
    int groups = (contacts.count() + GROUP - 1) / GROUP;
    int count = 0;
    for (int group = 0; group < groups; group++) {
      count += restless[group] ? 1 : 0;
    }
    return 2 * count >= groups;
  }

  private void ensureCapacity() {
    int old = scratches.length;
    if (old < parallel.count()) {
      scratches = Arrays.copyOf(scratches, parallel.count());
      for (int i = old; i < scratches.length; i++) {
        scratches[i] = new Scratch();
        scratches[i].misses = new MissFinder(settings, bodies, parts, contacts);
        scratches[i].boxes =
            lanes == null ? null : new BoxRows(bodies, parts, contacts, lanes, scratches[i].gaps);
      }
    }
  }

  /** Returns whether any updated row overlaps by more than the slop. */
  public boolean overlaps() {
    for (Scratch scratch : scratches) {
      if (scratch.overlaps) {
        return true;
      }
    }
    return false;
  }

  private void update(int from, int to, int worker) {
    Scratch scratch = scratches[worker];
    int end;
    for (int start = from; start < to; start = end) {
      end = Math.min(start - start % BLOCK + BLOCK, to);
      int before = scratch.keeping.boxMakes();
      int group = start / GROUP;
      boolean sample = start % GROUP < BLOCK;
      boolean kernel = !sample && restless[group] && scratch.granted > 0;
      list(start, end, scratch);
      int rest = kernel ? handBoxes(scratch) : follow(scratch);
      int n = addOthers(rest, scratch);
      sort(n, scratch);
      for (int i = 0; i < n; i++) {
        update(scratch.rows[i], scratch);
      }
      setSlowAside(scratch);
      if (sample) {
        restless[group] = (scratch.keeping.boxMakes() - before) * KEPT > end - start;
      }
    }
    if (scratch.boxes != null) {
      finishBoxes(scratch);
      setSlowAside(scratch);
    }
  }

  /**
   * Holds in reserve the points of rows whose bodies are too slow to close their gaps, while their
   * numbers are in the nearest cache.
   */
  private void setSlowAside(Scratch scratch) {
    IntList gaps = scratch.gaps;
    int left = scratch.looked;
    for (int i = left; i < gaps.count; i++) {
      int row = gaps.values[i];
      if (contacts.wasPushed(row)) {
        continue;
      }
      if (!scratch.misses.areSlow(row)) {
        gaps.values[left++] = row;
      } else if (contacts.hold(row)) {
        scratch.reserve.add(row);
        scratch.touching--;
      }
    }
    scratch.looked = left;
    gaps.count = left;
  }

  /** Notes that another row covers a row, which the caller ends next. */
  void noteCover(int row, int cover) {
    covered.add(row);
    covered.add(cover);
    covered.add(contacts.points[row]);
    marks[cover] |= COVERS;
  }

  /** Returns whether what a row covers meets in this step, though it itself doesn't. */
  private boolean coversOneThatMeets(int cover, MissFinder misses, IntPredicate passes) {
    for (int i = 0; (marks[cover] & COVERS) != 0 && i < covered.count; i += 3) {
      int row = covered.values[i];
      if (covered.values[i + 1] == cover
          && ((misses.meets(row) && !passed(row, covered.values[i + 2], passes))
              || coversOneThatMeets(row, misses, passes))) {
        return true;
      }
    }
    return false;
  }

  /** Returns whether a callback lets the parts of a row pass that was ended with some points. */
  private boolean passed(int row, int points, IntPredicate passes) {
    contacts.points[row] = (byte) points;
    boolean does = passes.test(row);
    contacts.points[row] = 0;
    return does;
  }

  /**
   * Decides about the updated rows whose gaps might be closed: they touch only if they meet in this
   * step, or were pushed in the one before. What covers others stands for all of the ground there.
   *
   * @param passes tells whether a callback lets the parts of a row pass each other
   * @return how many don't touch
   */
  public int dropMisses(IntPredicate passes) {
    int apart = 0;
    for (Scratch scratch : scratches) {
      IntList gaps = scratch.gaps;
      for (int i = 0; i < gaps.count; i++) {
        int row = gaps.values[i];
        int verdict = contacts.points[row] == 0 ? MissFinder.MEET : scratch.misses.judge(row);
        if (verdict == MissFinder.MISS && (marks[row] & COVERS) != 0) {
          missing.add(row);
        } else if (verdict == MissFinder.MISS) {
          contacts.end(row);
          apart++;
        } else if (verdict != MissFinder.MEET && contacts.hold(row)) {
          scratch.reserve.add(row);
          apart++;
        }
      }
      gaps.count = 0;
      scratch.looked = 0;
    }
    return apart + dropMissingCovers(passes);
  }

  /** Ends the rows that miss, unless what they cover meets; asks in the order of rows. */
  private int dropMissingCovers(IntPredicate passes) {
    int apart = 0;
    MissFinder misses = scratches[0].misses;
    Arrays.sort(missing.values, 0, missing.count);
    for (int i = 0; i < missing.count; i++) {
      int row = missing.values[i];
      if (!coversOneThatMeets(row, misses, passes)) {
        contacts.end(row);
        apart++;
      } else if (contacts.hold(row)) {
        scratches[0].reserve.add(row);
        apart++;
      }
    }
    missing.count = 0;
    return apart;
  }

  /** Makes the rows with points in reserve touch that were pushed in the step. */
  public void settleReserve() {
    for (Scratch scratch : scratches) {
      for (int i = 0; i < scratch.reserve.count; i++) {
        contacts.touchIfPushed(scratch.reserve.values[i]);
      }
    }
  }

  /**
   * Lists the rows of a block that respond, and the others. It doesn't branch, because no processor
   * could predict which rows do.
   */
  private void list(int from, int to, Scratch scratch) {
    ContactTable t = contacts;
    int responding = 0;
    int others = 0;
    for (int row = from; row < to; row++) {
      int does = t.responds(row) ? 1 : 0;
      int stays = ~marks[row] & LEFT;
      scratch.responding[responding] = row;
      responding += stays & does;
      scratch.others[others] = row;
      others += stays & ~does;
    }
    scratch.respondingCount = responding;
    scratch.otherCount = others;
  }

  /**
   * Lets a kernel update the listed rows of boxes, whenever there are enough of them.
   *
   * @return how many of the rows that respond are left to do, listed in the scratch
   */
  private int handBoxes(Scratch scratch) {
    scratch.otherCount = handBoxes(scratch.others, scratch.otherCount, scratch.others, scratch);
    return handBoxes(scratch.responding, scratch.respondingCount, scratch.rest, scratch);
  }

  private int handBoxes(int[] rows, int count, int[] to, Scratch scratch) {
    int rest = 0;
    for (int i = 0; i < count; i++) {
      int row = rows[i];
      if (scratch.used >= scratch.granted || !isOfBoxes(row)) {
        to[rest++] = row;
      } else if (scratch.boxes.add(row)) {
        updateBoxes(scratch);
      }
    }
    return rest;
  }

  private boolean isOfBoxes(int row) {
    return contacts.acts(row)
        && parts.isBox(contacts.part[2 * row])
        && parts.isBox(contacts.part[2 * row + 1]);
  }

  private void updateBoxes(Scratch scratch) {
    scratch.used++;
    int n = scratch.boxes.update(settings.speculativeDistance());
    for (int i = 0; i < n; i++) {
      update(scratch.boxes.row(i), scratch);
    }
  }

  /** Updates the rows of boxes that are left of a worker's piece. */
  private void finishBoxes(Scratch scratch) {
    if (scratch.used < scratch.granted && scratch.boxes.count() >= FEW_BOXES) {
      updateBoxes(scratch);
    }
    for (int i = 0; i < scratch.boxes.count(); i++) {
      update(scratch.boxes.row(i), scratch);
    }
    scratch.boxes.clear();
  }

  /**
   * Updates the rows whose manifold in the table is that of a face, and the one kept is, too, and
   * still holds: most rows of a heap at rest. Little enough is done with a row that the processor
   * reads the next ones from memory meanwhile.
   *
   * @return how many of the rows that respond are left to do, listed in the scratch
   */
  private int follow(Scratch scratch) {
    ContactTable t = contacts;
    KeptManifolds kept = t.kept;
    BodyStore s = bodies;
    float speculative = settings.speculativeDistance();
    float deepest = 0;
    int rest = 0;
    for (int i = 0; i < scratch.respondingCount; i++) {
      int row = scratch.responding[i];
      int a = t.bodyA(row);
      int b = t.bodyB(row);
      float aCos = s.cos[a];
      float aSin = s.sin[a];
      float worldX = s.x[b] - s.x[a];
      float worldY = s.y[b] - s.y[a];
      float x = aCos * worldX + aSin * worldY;
      float y = aCos * worldY - aSin * worldX;
      float cos = aCos * s.cos[b] + aSin * s.sin[b];
      float sin = aCos * s.sin[b] - aSin * s.cos[b];
      if (!kept.holds(row, x, y, cos, sin)
          || !kept.ofFace(row, t.points[row], t.id[2 * row], t.id[2 * row + 1])) {
        scratch.rest[rest++] = row;
        continue;
      }
      float gap =
          kept.follow(row, aCos, aSin, x, y, cos, sin, t.contact, row * ContactTable.CONTACT);
      // The boxes of parts so close overlap, so nobody needs to look.
      if (gap > speculative - KeptManifolds.slack(s.reach[b])) {
        scratch.rest[rest++] = row;
        continue;
      }
      t.touchOn(row);
      deepest = Math.min(deepest, gap);
      if (gap > TOUCHING) {
        scratch.gaps.add(row);
      }
    }
    scratch.touching += scratch.respondingCount - rest;
    scratch.overlaps |= -deepest > settings.slop();
    return rest;
  }

  /**
   * Adds the listed rows that don't respond to those left to do, except those that didn't touch
   * before either, and whose boxes are apart or which are known not to touch.
   *
   * @param rest how many rows are left to do, listed in the scratch
   * @return how many are left to do then
   */
  private int addOthers(int rest, Scratch scratch) {
    ContactTable t = contacts;
    int near = 0;
    for (int i = 0; i < scratch.otherCount; i++) { // without a branch, as above
      int row = scratch.others[i];
      int overlaps = parts.tight.overlaps(t.part[2 * row], t.part[2 * row + 1]) ? 1 : 0;
      int changes = t.isIdle(row) ? 0 : 1;
      scratch.others[near] = row;
      near += overlaps | changes;
    }
    int n = rest;
    for (int i = 0; i < near; i++) {
      int row = scratch.others[i];
      scratch.rest[n] = row;
      n += t.isIdle(row) && isApart(row, scratch) ? 0 : 1;
    }
    return n;
  }

  /** Returns whether the parts of a row are known not to touch. */
  private boolean isApart(int row, Scratch scratch) {
    int b = contacts.bodyB(row);
    place(contacts.bodyA(row), scratch.poseA);
    place(b, scratch.poseB);
    return contacts.kept.apart(
        row, scratch.poseA, scratch.poseB, bodies.reach[b], keepsManifold(row));
  }

  /** Returns whether a row may have a kept manifold, that of a rounded pose. */
  private boolean keepsManifold(int row) {
    return !contacts.sensor(row)
        && parts.isPolygon(contacts.part[2 * row])
        && parts.isPolygon(contacts.part[2 * row + 1]);
  }

  /** Puts the listed rows in order, the same kinds of pairs together. */
  private void sort(int n, Scratch scratch) {
    int[] next = scratch.next;
    byte[] kinds = scratch.kinds;
    Arrays.fill(next, 0);
    for (int i = 0; i < n; i++) {
      int row = scratch.rest[i];
      int kind =
          parts.kind[contacts.part[2 * row]] * ShapeTable.KINDS
              + parts.kind[contacts.part[2 * row + 1]];
      kinds[i] = (byte) kind;
      next[kind]++;
    }
    int sum = 0;
    for (int kind = 0; kind < next.length; kind++) {
      int size = next[kind];
      next[kind] = sum;
      sum += size;
    }
    for (int i = 0; i < n; i++) {
      scratch.rows[next[kinds[i]]++] = scratch.rest[i];
    }
  }

  private void update(int row, Scratch scratch) {
    Manifold manifold = scratch.manifold;
    boolean sensor = contacts.sensor(row);
    if ((contacts.flags[row] & ContactTable.IGNORED) != 0
        || !parts.tight.overlaps(contacts.part[2 * row], contacts.part[2 * row + 1])) {
      manifold.count = 0;
    } else {
      collide(row, sensor, scratch);
    }
    contacts.update(row, manifold);
    if (!sensor) {
      scratch.note(row, manifold, settings.slop());
    }
  }

  private void collide(int row, boolean sensor, Scratch scratch) {
    int partA = contacts.part[2 * row];
    int partB = contacts.part[2 * row + 1];
    int b = contacts.bodyB(row);
    place(contacts.bodyA(row), scratch.poseA);
    place(b, scratch.poseB);
    if (keepsManifold(row)) {
      contacts.kept.collide(
          row,
          parts.convex[partA],
          scratch.poseA,
          parts.convex[partB],
          scratch.poseB,
          bodies.reach[b],
          settings.speculativeDistance(),
          contacts.hint,
          scratch.keeping,
          scratch.manifold);
      return;
    }
    float speculative = sensor ? 0 : settings.speculativeDistance();
    boolean quick = parts.isDisc(partA) && parts.isDisc(partB);
    Collider collider = scratch.collider;
    collider.collide(
        parts.convex[partA],
        scratch.poseA,
        parts.convex[partB],
        scratch.poseB,
        speculative,
        contacts.hint[row],
        scratch.manifold);
    contacts.hint[row] = collider.hint();
    if (!quick && scratch.manifold.count == 0) {
      contacts.kept.keepApart(row, scratch.poseA, scratch.poseB, collider.gap(), speculative);
    } else if (!quick) {
      contacts.kept.forget(row);
    }
  }

  private void place(int body, Transform pose) {
    pose.set(bodies.x[body], bodies.y[body], bodies.cos[body], bodies.sin[body]);
  }
}
