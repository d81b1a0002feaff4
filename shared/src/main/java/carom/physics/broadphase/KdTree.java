package carom.physics.broadphase;

import java.util.Arrays;

/**
 * The engine's own index: a KD-tree over the centres of the boxes, with tight bounds per node.
 *
 * <p>The tree is made to be kept. {@link #add}, {@link #remove} and {@link #refit()} repair it in
 * place, so {@link #rebuild} is needed at most once.
 *
 * <p><b>Layout.</b> The tree is a perfect binary tree without node objects: node 1 is the root, 2n
 * and 2n + 1 are the children of n, and leaf l is node {@code leaves + l}. A leaf has room for
 * {@value #SLOTS} boxes and holds at most {@value #FILL} on average, so that boxes come and go
 * without moving others; its boxes lie side by side in one array, so that testing two leaves
 * touches a few cache lines. Inner nodes split x or y at the median of the centres, whichever
 * extent is wider.
 *
 * <p><b>From tick to tick.</b> Every leaf knows the cell, a region between split lines, for which
 * it was made. {@link #refit()} reads the new boxes leaf by leaf; a box whose centre is still in
 * the cell (with some slack) stays; the few others descend from the root again. When a leaf is
 * full, the tree rebuilds the smallest subtree around it that isn't crowded itself, as in a
 * packed-memory array. So the work is local where the change is local. When more than one box in
 * {@value #REBUILD_SHARE} left its cell, the whole tree is rebuilt at once. When most of the motion
 * is common to all boxes, the cells move along, so a swarm that flies or falls in formation costs
 * nothing extra. The partition affects only speed: bounds are always those of the boxes, so results
 * are right however stale the partition is.
 *
 * <pre>
 *   node          1                 children of n: 2n and 2n + 1
 *             /       \
 *           2           3           inner nodes: split coordinate, bounds
 *         /   \       /   \
 *        4     5     6     7        leaf l is node leaves + l: cell, bounds
 *       [ ]   [ ]   [ ]   [ ]       up to {@value #SLOTS} boxes side by side, ids beside them
 * </pre>
 *
 * <p>Work that only reads or replaces the arrays is in classes of its own: {@link KdBuilder},
 * {@link KdRefit}, {@link KdJoin}, {@link KdCast}, {@link KdBounds}.
 *
 * <p><b>Threads.</b> As for every {@link SpatialIndex}; in addition, {@link #query} only reads, so
 * between updates any number of threads may query.
 *
 * <p><b>Cost.</b> Refit and pairs take O(n) in practice, add and remove amortised O(log n), a query
 * O(log n + found). Recursion is no deeper than the tree, which has at most 24 levels.
 */
public final class KdTree implements SpatialIndex {
  /** Number of boxes that a leaf has room for. */
  static final int SLOTS = 16;

  /** Largest number of boxes per leaf, averaged over a tree that is built. */
  static final int FILL = 10;

  /**
   * Share (1 / n) of boxes above which, when they leave their cells in one tick, the tree is
   * rebuilt.
   */
  static final int REBUILD_SHARE = 2;

  /**
   * Share (1 / n) of boxes above which, when they are added or removed at once, the tree is
   * rebuilt.
   */
  static final int BULK_SHARE = 8;

  /** Share (1 / n) of boxes above which, when they changed, all boxes are refitted. */
  static final int REFIT_SHARE = 3;

  /**
   * Share of the cell's width by which a box's centre may leave the cell before the box moves to
   * another leaf.
   */
  static final float CELL_SLACK = 0.125f;

  /** Distance between the coordinate rows of a leaf. */
  static final int ROW = SLOTS;

  /** Number of bits by which to shift an index into {@link #slots} right to get its leaf. */
  static final int SHIFT = 6;

  /** Number of floats that a leaf has in {@link #slots}. */
  static final int BLOCK = 1 << SHIFT;

  /** Largest number of boxes, for which the arrays' lengths still fit an int. */
  private static final int MAX_SIZE = 1 << 27;

  private static final float INF = Float.POSITIVE_INFINITY;

  AabbArray boxes;
  private int size;
  int leaves = 1;

  /** Bounds by node: minX, minY, maxX, maxY; inverted infinities if the node is empty. */
  float[] bounds = new float[8];

  /** Split coordinate by inner node, in the frame that moves along. */
  float[] split = new float[1];

  /** True if an inner node splits y, by inner node. */
  boolean[] splitsY = new boolean[1];

