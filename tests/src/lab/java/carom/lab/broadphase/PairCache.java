package carom.lab.broadphase;

import carom.physics.broadphase.AabbArray;
import carom.physics.broadphase.IntVisitor;
import carom.physics.broadphase.KdTree;
import carom.physics.broadphase.PairVisitor;

/**
 * A cache of the overlapping pairs of many boxes that move a little from tick to tick. It keeps two
 * lists of pairs that may overlap soon.
 *
 * <p>Every box has an <i>inner room</i> for some ticks of its motion, within an <i>outer room</i>
 * for several times as many. While all boxes stay within their inner rooms, every overlapping pair
 * is in the list of pairs whose inner rooms overlap. Such a tick is one pass over the boxes and one
 * over that list. When many boxes leave, all get new inner rooms, whose pairs are picked from the
 * list of the outer ones, which is cheap too. Only when many boxes leave their outer rooms does the
 * cache ask a {@link KdTree} for the pairs of new ones. So results are exact in every tick, most
 * ticks are cheap, and about one in forty is expensive: judge the cost by the mean. The method is
 * Verlet's neighbour lists (1967) in two levels, with room along the motion instead of on all
 * sides.
 *
 * <p>The number of ticks that rooms last for follows from the boxes' speed relative to their sizes,
 * so that the lists stay short. The few boxes that leave early, because they changed course, get
 * larger rooms one by one. When that makes a list about twice as long as when it was made, its
 * rooms are made anew. For boxes that move their own size in a tick, the tree alone is faster.
 *
 * <p><b>Order, ownership, threads, errors</b> as for every {@code SpatialIndex}. <b>Cost.</b> O(n +
 * pairs) in most ticks. Boxes are kept in the order of the tree, so that memory access is local.
 */
public final class PairCache {
  /** Mean distance that boxes move within their outer rooms, in extents of the box. */
  private static final float OUTER_WAY = 1.25f;

  /** Smallest and largest number of ticks that outer rooms last for. */
  private static final float LEAST_TICKS = 4;

  private static final float MOST_TICKS = 100;

  /** Number of successive inner rooms that one outer room lasts for. */
  private static final float INNER_PER_OUTER = 5;

  /**
   * Share (1 / n) of boxes above which, when they leave their inner rooms, all boxes get new ones.
   */
  private static final int INNER_SHARE = 32;

  /** Share (1 / n) of boxes above which, when they leave their outer rooms, all get new ones. */
  private static final int OUTER_SHARE = 4;

  /** Largest {@link #age}, in ticks. The mean motion over more ticks is practically zero. */
  private static final int OLDEST = 1 << 20;

  /** Smallest room on each side of a box, in extents of the box. */
  private static final float MARGIN = 1 / 64f;

  /** Number of boxes from which on the caller's array doesn't fit the nearest caches. */
  private static final int FAR = 200_000;

  /** Number of boxes fetched at once from far memory, a power of two. */
  private static final int AHEAD = 64;

  /** Number of pairs tested before those that overlap are reported. */
  private static final int BATCH = 256;

  private static final int INNER = 0;
  private static final int OUTER = 1;

  private final int far;
  private AabbArray source = new AabbArray(0);
  private int size;

  /** Id, box as of the last refit, and rooms, each indexed by place. */
  private int[] ids = new int[0];

  private AabbArray boxes = new AabbArray(0);
  private AabbArray inner = new AabbArray(0);
  private final AabbArray outer = new AabbArray(0);

  /**
   * Left and lower edge by place, as of when inner rooms were made. For a box that changed course,
   * they are where the edges would have been had it always moved as now.
   */
  private float[] start = new float[0];

  /** Ticks since inner rooms were made, {@link #OLDEST} at most. */
  private int age;

  /** Number of ticks that new rooms last for. */
  private float innerTicks;

  private float outerTicks;

  /** Tree over the outer rooms; its ids are places. */
  private final KdTree tree = new KdTree(outer);

  private final PairList innerPairs = new PairList();
  private final PairList outerPairs = new PairList();

  /** Largest length of each list, see {@link #limit}. */
  private int innerLimit;

  private int outerLimit;
  private final int[] batch = new int[BATCH];

