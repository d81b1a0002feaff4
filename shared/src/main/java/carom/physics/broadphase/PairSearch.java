package carom.physics.broadphase;

import java.util.Arrays;

/**
 * Finds the overlapping pairs of a tree's boxes, among each other and with those of another tree,
 * in pieces that threads may run in parallel. A piece is a pair of subtrees a few levels below the
 * roots.
 *
 * <p>Call {@link #begin}, then {@link #run} once for every piece, then {@link #end}. Each pair is
 * reported by exactly one piece, exactly once.
 *
 * <p><b>Threads.</b> One thread calls begin and end; pieces may run on any thread, each with its
 * own worker number. Until the end, the trees must not change or be refitted.
 */
public final class PairSearch {
  /**
   * Number of pieces wanted of each search: enough that threads end at about the same time, few
   * enough that cutting costs microseconds.
   */
  private static final int PIECES = 64;

  private final KdTree tree;
  private final KdTree other;
  private KdJoin[] joins;

  /** Pairs of nodes within the tree, and of the tree with the other one. */
  private final Pieces own = new Pieces();

  private final Pieces across = new Pieces();
  private boolean selective;

  /** Pairs of nodes below which pairs of boxes are searched. */
  private static final class Pieces {
    /** Two ints for each pair of nodes. Going down a level replaces a pair by at most four. */
    private int[] nodes = new int[2 * 4 * PIECES];

    private int[] below = new int[2 * 4 * PIECES];
    private int count;
  }

  /**
   * Makes a search; call {@link #begin} before use.
   *
   * @param tree the tree whose boxes are searched; a reference is kept
   * @param other another tree, whose boxes are searched for pairs with those of the first, but not
   *     among each other; a reference is kept
   */
  public PairSearch(KdTree tree, KdTree other) {
    this.tree = tree;
    this.other = other;
    joins = new KdJoin[] {new KdJoin(tree)};
  }

  /**
   * Begins a search. O(boxes of the tree) if marks are given, else a few microseconds.
   *
   * @param marked whether the box of each id changed, or null to find all pairs. With marks, the
   *     search finds all pairs with a marked box of the tree, and some others; it doesn't visit
   *     nodes far from marked boxes
   * @param workers number of threads, at least 1. For one thread, the search has at most two
   *     pieces: the tree itself, and the tree with the other
   * @return the number of pieces
   */
  public int begin(boolean[] marked, int workers) {
    if (joins.length < workers) {
      int old = joins.length;
      joins = Arrays.copyOf(joins, workers);
      for (int i = old; i < workers; i++) {
        joins[i] = new KdJoin(tree);
      }
    }
    selective = marked != null;
    if (selective) {
      tree.heat(marked);
    }
    int wanted = workers > 1 ? PIECES : 1;
    cut(own, tree, wanted);
    cut(across, other, wanted);
    return own.count + across.count;
  }

  /**
   * Cuts a search into pieces: goes down from the roots until there are enough pieces or only
   * leaves.
   */
  private void cut(Pieces p, KdTree with, int wanted) {
    p.nodes[0] = 1;
    p.nodes[1] = 1;
    p.count = tree.size() > 0 && with.size() > 0 ? 1 : 0;
    int levels = tree.levels() + (p == own ? 0 : with.levels());
    for (int i = 0; i < levels && p.count > 0 && p.count < wanted; i++) {
      p.count =
          p == own
              ? joins[0].descend(p.nodes, p.count, selective, p.below)
              : joins[0].descend(with, p.nodes, p.count, selective, p.below);
      int[] swap = p.nodes;
      p.nodes = p.below;
      p.below = swap;
    }
  }

  /**
   * Searches one piece.
   *
   * @param piece number of the piece, from 0
   * @param worker number of the thread, 0..workers - 1 as given to {@link #begin}; no two running
   *     at once may have the same
   * @param visitor receives pairs in no particular order: idA &lt; idB of the tree, or idA of the
   *     tree and idB of the other. An exception that it throws ends the piece and reaches the
   *     caller
   * @throws IndexOutOfBoundsException if there is no such piece or worker
   */
  public void run(int piece, int worker, PairVisitor visitor) {
    KdJoin join = joins[worker];
    if (piece < own.count) {
      join.pairs(own.nodes[2 * piece], own.nodes[2 * piece + 1], selective, visitor);
    } else {
      int at = 2 * (piece - own.count);
      join.join(other, across.nodes[at], across.nodes[at + 1], selective, visitor);
    }
  }

  /** Ends the search. Call it even if a visitor threw. */
  public void end() {
    if (selective) {
      tree.cool();
      selective = false;
    }
  }
}