  /** Cell by leaf (minX, minY, maxX, maxY), slack included, in the frame that moves along. */
  float[] cell = new float[4];

  /** Number of boxes by leaf. */
  int[] fill = new int[1];

  /**
   * Scratch by node: whether it holds a box of interest; false outside of {@link #refit} and of a
   * {@link PairSearch}.
   */
  boolean[] hot = new boolean[2];

  /** Id of the box by slot. */
  int[] ids = new int[SLOTS];

  /**
   * Boxes by leaf: a block of four rows, minX, minY, maxX, maxY of its slots. No negative zeros.
   */
  float[] slots = new float[BLOCK];

  /** Slot by id, or -1 if the box isn't in the tree. */
  int[] slotOf = new int[0];

  /** Distance that the frame of the cells has moved since they were made, m. */
  double frameX;

  double frameY;

  /** Mean motion of the boxes in the last refit, m. */
  double meanX;

  double meanY;

  /**
   * True if the frame is expected to move by the mean motion in the next refit, false if it stays.
   */
  boolean riding;

  private final KdBuilder builder = new KdBuilder(this);
  private final KdRefit refit = new KdRefit(this);
  private final KdJoin search = new KdJoin(this);
  private final KdCast cast = new KdCast(this);

  /**
   * Makes an empty tree over these boxes.
   *
   * @param boxes the boxes, indexed by id; a reference is kept
   */
  public KdTree(AabbArray boxes) {
    this.boxes = boxes;
    clear();
  }

  @Override
  public int size() {
    return size;
  }

  /**
   * Returns whether a box is in the tree.
   *
   * @param id id of the box; any number
   * @return true if it is
   */
  public boolean contains(int id) {
    return id >= 0 && id < slotOf.length && slotOf[id] >= 0;
  }

  /** Returns how many levels the leaves are below the root. */
  int levels() {
    return Integer.numberOfTrailingZeros(leaves);
  }

  /** Returns how many boxes left their cells in the last refit. */
  int strays() {
    return refit.strays();
  }

  /**
   * Returns how many boxes were ever placed by building a subtree, a measure of the work of repair.
   */
  long built() {
    return builder.placed();
  }

  /** Removes all boxes, and keeps the memory. */
  public void clear() {
    cool(); // a refit that failed may have left marks, in all leaves there were
    Arrays.fill(slotOf, -1);
    size = 0;
    leaves = 1;
    fill[0] = 0;
    setCell(0, -INF, -INF, INF, INF);
    frameX = 0;
    frameY = 0;
    meanX = 0;
    meanY = 0;
    riding = false;
    fitLeaf(0);
  }

  // ---------------------------------------------------------------- changing the set of boxes

  /**
   * {@inheritDoc}
   *
   * <p>If the ids are those already in the tree, their order is used again, because building from
   * nearly sorted boxes is faster.
   */
  @Override
  public void rebuild(AabbArray newBoxes, int[] newIds, int count) {
    int limit = Math.min(MAX_SIZE, newIds.length);
    if (count < 0 || count > limit) {
      throw new IllegalArgumentException("count=" + count + ", limit 0.." + limit);
    }
    boxes = newBoxes;
    ensureWork(count);
    boolean same = count == size;
    for (int i = 0; i < count && same; i++) {
      same = contains(newIds[i]);
    }
    if (same) {
      builder.gather(0, leaves);
    } else {
      System.arraycopy(newIds, 0, builder.ids, 0, count);
    }
    clear();
    try {
      for (int i = 0; i < count; i++) {
        int id = newIds[i];
        boxes.check(id);
        ensureId(id);
        if (slotOf[id] >= 0) {
          throw new IllegalArgumentException("id=" + id + " comes twice in ids, index=" + i);
        }
        slotOf[id] = 0;
      }
    } catch (IllegalArgumentException e) {
      clear();
      throw e;
    }
    for (int i = 0; i < count; i++) {
      builder.put(i, builder.ids[i], boxes);
    }
    size = count;
    buildAll(count);
  }

