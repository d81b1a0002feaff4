package carom.physics.dynamics;

import carom.physics.broadphase.CastVisitor;
import carom.physics.broadphase.KdTree;
import carom.physics.broadphase.MovingBox;
import carom.physics.collision.Cast;
import carom.physics.collision.CastHit;
import carom.physics.collision.Sweep;
import carom.physics.collision.TimeOfImpact.State;
import carom.physics.collision.TimeOfImpact;
import carom.physics.dynamics.body.ActiveBodies;
import carom.physics.dynamics.body.BodyStore;
import carom.physics.dynamics.body.Checks;
import carom.physics.dynamics.body.Settings;
import carom.physics.dynamics.body.ShapeTable;
import carom.physics.dynamics.contact.ContactKey;
import carom.physics.dynamics.contact.ContactTable;
import carom.physics.dynamics.pairs.PairFinder;
import carom.physics.dynamics.solver.SolverBodies;
import carom.physics.dynamics.store.KeySorter;
import carom.physics.geometry.Convex;
import carom.physics.geometry.Segment;
import carom.physics.math.Aabb;
import carom.physics.math.Transform;
import carom.physics.math.Trig;
import java.util.Arrays;

/**
 * Stops fast bodies at what they would pass through within a step. Runs when the solver is done:
 * the motion of each fast body, from its pose at the start of the step to that at the end, is swept
 * against what is in its way, and the body is put where it first comes close. It keeps its
 * velocity; the contact of the next step answers the impact.
 *
 * <p><b>Who is swept.</b> Dynamic bodies that move farther in the step than {@link #GATE} times
 * their inner radius, turning included: against static and kinematic parts; bullets against dynamic
 * ones, too. Who pushes through something slowly is the solver's business.
 *
 * <p><b>What counts.</b> A body that touches something, or lies in it a little, must slide on
 * freely. So the question is first put with a <b>core</b>, the shape without its rim of {@link
 * #RIM} times its size: only when the core reaches the other surface the body is stopped, and then
 * where the whole shape came close, at half the speculative distance, or, if it was close from the
 * start, where the core arrives. If even the core is inside from the start, smaller ones are tried,
 * down to the middle of the shape, which must not pass. Contacts that a callback refused in this
 * step, sensors, filtered pairs and the back of chains don't count.
 *
 * <p><b>Targets that move.</b> Both motions are followed. The target stays where it ends, so the
 * body is put where it was relative to the target at the impact, but not through static parts.
 * Bullets are settled after all others and in the order of their slots, each against the corrected
 * motion of those before.
 *
 * <p>A sensor that a body crosses within one step hears nothing of it: only what is inside at the
 * start of a step counts.
 *
 * <p>The result depends on the state alone: candidates are tested in the order in which their boxes
 * can be met, which has nothing to do with the trees. Nothing is allocated in a steady world.
 */
public final class ContinuousCollision {
  /**
   * Motion in one step up to which a body isn't swept, in inner radii of its thinnest part; 0.5: it
   * then is still on the near side of what it runs into, and contacts push it back.
   */
  public static final float GATE = 0.5f;

  /**
   * Overlap with something static or kinematic, in inner radii, from which a body is swept however
   * slow it is; 0.25, but at least the slop. With {@link #GATE} on top the middle is still outside.
   */
  public static final float DEEP = 0.25f;

  /**
   * Thickness of the rim that may overlap, in sizes; 0.25. The size is the inner radius of the part
   * or half of the other one's length, whichever is less, so that nothing fits into the rim. The
   * slop comes on top, up to twice as much. Without a rim, bodies that slide or roll would stop at
   * every seam of the ground.
   */
  public static final float RIM = 0.25f;

  /** How near the core comes to a surface, in rims; 0.25. */
  public static final float CORE_GAP = 0.25f;

  /**
   * How near a body comes to what it is stopped at, in speculative distances; 0.5, so that the next
   * step has a contact, with room for rounding.
   */
  public static final float GAP = 0.5f;

