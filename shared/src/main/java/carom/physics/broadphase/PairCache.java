package carom.physics.broadphase;

import java.util.Arrays;

/**
 * The overlapping pairs of many boxes that move a little from tick to tick: a {@link KdTree} over
 * boxes that have room for some ticks of motion, and the list of its pairs.
 *
 * <p>While a box stays within its roomy one, no pair can come that isn't in the list; a tick then
 * is one stream over the boxes and one over the list. A box that left gets a new one, {@value
 * #TICKS} ticks ahead along its mean way since the last one, and is searched for; when more than
 * one in {@value #RENEW_SHARE} left, all are. So the answers are exact in every tick, most ticks
 * are cheap and one in some {@value #TICKS} is dear: look at the mean. The physics engine does the
 * same with its contacts. What moves several times its size in a tick is better off with the tree
 * alone.
 *
 * <p><b>Order, ownership, threads, cost, errors</b> as for every {@link SpatialIndex}; O(n + pairs)
 * in most ticks. Boxes are kept in the order of the tree, so that both streams are local.
 */
public final class PairCache {
  /** For how many ticks of motion a new roomy box has room. */
  static final int TICKS = 10;

  /** All boxes get new roomy ones when more than this fraction (1 / n) of them left theirs. */
  static final int RENEW_SHARE = 8;

  /** Room on each side in any case, in extents of the box. */
  private static final float MARGIN = 1 / 64f;

  /** Pairs tested before those that overlap are reported. */
  private static final int BATCH = 256;

  private AabbArray source = new AabbArray(0);
  private int size;

  /** By place: the id, the box as of the last refit, the roomy one, the box when that was made. */
  private int[] ids = new int[0];

  private final AabbArray boxes = new AabbArray(0);
  private final AabbArray roomy = new AabbArray(0);
  private final AabbArray start = new AabbArray(0);

  /** By place: when the roomy box was made. */
  private int[] since = new int[0];

  private int now;

  /** Over the roomy boxes, by place. */
  private final KdTree tree = new KdTree(roomy);

  /** Pairs of places whose roomy boxes overlap, each once. */
  private long[] pairs = new long[64];

  private int pairCount;

  /** Places that left their roomy boxes in this tick. */
  private int[] left = new int[0];

  private boolean[] isLeft = new boolean[0];
  private int leftCount;
  private int searched;
  private final int[] batch = new int[BATCH];
  private final PairVisitor onPair = this::append;
  private final IntVisitor onFound =
      place -> {
        if (place != searched && (!isLeft[place] || place > searched)) {
          append(searched, place);
        }
        return true;
      };

  /** Makes an empty cache. */
  public PairCache() {}

  /**
   * The number of boxes.
   *
   * @return the number of boxes
   */
  public int size() {
    return size;
  }

  /**
   * Forgets everything and takes these boxes.
   *
   * @param newBoxes the boxes, indexed by id; a reference is kept
   * @param newIds distinct ids, the first {@code count} entries are read
   * @param count number of ids, 0 or more
   * @throws IllegalArgumentException if count or an id is out of range, an id comes twice, or a box
   *     isn't finite with min &lt;= max; the cache is empty then
   */
  public void rebuild(AabbArray newBoxes, int[] newIds, int count) {
    size = 0;
    pairCount = 0;
    KdTree byId = new KdTree(newBoxes);
    byId.rebuild(newBoxes, newIds, count);
    source = newBoxes;
    ensure(count);
    size = byId.order(ids);
    now = 0;
    for (int place = 0; place < size; place++) {
      int id = ids[place];
      // adding zero turns -0 into +0, on which the sign tests of pairs() rely
      float minX = source.minX(id) + 0f;
      float minY = source.minY(id) + 0f;
      float maxX = source.maxX(id) + 0f;
      float maxY = source.maxY(id) + 0f;
      boxes.set(place, minX, minY, maxX, maxY);
      start.set(place, minX, minY, maxX, maxY);
      since[place] = 0;
      left[place] = place;
      renew(place);
    }
    tree.rebuild(roomy, left, size);
    tree.pairs(onPair);
  }

