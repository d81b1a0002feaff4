package carom.physics.dynamics.continuous;

import carom.physics.broadphase.CastVisitor;
import carom.physics.broadphase.KdTree;
import carom.physics.broadphase.MovingBox;
import carom.physics.collision.Cast;
import carom.physics.collision.CastHit;
import carom.physics.collision.Sweep;
import carom.physics.collision.TimeOfImpact;
import carom.physics.collision.TimeOfImpact.State;
import carom.physics.dynamics.body.BodyStore;
import carom.physics.dynamics.body.ShapeTable;
import carom.physics.dynamics.pairs.PairFinder;
import carom.physics.geometry.Convex;
import carom.physics.geometry.Segment;
import carom.physics.math.Aabb;
import carom.physics.math.Transform;
import carom.physics.settings.Settings;
import java.util.Arrays;

/**
 * Finds where a body on a path is stopped first. Candidates are the parts whose swept boxes meet
 * that of the path; they are tested in the order in which these boxes can be met, which has nothing
 * to do with the trees. {@link ContinuousCollision} says what counts as an impact.
 */
final class ImpactSearch {
  private static final int FIRST_CAPACITY = 16;
  private static final float NEVER = 2;

  /** The time of an impact that lets nothing move. */
  private static final float STUCK = Float.MIN_NORMAL;

  private final PairFinder pairs;
  private final Settings settings;
  private final BodyStore bodies;
  private final ShapeTable parts;
  private final SweptQuestions questions;
  private final FastBodies fast;
  private final TargetMotion target;
  private final SweptBox box;
  private final TimeOfImpact timeOfImpact = new TimeOfImpact();
  private final Cast cast = new Cast();
  private final CastHit castHit = new CastHit();
  private final CastVisitor onCandidate = this::candidate;

  // The search at present: which part moves how, and what may be in its way.
  private Sweep path;
  private int mover;
  private int moverPart;
  private boolean bullet;
  private float margin;
  private final MovingBox way = new MovingBox();
  private int[] candidates = new int[FIRST_CAPACITY];
  private double[] entries = new double[FIRST_CAPACITY];
  private int candidateCount;

  /** The earliest impact of the search, as a part of the step. */
  private float best;

  /** The part that the earliest impact is with. */
  private int bestPart;

  /** The mover's part that has it. */
  private int bestOwn;

  /** The outcome of the last test of two parts. */
  private State state = State.SEPARATED;

  // Scratch.
  private float middleX;
  private float middleY;
  private final Sweep ownFirst = new Sweep();
  private final Sweep ownSecond = new Sweep();
  private final Transform pose = new Transform();
  private final Transform targetPose = new Transform();
  private final Transform targetEnd = new Transform();
  private final Aabb tight = new Aabb();

  ImpactSearch(
      PairFinder pairs,
      Settings settings,
      BodyStore bodies,
      ShapeTable parts,
      SweptQuestions questions,
      FastBodies fast,
      TargetMotion target,
      SweptBox box) {
    this.pairs = pairs;
    this.settings = settings;
    this.bodies = bodies;
    this.parts = parts;
    this.questions = questions;
    this.fast = fast;
    this.target = target;
    this.box = box;
  }

  /** Returns whether the last search found an impact. */
  boolean found() {
    return best < 1;
  }

  /** Returns the time of the earliest impact, as a part of the step. */
  float time() {
    return best;
  }

  /** Returns the part that the earliest impact is with. */
  int part() {
    return bestPart;
  }

  /** Returns the part of the body that has the earliest impact. */
  int ownPart() {
    return bestOwn;
  }