  /** How many rims a core may lack that has got into something; 3. Beyond is the middle. */
  public static final int MOST_RIMS = 3;

  /** How near the middle of a shape comes to a surface, in inner radii; 0.1, if need be nearer. */
  public static final float CENTRE_GAP = 0.1f;

  private static final float NEVER = 2;

  /** The time of an impact that lets nothing move. */
  private static final float STUCK = Float.MIN_NORMAL;

  private static final float TWO_PI = (float) (2 * Math.PI);

  /** The angle in (0, pi/2) is at most this times its sine. */
  private static final float ANGLE_BY_SINE = 1.571f;

  private static final int FIRST_CAPACITY = 16;

  private final PairFinder pairs;
  private final Settings settings;
  private final BodyStore bodies;
  private final ActiveBodies active;
  private final ShapeTable parts;
  private final ContactTable contacts;

  /** Length of the step that the bodies were collected in, s. */
  private float stepS;

  private final TimeOfImpact impact = new TimeOfImpact();
  private final MovingBox box = new MovingBox();

  /** A fast body and its motion: one stretch up to {@code split}, perhaps another one after it. */
  private static final class Flight {
    private int body;
    private final Sweep whole = new Sweep();
    private final Sweep first = new Sweep();
    private final Sweep second = new Sweep();
    private float split;
  }

  private Flight[] flights = new Flight[0];
  private int count;

  /** Flight of each body, -1 if it isn't fast. */
  private int[] flightOf = new int[0];

  /** Flights in the order in which they are settled: bullets last, by slot. */
  private long[] order = new long[FIRST_CAPACITY];

  private final KeySorter sorter = new KeySorter();

  /** Bodies pressed into static or kinematic ones when the step began. */
  private boolean[] isPressed = new boolean[FIRST_CAPACITY];

  private boolean anyPressed;

  /** Whether anything that moves may be a target. */
  private boolean moving;

  /** The farthest any point of a slow body gets, m. */
  private float drift;

  private SolverBodies solverBodies;

  // The search at present: whose part moves how, and what may be in its way.
  private Sweep path;
  private int mover;
  private int moverPart;
  private boolean bullet;
  private float margin;
  private int[] candidates = new int[FIRST_CAPACITY];
  private double[] entries = new double[FIRST_CAPACITY];
  private int candidateCount;
  private final CastVisitor onCandidate = this::candidate;

  /** Earliest impact of the search, and whose part it is with. */
  private float best;

  private int bestPart;

  // The motion of the target at present: one stretch, or two.
  private final Sweep rest = new Sweep();
  private Sweep targetFirst;
  private Sweep targetSecond;
  private float targetSplit;

  /** What the last {@link #impact} found. */
  private State state = State.SEPARATED;

  private float middleX;
  private float middleY;
  private final Cast cast = new Cast();
  private final CastHit castHit = new CastHit();
  private final Sweep ownFirst = new Sweep();
  private final Sweep ownSecond = new Sweep();
  private final Sweep ride = new Sweep();
  private final Transform pose = new Transform();
  private final Transform hitPose = new Transform();
  private final Transform targetPose = new Transform();
  private final Transform targetEnd = new Transform();
  private final Transform endPose = new Transform();
  private final Aabb tight = new Aabb();
  private final Aabb swept = new Aabb();

  ContinuousCollision(
      PairFinder pairs,
      Settings settings,
      BodyStore bodies,
      ActiveBodies active,
      ShapeTable parts,
      ContactTable contacts) {
    this.pairs = pairs;
    this.settings = settings;
    this.bodies = bodies;
    this.active = active;
    this.parts = parts;
    this.contacts = contacts;
  }

  // ---------------------------------------------------------------- who is fast

