package carom.physics.dynamics.continuous;

import carom.physics.broadphase.KdTree;
import carom.physics.collision.Sweep;
import carom.physics.dynamics.body.ActiveBodies;
import carom.physics.dynamics.body.BodyStore;
import carom.physics.dynamics.body.ShapeTable;
import carom.physics.dynamics.contact.ContactEvents;
import carom.physics.dynamics.contact.ContactTable;
import carom.physics.dynamics.domain.SolverBodies;
import carom.physics.dynamics.pairs.PairFinder;
import carom.physics.math.Transform;
import carom.physics.settings.Settings;

/**
 * Stops fast bodies at what they would pass through within a step. Runs when the solver is done:
 * the motion of each fast body, from its pose at the start of the step to that at the end, is swept
 * against what is in its way, and the body is put where it first comes close. It keeps the velocity
 * it had there, without what gravity added since; the contact of the next step answers the impact.
 *
 * <p><b>Who is swept.</b> Dynamic bodies that move farther in the step than {@link #GATE} times
 * their inner radius, turning included: against static and kinematic parts; bullets against dynamic
 * ones, too. A bullet that a fast kinematic body may pass over is swept however slow it is. Who
 * pushes through something slowly is the solver's business.
 *
 * <p><b>What counts.</b> A body that touches something, or lies in it a little, must slide on
 * freely. So the question is first put with a <b>core</b>, the shape without its rim of {@link
 * #RIM} times its size: only when the core reaches the other surface the body is stopped, and then
 * where the whole shape came close, at half the speculative distance, or, if it was close from the
 * start, where the core arrives. If even the core is inside from the start, smaller ones are tried,
 * down to the middle of the shape, which must not pass. Contacts that a callback refused in this
 * step, sensors, filtered pairs and the back of chains don't count. Callbacks are asked about those
 * that had no contact when the step began ({@link SweptQuestions}).
 *
 * <p><b>Targets that move.</b> Both motions are followed. The target stays where it ends, so the
 * body is put where it was relative to the target at the impact, but not through static parts.
 * Bullets are settled after all others and in the order of their slots, each against the corrected
 * motion of those before.
 *
 * <p><b>Sensors</b> stop nothing. One that a fast body crosses within the step is told of it; see
 * {@link SensorCrossings}.
 *
 * <p>The result depends on the state alone: candidates are tested in the order in which their boxes
 * can be met, which has nothing to do with the trees. Nothing is allocated in a steady world.
 */
public final class ContinuousCollision {
  /**
   * Motion in one step up to which a body isn't swept, in inner radii of its thinnest part; 0.5.
   * The body is then still on the near side of what it runs into, and contacts push it back.
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

  /** Least distance of the core from a surface, in rims; 0.25. */
  public static final float CORE_GAP = 0.25f;

  /**
   * Distance at which a body is stopped, in speculative distances; 0.5, so that the next step has a
   * contact, with room for rounding.
   */
  public static final float GAP = 0.5f;

  /** Number of rims that a core which has got into something may lack; 3. Beyond is the middle. */
  public static final int MOST_RIMS = 3;

  /**
   * Least distance of the middle of a shape from a surface, in inner radii; 0.1, if need be less.
   */
  public static final float CENTRE_GAP = 0.1f;

  private final PairFinder pairs;
  private final Settings settings;
  private final BodyStore bodies;
  private final ShapeTable parts;
  private final FastBodies fast;
  private final TargetMotion target;
  private final SweptQuestions questions;
  private final ImpactSearch search;
  private final SweptBox swept;
  private final SensorCrossings crossings;

  private float stepS;

  // Scratch.
  private final Sweep ride = new Sweep();
  private final Transform hitPose = new Transform();
  private final Transform targetPose = new Transform();
  private final Transform targetEnd = new Transform();
  private final Transform endPose = new Transform();
  private final Transform askedPose = new Transform();
  private final Transform askedTarget = new Transform();

  /** Makes the stage of a world without bodies. */
  public ContinuousCollision(
      PairFinder pairs,
      Settings settings,
      BodyStore bodies,
      ActiveBodies active,
      ShapeTable parts,
      ContactTable contacts) {
    this.pairs = pairs;
    this.settings = settings;
    this.bodies = bodies;
    this.parts = parts;
    swept = new SweptBox(parts);
    fast = new FastBodies(settings, bodies, active, parts);
    target = new TargetMotion(bodies, active, fast);
    questions = new SweptQuestions(bodies, parts, contacts);
    search = new ImpactSearch(pairs, settings, bodies, parts, questions, fast, target, swept);
    crossings = new SensorCrossings(pairs, bodies, parts, contacts, fast, target);
  }

  /** Forgets which bodies overlapped deeply, when a step begins to find contacts. */
  public void forgetOverlaps() {
    fast.forgetOverlaps();
  }

  /**
   * Notes that a dynamic body overlaps a static or kinematic one when the step begins. One that
   * overlaps deeply is swept however slow it is, or it could be squeezed through bit by bit.
   *
   * @param overlap how deep, m
   */
  public void noteOverlap(int body, float overlap) {
    fast.noteOverlap(body, overlap);
  }