  /**
   * Adds a box with its present edges in the box array. Amortised O(log n).
   *
   * @param id index of the box in the box array
   * @throws IllegalArgumentException if the id is in the tree already or its box isn't valid; the
   *     tree stays as it was
   * @throws IllegalStateException if the tree holds {@value #MAX_SIZE} boxes
   */
  public void add(int id) {
    boxes.check(id);
    if (contains(id)) {
      throw new IllegalArgumentException(
          "id=" + id + " is in the tree already; remove it first, or call refit() if it moved");
    }
    if (size == MAX_SIZE) {
      throw new IllegalStateException("size=" + size + ", limit " + MAX_SIZE);
    }
    ensureId(id);
    size++;
    int leaf = insert(id);
    if (leaf >= 0) {
      KdBounds.fitAncestors(bounds, leaf + leaves);
    }
  }

  /**
   * Adds boxes as {@link #add} does. If there are many, the tree is rebuilt, O(n log n).
   *
   * @param newIds indexes of boxes in the box array, each once
   * @param count how many
   * @throws IllegalArgumentException if an id is in the tree already or a box isn't valid; the
   *     boxes before it may be in the tree then
   */
  public void addAll(int[] newIds, int count) {
    if (count <= size / BULK_SHARE) {
      for (int i = 0; i < count; i++) {
        add(newIds[i]);
      }
      return;
    }
    for (int i = 0; i < count; i++) {
      boxes.check(newIds[i]);
      ensureId(newIds[i]);
      if (slotOf[newIds[i]] >= 0) {
        throw new IllegalArgumentException("id=" + newIds[i] + " is in the tree already");
      }
    }
    ensureWork(size + count);
    int to = builder.gather(0, leaves);
    for (int i = 0; i < count; i++) {
      builder.put(to + i, newIds[i], boxes);
    }
    size += count;
    buildAll(size);
  }

  /**
   * Removes boxes as {@link #remove} does. If there are many, the tree is rebuilt.
   *
   * @param oldIds which
   * @param count how many
   */
  public void removeAll(int[] oldIds, int count) {
    if (count <= size / BULK_SHARE) {
      for (int i = 0; i < count; i++) {
        remove(oldIds[i]);
      }
      return;
    }
    for (int i = 0; i < count; i++) {
      if (contains(oldIds[i])) {
        takeOut(oldIds[i]);
      }
    }
    if (size == 0) {
      clear();
    } else {
      ensureWork(size);
      buildAll(builder.gather(0, leaves));
    }
  }

  /**
   * Takes a box out of its leaf without counting it as removed. The leaf's bounds stay as they are.
   */
  void takeFromCell(int id) {
    takeOut(id);
    size++;
  }

  /** Takes a box out of the tree and returns its leaf, whose bounds stay as they are. */
  private int takeOut(int id) {
    int slot = slotOf[id];
    int leaf = slot / SLOTS;
    int last = leaf * SLOTS + --fill[leaf];
    moveSlot(last, slot);
    slotOf[id] = -1;
    size--;
    return leaf;
  }

  /**
   * Removes a box. O(log n); bounds stay tight.
   *
   * @param id id of the box; any number
   * @return false if it wasn't in the tree
   */
  public boolean remove(int id) {
    if (!contains(id)) {
      return false;
    }
    int leaf = takeOut(id);
    fitLeaf(leaf);
    KdBounds.fitAncestors(bounds, leaf + leaves);
    return true;
  }

  /** Copies slot {@code from} over slot {@code to} of the same leaf. */
  void moveSlot(int from, int to) {
    int id = ids[from];
    ids[to] = id;
    slotOf[id] = to;
    int block = from / SLOTS * BLOCK;
    int source = block + from % SLOTS;
    int target = block + to % SLOTS;
    for (int row = 0; row < BLOCK; row += ROW) {
      slots[target + row] = slots[source + row];
    }
  }

  /**
   * Puts a box into the leaf for its centre. The box is already counted in {@link #size}, but not
   * in a leaf.
   *
   * @return the leaf, whose bounds are right but not its ancestors'; -1 if a subtree was rebuilt
   *     and all bounds are right
   */
  private int insert(int id) {
    return put(id, leafFor(id));
  }

  /** Returns the leaf for a box's centre. The method only reads. */
  int leafFor(int id) {
    float x = (float) (center(boxes.minX(id), boxes.maxX(id)) - frameX);
    float y = (float) (center(boxes.minY(id), boxes.maxY(id)) - frameY);
    int ties = id * 0x9E3779B9;
    int node = 1;
    while (node < leaves) {
      float c = splitsY[node] ? y : x;
      float s = split[node];
      int right = c > s ? 1 : 0;
      if (c == s) {
        right = ties >>> 31;
        ties <<= 1;
      }
      node = 2 * node + right;
    }
    return node - leaves;
  }