  /** Places of the boxes that left a room in this tick, and their motion in it. */
  private int[] left = new int[0];

  private float[] leftWay = new float[0];
  private int leftCount;

  /**
   * Sum of what {@link #fetch} read. It is never used, but keeps the JIT from removing the reads.
   */
  @SuppressWarnings("UnusedVariable")
  private float fetched;

  /** Place of the box whose rooms are growing, and the rooms before they grew. */
  private int growing;

  private final AabbArray before = new AabbArray(2);
  private final int[] one = new int[1];
  private final IntVisitor onMet =
      place -> {
        meet(place);
        return true;
      };

  /** Scratch for an order of places, and for what is brought into that order. */
  private int[] order = new int[0];

  private int[] otherIds = new int[0];
  private float[] otherStart = new float[0];

  /** Makes an empty cache. */
  public PairCache() {
    this(FAR);
  }

  /** Makes an empty cache with another number of boxes from which on memory counts as far. */
  PairCache(int far) {
    this.far = far;
  }

  /**
   * Returns the number of boxes.
   *
   * @return the number of boxes
   */
  public int size() {
    return size;
  }

  /** Returns the number of pairs kept in both lists, a measure of memory and time. */
  int kept() {
    return innerPairs.count + outerPairs.count;
  }

  /**
   * Replaces all boxes by these.
   *
   * @param newBoxes the boxes, indexed by id; a reference is kept
   * @param newIds distinct ids, the first {@code count} entries are read
   * @param count number of ids, 0 or more
   * @throws IllegalArgumentException if count or an id is out of range, an id comes twice, or a box
   *     isn't finite with min &lt;= max; the cache is empty then
   */
  public void rebuild(AabbArray newBoxes, int[] newIds, int count) {
    forget();
    if (count < 0 || count > newIds.length) {
      throw new IllegalArgumentException("count=" + count + ", limit 0.." + newIds.length);
    }
    boolean[] seen = new boolean[newBoxes.capacity()];
    for (int i = 0; i < count; i++) {
      int id = newIds[i];
      newBoxes.check(id);
      if (seen[id]) {
        throw new IllegalArgumentException("id=" + id + " comes twice in ids, index=" + i);
      }
      seen[id] = true;
    }
    source = newBoxes;
    ensure(count);
    System.arraycopy(newIds, 0, ids, 0, count);
    size = count;
    age = 0;
    for (int place = 0; place < size; place++) {
      copy(source, ids[place], boxes, place);
      copy(source, ids[place], outer, place);
      order[place] = place;
      startAt(place, 0, 0);
    }
    tree.rebuild(outer, order, size);
    renewOuter();
  }

  /**
   * Updates the cache to the boxes' present edges. Call it once per tick, after they moved.
   *
   * @throws IllegalArgumentException if a box isn't finite with min &lt;= max; the cache is empty
   *     then
   */
  public void refit() {
    age = Math.min(age + 1, OLDEST);
    follow();
    if (leftCount > size / INNER_SHARE) {
      renewInner();
    } else if (!growAll() || outerPairs.count > outerLimit) {
      renewOuter();
    } else if (innerPairs.count > innerLimit) {
      renewInner();
    }
  }

  /** Copies the boxes, and lists those that left their inner rooms. */
  private void follow() {
    leftCount = 0;
    if (size < far) {
      follow(0, size);
      return;
    }
    fetched = fetch(0, Math.min(AHEAD, size));
    for (int from = 0; from < size; from += AHEAD) {
      int to = from + AHEAD;
      fetched += fetch(to, Math.min(to + AHEAD, size));
      follow(from, Math.min(to, size));
    }
  }

  /**
   * Reads one edge of some of the caller's boxes, so that they are in the cache when the other
   * edges are read. A loop this short waits for many of them at once.
   */
  private float fetch(int first, int end) {
    float sum = 0;
    for (int place = first; place < end; place++) {
      sum += source.edges[4 * ids[place]];
    }
    return sum;
  }