  /**
   * Stops the fast bodies of a step at what they would have passed through.
   *
   * @param solved the step's bodies as the solver left them, written back already
   * @param dt length of the step, s
   * @param events decide who is let pass; null for nobody
   */
  public void run(SolverBodies solved, float dt, ContactEvents events) {
    if (!settings.continuous() || !fast.collect(solved, dt)) {
      return;
    }
    stepS = dt;
    questions.begin(events);
    fast.sort();
    if (fast.movingTargets()) {
      pairs.refresh();
      widen();
    }
    pairs.refit();
    for (int i = 0; i < fast.count(); i++) {
      settle(fast.inOrder(i), pairs.moving(), pairs.resting(), solved);
    }
    if (parts.anySensors()) {
      crossings.find();
    }
    fast.clear();
    pairs.posesChanged();
  }

  /** Begins the contacts with sensors that fast bodies crossed in this step. */
  public void beginCrossings(ContactEvents events) {
    crossings.begin(events);
  }

  /** Makes the boxes of fast bodies contain all of their way, so that the tree finds them. */
  private void widen() {
    for (int k = 0; k < fast.count(); k++) {
      int body = fast.flight(k).body;
      int first = bodies.firstPart[body];
      for (int part = first; part < first + bodies.partCount[body]; part++) {
        swept.setEmpty();
        swept.add(part, fast.flight(k).whole);
        pairs.cover(part, swept.box());
      }
    }
  }

  private void settle(Flight f, KdTree movingParts, KdTree fixedParts, SolverBodies solved) {
    find(f.body, f.whole, fast.movingTargets() ? movingParts : null, fixedParts);
    if (!search.found() || questions.movedAway()) {
      return;
    }
    float split = search.time();
    f.whole.at(split, hitPose);
    int body = parts.body[search.part()];
    target.of(body);
    endPose.set(hitPose);
    if (target.moves()) {
      target.at(split, targetPose);
      targetEnd.set(bodies.x[body], bodies.y[body], bodies.cos[body], bodies.sin[body]);
      carry();
      ride.between(hitPose, endPose);
      find(f.body, ride, null, fixedParts);
      if (questions.movedAway()) {
        return;
      }
      if (search.found()) {
        ride.at(search.time(), endPose);
      }
    }
    f.first.part(f.whole, 0, split);
    f.second.between(hitPose, endPose);
    f.split = split;
    keepEnergy(f.body, (1 - split) * stepS);
    int locks = bodies.linearLocks(f.body);
    endPose.x = (locks & BodyStore.LOCK_X) == 0 ? endPose.x : hitPose.x;
    endPose.y = (locks & BodyStore.LOCK_Y) == 0 ? endPose.y : hitPose.y;
    float inverse = 1 / (float) Math.sqrt(endPose.cos * endPose.cos + endPose.sin * endPose.sin);
    endPose.cos *= inverse;
    endPose.sin *= inverse;
    solved.putBack(f.body, bodies, endPose);
    bodies.x[f.body] = endPose.x;
    bodies.y[f.body] = endPose.y;
    bodies.cos[f.body] = endPose.cos;
    bodies.sin[f.body] = endPose.sin;
    if (fast.movingTargets()) {
      strayed(f);
    }
  }

  /** Finds the earliest impact at which a body is stopped: callbacks may let it pass others. */
  private void find(int body, Sweep along, KdTree movingParts, KdTree fixedParts) {
    do {
      search.find(body, along, movingParts, fixedParts);
    } while (search.found() && !stops(along) && !questions.movedAway());
  }

  private boolean stops(Sweep along) {
    along.at(search.time(), askedPose);
    target.of(parts.body[search.part()]);
    target.at(search.time(), askedTarget);
    return questions.stops(search.ownPart(), askedPose, search.part(), askedTarget);
  }

  /**
   * Takes off what gravity added to the speed on the way that the body is put back, or else it has
   * more energy than before. What contacts have taken already isn't taken again.
   */
  private void keepEnergy(int body, float seconds) {
    int locks = bodies.linearLocks(body);
    float x = (locks & BodyStore.LOCK_X) == 0 ? bodies.gravityScale[body] * settings.gravityX() : 0;
    float y = (locks & BodyStore.LOCK_Y) == 0 ? bodies.gravityScale[body] * settings.gravityY() : 0;
    float falling = bodies.vx[body] * x + bodies.vy[body] * y;
    if (falling > 0) {
      float taken = Math.min(seconds, falling / (x * x + y * y));
      bodies.vx[body] -= taken * x;
      bodies.vy[body] -= taken * y;
    }
  }

  /** Widens later searches if a body that was carried along left the box the tree knows of it. */
  private void strayed(Flight f) {
    int first = bodies.firstPart[f.body];
    for (int part = first; part < first + bodies.partCount[f.body]; part++) {
      swept.setEmpty();
      swept.add(part, f.second);
      fast.widenDrift(parts.fat.minX(part) - swept.minX());
      fast.widenDrift(parts.fat.minY(part) - swept.minY());
      fast.widenDrift(swept.maxX() - parts.fat.maxX(part));
      fast.widenDrift(swept.maxY() - parts.fat.maxY(part));
    }
  }

  /**
   * Computes the end pose: the pose of the impact, moved along with the target from the impact to
   * the end of the step.
   */
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
}