  /**
   * Notes that a dynamic body overlaps a static or kinematic one when the step begins: one that is
   * pressed in deep is swept however slow it is, or it could be squeezed through bit by bit.
   *
   * @param overlap how deep, m
   */
  void pressed(int body, float overlap) {
    if (overlap > DEEP * bodies.innerRadius[body]) {
      if (isPressed.length <= body) {
        isPressed = Arrays.copyOf(isPressed, bodies.type.length);
      }
      anyPressed |= !isPressed[body];
      isPressed[body] = true;
    }
  }

  /** Forgets who was pressed. */
  void begin() {
    if (anyPressed) {
      Arrays.fill(isPressed, false);
      anyPressed = false;
    }
  }

  /**
   * Collects the fast bodies of the step that the solver has just finished.
   *
   * @param dt length of that step, s
   * @return whether there are any
   */
  boolean collect(SolverBodies solved, float dt) {
    solverBodies = solved;
    stepS = dt;
    count = 0;
    moving = false;
    float[] s = solved.state;
    for (int i = 0; i < active.count; i++) {
      int body = active.list[i];
      if (bodies.type[body] != BodyStore.DYNAMIC) {
        moving = true;
        continue;
      }
      int at = solved.slot(body) * SolverBodies.STRIDE;
      float dx = s[at + SolverBodies.DX];
      float dy = s[at + SolverBodies.DY];
      float turn = ANGLE_BY_SINE * Math.abs(s[at + SolverBodies.SIN]);
      float free = GATE * bodies.innerRadius[body] - bodies.reach[body] * turn;
      boolean slow = s[at + SolverBodies.COS] > 0 && free >= 0 && dx * dx + dy * dy <= free * free;
      boolean pressedIn = anyPressed && body < isPressed.length && isPressed[body];
      if (!slow || pressedIn) {
        add(body, pressedIn);
      }
    }
    return count > 0;
  }

  private void add(int body, boolean pressedIn) {
    float limit = GATE * bodies.innerRadius[body];
    boolean atEdge =
        Math.abs(bodies.x[body]) >= Checks.MAX_COORDINATE
            || Math.abs(bodies.y[body]) >= Checks.MAX_COORDINATE;
    if (atEdge || limit == Float.POSITIVE_INFINITY) {
      return;
    }
    if (count == flights.length) {
      flights = Arrays.copyOf(flights, Math.max(FIRST_CAPACITY, count * 2));
      for (int i = count; i < flights.length; i++) {
        flights[i] = new Flight();
      }
    }
    Flight f = flights[count];
    motion(body, f.whole);
    float way = (float) Math.sqrt(f.whole.dx * f.whole.dx + f.whole.dy * f.whole.dy);
    if (way == 0 && f.whole.angleRad == 0) {
      return;
    }
    if (!pressedIn && way + arm(body) * Math.abs(f.whole.angleRad) <= limit) {
      return;
    }
    f.body = body;
    f.split = 1;
    count++;
  }

  /** Farthest vertex from the centre of mass, which is what turning moves. */
  private float arm(int body) {
    float square = 0;
    int first = bodies.firstPart[body];
    for (int part = first; part < first + bodies.partCount[body]; part++) {
      Convex c = parts.convex[part];
      for (int i = 0; i < c.vertexCount(); i++) {
        float x = c.vertexX(i);
        float y = c.vertexY(i);
        square = Math.max(square, x * x + y * y);
      }
    }
    return (float) Math.sqrt(square);
  }