  private void follow(int first, int end) {
    float[] from = source.edges;
    float[] to = boxes.edges;
    float[] room = inner.edges;
    int out = leftCount;
    for (int place = first; place < end; place++) {
      int f = 4 * ids[place];
      int t = 4 * place;
      float minX = from[f] + 0f;
      float minY = from[f + 1] + 0f;
      float maxX = from[f + 2] + 0f;
      float maxY = from[f + 3] + 0f;
      if (!(minX <= maxX
          && minY <= maxY
          && minX >= room[t]
          && minY >= room[t + 1]
          && maxX <= room[t + 2]
          && maxY <= room[t + 3])) {
        if (!AabbArray.valid(minX, minY, maxX, maxY)) {
          IllegalArgumentException invalid = source.invalid(ids[place]);
          forget();
          throw invalid;
        }
        leftWay[2 * out] = minX - to[t];
        leftWay[2 * out + 1] = minY - to[t + 1];
        left[out++] = place;
      }
      to[t] = minX;
      to[t + 1] = minY;
      to[t + 2] = maxX;
      to[t + 3] = maxY;
    }
    leftCount = out;
  }

  // ---------------------------------------------------------------- all rooms

  /** Gives all boxes new inner rooms, and new outer rooms if many boxes left theirs. */
  private void renewInner() {
    float[] e = boxes.edges;
    float[] limit = outer.edges;
    float perTick = perTick();
    leftCount = 0;
    for (int place = 0; place < size; place++) {
      int at = 4 * place;
      if (e[at] < limit[at]
          || e[at + 1] < limit[at + 1]
          || e[at + 2] > limit[at + 2]
          || e[at + 3] > limit[at + 3]) {
        leftWay[2 * leftCount] = perTick * (e[at] - start[2 * place]);
        leftWay[2 * leftCount + 1] = perTick * (e[at + 1] - start[2 * place + 1]);
        left[leftCount++] = place;
      }
    }
    if (leftCount <= size / OUTER_SHARE && growAll() && outerPairs.count <= outerLimit) {
      pickInner();
    } else {
      renewOuter();
    }
  }

  /** Makes all rooms anew. */
  private void renewOuter() {
    float[] e = boxes.edges;
    double way = 0;
    double extent = 0;
    for (int place = 0; place < size; place++) {
      int at = 4 * place;
      way += Math.abs(e[at] - start[2 * place]) + Math.abs(e[at + 1] - start[2 * place + 1]);
      extent += e[at + 2] - e[at] + (e[at + 3] - e[at + 1]);
    }
    double ticks = OUTER_WAY * extent / (way * perTick());
    outerTicks = ticks > LEAST_TICKS ? (float) Math.min(ticks, MOST_TICKS) : LEAST_TICKS;
    innerTicks = Math.max(1, outerTicks / INNER_PER_OUTER);
    setRooms(outer, outerTicks);
    tree.refit();
    permute();
    setRooms(outer, outerTicks);
    outerPairs.clear();
    tree.pairs(outerPairs);
    outerLimit = limit(outerPairs);
    pickInner();
  }

  /** Sorts all places into the order of the tree. */
  private void permute() {
    tree.number(order);
    float[] from = boxes.edges;
    float[] to = inner.edges;
    for (int place = 0; place < size; place++) {
      int old = order[place];
      to[4 * place] = from[4 * old];
      to[4 * place + 1] = from[4 * old + 1];
      to[4 * place + 2] = from[4 * old + 2];
      to[4 * place + 3] = from[4 * old + 3];
      otherIds[place] = ids[old];
      otherStart[2 * place] = start[2 * old];
      otherStart[2 * place + 1] = start[2 * old + 1];
    }
    AabbArray swapBoxes = boxes;
    boxes = inner;
    inner = swapBoxes;
    int[] swapIds = ids;
    ids = otherIds;
    otherIds = swapIds;
    float[] swapStart = start;
    start = otherStart;
    otherStart = swapStart;
  }