  /** Puts a box into a known leaf, as {@link #insert} does. */
  int put(int id, int leaf) {
    int n = fill[leaf];
    if (n == SLOTS) {
      makeRoom(leaf, id);
      return -1;
    }
    fill[leaf] = n + 1;
    store(leaf, n, id, boxes, id);
    int at = leaf * BLOCK + n;
    KdBounds.extend(
        bounds,
        leaf + leaves,
        slots[at],
        slots[at + ROW],
        slots[at + 2 * ROW],
        slots[at + 3 * ROW]);
    return leaf;
  }

  /** Rebuilds the smallest uncrowded subtree around a full leaf, with one box more. */
  private void makeRoom(int leaf, int id) {
    int height = levels();
    int first = leaf;
    int end = leaf + 1;
    int count = fill[leaf] + 1;
    for (int h = 1; h <= height; h++) {
      int wide = 1 << h;
      int newFirst = leaf & -wide;
      int newEnd = newFirst + wide;
      count += sumFill(newFirst, first) + sumFill(end, newEnd);
      first = newFirst;
      end = newEnd;
      // allowed: a full leaf at height 0, down to FILL boxes per leaf at the root
      long limit = (long) wide * (SLOTS * height - (SLOTS - FILL) * h) / height;
      if (count <= limit) {
        ensureWork(count);
        builder.put(builder.gather(first, end), id, boxes);
        buildSubtree((leaf + leaves) >> h, count);
        return;
      }
    }
    ensureWork(size);
    int others = builder.gather(0, leaves);
    builder.put(others, id, boxes);
    buildAll(others + 1);
  }

  private int sumFill(int from, int to) {
    int sum = 0;
    for (int leaf = from; leaf < to; leaf++) {
      sum += fill[leaf];
    }
    return sum;
  }

  /**
   * Lists the boxes of one of several parts of the tree, near boxes near each other. Listing all
   * parts gives every box once, if none moves from leaf to leaf meanwhile.
   *
   * @param part number of the part, 0..{@code parts} - 1
   * @param parts number of parts, at least 1
   * @param out receives the ids; {@link #size()} entries are enough
   * @return how many
   */
  public int slice(int part, int parts, int[] out) {
    int end = (int) ((part + 1L) * leaves / parts);
    int to = 0;
    for (int leaf = (int) ((long) part * leaves / parts); leaf < end; leaf++) {
      System.arraycopy(ids, leaf * SLOTS, out, to, fill[leaf]);
      to += fill[leaf];
    }
    return to;
  }

  /**
   * Renumbers the boxes from 0 on in the order of the leaves. The caller sorts the box array into
   * that order.
   *
   * @param old receives the former id of each box
   */
  public void number(int[] old) {
    int to = 0;
    for (int leaf = 0; leaf < leaves; leaf++) {
      int first = leaf * SLOTS;
      for (int slot = first; slot < first + fill[leaf]; slot++) {
        old[to] = ids[slot];
        ids[slot] = to;
        to++;
      }
    }
    ensureId(to - 1);
    Arrays.fill(slotOf, -1);
    for (int leaf = 0; leaf < leaves; leaf++) {
      int first = leaf * SLOTS;
      for (int slot = first; slot < first + fill[leaf]; slot++) {
        slotOf[ids[slot]] = slot;
      }
    }
  }

  // ---------------------------------------------------------------- following motion

  /**
   * Updates the tree to the boxes' new edges. Call it once per tick, after they moved. O(n), plus
   * the repair for boxes that left their cells.
   *
   * @throws IllegalArgumentException if a box isn't finite with min &lt;= max; the tree is empty
   *     then
   */
  public void refit() {
    refit.all();
  }

  /**
   * Returns the refit of this tree, for several threads to run in parallel what {@link #refit()}
   * does.
   *
   * @return the tree's only refit
   */
  public KdRefit refitting() {
    return refit;
  }

  /**
   * Updates the tree to the new edges of some boxes; all others must be where they were.
   * O(changed), plus the repair for boxes that left their cells. The frame of the cells stays,
   * however the boxes move.
   *
   * @param changed ids, each once; those that aren't in the tree are skipped
   * @param count how many
   * @throws IllegalArgumentException if a box isn't finite with min &lt;= max; the tree is empty
   *     then
   */
  public void refit(int[] changed, int count) {
    if (isMost(count)) {
      refit.all();
    } else {
      refit.some(changed, count);
    }
  }

