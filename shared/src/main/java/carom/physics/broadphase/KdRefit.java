package carom.physics.broadphase;

/**
 * Updates a {@link KdTree} to the new edges of its boxes, in pieces that threads may run in
 * parallel. It reads the boxes leaf by leaf, finds the leaves for boxes that left their cells, and
 * puts them there.
 *
 * <p>Call {@link #begin}, then {@link #read} once for every piece, {@link #gather}, then {@link
 * #route} once for every piece, then {@link #end}. The resulting tree doesn't depend on which
 * thread runs which piece.
 *
 * <p><b>Threads.</b> One thread calls begin, gather and end; pieces may run on any thread. Until
 * the end, no other code may use the tree.
 */
public final class KdRefit {
  /**
   * Number of leaves in a piece to read, and of boxes in a piece to route: some microseconds of
   * work each.
   */
  private static final int LEAVES = 32;

  private static final int BOXES = 64;

  private static final float INF = Float.POSITIVE_INFINITY;

  // Sums over one box of each leaf of a piece: its motion, how far it moved, how far from a guess.
  private static final int SUM_X = 0;
  private static final int SUM_Y = 1;
  private static final int MOTION = 2;
  private static final int RESIDUE = 3;
  private static final int SUMS = 4;

  private final KdTree tree;

  /** Sums of each piece. */
  private double[] sums = new double[SUMS];

  /** Id of an invalid box by piece, or -1 if all are valid. */
  private int[] invalid = new int[1];

  /**
   * Number of boxes that left a leaf's cell, by leaf. Their ids are stored after those that stayed.
   */
  private int[] gone = new int[1];

  /** Scratch: the leaves with a changed box. */
  private int[] touched = new int[1];

  /** Ids of the boxes that left their cells, and the leaf that each belongs to. */
  private int[] stray = new int[KdTree.SLOTS];

  private int[] leafOf = new int[KdTree.SLOTS];
  private int strays;

  KdRefit(KdTree tree) {
    this.tree = tree;
  }

  /** Returns how many boxes left their cells in the last refit. */
  int strays() {
    return strays;
  }

  /** Returns the number of pieces to read. */
  private int pieces() {
    return pieces(tree.leaves);
  }

  private static int pieces(int leaves) {
    return (leaves + LEAVES - 1) / LEAVES;
  }

  /**
   * Begins a refit of all boxes.
   *
   * @return the number of pieces to read
   */
  public int begin() {
    strays = 0;
    if (tree.size() == 0) {
      return 0;
    }
    reserve();
    return pieces();
  }

  /** Makes room for as many leaves as the tree has room for, and for its boxes. */
  private void reserve() {
    int room = tree.fill.length;
    if (gone.length < room) {
      gone = new int[room];
      touched = new int[room];
      sums = new double[SUMS * pieces(room)];
      invalid = new int[pieces(room)];
    }
    if (stray.length < tree.size()) {
      stray = new int[Math.max(tree.size(), stray.length + (stray.length >> 1))];
      leafOf = new int[stray.length];
    }
  }

  /**
   * Reads the boxes of some leaves, and removes the boxes that left their cells.
   *
   * @param piece number of the piece, 0..{@link #begin} - 1; not checked: a larger one corrupts the
   *     refit
   */
  public void read(int piece) {
    int from = piece * LEAVES;
    int to = Math.min(from + LEAVES, tree.leaves);
    float offX = (float) tree.frameX + (tree.riding ? (float) tree.meanX : 0);
    float offY = (float) tree.frameY + (tree.riding ? (float) tree.meanY : 0);
    sample(piece, from, to);
    invalid[piece] = -1;
    for (int leaf = from; leaf < to && invalid[piece] < 0; leaf++) {
      invalid[piece] = readLeaf(leaf, offX, offY);
    }
  }

