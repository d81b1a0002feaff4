package carom.physics.dynamics.pairs;

import carom.physics.broadphase.AabbArray;
import carom.physics.broadphase.IntVisitor;
import carom.physics.broadphase.KdRefit;
import carom.physics.broadphase.KdTree;
import carom.physics.broadphase.PairSearch;
import carom.physics.broadphase.PairVisitor;
import carom.physics.dynamics.body.ActiveBodies;
import carom.physics.dynamics.body.BodyStore;
import carom.physics.dynamics.body.Settings;
import carom.physics.dynamics.body.ShapeTable;
import carom.physics.dynamics.contact.ContactKey;
import carom.physics.dynamics.contact.ContactTable;
import carom.physics.dynamics.parallel.ParallelFor;
import carom.physics.dynamics.store.KeySorter;
import carom.physics.math.Aabb;
import carom.physics.math.Transform;
import java.util.Arrays;

/**
 * The first stages of a step: keeps the fat boxes of all parts, and has a row in the contact table
 * for every pair whose boxes overlap and of which one body is awake.
 *
 * <p>There are two trees, one for the parts of active bodies and one for those of static and
 * sleeping bodies. Only pairs with a part that got a new box since the last search are searched, so
 * what is quiet costs nothing. Pairs are handed to the contact table in the order of their keys;
 * which of them were found when never shows in a result.
 */
public final class PairFinder {
  private static final int FIRST_CAPACITY = 64;

  /** More pairs than this per awake body are a crowd. */
  private static final int CROWDED = 2;

  /** For how many ticks fat boxes are meant to last where pairs are few. */
  private static final int SPARSE_TICKS = 12;

  /** In as many steps each branch of the tree has its turn once; some fewer than boxes last. */
  private static final int TURNS = 10;

  /** With fewer parts all may get new boxes in one step: dear, but not long. */
  private static final int LONG_STEP = 4_096;

  /** When more than this fraction (1 / n) of the parts left their fat boxes, all get new ones. */
  private static final int RENEW_SHARE = 4;

  /** Up to this fraction (1 / n) of moved parts, each is searched for itself. */
  private static final int SEARCH_SHARE = 16;

  /** Bodies whose boxes make a piece of work for a worker. */
  private static final int GRAIN = 64;

  /** Sorting fewer candidates isn't worth sharing. */
  private static final int FEWEST_TO_SHARE = 2_048;

  /** Moved parts that make a piece of work, and with too few of which threads don't search. */
  private static final int SEARCH_GRAIN = 32;

  /** Relative rounding of the edges of a box, as far from the origin as it is. */
  private static final float ROUNDING = 0x1p-22f;

  private final Settings settings;
  private final BodyStore bodies;
  private final ShapeTable parts;
  private final ContactTable contacts;
  private final PairRule rule;

  private final ParallelFor parallel;
  private Desk[] desks = {new Desk()};

  /** What one worker needs to measure boxes and to collect candidates. */
  private final class Desk implements PairVisitor, IntVisitor {
    private final Transform pose = new Transform();
    private final Aabb box = new Aabb();

    /** Keys of pairs that it found. */
    private long[] candidates = new long[FIRST_CAPACITY];

    private int count;

    /** Those that this worker sorts for all. */
    private long[] share = new long[FIRST_CAPACITY];

    private int shareCount;
    private final KeySorter sorter = new KeySorter();

    /** The part that is searched for itself. */
    private int around;

    @Override
    public void pair(int p, int q) {
      long key = candidate(p, q);
      if (key >= 0) {
        reserve(count + 1);
        candidates[count++] = key;
      }
    }

    @Override
    public boolean visit(int found) {
      pair(around, found);
      return true;
    }

    private void reserve(int room) {
      if (room > candidates.length) {
        candidates = Arrays.copyOf(candidates, Math.max(room, 2 * candidates.length));
      }
    }

    /**
     * Takes the keys of a range that all found, in order. Without a branch, as ranges are found in
     * any order.
     */
    private void sortRange(long from, long to) {
      int n = 0;
      for (Desk desk : desks) {
        for (int i = 0; i < desk.count; i++) {
          long key = desk.candidates[i];
          share[n] = key;
          n += (int) ((~(key - from) & (key - to)) >>> Long.SIZE - 1);
        }
      }
      shareCount = n;
      share = sorter.sort(share, n);
    }
  }