  /**
   * Returns whether {@link #refit(int[], int)} would read all boxes instead.
   *
   * @param count how many changed
   * @return true if {@link #refitting} is the better choice
   */
  public boolean isMost(int count) {
    return count > size / REFIT_SHARE;
  }

  /** Returns whether rebuilding the tree is cheaper than moving this many boxes one by one. */
  boolean isOutrun(int strays) {
    boolean sparse = size < leaves;
    return leaves > 1 && (sparse || strays > size / REBUILD_SHARE);
  }

  /** Rebuilds the tree, including the boxes that left their cells. */
  void rebuild(int[] stray, int strays) {
    ensureWork(size);
    int stayed = builder.gather(0, leaves);
    for (int i = 0; i < strays; i++) {
      builder.put(stayed + i, stray[i], boxes);
    }
    buildAll(size);
  }

  /** Moves the frame by the mean motion if it rode along, and decides whether it will next time. */
  void follow(double newMeanX, double newMeanY, boolean common) {
    boolean finite = Math.abs(newMeanX) + Math.abs(newMeanY) <= Float.MAX_VALUE;
    meanX = finite ? newMeanX : 0;
    meanY = finite ? newMeanY : 0;
    if (riding) {
      frameX += meanX;
      frameY += meanY;
    }
    riding = common && finite;
  }

  // ---------------------------------------------------------------- building

  /** Builds the whole tree from the first boxes of the builder's list. */
  private void buildAll(int count) {
    setLeaves(leavesFor(count));
    frameX = 0;
    frameY = 0;
    buildSubtree(1, count);
  }

  /** Builds a subtree from the first boxes of the builder's list, and fits all bounds. */
  private void buildSubtree(int node, int count) {
    builder.build(node, count);
    KdBounds.fitInner(bounds, node, leaves);
    KdBounds.fitAncestors(bounds, node);
  }

  /** Writes an id and a box, {@code from[e]}, into slot {@code k} of a leaf. */
  void store(int leaf, int k, int id, AabbArray from, int e) {
    ids[leaf * SLOTS + k] = id;
    slotOf[id] = leaf * SLOTS + k;
    int at = leaf * BLOCK + k;
    // adding zero turns -0 into +0, which the sign tests of pairs() rely on
    slots[at] = from.minX(e) + 0f;
    slots[at + ROW] = from.minY(e) + 0f;
    slots[at + 2 * ROW] = from.maxX(e) + 0f;
    slots[at + 3 * ROW] = from.maxY(e) + 0f;
  }

  static float center(float min, float max) {
    return 0.5f * min + 0.5f * max;
  }

  void setCell(int leaf, float left, float bottom, float right, float top) {
    // an open side would make the slack infinite, and infinity minus infinity must not occur
    float slackX = right - left < INF ? CELL_SLACK * (right - left) : 0;
    float slackY = top - bottom < INF ? CELL_SLACK * (top - bottom) : 0;
    cell[4 * leaf] = left - slackX;
    cell[4 * leaf + 1] = bottom - slackY;
    cell[4 * leaf + 2] = right + slackX;
    cell[4 * leaf + 3] = top + slackY;
  }

  // ---------------------------------------------------------------- bounds

  void fitLeaf(int leaf) {
    float left = INF;
    float bottom = INF;
    float right = -INF;
    float top = -INF;
    int from = leaf * BLOCK;
    int to = from + fill[leaf];
    for (int i = from; i < to; i++) {
      left = Math.min(left, slots[i]);
      bottom = Math.min(bottom, slots[i + ROW]);
      right = Math.max(right, slots[i + 2 * ROW]);
      top = Math.max(top, slots[i + 3 * ROW]);
    }
    KdBounds.set(bounds, leaf + leaves, left, bottom, right, top);
  }

  // ---------------------------------------------------------------- memory

  /**
   * Makes room for boxes before they come, so that those that leave and come back allocate nothing.
   * The tree is rebuilt if its arrays are too small.
   *
   * @param count boxes in the tree
   * @param idBound one more than the largest id
   */
  public void reserve(int count, int idBound) {
    ensureId(idBound - 1);
    ensureWork(Math.max(count, size));
    if (fill.length < leavesFor(count)) {
      int n = builder.gather(0, leaves);
      makeLeaves(leavesFor(count));
      buildAll(n);
    }
  }