  /** Finds the earliest impact of a body on a path; the tree of moving parts may be null. */
  void find(int body, Sweep along, KdTree movingParts, KdTree fixedParts) {
    mover = body;
    path = along;
    bullet = bodies.bullet(body);
    best = NEVER;
    margin =
        Math.max(ContinuousCollision.GAP * settings.speculativeDistance(), TimeOfImpact.MIN_TARGET);
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
        cast(movingParts, fast.drift());
      }
      sortCandidates();
      for (int i = 0; i < candidateCount && entries[i] <= best; i++) {
        meet(candidates[i]);
      }
    }
  }

  /** Computes the box that the part sweeps along its path, larger by twice the gap it may keep. */
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
    way.set(tight.minX, tight.minY, tight.maxX, tight.maxY, path.dx, path.dy);
    setBox(more);
    tree.cast(tight.minX, tight.minY, tight.maxX, tight.maxY, path.dx, path.dy, 1, onCandidate);
  }

  /** Takes a part if its own swept box is met; the way is never shortened. */
  private float candidate(int part, float end) {
    int body = parts.body[part];
    boolean counts = bodies.type[body] != BodyStore.DYNAMIC || bullet;
    if (body == mover || !counts || parts.sensor[part] || !pairs.mayTouch(moverPart, part)) {
      return end;
    }
    target.of(body);
    box.setEmpty();
    box.add(part, target.first);
    if (target.split < 1) {
      box.add(part, target.second);
    }
    double entry = way.enter(box.minX(), box.minY(), box.maxX(), box.maxY());
    if (entry <= 1 && !questions.pass(moverPart, part) && !isBehind(part)) {
      if (candidateCount == candidates.length) {
        candidates = Arrays.copyOf(candidates, candidateCount * 2);
        entries = Arrays.copyOf(entries, candidateCount * 2);
      }
      candidates[candidateCount] = part;
      entries[candidateCount++] = entry;
    }
    return end;
  }

  /** Sorts by ascending entry, equal ones by body and part: an order that no tree decides. */
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

  /** Returns whether the target is solid from the other side only. */
  private boolean isBehind(int part) {
    if (!(parts.convex[part] instanceof Segment line && line.isOneSided())) {
      return false;
    }
    middle(parts.convex[moverPart], path, 0);
    Sweep s = target.first;
    targetPose.set(s.x, s.y, s.cos, s.sin);
    double dx = (double) middleX - targetPose.x;
    double dy = (double) middleY - targetPose.y;
    double localX = targetPose.cos * dx + targetPose.sin * dy - line.vertexX(0);
    double localY = targetPose.cos * dy - targetPose.sin * dx - line.vertexY(0);
    return line.normalX(0) * localX + line.normalY(0) * localY < 0;
  }

  /** Decides whether and when the mover's part is stopped at another one. */
  private void meet(int part) {
    Convex own = parts.convex[moverPart];
    Convex other = parts.convex[part];
    target.of(parts.body[part]);
    pose.set(target.first.x, target.first.y, target.first.cos, target.first.sin);
    other.aabb(pose, tight);
    if (target.split < 1) {
      ownFirst.part(path, 0, target.split);
      ownSecond.part(path, target.split, 1);
    } else {
      ownFirst.set(path);
    }
    float inner = own.innerRadius();
    float size = Math.min(inner, 0.5f * Math.max(tight.width(), tight.height()));
    float rim =
        Math.min(
            ContinuousCollision.RIM * size + settings.slop(), 2 * ContinuousCollision.RIM * size);
    float gap = Math.max(TimeOfImpact.MIN_TARGET, ContinuousCollision.CORE_GAP * rim);
    float at = impact(own, rim, other, gap);
    if (at > 0 && at <= 1) {
      float whole = impact(own, 0, other, margin);
      at = whole > 0 ? Math.min(whole, at) : at;
    }
    for (int rims = 2;
        rims <= ContinuousCollision.MOST_RIMS && at == 0 && rims * rim < inner;
        rims++) {
      at = impact(own, rims * rim, other, gap);
    }
    if (at == 0) {
      at =
          impact(
              own,
              inner,
              other,
              Math.max(TimeOfImpact.MIN_TARGET, ContinuousCollision.CENTRE_GAP * inner));
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
      bestOwn = moverPart;
    }
  }

  /** Returns the smallest gap that rounding to floats leaves, m. */
  private float finest() {
    float farthest = Math.max(Math.abs(path.x), Math.abs(path.y));
    return Math.max(TimeOfImpact.MIN_TARGET, 4 * Math.ulp(farthest));
  }

  /**
   * Returns whether the middle of the mover's part, seen from the target, meets it on the straight
   * way.
   */
  private boolean crosses(Convex own, Convex other) {
    middle(own, path, 0);
    float x = middleX;
    float y = middleY;
    middle(own, path, 1);
    target.at(0, targetPose);
    target.at(1, targetEnd);
    float startX = targetPose.localX(x, y);
    float startY = targetPose.localY(x, y);
    float dx = targetEnd.localX(middleX, middleY) - startX;
    float dy = targetEnd.localY(middleX, middleY) - startY;
    pose.setIdentity();
    return cast.ray(other, pose, startX, startY, dx, dy, 1, castHit);
  }

  /** Computes the mean of a part's vertices, in world axes. */
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
   * Returns when a shape, made smaller, comes near another one, as a part of the step: 0 if it is
   * near from the start, {@link #NEVER} if it never is.
   */
  private float impact(Convex own, float inset, Convex other, float gap) {
    state = timeOfImpact.find(own, inset, ownFirst, other, target.first, gap);
    if (state != State.SEPARATED) {
      return target.split * timeOfImpact.fraction();
    }
    if (target.split < 1) {
      state = timeOfImpact.find(own, inset, ownSecond, other, target.second, gap);
      if (state != State.SEPARATED) {
        return target.split + (1 - target.split) * timeOfImpact.fraction();
      }
    }
    return NEVER;
  }
}