  /**
   * While boxes are refreshed: the bodies of which a part left its fat box, those that one piece of
   * work found from its first place on; per piece, by that place, its end and how many it found.
   */
  private int[] strayed = new int[FIRST_CAPACITY];

  private int[] pieceEnd = new int[FIRST_CAPACITY];
  private int[] pieceFound = new int[FIRST_CAPACITY];

  /** Which branch of the tree had its turn last. */
  private int turn;

  private ActiveBodies refreshed;
  private float lastStep;
  private final ParallelFor.Range measuring = this::measureBodies;
  private final ParallelFor.Range renewing = this::renewParts;

  /** Parts of active bodies, and of those that are static or sleep. */
  private final KdTree moving;

  private final KdTree resting;

  /** Whether boxes in the moving tree changed since it was refitted. */
  private boolean movingStale;

  /** Whether poses changed since fat boxes were refreshed. */
  private boolean boxesStale;

  /** Whether all pairs must be searched, for instance because a static body is new. */
  private boolean searchAll;

  /** Parts that are in no tree yet, though their bodies take part. */
  private int[] newParts = new int[FIRST_CAPACITY];

  private int newCount;

  /** Parts that got another box since pairs were searched. */
  private int[] movedParts = new int[FIRST_CAPACITY];

  private int movedCount;

  /** How many of them got it together with their neighbours. */
  private int togetherCount;

  /** Scratch: parts that go from one tree to the other. */
  private int[] partList = new int[FIRST_CAPACITY];

  private int partListCount;

  private final PairSearch search;
  private final KdRefit refitting;
  private final ParallelFor.Range reading = this::readPieces;
  private final ParallelFor.Range routing = this::routePieces;

  /** The pairs to have rows, by ascending key. */
  private long[] candidates = new long[FIRST_CAPACITY];

  private int candidateCount;
  private final KeySorter sorter = new KeySorter();

  /** By how many workers they are sorted. */
  private int ranges;

  private final ParallelFor.Range sorting = this::sortShares;

  /** Whether parts in the moving tree are searched for each by itself, unless with neighbours. */
  private boolean each;

  private final ParallelFor.Range searching = this::searchPieces;
  private final ParallelFor.Range searchingAround = this::searchAround;

  public PairFinder(
      Settings settings,
      BodyStore bodies,
      ShapeTable parts,
      ContactTable contacts,
      PairRule rule,
      ParallelFor parallel) {
    this.parallel = parallel;
    this.settings = settings;
    this.bodies = bodies;
    this.parts = parts;
    this.contacts = contacts;
    this.rule = rule;
    moving = new KdTree(parts.fat);
    resting = new KdTree(parts.fat);
    search = new PairSearch(moving, resting);
    refitting = moving.refitting();
  }

  // ---------------------------------------------------------------- who takes part

  /** Takes a body in, where it is now: among the active ones unless it is static or sleeps. */
  public void enter(int body) {
    boolean rests = rests(body);
    int first = bodies.firstPart[body];
    for (int part = first; part < first + bodies.partCount[body]; part++) {
      if (rests) {
        restingBox(body, part);
      } else {
        parts.fat.set(part, bodies.x[body], bodies.y[body], bodies.x[body], bodies.y[body]);
      }
      expect(part);
    }
    searchAll |= bodies.type[body] == BodyStore.STATIC;
    boxesStale = true;
  }

  /** Takes a body out. */
  public void leave(int body) {
    int first = bodies.firstPart[body];
    for (int part = first; part < first + bodies.partCount[body]; part++) {
      if (!moving.remove(part)) {
        resting.remove(part);
      }
    }
  }

  /** Must be called when a static body was put elsewhere. */
  public void movedStatic(int body) {
    int first = bodies.firstPart[body];
    for (int part = first; part < first + bodies.partCount[body]; part++) {
      resting.remove(part);
      restingBox(body, part);
      expect(part);
    }
    searchAll = true;
  }

  /** Takes everything out. */
  public void clear() {
    movedCount = 0;
    togetherCount = 0;
    for (int i = 0; i < newCount; i++) {
      parts.expected[newParts[i]] = false;
    }
    newCount = 0;
    moving.clear();
    resting.clear();
  }