  /** How an awake body moved in this step, as the solver left it. */
  private void motion(int body, Sweep out) {
    int at = solverBodies.slot(body) * SolverBodies.STRIDE;
    float[] s = solverBodies.state;
    float dc = s[at + SolverBodies.COS];
    float ds = s[at + SolverBodies.SIN];
    float c = bodies.cos[body];
    float n = bodies.sin[body];
    out.dx = s[at + SolverBodies.DX];
    out.dy = s[at + SolverBodies.DY];
    out.x = bodies.x[body] - out.dx;
    out.y = bodies.y[body] - out.dy;
    out.cos = c * dc + n * ds;
    out.sin = n * dc - c * ds;
    out.angleRad = 0;
    if (ds != 0 || dc < 0) {
      // The way round that fits the speed, but at most one full turn more than the shortest: then
      // every direction has been swept.
      float shortest = Trig.atan2(ds, dc);
      float more = (bodies.w[body] * stepS - shortest) / TWO_PI;
      out.angleRad = shortest + TWO_PI * Math.max(-1, Math.min(1, Math.round(more)));
    }
  }

  /**
   * Decides the order, and whether moving targets are to be searched.
   *
   * @return whether boxes and tree of the moving parts must be up to date
   */
  boolean prepare() {
    if (flightOf.length < bodies.slots()) {
      flightOf = new int[bodies.type.length];
      Arrays.fill(flightOf, -1);
    }
    if (order.length < count) {
      order = new long[flights.length];
    }
    for (int k = 0; k < count; k++) {
      int body = flights[k].body;
      flightOf[body] = k;
      boolean last = bodies.bullet(body);
      moving |= last;
      order[k] = (last ? 1L << 32 : 0) | body;
    }
    order = sorter.sort(order, count);
    drift = 0;
    for (int i = 0; i < active.count && moving; i++) {
      int body = active.list[i];
      if (flightOf[body] < 0) {
        motion(body, rest);
        float turn = Math.min(2, Math.abs(rest.angleRad));
        drift = Math.max(drift, Math.abs(rest.dx) + Math.abs(rest.dy) + bodies.reach[body] * turn);
      }
    }
    return moving;
  }

  /** Makes the boxes of fast bodies contain all of their way, so that the tree finds them. */
  void widen() {
    for (int k = 0; k < count; k++) {
      int body = flights[k].body;
      int first = bodies.firstPart[body];
      for (int part = first; part < first + bodies.partCount[body]; part++) {
        swept.setEmpty();
        addSweep(part, flights[k].whole);
        pairs.cover(part, swept);
      }
    }
  }

  // ---------------------------------------------------------------- settling

  /** Puts every fast body where it first meets something. */
  void settle(KdTree movingParts, KdTree fixedParts) {
    for (int i = 0; i < count; i++) {
      settle(flights[flightOf[(int) order[i]]], movingParts, fixedParts);
    }
    for (int k = 0; k < count; k++) {
      flightOf[flights[k].body] = -1;
    }
  }

  private void settle(Flight f, KdTree movingParts, KdTree fixedParts) {
    search(f.body, f.whole, moving ? movingParts : null, fixedParts);
    if (best >= 1) {
      return;
    }
    float split = best;
    f.whole.at(split, hitPose);
    int target = parts.body[bestPart];
    targetMotion(target);
    endPose.set(hitPose);
    if (targetMoves()) {
      targetAt(split, targetPose);
      targetEnd.set(bodies.x[target], bodies.y[target], bodies.cos[target], bodies.sin[target]);
      carry();
      ride.between(hitPose, endPose);
      search(f.body, ride, null, fixedParts);
      if (best < 1) {
        ride.at(best, endPose);
      }
    }
    f.first.part(f.whole, 0, split);
    f.second.between(hitPose, endPose);
    f.split = split;
    bodies.x[f.body] = endPose.x;
    bodies.y[f.body] = endPose.y;
    float inverse = 1 / (float) Math.sqrt(endPose.cos * endPose.cos + endPose.sin * endPose.sin);
    bodies.cos[f.body] = endPose.cos * inverse;
    bodies.sin[f.body] = endPose.sin * inverse;
    if (moving) {
      strayed(f);
    }
  }

