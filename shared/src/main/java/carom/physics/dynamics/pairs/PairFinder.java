package carom.physics.dynamics.pairs;

import carom.physics.broadphase.KdTree;
import carom.physics.dynamics.body.ActiveBodies;
import carom.physics.dynamics.body.BodyStore;
import carom.physics.dynamics.body.ShapeTable;
import carom.physics.dynamics.contact.ContactTable;
import carom.physics.dynamics.contact.RowOrder;
import carom.physics.dynamics.store.ParallelFor;
import carom.physics.math.Aabb;
import carom.physics.settings.Settings;

/**
 * The broadphase of a world: makes sure that the contact table has a row for every pair of parts
 * whose fat boxes overlap and of which one body is awake.
 *
 * <pre>
 *   poses --BoxRefresh--&gt; fat boxes --PartTrees--&gt; moving and resting tree
 *                              |                              |
 *                         MovedParts ----CandidateSearch------+
 *                                              | keys per worker
 *                                       CandidateSorter
 *                                              | keys, ascending
 *                                     contact.RowOrder.merge
 *                                              | new rows between the others, others gone
 *                                        contact table
 * </pre>
 *
 * <p>There are two trees, one for the parts of active bodies and one for those of static and
 * sleeping bodies. Only pairs with a part that got a new box since the last search are searched, so
 * quiet bodies cost nothing. When a pair was found shows in no result: rows are in the order of
 * their keys.
 *
 * <p>One thread calls; workers share what is long.
 */
public final class PairFinder {
  private final BodyStore bodies;
  private final ActiveBodies active;
  private final ShapeTable parts;
  private final ContactTable contacts;
  private final RowOrder rows;
  private final MovedParts moved;
  private final FatBoxes boxes;
  private final PartTrees trees;
  private final BoxRefresh refresh;
  private final PairFilter filter;
  private final CandidateSearch search;
  private final CandidateSorter sorter;
  private final ParallelFor parallel;

  /** The length of the last step, s; before the first one that of most games. */
  private float lastStep = 1 / 60f;

  /** True if poses changed since fat boxes were refreshed. */
  private boolean boxesStale;

  /** True if the next search looks at all pairs, for instance because a static body is new. */
  private boolean searchAll;

  /** Makes the broadphase of a world without bodies. */
  public PairFinder(
      Settings settings,
      BodyStore bodies,
      ActiveBodies active,
      ShapeTable parts,
      ContactTable contacts,
      PairRule rule,
      ParallelFor parallel) {
    this.bodies = bodies;
    this.active = active;
    this.parts = parts;
    this.parallel = parallel;
    this.contacts = contacts;
    rows = contacts.order();
    moved = new MovedParts(parts);
    boxes = new FatBoxes(settings, bodies, parts, contacts);
    trees = new PartTrees(bodies, parts, boxes, moved, parallel);
    refresh = new BoxRefresh(bodies, boxes, trees.moving, moved, parallel);
    filter = new PairFilter(bodies, parts, rule);
    search = new CandidateSearch(parts, trees, moved, filter, parallel);
    sorter = new CandidateSorter(contacts, parallel);
  }

  // ---------------------------------------------------------------- bodies that come and go

  /** Adds a body at its pose: to the active ones, unless it is static or asleep. */
  public void enter(int body) {
    trees.enter(body);
    searchAll |= bodies.type[body] == BodyStore.STATIC;
    boxesStale = true;
  }

  /** Removes a body. */
  public void leave(int body) {
    trees.leave(body);
  }

  /** Moves a static body to its new pose. */
  public void moveStatic(int body) {
    trees.moveStatic(body);
    searchAll = true;
  }

  /** Removes all bodies. */
  public void clear() {
    moved.drop();
    trees.clear();
  }

  /** Inserts all queued parts into the trees, before bodies fall asleep or wake. */
  public void insertPending() {
    trees.insertPending();
  }