  /** Must be called after active bodies fell asleep; {@link #admit} before they did. */
  public void rest(int[] which, int count) {
    listParts(which, count);
    moving.removeAll(partList, partListCount);
    Desk desk = desks[0];
    for (int i = 0; i < count; i++) {
      place(which[i], desk.pose);
      int first = bodies.firstPart[which[i]];
      for (int part = first; part < first + bodies.partCount[which[i]]; part++) {
        measure(part, desk);
        if (!holds(part)) {
          fatten(part, settings.aabbMargin(), 0, 0);
          markMoved(part);
        }
      }
    }
    resting.addAll(partList, partListCount);
  }

  /** Must be called after sleeping bodies woke; {@link #admit} before they did. */
  public void wake(int[] which, int count) {
    listParts(which, count);
    resting.removeAll(partList, partListCount);
    moving.addAll(partList, partListCount);
    for (int i = 0; i < partListCount; i++) {
      markMoved(partList[i]);
    }
    boxesStale = true;
  }

  private boolean rests(int body) {
    return bodies.type[body] == BodyStore.STATIC || bodies.asleep(body);
  }

  private void restingBox(int body, int part) {
    place(body, desks[0].pose);
    measure(part, desks[0]);
    fatten(part, 0, 0, 0);
  }

  /** Has a part put into its tree before one is used, so that crowds come at once. */
  private void expect(int part) {
    if (parts.expected[part]) {
      return;
    }
    parts.expected[part] = true;
    if (newCount == newParts.length) {
      newParts = Arrays.copyOf(newParts, newCount * 2);
    }
    newParts[newCount++] = part;
  }

  /** Puts the parts that came into the trees. */
  public void admit() {
    if (newCount > 0) {
      admit(moving, false);
      admit(resting, true);
      newCount = 0;
    }
  }

  private void admit(KdTree tree, boolean restingOnes) {
    int others = 0;
    partListCount = 0;
    for (int i = 0; i < newCount; i++) {
      int part = newParts[i];
      int body = parts.body[part];
      if (body < 0 || bodies.disabled(body)) {
        parts.expected[part] = false;
      } else if (rests(body) != restingOnes) {
        newParts[others++] = part;
      } else {
        parts.expected[part] = false;
        listPart(part);
      }
    }
    newCount = others;
    tree.addAll(partList, partListCount);
  }

  private void listParts(int[] which, int count) {
    partListCount = 0;
    for (int i = 0; i < count; i++) {
      int first = bodies.firstPart[which[i]];
      for (int part = first; part < first + bodies.partCount[which[i]]; part++) {
        listPart(part);
      }
    }
  }

  private void listPart(int part) {
    if (partListCount == partList.length) {
      partList = Arrays.copyOf(partList, partListCount * 2);
    }
    partList[partListCount++] = part;
  }

  // ---------------------------------------------------------------- boxes

  /** Must be called when poses changed. */
  public void posesChanged() {
    boxesStale = true;
  }

  /** Must be called when pairs may be missing of which no part moved. */
  public void searchAll() {
    searchAll = true;
  }

  /**
   * Gives every part of an active body whose fat box no longer contains it a new one. When many
   * left theirs at once, all get new ones; where pairs are few, a share of the others gets them
   * before they leave, so that the next search is some ticks away for all of these.
   *
   * @param dt length of the last step, s
   */
  public void refresh(ActiveBodies active, float dt) {
    if (!boxesStale) {
      return;
    }
    boxesStale = false;
    lastStep = dt;
    measure(active);
    listStrayed();
    boolean many = partListCount > moving.size() / RENEW_SHARE;
    if (many) {
      listParts(active.list, active.count);
    }
    for (int i = 0; i < partListCount; i++) {
      markMoved(partList[i]);
    }
    parallel.run(0, partListCount, GRAIN, renewing);
    movingStale |= partListCount > 0;
    if (!many && moving.size() >= LONG_STEP && isSparse(active.count)) {
      renewInTurn();
    }
  }

  /** Lists the parts that left their fat boxes, in the order of the active bodies. */
  private void listStrayed() {
    partListCount = 0;
    int end;
    for (int from = 0; from < refreshed.count; from = end) {
      int piece = from / GRAIN;
      end = pieceEnd[piece];
      for (int i = from; i < from + pieceFound[piece]; i++) {
        int first = bodies.firstPart[strayed[i]];
        int parts = bodies.partCount[strayed[i]];
        for (int part = first; part < first + parts; part++) {
          if (parts == 1 || !holds(part)) {
            listPart(part);
          }
        }
      }
    }
  }