  /**
   * Sums up the motion of the boxes of some leaves, before they are read. One box of each leaf is
   * enough.
   */
  private void sample(int piece, int from, int to) {
    float[] edges = tree.boxes.edges;
    float guessX = (float) tree.meanX;
    float guessY = (float) tree.meanY;
    double sumX = 0;
    double sumY = 0;
    double motion = 0;
    double residue = 0;
    for (int leaf = from; leaf < to; leaf++) {
      if (tree.fill[leaf] > 0) {
        int id = tree.ids[leaf * KdTree.SLOTS];
        float moveX = edges[4 * id] - tree.slots[leaf * KdTree.BLOCK];
        float moveY = edges[4 * id + 1] - tree.slots[leaf * KdTree.BLOCK + KdTree.ROW];
        sumX += moveX;
        sumY += moveY;
        motion += Math.abs(moveX) + Math.abs(moveY);
        residue += Math.abs(moveX - guessX) + Math.abs(moveY - guessY);
      }
    }
    sums[SUMS * piece + SUM_X] = sumX;
    sums[SUMS * piece + SUM_Y] = sumY;
    sums[SUMS * piece + MOTION] = motion;
    sums[SUMS * piece + RESIDUE] = residue;
  }

  /**
   * Reads the boxes of a leaf, and removes those that left its cell. Returns the id of an invalid
   * box, or -1.
   */
  private int readLeaf(int leaf, float offX, float offY) {
    KdTree t = tree;
    float[] edges = t.boxes.edges;
    float[] slots = t.slots;
    int[] ids = t.ids;
    float cellLeft = t.cell[4 * leaf] + offX;
    float cellBottom = t.cell[4 * leaf + 1] + offY;
    float cellRight = t.cell[4 * leaf + 2] + offX;
    float cellTop = t.cell[4 * leaf + 3] + offY;
    float left = INF;
    float bottom = INF;
    float right = -INF;
    float top = -INF;
    int all = t.fill[leaf];
    int n = all;
    int first = leaf * KdTree.SLOTS;
    int block = leaf * KdTree.BLOCK;
    for (int k = 0; k < n; ) {
      int id = ids[first + k];
      float x0 = edges[4 * id] + 0f;
      float y0 = edges[4 * id + 1] + 0f;
      float x1 = edges[4 * id + 2] + 0f;
      float y1 = edges[4 * id + 3] + 0f;
      if (!(x0 <= x1 && y0 <= y1)) {
        return id;
      }
      float x = KdTree.center(x0, x1);
      float y = KdTree.center(y0, y1);
      if (x < cellLeft || x > cellRight || y < cellBottom || y > cellTop) {
        if (!AabbArray.valid(x0, y0, x1, y1)) {
          return id;
        }
        t.slotOf[id] = -1;
        n--;
        if (k < n) {
          t.moveSlot(first + n, first + k);
        }
        ids[first + n] = id;
        continue;
      }
      slots[block + k] = x0;
      slots[block + KdTree.ROW + k] = y0;
      slots[block + 2 * KdTree.ROW + k] = x1;
      slots[block + 3 * KdTree.ROW + k] = y1;
      left = Math.min(left, x0);
      bottom = Math.min(bottom, y0);
      right = Math.max(right, x1);
      top = Math.max(top, y1);
      k++;
    }
    t.fill[leaf] = n;
    gone[leaf] = all - n;
    KdBounds.set(t.bounds, leaf + t.leaves, left, bottom, right, top);
    return n > 0 && !AabbArray.valid(left, bottom, right, top) ? invalidOf(leaf) : -1;
  }

  /** Returns the id of an invalid box in a leaf whose bounds are suspicious, or -1. */
  private int invalidOf(int leaf) {
    for (int k = 0; k < tree.fill[leaf]; k++) {
      int id = tree.ids[leaf * KdTree.SLOTS + k];
      AabbArray b = tree.boxes;
      if (!AabbArray.valid(b.minX(id), b.minY(id), b.maxX(id), b.maxY(id))) {
        return id;
      }
    }
    return -1;
  }

  /**
   * Combines the results of all pieces that were read.
   *
   * @return the number of pieces to route, 0 if {@link #end} will rebuild the tree
   * @throws IllegalArgumentException if a box isn't finite with min &lt;= max; the tree is empty
   *     then
   */
  public int gather() {
    if (tree.size() == 0) {
      return 0;
    }
    double sumX = 0;
    double sumY = 0;
    double motion = 0;
    double residue = 0;
    int seen = 0;
    for (int piece = 0; piece < pieces(); piece++) {
      if (invalid[piece] >= 0) {
        tree.clear();
        throw tree.boxes.invalid(invalid[piece]);
      }
      sumX += sums[SUMS * piece + SUM_X];
      sumY += sums[SUMS * piece + SUM_Y];
      motion += sums[SUMS * piece + MOTION];
      residue += sums[SUMS * piece + RESIDUE];
    }
    for (int leaf = 0; leaf < tree.leaves; leaf++) {
      int behind = leaf * KdTree.SLOTS + tree.fill[leaf];
      seen += tree.fill[leaf] + gone[leaf] > 0 ? 1 : 0;
      for (int i = behind; i < behind + gone[leaf]; i++) {
        stray[strays++] = tree.ids[i];
      }
    }
    tree.follow(sumX / Math.max(1, seen), sumY / Math.max(1, seen), residue < 0.5 * motion);
    return tree.isOutrun(strays) ? 0 : (strays + BOXES - 1) / BOXES;
  }