  private static int leavesFor(int count) {
    int wanted = 1;
    while ((long) wanted * FILL < count) {
      wanted *= 2;
    }
    return wanted;
  }

  private void setLeaves(int wanted) {
    leaves = wanted;
    if (fill.length < wanted) {
      makeLeaves(wanted);
    }
  }

  private void makeLeaves(int room) {
    bounds = new float[8 * room];
    split = new float[room];
    splitsY = new boolean[room];
    cell = new float[4 * room];
    fill = new int[room];
    hot = new boolean[2 * room];
    ids = new int[SLOTS * room];
    slots = new float[BLOCK * room];
  }

  private void ensureId(int id) {
    if (id >= slotOf.length) {
      int old = slotOf.length;
      slotOf = Arrays.copyOf(slotOf, Math.max(id + 1, old + (old >> 1) + 16));
      Arrays.fill(slotOf, old, slotOf.length, -1);
    }
  }

  private void ensureWork(int count) {
    builder.reserve(count);
  }

  // ---------------------------------------------------------------- searching

  @Override
  public void query(float minX, float minY, float maxX, float maxY, IntVisitor visitor) {
    int node = 1;
    do {
      int b = 4 * node;
      if (bounds[b] <= maxX
          && bounds[b + 2] >= minX
          && bounds[b + 1] <= maxY
          && bounds[b + 3] >= minY) {
        if (node < leaves) {
          node = 2 * node;
          continue;
        }
        int leaf = node - leaves;
        for (int k = 0; k < fill[leaf]; k++) {
          int at = leaf * BLOCK + k;
          if (slots[at] <= maxX
              && slots[at + 2 * ROW] >= minX
              && slots[at + ROW] <= maxY
              && slots[at + 3 * ROW] >= minY
              && !visitor.visit(ids[leaf * SLOTS + k])) {
            return;
          }
        }
      }
      node = next(node);
    } while (node != 1);
  }

  /**
   * {@inheritDoc}
   *
   * <p>Unlike {@link #query}, a cast uses the tree's scratch memory, so only one thread may cast at
   * a time.
   */
  @Override
  public void cast(
      float minX,
      float minY,
      float maxX,
      float maxY,
      float dx,
      float dy,
      float maxFraction,
      CastVisitor visitor) {
    cast.run(minX, minY, maxX, maxY, dx, dy, maxFraction, visitor);
  }

  /** Returns the node after a subtree in depth-first order, 1 at the end. */
  private static int next(int node) {
    int after = node + 1;
    return after >> Integer.numberOfTrailingZeros(after);
  }

  @Override
  public void pairs(PairVisitor visitor) {
    search.pairs(1, 1, false, visitor);
  }

  /** Marks the nodes that hold marked boxes as {@link #hot}. */
  void heat(boolean[] marked) {
    for (int leaf = 0; leaf < leaves; leaf++) {
      boolean any = false;
      int first = leaf * SLOTS;
      for (int i = first; i < first + fill[leaf]; i++) {
        any |= marked[ids[i]];
      }
      hot[leaf + leaves] = any;
    }
    for (int node = leaves - 1; node > 0; node--) {
      hot[node] = hot[2 * node] || hot[2 * node + 1];
    }
  }

  /** Clears the {@link #hot} marks of all nodes. */
  void cool() {
    Arrays.fill(hot, 0, 2 * leaves, false);
  }

  /**
   * Visits every pair of overlapping boxes, the first from this tree and the second from the other,
   * each exactly once. Pairs are not ordered by id: idA belongs to this tree, idB to the other.
   *
   * @param other another tree; the same tree gives each pair twice and each box with itself
   * @param visitor receives the pairs
   */
  public void join(KdTree other, PairVisitor visitor) {
    search.join(other, 1, 1, false, visitor);
  }

  /**
   * Visits all nodes that hold a box, parents before children.
   *
   * @param visitor receives bounds and depths
   */
  public void cells(CellVisitor visitor) {
    int node = 1;
    do {
      int b = 4 * node;
      if (bounds[b] <= bounds[b + 2]) {
        int depth = 31 - Integer.numberOfLeadingZeros(node);
        visitor.cell(bounds[b], bounds[b + 1], bounds[b + 2], bounds[b + 3], depth);
        if (node < leaves) {
          node = 2 * node;
          continue;
        }
      }
      node = next(node);
    } while (node != 1);
  }
}
