package carom.physics.broadphase.kd;

import carom.physics.broadphase.index.PairVisitor;
import java.util.Arrays;

/**
 * Finds the overlapping pairs of a tree's boxes, among each other and with those of another tree,
 * in pieces that threads may do side by side: pairs of subtrees, from a few levels below the roots.
 *
 * <p>{@link #begin}, then {@link #run} once for every piece, then {@link #end}. The pieces depend
 * on the trees alone; each pair is reported by one of them, exactly once.
 *
 * <p><b>Threads.</b> Begin and end on one; pieces on any, each with a worker's number of its own.
 * Meanwhile the trees mustn't change, nor be fitted again.
 */
public final class PairSearch {
  /** Enough that threads end at about the same time, few enough that cutting costs microseconds. */
  private static final int PIECES = 64;

  private final KdTree tree;
  private final KdTree other;
  private KdJoin[] joins;

  /** Node pairs of the tree itself, and of the tree and the other one. */
  private final Pieces own = new Pieces();

  private final Pieces across = new Pieces();
  private boolean selective;

  /** Pairs of nodes below which pairs of boxes are searched. */
  private static final class Pieces {
    /** Going down a level replaces a pair by four at most. */
    private int[] nodes = new int[2 * 4 * PIECES];

    private int[] below = new int[2 * 4 * PIECES];
    private int count;
  }

  /**
   * Makes a search that wasn't begun.
   *
   * @param tree whose boxes are searched; a reference is kept
   * @param other another tree, whose boxes are searched for pairs with those of the first, but not
   *     among each other; a reference is kept
   */
  public PairSearch(KdTree tree, KdTree other) {
    this.tree = tree;
    this.other = other;
    joins = new KdJoin[] {new KdJoin(tree)};
  }

  /**
   * Begins to search. O(boxes of the tree) if something is marked, else a few microseconds.
   *
   * @param marked per id, whether its box changed: found are all pairs with a marked box of the
   *     tree, and some others, and nothing is touched that isn't near one; null: all pairs
   * @param workers how many threads there are, at least 1; for one the search isn't cut any further
   *     than into its two trees
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

  /** Goes down from the roots, until there are pieces enough or only leaves. */
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
   * Does one piece.
   *
   * @param piece which, from 0
   * @param worker number of the thread, from 0 to one less than {@link #begin} was told; no two at
   *     once have the same
   * @param visitor receives pairs in no particular order: idA &lt; idB of the tree, or idA of the
   *     tree and idB of the other. What it throws ends the piece, and goes to the caller
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

  /** Ends the search; also if a visitor threw. */
  public void end() {
    if (selective) {
      tree.cool();
      selective = false;
    }
  }
}