  private void renewParts(int from, int to, int worker) {
    for (int i = from; i < to; i++) {
      renew(partList[i]);
    }
  }

  /**
   * Renews, in the next branch of the tree, the boxes that wouldn't last until it is its turn
   * again. So the work is spread over the steps, and what is searched in one of them is in one
   * place.
   */
  private void renewInTurn() {
    if (partList.length < moving.size()) {
      partList = new int[2 * moving.size()];
    }
    turn = (turn + 1) % TURNS;
    int count = moving.slice(turn, TURNS, partList);
    AabbArray t = parts.tight;
    for (int i = 0; i < count; i++) {
      int part = partList[i];
      int body = parts.body[part];
      float wayX = TURNS * lastStep * bodies.vx[body];
      float wayY = TURNS * lastStep * bodies.vy[body];
      if (!parts.fat.contains(
          part,
          t.minX(part) + wayX,
          t.minY(part) + wayY,
          t.maxX(part) + wayX,
          t.maxY(part) + wayY)) {
        markMoved(part);
        renew(part);
        togetherCount += parts.together[part] ? 0 : 1;
        parts.together[part] = true;
        movingStale = true;
      }
    }
  }

  /** How many parts active bodies have, once they were searched. */
  public int movingParts() {
    return moving.size();
  }

  /**
   * Lists the active bodies, near ones near each other, each as often as it has parts.
   *
   * @param out receives {@link #movingParts} slots
   * @return how many
   */
  public int listBodies(int[] out) {
    int n = moving.slice(0, 1, out);
    for (int i = 0; i < n; i++) {
      out[i] = parts.body[out[i]];
    }
    return n;
  }

  /** Whether there are so few pairs that roomy boxes spare more searches than they make rows. */
  private boolean isSparse(int activeCount) {
    return 2 * contacts.count() <= activeCount;
  }

  /** Measures the parts of all active bodies, and finds out which bodies strayed. */
  private void measure(ActiveBodies active) {
    if (strayed.length < active.count) {
      strayed = new int[active.list.length];
      pieceEnd = new int[strayed.length / GRAIN + 1];
      pieceFound = new int[pieceEnd.length];
    }
    furnish();
    refreshed = active;
    parallel.run(0, active.count, GRAIN, measuring);
  }

  /** Has a desk for each worker. */
  private void furnish() {
    int old = desks.length;
    if (old < parallel.count()) {
      desks = Arrays.copyOf(desks, parallel.count());
      for (int i = old; i < desks.length; i++) {
        desks[i] = new Desk();
      }
    }
  }

  /** Lists who strayed without a branch, as that is not to be foreseen. */
  private void measureBodies(int from, int to, int worker) {
    Desk desk = desks[worker];
    int found = from;
    for (int i = from; i < to; i++) {
      int body = refreshed.list[i];
      place(body, desk.pose);
      int first = bodies.firstPart[body];
      int end = first + bodies.partCount[body];
      boolean hold = true;
      for (int part = first; part < end; part++) {
        measure(part, desk);
        hold &= holds(part);
      }
      strayed[found] = body;
      found += hold ? 0 : 1;
    }
    pieceEnd[from / GRAIN] = to;
    pieceFound[from / GRAIN] = found - from;
  }

  private void place(int body, Transform pose) {
    pose.set(bodies.x[body], bodies.y[body], bodies.cos[body], bodies.sin[body]);
  }

  /** Measures the tight box of a part at the desk's pose. */
  private void measure(int part, Desk desk) {
    Transform pose = desk.pose;
    Aabb box = desk.box;
    parts.convex[part].aabb(pose, box);
    float reach = 0.5f * settings.speculativeDistance();
    reach += ROUNDING * (Math.abs(pose.x) + Math.abs(pose.y));
    parts.tight.set(part, box.minX - reach, box.minY - reach, box.maxX + reach, box.maxY + reach);
  }

  /** Whether a part's fat box still contains its tight one. */
  private boolean holds(int part) {
    AabbArray t = parts.tight;
    return parts.fat.contains(part, t.minX(part), t.minY(part), t.maxX(part), t.maxY(part));
  }