  /**
   * Takes over the boxes' new places: call once per tick, after they moved. O(n), every tenth time
   * or so with a search for all pairs.
   *
   * @throws IllegalArgumentException if a box isn't finite with min &lt;= max; the cache is empty
   *     then
   */
  public void refit() {
    now++;
    follow();
    if (leftCount == 0) {
      return;
    }
    if (leftCount > size / RENEW_SHARE) {
      for (int place = 0; place < size; place++) {
        renew(place);
      }
      tree.refit();
      pairCount = 0;
      tree.pairs(onPair);
      return;
    }
    for (int i = 0; i < leftCount; i++) {
      renew(left[i]);
      isLeft[left[i]] = true;
    }
    tree.refit(left, leftCount);
    dropPairsOfThoseThatLeft();
    for (int i = 0; i < leftCount; i++) {
      int p = left[i];
      searched = p;
      tree.query(roomy.minX(p), roomy.minY(p), roomy.maxX(p), roomy.maxY(p), onFound);
    }
    for (int i = 0; i < leftCount; i++) {
      isLeft[left[i]] = false;
    }
  }

  /** Copies the boxes, and lists those that left their roomy ones. */
  private void follow() {
    float[] from = source.edges;
    float[] to = boxes.edges;
    float[] room = roomy.edges;
    int out = 0;
    for (int place = 0; place < size; place++) {
      int f = 4 * ids[place];
      int t = 4 * place;
      float minX = from[f] + 0f;
      float minY = from[f + 1] + 0f;
      float maxX = from[f + 2] + 0f;
      float maxY = from[f + 3] + 0f;
      to[t] = minX;
      to[t + 1] = minY;
      to[t + 2] = maxX;
      to[t + 3] = maxY;
      boolean valid = minX <= maxX && minY <= maxY;
      if (!(valid
          && minX >= room[t]
          && minY >= room[t + 1]
          && maxX <= room[t + 2]
          && maxY <= room[t + 3])) {
        if (!AabbArray.valid(minX, minY, maxX, maxY)) {
          size = 0;
          pairCount = 0;
          throw source.invalid(ids[place]);
        }
        left[out++] = place;
      }
    }
    leftCount = out;
  }

  /** Makes a roomy box, ahead along the mean way since the last one. */
  private void renew(int place) {
    float minX = boxes.minX(place);
    float minY = boxes.minY(place);
    float maxX = boxes.maxX(place);
    float maxY = boxes.maxY(place);
    float ahead = (float) TICKS / Math.max(1, now - since[place]);
    float wayX = ahead * (minX - start.minX(place));
    float wayY = ahead * (minY - start.minY(place));
    float marginX = MARGIN * (maxX - minX);
    float marginY = MARGIN * (maxY - minY);
    float leftEdge = minX - marginX + Math.min(wayX, 0);
    float low = minY - marginY + Math.min(wayY, 0);
    float right = maxX + marginX + Math.max(wayX, 0);
    float high = maxY + marginY + Math.max(wayY, 0);
    if (AabbArray.valid(leftEdge, low, right, high)) {
      roomy.set(place, leftEdge, low, right, high);
    } else {
      roomy.set(place, minX, minY, maxX, maxY);
    }
    start.set(place, minX, minY, maxX, maxY);
    since[place] = now;
  }

  private void append(int p, int q) {
    if (pairCount == pairs.length) {
      pairs = Arrays.copyOf(pairs, pairCount + (pairCount >> 1));
    }
    pairs[pairCount++] = (long) p << 32 | q;
  }

  private void dropPairsOfThoseThatLeft() {
    int kept = 0;
    for (int i = 0; i < pairCount; i++) {
      long pair = pairs[i];
      pairs[kept] = pair;
      kept += isLeft[(int) (pair >>> 32)] || isLeft[(int) pair] ? 0 : 1;
    }
    pairCount = kept;
  }

  /**
   * Visits every unordered pair of overlapping boxes exactly once, with idA &lt; idB.
   *
   * @param visitor receives the pairs
   */
  public void pairs(PairVisitor visitor) {
    for (int from = 0; from < pairCount; from += BATCH) {
      int found = test(from, Math.min(from + BATCH, pairCount));
      for (int k = 0; k < found; k++) {
        long pair = pairs[batch[k]];
        int a = ids[(int) (pair >>> 32)];
        int b = ids[(int) pair];
        visitor.pair(Math.min(a, b), Math.max(a, b));
      }
    }
  }

  /** Lists which pairs of a range overlap now, without a branch; answers how many. */
  private int test(int from, int to) {
    float[] e = boxes.edges;
    int found = 0;
    for (int i = from; i < to; i++) {
      int p = 4 * (int) (pairs[i] >>> 32);
      int q = 4 * (int) pairs[i];
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

  private void ensure(int count) {
    if (count > ids.length) {
      ids = new int[count];
      since = new int[count];
      left = new int[count];
      isLeft = new boolean[count];
      boxes.ensureCapacity(count);
      roomy.ensureCapacity(count);
      start.ensureCapacity(count);
    }
  }
}