  /** Makes all inner rooms anew, within the outer ones, and the list of their pairs. */
  private void pickInner() {
    setRooms(inner, innerTicks);
    float[] e = boxes.edges;
    float[] room = inner.edges;
    float[] limit = outer.edges;
    for (int place = 0; place < size; place++) {
      int at = 4 * place;
      if (room[at] < limit[at]) {
        room[at] = limit[at];
      }
      if (room[at + 1] < limit[at + 1]) {
        room[at + 1] = limit[at + 1];
      }
      if (room[at + 2] > limit[at + 2]) {
        room[at + 2] = limit[at + 2];
      }
      if (room[at + 3] > limit[at + 3]) {
        room[at + 3] = limit[at + 3];
      }
      start[2 * place] = e[at];
      start[2 * place + 1] = e[at + 1];
    }
    age = 0;
    innerPairs.clear();
    for (int from = 0; from < outerPairs.count; from += BATCH) {
      int found = test(room, outerPairs, from);
      innerPairs.addFrom(outerPairs, batch, found);
    }
    innerLimit = limit(innerPairs);
  }

  /**
   * Returns the length to which a list that was just made may grow before all its rooms are made
   * anew. Without a limit, a box that flies about among resting ones would some day have a pair
   * with each of them.
   */
  private int limit(PairList made) {
    return (int) Math.min(Integer.MAX_VALUE, 2L * made.count + size);
  }

  /** Returns 1 divided by the ticks since inner rooms were made. */
  private float perTick() {
    return 1f / Math.max(1, age);
  }

  /** Makes rooms for some ticks ahead along the boxes' mean motion since inner rooms were made. */
  private void setRooms(AabbArray rooms, float ticks) {
    float[] e = boxes.edges;
    float[] s = start;
    float ahead = ticks * perTick();
    for (int place = 0; place < size; place++) {
      float wayX = ahead * (e[4 * place] - s[2 * place]);
      float wayY = ahead * (e[4 * place + 1] - s[2 * place + 1]);
      setRoom(e, rooms.edges, 4 * place, wayX, wayY);
    }
  }

  /** Makes a room around a box and the same box moved by a way. */
  private static void setRoom(float[] e, float[] room, int at, float wayX, float wayY) {
    float minX = e[at];
    float minY = e[at + 1];
    float maxX = e[at + 2];
    float maxY = e[at + 3];
    float marginX = MARGIN * (maxX - minX);
    float marginY = MARGIN * (maxY - minY);
    float leftEdge = minX - marginX + negative(wayX);
    float low = minY - marginY + negative(wayY);
    float right = maxX + marginX + positive(wayX);
    float high = maxY + marginY + positive(wayY);
    boolean valid = AabbArray.valid(leftEdge, low, right, high);
    room[at] = valid ? leftEdge : minX;
    room[at + 1] = valid ? low : minY;
    room[at + 2] = valid ? right : maxX;
    room[at + 3] = valid ? high : maxY;
  }

  /**
   * Returns the smaller of x and 0. It has no branch, because the signs of ways are unpredictable.
   */
  private static float negative(float x) {
    int bits = Float.floatToRawIntBits(x);
    return Float.intBitsToFloat(bits & bits >> 31);
  }

  /** Returns the larger of x and 0. */
  private static float positive(float x) {
    int bits = Float.floatToRawIntBits(x);
    return Float.intBitsToFloat(bits & ~(bits >> 31));
  }

  // ---------------------------------------------------------------- one by one

  /**
   * Makes the rooms of all boxes that left theirs larger. Returns false if all rooms must be made
   * anew.
   */
  private boolean growAll() {
    for (int i = 0; i < leftCount; i++) {
      if (!grow(left[i], leftWay[2 * i], leftWay[2 * i + 1])) {
        return false;
      }
    }
    return true;
  }

  /**
   * Makes the rooms of a box that left one larger, so that the pairs in the lists stay valid, and
   * adds its new pairs. Returns false if the room is too large for a float.
   */
  private boolean grow(int place, float wayX, float wayY) {
    growing = place;
    copy(inner, place, before, INNER);
    copy(outer, place, before, OUTER);
    setRoom(boxes.edges, inner.edges, 4 * place, innerTicks * wayX, innerTicks * wayY);
    unite(inner, place, before, INNER);
    AabbArray reach = inner;
    if (!outer.contains(
        place, inner.minX(place), inner.minY(place), inner.maxX(place), inner.maxY(place))) {
      setRoom(boxes.edges, outer.edges, 4 * place, outerTicks * wayX, outerTicks * wayY);
      unite(outer, place, before, OUTER);
      unite(outer, place, inner, place);
      reach = outer;
      if (!AabbArray.valid(
          outer.minX(place), outer.minY(place), outer.maxX(place), outer.maxY(place))) {
        return false;
      }
      one[0] = place;
      tree.refit(one, 1);
    }
    startAt(place, wayX, wayY);
    tree.query(reach.minX(place), reach.minY(place), reach.maxX(place), reach.maxY(place), onMet);
    return true;
  }