  /**
   * Gives a part a new fat box around its tight one, for some ticks of motion. Where there are few
   * pairs a roomy box spares searches; in a crowd a needless pair costs more than a search, so the
   * boxes of what moves fast are hardly larger than it.
   */
  private void renew(int part) {
    int body = parts.body[part];
    float wayX = lastStep * bodies.vx[body];
    float wayY = lastStep * bodies.vy[body];
    int activeCount = refreshed.count;
    int pairs = contacts.count();
    float margin = settings.aabbMargin();
    float ticks = SPARSE_TICKS;
    if (pairs > CROWDED * activeCount) {
      margin = Math.abs(wayX) + Math.abs(wayY) > margin ? 0 : margin;
      ticks = 0;
    } else if (!isSparse(activeCount)) {
      ticks = 1;
    }
    fatten(part, margin, ticks * wayX, ticks * wayY);
  }

  /** Sets a part's fat box: the tight one with a margin, and room for a way. */
  private void fatten(int part, float margin, float wayX, float wayY) {
    AabbArray tight = parts.tight;
    parts.fat.set(
        part,
        tight.minX(part) - margin + Math.min(wayX, 0),
        tight.minY(part) - margin + Math.min(wayY, 0),
        tight.maxX(part) + margin + Math.max(wayX, 0),
        tight.maxY(part) + margin + Math.max(wayY, 0));
  }

  /** Has the pairs of all parts of a body searched in the next step. */
  public void searchBody(int body) {
    int first = bodies.firstPart[body];
    for (int part = first; part < first + bodies.partCount[body]; part++) {
      markMoved(part);
    }
  }

  private void markMoved(int part) {
    if (parts.moved[part]) {
      return;
    }
    parts.moved[part] = true;
    if (movedCount == movedParts.length) {
      movedParts = Arrays.copyOf(movedParts, Math.max(parts.moved.length, movedCount * 2));
    }
    movedParts[movedCount++] = part;
  }

  /** Makes the fat box of a moving part contain another box, too. */
  public void cover(int part, Aabb other) {
    AabbArray fat = parts.fat;
    if (!fat.contains(part, other.minX, other.minY, other.maxX, other.maxY)) {
      fat.set(
          part,
          Math.min(fat.minX(part), other.minX),
          Math.min(fat.minY(part), other.minY),
          Math.max(fat.maxX(part), other.maxX),
          Math.max(fat.maxY(part), other.maxY));
      movingStale = true;
      markMoved(part);
    }
  }

  /** The tight box of a part, at the pose of its body now. */
  public void tightBox(int part, Aabb out) {
    place(parts.body[part], desks[0].pose);
    parts.convex[part].aabb(desks[0].pose, out);
  }

  // ---------------------------------------------------------------- pairs

  /** Whether filters, joints and types let two parts touch. */
  public boolean mayTouch(int p, int q) {
    int a = parts.body[p];
    int b = parts.body[q];
    return (bodies.invMass[a] != 0 || bodies.invMass[b] != 0)
        && parts.meet(p, q)
        && rule.mayTouch(a, b);
  }

  /** Whether a row's parts still may touch: after bodies, filters or joints changed. */
  public boolean mayStay(ContactTable rows, int row) {
    int p = rows.partA(row);
    int q = rows.partB(row);
    boolean gone = bodies.disabled(parts.body[p]) || bodies.disabled(parts.body[q]);
    return !gone && mayTouch(p, q);
  }