  /** Takes bodies that have just fallen asleep out of the active ones. */
  public void rest(int[] which, int count) {
    trees.toResting(which, count);
  }

  /** Takes bodies that have just woken to the active ones. */
  public void wake(int[] which, int count) {
    trees.toMoving(which, count);
    boxesStale = true;
  }

  // ---------------------------------------------------------------- boxes

  /** Sets the length of the steps, s, for which fat boxes make room. */
  public void setTimeStep(float dt) {
    lastStep = dt;
  }

  /** Marks all boxes as stale, because poses changed; the next {@link #refresh} measures them. */
  public void posesChanged() {
    boxesStale = true;
  }

  /**
   * Gives every part of an active body whose fat box no longer contains it a new one. Does nothing
   * if no pose changed.
   */
  public void refresh() {
    if (boxesStale) {
      boxesStale = false;
      if (refresh.run(active, lastStep)) {
        trees.markStale();
      }
    }
  }

  /** Widens the fat box of a moving part until it contains another box. */
  public void cover(int part, Aabb other) {
    if (boxes.cover(part, other)) {
      trees.markStale();
      moved.mark(part);
    }
  }

  /** Computes the box of a part at the pose of its body now, without any margin. */
  public void tightBox(int part, Aabb out) {
    boxes.tightBox(part, out);
  }

  // ---------------------------------------------------------------- pairs

  /** Sets a rule of the user, which is asked last; null for none. */
  public void customRule(PartRule custom) {
    filter.custom(custom);
  }

  /** Returns whether filters, joints, types and the user's rule let two parts touch. */
  public boolean mayTouch(int p, int q) {
    return filter.mayTouch(p, q);
  }

  /** Returns whether the parts of a row still may touch, after bodies or joints changed. */
  public boolean mayStay(ContactTable table, int row) {
    return filter.mayStay(table, row);
  }

  /**
   * Makes the next search look at all pairs, because some may be missing of which no part moved.
   */
  public void searchAll() {
    searchAll = true;
  }

  /** Makes the next search look at the pairs of all parts of a body. */
  public void searchBody(int body) {
    int first = bodies.firstPart[body];
    for (int part = first; part < first + bodies.partCount[body]; part++) {
      moved.mark(part);
    }
  }

  /** Brings the trees up to the fat boxes. */
  public void refit() {
    trees.refit();
  }

  /** Brings the contact table's rows up to the fat boxes. */
  public void find() {
    if (moved.count == 0 && !searchAll) {
      return;
    }
    trees.refit();
    CandidateList[] found = search.run(searchAll, sorter.capacity());
    long[] keys = sorter.sort(found);
    int count = filter.ask(keys, sorter.count(), contacts);
    rows.merge(keys, count, bodies, parts, searchAll, parallel);
    moved.clear();
    searchAll = false;
  }

  // ---------------------------------------------------------------- questions

  /**
   * Returns how many parts, awake or not, any step may have to deal with; more than a few thousand
   * don't count. What grows with them makes room for them in time.
   */
  public int fewMovableParts() {
    return trees.fewMovable();
  }

  /** Returns the number of parts of active bodies, as of the last {@link #refit}. */
  public int movingParts() {
    return trees.moving.size();
  }

  /**
   * Lists the active bodies, near ones near each other, each as often as it has parts.
   *
   * @param out receives {@link #movingParts} slots
   * @return how many
   */
  public int listBodies(int[] out) {
    int n = trees.moving.slice(0, 1, out);
    for (int i = 0; i < n; i++) {
      out[i] = parts.body[out[i]];
    }
    return n;
  }

  /** Returns the tree of the active bodies' parts, as of the last {@link #refit}. */
  public KdTree moving() {
    return trees.moving;
  }

  /** Returns the tree of the static and sleeping bodies' parts, as of the last {@link #refit}. */
  public KdTree resting() {
    return trees.resting;
  }
}