  /** Sets the mean motion of a box, per tick. */
  private void startAt(int place, float wayX, float wayY) {
    start[2 * place] = boxes.minX(place) - age * wayX;
    start[2 * place + 1] = boxes.minY(place) - age * wayY;
  }

  /** Adds the pair of the growing box and another one to each list whose rooms overlap only now. */
  private void meet(int place) {
    if (place == growing) {
      return;
    }
    if (!overlap(before, OUTER, outer, place)) {
      outerPairs.pair(place, growing);
    }
    if (overlap(inner, growing, inner, place) && !overlap(before, INNER, inner, place)) {
      innerPairs.pair(place, growing);
    }
  }

  private static boolean overlap(AabbArray a, int i, AabbArray b, int k) {
    return b.overlaps(k, a.minX(i), a.minY(i), a.maxX(i), a.maxY(i));
  }

  /** Copies a box. Adding zero turns -0 into +0, on which the sign tests of pairs rely. */
  private static void copy(AabbArray from, int i, AabbArray to, int k) {
    to.set(k, from.minX(i) + 0f, from.minY(i) + 0f, from.maxX(i) + 0f, from.maxY(i) + 0f);
  }

  private static void unite(AabbArray rooms, int place, AabbArray b, int i) {
    rooms.set(
        place,
        Math.min(rooms.minX(place), b.minX(i)),
        Math.min(rooms.minY(place), b.minY(i)),
        Math.max(rooms.maxX(place), b.maxX(i)),
        Math.max(rooms.maxY(place), b.maxY(i)));
  }

  // ---------------------------------------------------------------- pairs

  /**
   * Visits every unordered pair of overlapping boxes exactly once, with idA &lt; idB.
   *
   * @param visitor receives the pairs
   */
  public void pairs(PairVisitor visitor) {
    long[] list = innerPairs.list;
    for (int from = 0; from < innerPairs.count; from += BATCH) {
      int found = test(boxes.edges, innerPairs, from);
      for (int k = 0; k < found; k++) {
        long pair = list[batch[k]];
        int a = ids[(int) (pair >>> 32)];
        int b = ids[(int) pair];
        visitor.pair(Math.min(a, b), Math.max(a, b));
      }
    }
  }

  /** Lists which pairs of a batch overlap, without a branch, and returns how many. */
  private int test(float[] e, PairList pairs, int from) {
    long[] list = pairs.list;
    int to = Math.min(from + BATCH, pairs.count);
    int found = 0;
    for (int i = from; i < to; i++) {
      int p = 4 * (int) (list[i] >>> 32);
      int q = 4 * (int) list[i];
      batch[found] = i;
      int apart =
          Float.floatToRawIntBits(e[q + 2] - e[p])
              | Float.floatToRawIntBits(e[p + 2] - e[q])
              | Float.floatToRawIntBits(e[q + 3] - e[p + 1])
              | Float.floatToRawIntBits(e[p + 3] - e[q + 1]);
      found += 1 + (apart >> 31);
    }
    return found;
  }

  // ---------------------------------------------------------------- memory

  private void forget() {
    size = 0;
    leftCount = 0;
    innerPairs.clear();
    outerPairs.clear();
  }

  private void ensure(int count) {
    if (count > ids.length) {
      ids = new int[count];
      otherIds = new int[count];
      order = new int[count];
      left = new int[count];
      leftWay = new float[2 * count];
      start = new float[2 * count];
      otherStart = new float[2 * count];
      boxes.ensureCapacity(count);
      inner.ensureCapacity(count);
      outer.ensureCapacity(count);
    }
  }
}