  /** Brings the trees up to the fat boxes. */
  public void refit() {
    admit();
    if (!movingStale) {
      return;
    }
    movingStale = false;
    if (!moving.isMost(movedCount)) {
      moving.refit(movedParts, movedCount);
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

  /** Brings the contact table's rows up to the fat boxes. */
  public void find() {
    if (movedCount == 0 && !searchAll) {
      return;
    }
    refit();
    furnish();
    for (Desk desk : desks) {
      desk.count = 0;
      desk.reserve(candidates.length); // who finds how many is chance, to grow by it isn't
    }
    each = !searchAll && movedCount - togetherCount <= moving.size() / SEARCH_SHARE;
    if (!each || togetherCount > 0) {
      searchTrees();
    }
    if (!searchAll) {
      parallel.run(0, movedCount, SEARCH_GRAIN, searchingAround);
    }
    sortCandidates();
    contacts.merge(candidates, candidateCount, bodies, parts, searchAll, parallel);
    for (int i = 0; i < movedCount; i++) {
      parts.moved[movedParts[i]] = false;
      parts.together[movedParts[i]] = false;
    }
    togetherCount = 0;
    movedCount = 0;
    searchAll = false;
  }

  /**
   * Brings together what the desks found. Each worker sorts the keys of a range; that ranges be
   * about as long, they end where shares of the rows do that are there already.
   */
  private void sortCandidates() {
    int sum = 0;
    for (Desk desk : desks) {
      sum += desk.count;
    }
    if (candidates.length <= sum) { // there is always one to spare, see sortRange
      candidates = new long[2 * Integer.highestOneBit(sum)];
    }
    candidateCount = 0;
    ranges = sum < FEWEST_TO_SHARE ? 1 : desks.length;
    if (ranges == 1) {
      for (Desk desk : desks) {
        append(desk.candidates, desk.count);
      }
      candidates = sorter.sort(candidates, candidateCount);
      return;
    }
    for (Desk desk : desks) {
      if (desk.share.length < candidates.length) {
        desk.share = new long[candidates.length];
      }
    }
    parallel.each(ranges, sorting);
    for (Desk desk : desks) {
      append(desk.share, desk.shareCount);
    }
  }

  private void append(long[] keys, int count) {
    System.arraycopy(keys, 0, candidates, candidateCount, count);
    candidateCount += count;
  }

  private void sortShares(int from, int to, int worker) {
    for (int range = from; range < to; range++) {
      desks[range].sortRange(rangeStart(range), rangeStart(range + 1));
    }
  }

  /** The least key of a range, and behind the last one of all. */
  private long rangeStart(int range) {
    if (range == 0) {
      return 0;
    }
    int rows = contacts.count();
    return range == ranges || rows == 0
        ? Long.MAX_VALUE
        : contacts.key[(int) ((long) rows * range / ranges)];
  }

  /** Walks the trees where boxes are marked, or everywhere. */
  private void searchTrees() {
    boolean[] marked = searchAll ? null : each ? parts.together : parts.moved;
    int searched = searchAll ? moving.size() : each ? togetherCount : movedCount;
    try {
      int pieces =
          search.begin(marked, parallel.shares(searched, SEARCH_GRAIN) ? parallel.count() : 1);
      parallel.run(0, pieces, 1, searching);
    } finally {
      search.end();
    }
  }

  private void searchPieces(int from, int to, int worker) {
    for (int piece = from; piece < to; piece++) {
      search.run(piece, worker, desks[worker]);
    }
  }

  /**
   * Finds what the fat boxes of moved parts overlap that the walk of the trees leaves out; two
   * parts that rest needn't find each other.
   */
  private void searchAround(int from, int to, int worker) {
    Desk desk = desks[worker];
    AabbArray fat = parts.fat;
    for (int i = from; i < to; i++) {
      int part = movedParts[i];
      boolean moves = moving.contains(part);
      boolean searched = !each || parts.together[part];
      if ((searched || !moves) && !resting.contains(part)) {
        continue;
      }
      desk.around = part;
      float minX = fat.minX(part);
      float minY = fat.minY(part);
      float maxX = fat.maxX(part);
      float maxY = fat.maxY(part);
      moving.query(minX, minY, maxX, maxY, desk);
      if (moves) {
        resting.query(minX, minY, maxX, maxY, desk);
      }
    }
  }

  /** The key of a pair that needs a row, or -1. Only reads. */
  private long candidate(int p, int q) {
    if (!searchAll && !parts.moved[p] && !parts.moved[q]) {
      return -1;
    }
    int a = parts.body[p];
    int b = parts.body[q];
    if (a == b || !mayTouch(p, q)) {
      return -1;
    }
    return a < b
        ? ContactKey.of(a, p - bodies.firstPart[a], b, q - bodies.firstPart[b])
        : ContactKey.of(b, q - bodies.firstPart[b], a, p - bodies.firstPart[a]);
  }

  // ---------------------------------------------------------------- questions

  /** The tree of the active bodies' parts, as of the last {@link #refit}. */
  public KdTree moving() {
    return moving;
  }

  /** The tree of the static and sleeping bodies' parts, as of the last {@link #refit}. */
  public KdTree resting() {
    return resting;
  }
}
