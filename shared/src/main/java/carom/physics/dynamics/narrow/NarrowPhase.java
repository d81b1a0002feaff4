package carom.physics.dynamics.narrow;

import carom.physics.collision.Collider;
import carom.physics.collision.Manifold;
import carom.physics.dynamics.body.BodyStore;
import carom.physics.dynamics.body.Settings;
import carom.physics.dynamics.body.ShapeTable;
import carom.physics.dynamics.contact.ContactTable;
import carom.physics.dynamics.contact.KeptManifolds;
import carom.physics.dynamics.parallel.ParallelFor;
import carom.physics.math.Transform;
import java.util.Arrays;

/**
 * Updates the rows of the contact table: one manifold per pair of parts.
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

  /** Rows of which the first block tells whether manifolds of all of them are worth keeping, */
  private static final int GROUP = 8 * BLOCK;

  /** or were faster made anew by the kernel: if more than one in so many was, of two boxes. */
  private static final int KEPT = 8;

  /** With fewer rows of boxes the kernel is idle in too many lanes. */
  private static final int FEW_BOXES = 4;

  /** Rows that make a piece of work for a worker. */
  private static final int GRAIN = 64;

  private final Settings settings;
  private final BodyStore bodies;
  private final ShapeTable parts;
  private final ContactTable contacts;
  private final ParallelFor parallel;
  private final BoxLanes lanes = BoxLanes.FOUND;
  private final ParallelFor.Range updating = this::update;

  /** Per row: whether it stays as it is. */
  private boolean[] left = new boolean[0];

  /**
   * Per group of rows: whether many manifolds of its first block were made anew. Decides about
   * speed alone, so workers needn't agree on it.
   */
  private boolean[] restless = new boolean[0];

  private Desk[] desks = new Desk[0];

  /** What one worker needs. */
  private static final class Desk {
    private final Collider collider = new Collider();
    private final KeptManifolds.Desk keeping = new KeptManifolds.Desk();
    private final Manifold manifold = new Manifold();
    private final Transform poseA = new Transform();
    private final Transform poseB = new Transform();

    /** The rows of a block that are left to do, and the same in the order of kinds. */
    private final int[] rest = new int[BLOCK];

    private final int[] rows = new int[BLOCK];
    private final byte[] kinds = new byte[BLOCK];
    private final int[] next = new int[ShapeTable.KINDS * ShapeTable.KINDS];

    /** Rows of boxes that wait until there are enough; null without a kernel for them. */
    private BoxRows boxes;

    /** How many times the kernel may be used in this step, and was. */
    private int granted;

    private int used;

    private int touching;
    private boolean pressed;

    void begin(int kernelRuns) {
      touching = 0;
      pressed = false;
      granted = boxes == null ? 0 : kernelRuns;
      used = 0;
      if (boxes != null) {
        boxes.begin();
      }
    }

    void end(float slop) {
      if (boxes != null) {
        touching += boxes.touching();
        pressed |= boxes.deepest() > slop;
      }
    }

    /** Counts what a row that responds became. */
    void note(Manifold m, float slop) {
      if (m.count > 0) {
        touching++;
        pressed |= -m.minSeparation() > slop;
      }
    }
  }

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

  /** Begins: all rows are to be updated that aren't {@link #leave left} as they are. */
  public void begin() {
    int count = contacts.count();
    if (left.length < count) {
      left = new boolean[contacts.capacity()];
      restless = Arrays.copyOf(restless, left.length / GROUP + 1);
    }
    Arrays.fill(left, 0, count, false);
    contacts.keepManifolds();
  }

  /** Has a row stay as it is. */
  public void leave(int row) {
    left[row] = true;
  }

  /** Whether a row stays, or stayed, as it is. */
  public boolean isLeft(int row) {
    return left[row];
  }

  /** Updates the rows; answers how many of them have contact points. */
  public int run() {
    furnish();
    int rows = contacts.count();
    int blocks = rows / BoxLanes.LANES;
    int granted = lanes == null || !isRestless() ? 0 : lanes.grant(blocks, rows);
    for (Desk desk : desks) {
      desk.begin(granted < blocks ? granted / desks.length : Integer.MAX_VALUE);
    }
    parallel.run(0, contacts.count(), GRAIN, updating);
    int touching = 0;
    for (Desk desk : desks) {
      desk.end(settings.slop());
      touching += desk.touching;
    }
    return touching;
  }

  /**
   * Whether half of the groups had many manifolds made anew in the step before. Where fewer have,
   * the kernel gains nothing, and until it is compiled it allocates.
   */
  private boolean isRestless() {
    int groups = (contacts.count() + GROUP - 1) / GROUP;
    int count = 0;
    for (int group = 0; group < groups; group++) {
      count += restless[group] ? 1 : 0;
    }
    return 2 * count >= groups;
  }

  private void furnish() {
    int old = desks.length;
    if (old < parallel.count()) {
      desks = Arrays.copyOf(desks, parallel.count());
      for (int i = old; i < desks.length; i++) {
        desks[i] = new Desk();
        desks[i].boxes = lanes == null ? null : new BoxRows(bodies, parts, contacts, lanes);
      }
    }
  }

  /** Whether any row updated overlaps by more than the slop. */
  public boolean pressed() {
    for (Desk desk : desks) {
      if (desk.pressed) {
        return true;
      }
    }
    return false;
  }

  private void update(int from, int to, int worker) {
    Desk desk = desks[worker];
    int end;
    for (int start = from; start < to; start = end) {
      end = Math.min(start - start % BLOCK + BLOCK, to);
      int before = desk.keeping.boxMakes();
      int group = start / GROUP;
      boolean sample = start % GROUP < BLOCK;
      boolean kernel = !sample && restless[group] && desk.granted > 0;
      int n = kernel ? handBoxes(start, end, desk) : follow(start, end, desk);
      sort(n, desk);
      for (int i = 0; i < n; i++) {
        update(desk.rows[i], desk);
      }
      if (sample) {
        restless[group] = (desk.keeping.boxMakes() - before) * KEPT > end - start;
      }
    }
    if (desk.boxes != null) {
      finishBoxes(desk);
    }
  }

  /**
   * Has a kernel update the rows of boxes of a block, whenever there are enough of them.
   *
   * @return how many rows are left to do, listed at the desk
   */
  private int handBoxes(int from, int to, Desk desk) {
    int rest = 0;
    for (int row = from; row < to; row++) {
      if (left[row]) {
        continue;
      }
      if (desk.used >= desk.granted || !isOfBoxes(row)) {
        desk.rest[rest++] = row;
      } else if (desk.boxes.add(row)) {
        updateBoxes(desk);
      }
    }
    return rest;
  }

  private boolean isOfBoxes(int row) {
    return contacts.acts(row)
        && parts.isBox(contacts.part[2 * row])
        && parts.isBox(contacts.part[2 * row + 1]);
  }

  private void updateBoxes(Desk desk) {
    desk.used++;
    int n = desk.boxes.update(settings.speculativeDistance());
    for (int i = 0; i < n; i++) {
      update(desk.boxes.row(i), desk);
    }
  }

  /** Updates the rows of boxes that are left of a worker's piece. */
  private void finishBoxes(Desk desk) {
    if (desk.used < desk.granted && desk.boxes.count() >= FEW_BOXES) {
      updateBoxes(desk);
    }
    for (int i = 0; i < desk.boxes.count(); i++) {
      update(desk.boxes.row(i), desk);
    }
    desk.boxes.clear();
  }

  /**
   * Updates the rows whose manifold in the table is that of a face, and the one kept is, too, and
   * still holds: most rows of a heap at rest. Little enough is done with a row that the processor
   * reads the next ones from memory meanwhile.
   *
   * @return how many rows are left to do, listed at the desk
   */
  private int follow(int from, int to, Desk desk) {
    ContactTable t = contacts;
    KeptManifolds kept = t.kept;
    BodyStore s = bodies;
    float speculative = settings.speculativeDistance();
    float deepest = 0;
    int rest = 0;
    int followed = 0;
    for (int row = from; row < to; row++) {
      if (left[row]) {
        continue;
      }
      if (!t.responds(row)) {
        desk.rest[rest++] = row;
        continue;
      }
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
        desk.rest[rest++] = row;
        continue;
      }
      float gap =
          kept.follow(row, aCos, aSin, x, y, cos, sin, t.contact, row * ContactTable.CONTACT);
      // The boxes of parts so close overlap, so nobody needs to look.
      if (gap > speculative - KeptManifolds.slack(s.reach[b])) {
        desk.rest[rest++] = row;
        continue;
      }
      t.touchOn(row);
      followed++;
      deepest = Math.min(deepest, gap);
    }
    desk.touching += followed;
    desk.pressed |= -deepest > settings.slop();
    return rest;
  }

  /** Puts the listed rows in order, the same kinds of pairs together. */
  private void sort(int n, Desk desk) {
    int[] next = desk.next;
    byte[] kinds = desk.kinds;
    Arrays.fill(next, 0);
    for (int i = 0; i < n; i++) {
      int row = desk.rest[i];
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
      desk.rows[next[kinds[i]]++] = desk.rest[i];
    }
  }

  private void update(int row, Desk desk) {
    Manifold manifold = desk.manifold;
    boolean sensor = contacts.sensor(row);
    if ((contacts.flags[row] & ContactTable.IGNORED) != 0
        || !parts.tight.overlaps(contacts.part[2 * row], contacts.part[2 * row + 1])) {
      manifold.count = 0;
    } else {
      collide(row, sensor, desk);
    }
    contacts.update(row, manifold);
    if (!sensor) {
      desk.note(manifold, settings.slop());
    }
  }

  private void collide(int row, boolean sensor, Desk desk) {
    int partA = contacts.part[2 * row];
    int partB = contacts.part[2 * row + 1];
    int b = contacts.bodyB(row);
    place(contacts.bodyA(row), desk.poseA);
    place(b, desk.poseB);
    if (!sensor && parts.isPolygon(partA) && parts.isPolygon(partB)) {
      contacts.kept.collide(
          row,
          parts.convex[partA],
          desk.poseA,
          parts.convex[partB],
          desk.poseB,
          bodies.reach[b],
          settings.speculativeDistance(),
          contacts.hint,
          desk.keeping,
          desk.manifold);
      return;
    }
    float speculative = sensor ? 0 : settings.speculativeDistance();
    boolean quick = parts.isDisc(partA) && parts.isDisc(partB);
    if (!quick && contacts.kept.apart(row, desk.poseA, desk.poseB, bodies.reach[b])) {
      desk.manifold.count = 0;
      return;
    }
    Collider collider = desk.collider;
    collider.collide(
        parts.convex[partA],
        desk.poseA,
        parts.convex[partB],
        desk.poseB,
        speculative,
        contacts.hint[row],
        desk.manifold);
    contacts.hint[row] = collider.hint();
    if (!quick && desk.manifold.count == 0) {
      contacts.kept.keepApart(row, desk.poseA, desk.poseB, collider.gap(), speculative);
    } else if (!quick) {
      contacts.kept.forget(row);
    }
  }

  private void place(int body, Transform pose) {
    pose.set(bodies.x[body], bodies.y[body], bodies.cos[body], bodies.sin[body]);
  }
}