  /** Widens later searches if a body that was carried along left the box the tree knows of it. */
  private void strayed(Flight f) {
    int first = bodies.firstPart[f.body];
    for (int part = first; part < first + bodies.partCount[f.body]; part++) {
      swept.setEmpty();
      addSweep(part, f.second);
      drift = Math.max(drift, parts.fat.minX(part) - swept.minX);
      drift = Math.max(drift, parts.fat.minY(part) - swept.minY);
      drift = Math.max(drift, swept.maxX - parts.fat.maxX(part));
      drift = Math.max(drift, swept.maxY - parts.fat.maxY(part));
    }
  }

  /** The end pose: the pose moved along with the target from the impact to the end of the step. */
  private void carry() {
    float c = targetEnd.cos * targetPose.cos + targetEnd.sin * targetPose.sin;
    float n = targetEnd.sin * targetPose.cos - targetEnd.cos * targetPose.sin;
    float x = hitPose.x - targetPose.x;
    float y = hitPose.y - targetPose.y;
    endPose.set(
        targetEnd.x + (c * x - n * y),
        targetEnd.y + (n * x + c * y),
        c * hitPose.cos - n * hitPose.sin,
        n * hitPose.cos + c * hitPose.sin);
  }

  // ---------------------------------------------------------------- searching

  /** Finds the earliest impact of a body on a path; the tree of moving parts may be null. */
  private void search(int body, Sweep along, KdTree movingParts, KdTree fixedParts) {
    mover = body;
    path = along;
    bullet = bodies.bullet(body);
    best = NEVER;
    margin = Math.max(GAP * settings.speculativeDistance(), TimeOfImpact.MIN_TARGET);
    int first = bodies.firstPart[body];
    for (int part = first; part < first + bodies.partCount[body]; part++) {
      if (parts.sensor[part]) {
        continue;
      }
      moverPart = part;
      candidateCount = 0;
      setBox(0);
      cast(fixedParts, 0);
      if (movingParts != null) {
        cast(movingParts, drift);
      }
      sortCandidates();
      for (int i = 0; i < candidateCount && entries[i] <= best; i++) {
        meet(candidates[i]);
      }
    }
  }

  /** The box that the part sweeps along its path, larger by twice the gap it may keep. */
  private void setBox(float more) {
    Convex c = parts.convex[moverPart];
    pose.set(path.x, path.y, path.cos, path.sin);
    c.aabb(pose, tight);
    float turned = bodies.reach[mover] * Math.abs(path.angleRad);
    float extra = 2 * margin + more;
    float reach = c.reach();
    if (turned > reach) {
      tight.set(pose.x - reach, pose.y - reach, pose.x + reach, pose.y + reach);
    } else {
      extra += turned;
    }
    tight.set(tight.minX - extra, tight.minY - extra, tight.maxX + extra, tight.maxY + extra);
  }

  private void cast(KdTree tree, float more) {
    setBox(0);
    box.set(tight.minX, tight.minY, tight.maxX, tight.maxY, path.dx, path.dy);
    setBox(more);
    tree.cast(tight.minX, tight.minY, tight.maxX, tight.maxY, path.dx, path.dy, 1, onCandidate);
  }

  /** Takes a part if its own swept box is met; the way is never shortened. */
  private float candidate(int part, float end) {
    int body = parts.body[part];
    boolean target = bodies.type[body] != BodyStore.DYNAMIC || bullet;
    if (body == mover || !target || parts.sensor[part] || !pairs.mayTouch(moverPart, part)) {
      return end;
    }
    targetMotion(body);
    swept.setEmpty();
    addSweep(part, targetFirst);
    if (targetSplit < 1) {
      addSweep(part, targetSecond);
    }
    double entry = box.enter(swept.minX, swept.minY, swept.maxX, swept.maxY);
    if (entry <= 1 && !vetoed(part) && !isBehind(part)) {
      if (candidateCount == candidates.length) {
        candidates = Arrays.copyOf(candidates, candidateCount * 2);
        entries = Arrays.copyOf(entries, candidateCount * 2);
      }
      candidates[candidateCount] = part;
      entries[candidateCount++] = entry;
    }
    return end;
  }

