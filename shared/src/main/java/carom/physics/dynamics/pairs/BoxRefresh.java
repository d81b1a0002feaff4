package carom.physics.dynamics.pairs;

import carom.physics.broadphase.KdTree;
import carom.physics.dynamics.body.ActiveBodies;
import carom.physics.dynamics.body.BodyStore;
import carom.physics.dynamics.store.IntList;
import carom.physics.dynamics.store.ParallelFor;
import java.util.Arrays;

/**
 * The first stage of a step: measures the parts of all active bodies, and gives those a new fat box
 * that left theirs. When many left at once, all parts get new ones. Where pairs are few, a share of
 * the other parts gets them early, so that the next search is some ticks away for all of these.
 *
 * <p>Workers share the parts. Which worker measures which part shows in no result: parts are listed
 * in the order of the active bodies.
 */
final class BoxRefresh {
  /** Number of steps in which each branch of the tree has its turn once. */
  private static final int TURNS = 10;

  /** Number of parts from which on boxes are renewed in turns; fewer are cheap in one step. */
  private static final int LONG_STEP = 4_096;

  /**
   * Share (1 / n) of the parts that must have left their fat boxes before all parts get new ones.
   * The search then costs hardly more than for those that left, and the next steps need none.
   */
  private static final int RENEW_SHARE = 10;

  /** Share as {@link #RENEW_SHARE}, but in a crowd, where new boxes soon are left again. */
  private static final int CROWD_SHARE = 4;

  /** Number of bodies in a piece of a worker's work. */
  private static final int GRAIN = 64;

  private final BodyStore bodies;
  private final FatBoxes boxes;
  private final KdTree moving;
  private final MovedParts moved;
  private final ParallelFor parallel;
  private final ParallelFor.Range measuring = this::measureBodies;
  private final ParallelFor.Range renewing = this::renewParts;

  /** One per worker. */
  private FatBoxes.Scratch[] scratch = {new FatBoxes.Scratch()};

  /** The parts to renew. */
  private final IntList list = new IntList();

  /**
   * The bodies of which a part left its fat box. Each piece of work lists those that it found from
   * its own first place on.
   */
  private int[] strayed = new int[64];

  /** Per piece of work: its end, and how many bodies it listed in {@link #strayed}. */
  private int[] pieceEnd = new int[64];

  private int[] pieceFound = new int[64];

  /** The branch of the tree that had its turn last. */
  private int turn;

  // The refresh at present.
  private ActiveBodies active;
  private float dt;

  BoxRefresh(
      BodyStore bodies, FatBoxes boxes, KdTree moving, MovedParts moved, ParallelFor parallel) {
    this.bodies = bodies;
    this.boxes = boxes;
    this.moving = moving;
    this.moved = moved;
    this.parallel = parallel;
  }

  /**
   * Measures all active bodies and renews fat boxes.
   *
   * @param bodiesToMeasure the active bodies
   * @param lastStep length of the last step, s
   * @return whether any box in the moving tree changed
   */
  boolean run(ActiveBodies bodiesToMeasure, float lastStep) {
    active = bodiesToMeasure;
    dt = lastStep;
    ensureCapacity();
    parallel.run(0, active.count, GRAIN, measuring);
    listStrayed();
    int share = boxes.isCrowd(active.count) ? CROWD_SHARE : RENEW_SHARE;
    boolean many = list.count > moving.size() / share;
    if (many) {
      bodies.listParts(active.list, active.count, list);
    }
    for (int i = 0; i < list.count; i++) {
      moved.mark(list.values[i]);
    }
    parallel.run(0, list.count, GRAIN, renewing);
    boolean changed = list.count > 0;
    if (!many && moving.size() >= LONG_STEP && boxes.isSparse(active.count)) {
      changed |= renewInTurn();
    }
    return changed;
  }

  private void ensureCapacity() {
    if (strayed.length < active.count) {
      strayed = new int[active.list.length];
      pieceEnd = new int[strayed.length / GRAIN + 1];
      pieceFound = new int[pieceEnd.length];
    }
    int old = scratch.length;
    if (old < parallel.count()) {
      scratch = Arrays.copyOf(scratch, parallel.count());
      for (int i = old; i < scratch.length; i++) {
        scratch[i] = new FatBoxes.Scratch();
      }
    }
  }

  /** Lists the bodies that strayed without a branch, which no processor could predict. */
  private void measureBodies(int from, int to, int worker) {
    FatBoxes.Scratch s = scratch[worker];
    int found = from;
    for (int i = from; i < to; i++) {
      int body = active.list[i];
      boxes.place(body, s.pose);
      int first = bodies.firstPart[body];
      int end = first + bodies.partCount[body];
      boolean hold = true;
      for (int part = first; part < end; part++) {
        boxes.measure(part, s);
        hold &= boxes.holds(part);
      }
      strayed[found] = body;
      found += hold ? 0 : 1;
    }
    pieceEnd[from / GRAIN] = to;
    pieceFound[from / GRAIN] = found - from;
  }

  /** Lists the parts that left their fat boxes, in the order of the active bodies. */
  private void listStrayed() {
    list.count = 0;
    int end;
    for (int from = 0; from < active.count; from = end) {
      int piece = from / GRAIN;
      end = pieceEnd[piece];
      for (int i = from; i < from + pieceFound[piece]; i++) {
        int first = bodies.firstPart[strayed[i]];
        int count = bodies.partCount[strayed[i]];
        for (int part = first; part < first + count; part++) {
          if (count == 1 || !boxes.holds(part)) {
            list.add(part);
          }
        }
      }
    }
  }

  private void renewParts(int from, int to, int worker) {
    for (int i = from; i < to; i++) {
      boxes.renew(list.values[i], dt, active.count);
    }
  }

  /**
   * Renews, in the next branch of the tree, the boxes that wouldn't last until its next turn. This
   * spreads the work over the steps, and keeps what one step searches in one place.
   *
   * @return whether any box changed
   */
  private boolean renewInTurn() {
    list.ensureRoom(moving.size());
    turn = (turn + 1) % TURNS;
    int count = moving.slice(turn, TURNS, list.values);
    float wait = TURNS * dt;
    boolean changed = false;
    for (int i = 0; i < count; i++) {
      int part = list.values[i];
      if (!boxes.holdsFor(part, wait)) {
        moved.markTogether(part);
        boxes.renew(part, dt, active.count);
        changed = true;
      }
    }
    return changed;
  }
}
