package carom.physics.dynamics.pairs;

import carom.physics.broadphase.AabbArray;
import carom.physics.broadphase.KdTree;
import carom.physics.broadphase.PairSearch;
import carom.physics.dynamics.body.ShapeTable;
import carom.physics.dynamics.store.ParallelFor;
import java.util.Arrays;

/**
 * Searches the two trees for pairs with a part that moved, in one of two ways, or in both. Looking
 * up the surroundings of each moved part is best if few moved. Walking the trees wherever a box is
 * marked is best if many moved, or neighbours moved together.
 *
 * <p>Workers share the search. Each collects what it finds in a list of its own.
 */
final class CandidateSearch {
  /** Up to this fraction (1 / n) of moved parts, each is looked up by itself. */
  private static final int SEARCH_SHARE = 16;

  /** Number of moved parts in a piece of a worker's work. */
  private static final int GRAIN = 32;

  private final ShapeTable parts;
  private final KdTree moving;
  private final KdTree resting;
  private final MovedParts moved;
  private final PairFilter filter;
  private final ParallelFor parallel;
  private final PairSearch walk;
  private final ParallelFor.Range walking = this::walkPieces;
  private final ParallelFor.Range lookingUp = this::lookUp;

  /** One per worker. */
  private CandidateList[] lists;

  /** True if all pairs are searched, false if only those with a part that moved. */
  private boolean all;

  /** True if moved parts are looked up one by one, except those that moved together. */
  private boolean each;

  CandidateSearch(
      ShapeTable parts,
      PartTrees trees,
      MovedParts moved,
      PairFilter filter,
      ParallelFor parallel) {
    this.parts = parts;
    this.moving = trees.moving;
    this.resting = trees.resting;
    this.moved = moved;
    this.filter = filter;
    this.parallel = parallel;
    walk = new PairSearch(moving, resting);
    lists = new CandidateList[] {new CandidateList(parts, filter)};
  }

  /**
   * Searches the pairs.
   *
   * @param everyPair whether pairs count of which neither part moved
   * @param room keys that each list gets room for at once, so that lists grow with the world and
   *     not by which worker happens to find how many
   * @return what each worker found
   */
  CandidateList[] run(boolean everyPair, int room) {
    all = everyPair;
    ensureWorkers();
    for (CandidateList list : lists) {
      list.begin(all);
      list.ensureCapacity(room);
    }
    each = !all && moved.count - moved.togetherCount <= moving.size() / SEARCH_SHARE;
    if (!each || moved.togetherCount > 0) {
      walkTrees();
    }
    if (!all) {
      parallel.run(0, moved.count, GRAIN, lookingUp);
    }
    return lists;
  }

  private void ensureWorkers() {
    int old = lists.length;
    if (old < parallel.count()) {
      lists = Arrays.copyOf(lists, parallel.count());
      for (int i = old; i < lists.length; i++) {
        lists[i] = new CandidateList(parts, filter);
      }
    }
  }

  /** Walks the trees where boxes are marked, or everywhere. */
  private void walkTrees() {
    boolean[] marked = all ? null : each ? parts.together : parts.moved;
    int searched = all ? moving.size() : each ? moved.togetherCount : moved.count;
    try {
      int pieces = walk.begin(marked, parallel.shares(searched, GRAIN) ? parallel.count() : 1);
      parallel.run(0, pieces, 1, walking);
    } finally {
      walk.end();
    }
  }

  private void walkPieces(int from, int to, int worker) {
    for (int piece = from; piece < to; piece++) {
      walk.run(piece, worker, lists[worker]);
    }
  }

  /**
   * Looks up the surroundings of moved parts, as far as the walk of the trees leaves them out. Two
   * parts that rest never need each other.
   */
  private void lookUp(int from, int to, int worker) {
    CandidateList list = lists[worker];
    AabbArray fat = parts.fat;
    for (int i = from; i < to; i++) {
      int part = moved.list[i];
      boolean moves = moving.contains(part);
      boolean walked = !each || parts.together[part];
      if ((walked || !moves) && !resting.contains(part)) {
        continue;
      }
      list.searchAround(part);
      float minX = fat.minX(part);
      float minY = fat.minY(part);
      float maxX = fat.maxX(part);
      float maxY = fat.maxY(part);
      moving.query(minX, minY, maxX, maxY, list);
      if (moves) {
        resting.query(minX, minY, maxX, maxY, list);
      }
    }
  }
}