  /** By ascending entry, of equal ones by body and part: an order that no tree decides. */
  private void sortCandidates() {
    for (int i = 1; i < candidateCount; i++) {
      int part = candidates[i];
      double entry = entries[i];
      int j = i - 1;
      while (j >= 0 && isLater(candidates[j], entries[j], part, entry)) {
        candidates[j + 1] = candidates[j];
        entries[j + 1] = entries[j];
        j--;
      }
      candidates[j + 1] = part;
      entries[j + 1] = entry;
    }
  }

  private boolean isLater(int p, double entryP, int q, double entryQ) {
    if (entryP != entryQ) {
      return entryP > entryQ;
    }
    int a = parts.body[p];
    int b = parts.body[q];
    return a != b ? a > b : p > q;
  }

  /** Adds what a part sweeps to the swept box; what turning adds to the ends is bounded. */
  private void addSweep(int part, Sweep s) {
    Convex c = parts.convex[part];
    pose.set(s.x, s.y, s.cos, s.sin);
    c.aabb(pose, tight);
    swept.add(tight);
    if (s.dx == 0 && s.dy == 0 && s.angleRad == 0) {
      return;
    }
    s.at(1, pose);
    c.aabb(pose, tight);
    swept.add(tight);
    if (s.angleRad != 0) {
      float bulge = c.reach() * Math.min(2, 0.125f * s.angleRad * s.angleRad);
      swept.set(swept.minX - bulge, swept.minY - bulge, swept.maxX + bulge, swept.maxY + bulge);
    }
  }

  /** Whether a callback refused this contact in this step. */
  private boolean vetoed(int part) {
    int other = parts.body[part];
    int a = Math.min(mover, other);
    int b = Math.max(mover, other);
    int p = mover < other ? moverPart : part;
    int q = mover < other ? part : moverPart;
    int row = contacts.find(ContactKey.of(a, p - bodies.firstPart[a], b, q - bodies.firstPart[b]));
    return row >= 0 && (contacts.flags[row] & ContactTable.VETOED) != 0;
  }

  /** Whether the target is solid from the other side only. */
  private boolean isBehind(int part) {
    if (!(parts.convex[part] instanceof Segment line && line.isOneSided())) {
      return false;
    }
    middle(parts.convex[moverPart], path, 0);
    Sweep s = targetFirst;
    targetPose.set(s.x, s.y, s.cos, s.sin);
    double dx = (double) middleX - targetPose.x;
    double dy = (double) middleY - targetPose.y;
    double localX = targetPose.cos * dx + targetPose.sin * dy - line.vertexX(0);
    double localY = targetPose.cos * dy - targetPose.sin * dx - line.vertexY(0);
    return line.normalX(0) * localX + line.normalY(0) * localY < 0;
  }

  // ---------------------------------------------------------------- targets

  /** How the target moved: not at all, straight on, or straight on and then stopped or carried. */
  private void targetMotion(int body) {
    int flight = bodies.type[body] == BodyStore.STATIC ? -1 : flightOf[body];
    targetSplit = 1;
    if (flight >= 0) {
      Flight f = flights[flight];
      targetSplit = f.split;
      targetFirst = f.split < 1 ? f.first : f.whole;
      targetSecond = f.second;
    } else {
      targetFirst = rest;
      if (active.contains(body)) {
        motion(body, rest);
      } else {
        pose.set(bodies.x[body], bodies.y[body], bodies.cos[body], bodies.sin[body]);
        rest.set(pose, 0, 0, 0);
      }
    }
  }

  private boolean targetMoves() {
    Sweep s = targetFirst;
    return targetSplit < 1 || s.dx != 0 || s.dy != 0 || s.angleRad != 0;
  }

