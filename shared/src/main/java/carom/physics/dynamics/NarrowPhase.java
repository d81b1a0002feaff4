package carom.physics.dynamics;

import carom.physics.collision.Collider;
import carom.physics.collision.Manifold;
import carom.physics.math.Transform;
import java.util.Arrays;

/**
 * Updates the rows of the contact table: one manifold per pair of parts.
 *
 * <p>Each row depends on the poses and on what it said before, and writes to itself alone. So the
 * order doesn't matter, and workers may share the rows. Within a block of {@value #BLOCK} rows,
 * which stay in the nearest cache, pairs of the same kinds of shapes follow each other: the
 * processor guesses most branches right, then, which in a pile of mixed shapes saves a quarter of
 * the time.
 */
final class NarrowPhase {
  private static final int BLOCK = 256;

  /** Rows that make a piece of work for a worker. */
  private static final int GRAIN = 64;

  private final Settings settings;
  private final BodyStore bodies;
  private final ShapeTable parts;
  private final ContactTable contacts;
  private final Crew crew;
  private final Crew.Range updating = this::update;

  /** Per row: whether it stays as it is. */
  private boolean[] left = new boolean[0];

  private Desk[] desks = {new Desk()};

  /** What one worker needs. */
  private static final class Desk {
    private final Collider collider = new Collider();
    private final KeptManifolds.Desk keeping = new KeptManifolds.Desk();
    private final Manifold manifold = new Manifold();
    private final Transform poseA = new Transform();
    private final Transform poseB = new Transform();
    private final int[] rows = new int[BLOCK];
    private final byte[] kinds = new byte[BLOCK];
    private final int[] next = new int[ShapeTable.KINDS * ShapeTable.KINDS];
    private int touching;
    private boolean pressed;
  }

  NarrowPhase(
      Settings settings, BodyStore bodies, ShapeTable parts, ContactTable contacts, Crew crew) {
    this.settings = settings;
    this.bodies = bodies;
    this.parts = parts;
    this.contacts = contacts;
    this.crew = crew;
  }

  /** Begins: all rows are to be updated that aren't {@link #leave left} as they are. */
  void begin() {
    int count = contacts.count();
    if (left.length < count) {
      left = new boolean[Math.max(count, left.length * 2)];
    }
    Arrays.fill(left, 0, count, false);
    contacts.keepManifolds();
  }

  /** Has a row stay as it is. */
  void leave(int row) {
    left[row] = true;
  }

  /** Whether a row stays, or stayed, as it is. */
  boolean isLeft(int row) {
    return left[row];
  }

  /** Updates the rows; answers how many of them have contact points. */
  int run() {
    if (desks.length < crew.count()) {
      int old = desks.length;
      desks = Arrays.copyOf(desks, crew.count());
      for (int i = old; i < desks.length; i++) {
        desks[i] = new Desk();
      }
    }
    for (Desk desk : desks) {
      desk.touching = 0;
      desk.pressed = false;
    }
    crew.run(0, contacts.count(), GRAIN, updating);
    int touching = 0;
    for (Desk desk : desks) {
      touching += desk.touching;
    }
    return touching;
  }

  /** Whether any row updated overlaps by more than the slop. */
  boolean pressed() {
    for (Desk desk : desks) {
      if (desk.pressed) {
        return true;
      }
    }
    return false;
  }

  private void update(int from, int to, int worker) {
    Desk desk = desks[worker];
    for (int start = from; start < to; start += BLOCK) {
      int n = sort(start, Math.min(start + BLOCK, to), desk);
      for (int i = 0; i < n; i++) {
        update(desk.rows[i], desk);
      }
    }
  }

  /** Lists the rows of a block, the same kinds of pairs together; answers how many there are. */
  private int sort(int from, int to, Desk desk) {
    int[] next = desk.next;
    byte[] kinds = desk.kinds;
    Arrays.fill(next, 0);
    for (int row = from; row < to; row++) {
      int kind =
          parts.kind[contacts.part[2 * row]] * ShapeTable.KINDS
              + parts.kind[contacts.part[2 * row + 1]];
      kinds[row - from] = (byte) kind;
      next[kind]++;
    }
    int sum = 0;
    for (int kind = 0; kind < next.length; kind++) {
      int size = next[kind];
      next[kind] = sum;
      sum += size;
    }
    for (int row = from; row < to; row++) {
      desk.rows[next[kinds[row - from]]++] = row;
    }
    return to - from;
  }

  private void update(int row, Desk desk) {
    if (left[row]) {
      return;
    }
    Manifold manifold = desk.manifold;
    boolean sensor = contacts.sensor(row);
    if ((contacts.flags[row] & ContactTable.IGNORED) != 0
        || !parts.tight.overlaps(contacts.part[2 * row], contacts.part[2 * row + 1])) {
      manifold.count = 0;
    } else {
      collide(row, sensor, desk);
    }
    contacts.update(row, manifold);
    if (manifold.count > 0 && !sensor) {
      desk.touching++;
      desk.pressed |= -manifold.minSeparation() > settings.slop();
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
