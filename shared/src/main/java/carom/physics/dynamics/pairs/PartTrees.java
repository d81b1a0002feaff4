package carom.physics.dynamics.pairs;

import carom.physics.broadphase.KdRefit;
import carom.physics.broadphase.KdTree;
import carom.physics.dynamics.body.BodyStore;
import carom.physics.dynamics.body.ShapeTable;
import carom.physics.dynamics.store.IntList;
import carom.physics.dynamics.store.ParallelFor;

/**
 * The two KD-trees of the parts' fat boxes, and which part is in which of them.
 *
 * <pre>
 *                 insertPending                 bodies fall asleep
 *   pending  ----------------------&gt;  moving  ----------------------&gt;  resting
 *   parts             |               (parts of   &lt;------------------  (parts of static and
 *   (queued)          |               active       bodies wake          sleeping bodies)
 *                     |               bodies)                              ^
 *                     +----------------------------------------------------+
 * </pre>
 *
 * <p>The moving tree is refitted when boxes in it changed. A part of the resting tree never changes
 * its box: it is taken out and put back.
 *
 * <p>New parts are queued and inserted before the next query, because inserting many at once is
 * cheaper than one by one. The queue must be empty when a body falls asleep or wakes, as the state
 * of the body decides which tree its parts are inserted into; the methods assert it.
 */
final class PartTrees {
  /** Parts up to which there is room for all of them in both trees, so that few steps allocate. */
  private static final int FEW = 2_048;

  /** The tree of the active bodies' parts. */
  final KdTree moving;

  /** The tree of the static and sleeping bodies' parts. */
  final KdTree resting;

  private final BodyStore bodies;
  private final ShapeTable parts;
  private final FatBoxes boxes;
  private final MovedParts moved;
  private final ParallelFor parallel;
  private final KdRefit refitting;
  private final ParallelFor.Range reading = this::readPieces;
  private final ParallelFor.Range routing = this::routePieces;

  /** Parts that are in no tree yet. */
  private final IntList pending = new IntList();

  /** Scratch: parts that enter or leave a tree. */
  private final IntList batch = new IntList();

  /** Number of parts of bodies that aren't static. */
  private int movable;

  /** True if boxes in the moving tree changed since it was refitted. */
  private boolean stale;

  PartTrees(
      BodyStore bodies, ShapeTable parts, FatBoxes boxes, MovedParts moved, ParallelFor parallel) {
    this.bodies = bodies;
    this.parts = parts;
    this.boxes = boxes;
    this.moved = moved;
    this.parallel = parallel;
    moving = new KdTree(parts.fat);
    resting = new KdTree(parts.fat);
    refitting = moving.refitting();
  }

  /** Queues the parts of a body that begins to take part. */
  void enter(int body) {
    boolean rests = rests(body);
    int first = bodies.firstPart[body];
    movable += bodies.type[body] == BodyStore.STATIC ? 0 : bodies.partCount[body];
    for (int part = first; part < first + bodies.partCount[body]; part++) {
      if (rests) {
        boxes.setResting(body, part);
      } else {
        boxes.setEmpty(body, part);
      }
      queue(part);
    }
  }

  /** Removes the parts of a body. */
  void leave(int body) {
    int first = bodies.firstPart[body];
    movable -= bodies.type[body] == BodyStore.STATIC ? 0 : bodies.partCount[body];
    for (int part = first; part < first + bodies.partCount[body]; part++) {
      if (!moving.remove(part)) {
        resting.remove(part);
      }
    }
  }

  /** Moves the parts of a static body to its new pose. */
  void moveStatic(int body) {
    int first = bodies.firstPart[body];
    for (int part = first; part < first + bodies.partCount[body]; part++) {
      resting.remove(part);
      boxes.setResting(body, part);
      queue(part);
    }
  }

  /** Empties both trees and the queue. */
  void clear() {
    for (int i = 0; i < pending.count; i++) {
      parts.pending[pending.values[i]] = false;
    }
    pending.count = 0;
    movable = 0;
    moving.clear();
    resting.clear();
  }

  /** Takes bodies that have just fallen asleep to the resting tree. */
  void toResting(int[] which, int count) {
    assert pending.count == 0 : "pending parts must be inserted before bodies fall asleep";
    bodies.listParts(which, count, batch);
    moving.removeAll(batch.values, batch.count);
    for (int i = 0; i < count; i++) {
      boxes.settle(which[i], moved);
    }
    resting.addAll(batch.values, batch.count);
  }

  /** Takes bodies that have just woken to the moving tree, and marks their parts as moved. */
  void toMoving(int[] which, int count) {
    assert pending.count == 0 : "pending parts must be inserted before bodies wake";
    bodies.listParts(which, count, batch);
    resting.removeAll(batch.values, batch.count);
    moving.addAll(batch.values, batch.count);
    for (int i = 0; i < batch.count; i++) {
      moved.mark(batch.values[i]);
    }
  }

  /** Returns how many parts may come to either tree for which room is made before they do. */
  int fewMovable() {
    return Math.min(movable, FEW);
  }

  private boolean rests(int body) {
    return bodies.type[body] == BodyStore.STATIC || bodies.asleep(body);
  }

  private void queue(int part) {
    if (!parts.pending[part]) {
      parts.pending[part] = true;
      pending.add(part);
    }
  }

  /** Inserts the queued parts into the tree that the state of their body asks for. */
  void insertPending() {
    if (pending.count > 0) {
      int few = fewMovable();
      batch.ensureRoom(few);
      moving.reserve(few, parts.body.length);
      resting.reserve(
          moving.size() + resting.size() + pending.count - movable + few, parts.body.length);
      insertPending(moving, false);
      insertPending(resting, true);
      pending.count = 0;
    }
  }

  private void insertPending(KdTree tree, boolean restingOnes) {
    int others = 0;
    batch.count = 0;
    for (int i = 0; i < pending.count; i++) {
      int part = pending.values[i];
      int body = parts.body[part];
      if (body < 0 || bodies.disabled(body)) {
        parts.pending[part] = false;
      } else if (rests(body) != restingOnes) {
        pending.values[others++] = part;
      } else {
        parts.pending[part] = false;
        batch.add(part);
      }
    }
    pending.count = others;
    tree.addAll(batch.values, batch.count);
  }

  /** Notes that boxes in the moving tree changed. */
  void markStale() {
    stale = true;
  }

  /** Inserts the queued parts and brings the moving tree up to the fat boxes. */
  void refit() {
    insertPending();
    if (!stale) {
      return;
    }
    stale = false;
    if (!moving.isMost(moved.count)) {
      moving.refit(moved.list, moved.count);
      return;
    }
    parallel.run(0, refitting.begin(), 1, reading);
    parallel.run(0, refitting.gather(), 1, routing);
    refitting.end();
  }

  private void readPieces(int from, int to, int worker) {
    for (int piece = from; piece < to; piece++) {
      refitting.read(piece);
    }
  }

  private void routePieces(int from, int to, int worker) {
    for (int piece = from; piece < to; piece++) {
      refitting.route(piece);
    }
  }
}