  private void targetAt(float time, Transform out) {
    if (time <= targetSplit) {
      targetFirst.at(time / targetSplit, out);
    } else {
      targetSecond.at((time - targetSplit) / (1 - targetSplit), out);
    }
  }

  // ---------------------------------------------------------------- impacts

  /** Decides whether and when the mover's part is stopped at another one. */
  private void meet(int part) {
    Convex own = parts.convex[moverPart];
    Convex other = parts.convex[part];
    targetMotion(parts.body[part]);
    pose.set(targetFirst.x, targetFirst.y, targetFirst.cos, targetFirst.sin);
    other.aabb(pose, tight);
    if (targetSplit < 1) {
      ownFirst.part(path, 0, targetSplit);
      ownSecond.part(path, targetSplit, 1);
    } else {
      ownFirst.set(path);
    }
    float inner = own.innerRadius();
    float size = Math.min(inner, 0.5f * Math.max(tight.width(), tight.height()));
    float rim = Math.min(RIM * size + settings.slop(), 2 * RIM * size);
    float gap = Math.max(TimeOfImpact.MIN_TARGET, CORE_GAP * rim);
    float at = impact(own, rim, other, gap);
    if (at > 0 && at <= 1) {
      float whole = impact(own, 0, other, margin);
      at = whole > 0 ? Math.min(whole, at) : at;
    }
    for (int rims = 2; rims <= MOST_RIMS && at == 0 && rims * rim < inner; rims++) {
      at = impact(own, rims * rim, other, gap);
    }
    if (at == 0) {
      at = impact(own, inner, other, Math.max(TimeOfImpact.MIN_TARGET, CENTRE_GAP * inner));
    }
    if (at == 0) {
      at = impact(own, inner, other, finest());
    }
    if (at == 0 && state != State.OVERLAPPING && crosses(own, other)) {
      at = STUCK;
    }
    if (at > 0 && at < best) {
      best = at;
      bestPart = part;
    }
  }

  /** The smallest gap that rounding to floats leaves, m. */
  private float finest() {
    float farthest = Math.max(Math.abs(path.x), Math.abs(path.y));
    return Math.max(TimeOfImpact.MIN_TARGET, 4 * Math.ulp(farthest));
  }

  /** Whether the middle of the mover's part, seen from the target, meets it on the straight way. */
  private boolean crosses(Convex own, Convex other) {
    middle(own, path, 0);
    float x = middleX;
    float y = middleY;
    middle(own, path, 1);
    targetAt(0, targetPose);
    targetAt(1, targetEnd);
    float startX = targetPose.localX(x, y);
    float startY = targetPose.localY(x, y);
    float dx = targetEnd.localX(middleX, middleY) - startX;
    float dy = targetEnd.localY(middleX, middleY) - startY;
    pose.setIdentity();
    return cast.ray(other, pose, startX, startY, dx, dy, 1, castHit);
  }

  /** Where the mean of a part's vertices is. */
  private void middle(Convex c, Sweep s, float time) {
    float x = 0;
    float y = 0;
    for (int i = 0; i < c.vertexCount(); i++) {
      x += c.vertexX(i) / c.vertexCount();
      y += c.vertexY(i) / c.vertexCount();
    }
    s.at(time, pose);
    middleX = pose.worldX(x, y);
    middleY = pose.worldY(x, y);
  }

  /**
   * When a shape, made smaller, comes near another one, as a part of the step: 0 if it is near from
   * the start, {@link #NEVER} if it doesn't.
   */
  private float impact(Convex own, float inset, Convex other, float gap) {
    state = impact.find(own, inset, ownFirst, other, targetFirst, gap);
    if (state != State.SEPARATED) {
      return targetSplit * impact.fraction();
    }
    if (targetSplit < 1) {
      state = impact.find(own, inset, ownSecond, other, targetSecond, gap);
      if (state != State.SEPARATED) {
        return targetSplit + (1 - targetSplit) * impact.fraction();
      }
    }
    return NEVER;
  }
}