  /**
   * Finds the leaves for some of the boxes that left their cells.
   *
   * @param piece number of the piece, 0..{@link #gather} - 1; not checked: a larger one does
   *     nothing
   */
  public void route(int piece) {
    route(piece * BOXES, Math.min((piece + 1) * BOXES, strays));
  }

  private void route(int from, int to) {
    for (int i = from; i < to; i++) {
      leafOf[i] = tree.leafFor(stray[i]);
    }
  }

  /**
   * Ends the refit: puts the boxes that left their cells into their leaves and makes all bounds
   * right.
   */
  public void end() {
    if (tree.size() > 0 && !placeStrays()) {
      KdBounds.fitInner(tree.bounds, 1, tree.leaves);
    }
  }

  /**
   * Puts the boxes that left their cells into their leaves. Returns whether the whole tree was
   * rebuilt instead, so that all bounds are right.
   */
  private boolean placeStrays() {
    if (tree.isOutrun(strays)) {
      tree.rebuild(stray, strays);
      return true;
    }
    long built = tree.built();
    for (int i = 0; i < strays; i++) {
      tree.put(stray[i], built == tree.built() ? leafOf[i] : tree.leafFor(stray[i]));
    }
    return false;
  }

  /** Runs a whole refit on this thread; throws as {@link #gather} does. */
  void all() {
    int read = begin();
    for (int piece = 0; piece < read; piece++) {
      read(piece);
    }
    int routed = gather();
    for (int piece = 0; piece < routed; piece++) {
      route(piece);
    }
    end();
  }

  /**
   * Refits some boxes on this thread; all others must be where they were. See {@link
   * KdTree#refit(int[], int)}.
   */
  void some(int[] changed, int count) {
    KdTree t = tree;
    reserve();
    strays = 0;
    float offX = (float) t.frameX;
    float offY = (float) t.frameY;
    int leaves = 0;
    for (int i = 0; i < count; i++) {
      int id = changed[i];
      if (!t.contains(id)) {
        continue;
      }
      AabbArray b = t.boxes;
      if (!AabbArray.valid(b.minX(id), b.minY(id), b.maxX(id), b.maxY(id))) {
        t.clear();
        throw b.invalid(id);
      }
      int slot = t.slotOf[id];
      int leaf = slot / KdTree.SLOTS;
      if (!t.hot[leaf + t.leaves]) {
        t.hot[leaf + t.leaves] = true;
        touched[leaves++] = leaf;
      }
      float x = KdTree.center(b.minX(id), b.maxX(id)) - offX;
      float y = KdTree.center(b.minY(id), b.maxY(id)) - offY;
      int c = 4 * leaf;
      if (x < t.cell[c] || y < t.cell[c + 1] || x > t.cell[c + 2] || y > t.cell[c + 3]) {
        t.takeFromCell(id);
        stray[strays++] = id;
      } else {
        t.store(leaf, slot % KdTree.SLOTS, id, b, id);
      }
    }
    t.riding = false;
    for (int i = 0; i < leaves; i++) {
      t.hot[touched[i] + t.leaves] = false;
      t.fitLeaf(touched[i]);
    }
    route(0, t.isOutrun(strays) ? 0 : strays);
    if (placeStrays()) {
      return;
    }
    if (leaves > t.leaves / KdTree.REFIT_SHARE) {
      KdBounds.fitInner(t.bounds, 1, t.leaves);
      return;
    }
    for (int i = 0; i < leaves; i++) {
      KdBounds.fitAncestors(t.bounds, touched[i] + t.leaves);
    }
    for (int i = 0; i < strays; i++) {
      KdBounds.fitAncestors(t.bounds, t.slotOf[stray[i]] / KdTree.SLOTS + t.leaves);
    }
  }
}
