package carom.physics.particles;

import carom.physics.Body;
import carom.physics.BodyType;
import carom.physics.BodyVisitor;
import carom.physics.Filter;
import carom.physics.World;
import carom.physics.geometry.Convex;
import carom.physics.geometry.Shape;
import carom.physics.math.Aabb;
import carom.physics.math.Transform;
import java.util.Arrays;

/**
 * Copies of the bodies that particles may touch in a step, with their motion while particles push
 * them. At the end, the world gets one impulse for each body.
 */
final class NearBodies {
  // For each body: centre, rotation, velocity, 1/m, 1/I, the impulse so far, and the origin in its
  // frame.
  private Body<?>[] body = new Body<?>[16];
  float[] x = new float[16];
  float[] y = new float[16];
  float[] cos = new float[16];
  float[] sin = new float[16];
  float[] vx = new float[16];
  float[] vy = new float[16];
  float[] w = new float[16];
  float[] invMass = new float[16];

  /** True if the body is dynamic. Bodies that aren't are solved last. */
  boolean[] movable = new boolean[16];

  float[] invInertia = new float[16];
  private float[] gravity = new float[16];
  private float[] impulseX = new float[16];
  private float[] impulseY = new float[16];
  private double[] impulseW = new double[16];
  float[] localX = new float[16];
  float[] localY = new float[16];

  /** Pose at the start of the substep, for particles that pass through a part within it. */
  float[] oldX = new float[16];

  float[] oldY = new float[16];
  float[] oldCos = new float[16];
  float[] oldSin = new float[16];
  private int count;

  // For each convex part: its body, its friction and its bounding box over the whole step.
  Convex[] part = new Convex[16];
  int[] owner = new int[16];
  float[] friction = new float[16];
  private float[] minX = new float[16];
  private float[] minY = new float[16];
  private float[] maxX = new float[16];
  private float[] maxY = new float[16];
  private int partCount;
  private int[] firstPart = new int[17];

  /** By slot: the body's index here, valid if the stamp is that of this step. */
  private int[] place = new int[0];

  private int[] stamp = new int[0];
  private int step;

  private final Aabb box = new Aabb();
  private final Transform pose = new Transform();

  private Filter filter;
  private boolean twoWay;
  private float dt;

  private int[] found = new int[16];
  private int foundCount;
  private final BodyVisitor<Object> find = this::find;

  void begin(World<?> world, ParticleDef def, float seconds) {
    filter = def.filter;
    twoWay = def.twoWay;
    dt = seconds;
    count = 0;
    partCount = 0;
    if (stamp.length < world.slotCount()) {
      stamp = new int[world.slotCount() * 2];
      place = new int[world.slotCount() * 2];
      step = 0;
    }
    step++;
  }

  /** Finds the bodies whose box overlaps an area, by ascending index. Returns their number. */
  @SuppressWarnings("unchecked")
  <T> int query(World<T> world, float left, float low, float right, float high) {
    foundCount = 0;
    BodyVisitor<T> visitor = (BodyVisitor<T>) (BodyVisitor<?>) find;
    world.queryAabb(left, low, right, high, visitor);
    return foundCount;
  }

  /** Returns the index of a body that the last query found. */
  int found(int i) {
    return found[i];
  }

  int firstPart(int b) {
    return firstPart[b];
  }

  int endPart(int b) {
    return firstPart[b + 1];
  }

  boolean overlaps(int k, float left, float low, float right, float high) {
    return minX[k] <= right && left <= maxX[k] && minY[k] <= high && low <= maxY[k];
  }

  private boolean find(Body<?> b) {
    int slot = b.index();
    if (stamp[slot] != step) {
      stamp[slot] = step;
      place[slot] = count;
      add(b);
    }
    if (foundCount == found.length) {
      found = Arrays.copyOf(found, foundCount * 2);
    }
    found[foundCount++] = place[slot];
    return true;
  }

  private void add(Body<?> b) {
    if (count == body.length) {
      grow();
    }
    int i = count++;
    body[i] = b;
    x[i] = b.centerX();
    y[i] = b.centerY();
    cos[i] = b.cos();
    sin[i] = b.sin();
    vx[i] = b.velocityX();
    vy[i] = b.velocityY();
    w[i] = b.angularVelocity();
    movable[i] = b.type() == BodyType.DYNAMIC;
    boolean pushed = twoWay && movable[i];
    invMass[i] = pushed ? 1 / b.mass() : 0;
    invInertia[i] = pushed && b.inertia() > 0 ? 1 / b.inertia() : 0;
    gravity[i] = pushed ? b.gravityScale() : 0;
    impulseX[i] = 0;
    impulseY[i] = 0;
    impulseW[i] = 0;
    float ox = b.x() - x[i];
    float oy = b.y() - y[i];
    localX[i] = cos[i] * ox + sin[i] * oy;
    localY[i] = cos[i] * oy - sin[i] * ox;
    firstPart[i] = partCount;
    pose.set(b.x(), b.y(), b.cos(), b.sin());
    for (int k = 0; k < b.shapeCount(); k++) {
      if (!b.sensor(k) && b.filter(k).meets(filter)) {
        add(i, b.shape(k), b.material(k).friction());
      }
    }
    firstPart[i + 1] = partCount;
  }

  private void add(int i, Shape shape, float mu) {
    float turn = Math.abs(w[i]) * shape.reach() * dt;
    float wayX = vx[i] * dt;
    float wayY = vy[i] * dt;
    for (int p = 0; p < shape.parts().size(); p++) {
      if (partCount == part.length) {
        growParts();
      }
      int k = partCount++;
      part[k] = shape.parts().get(p);
      owner[k] = i;
      friction[k] = mu;
      part[k].aabb(pose, box);
      minX[k] = box.minX - turn + Math.min(0, wayX);
      minY[k] = box.minY - turn + Math.min(0, wayY);
      maxX[k] = box.maxX + turn + Math.max(0, wayX);
      maxY[k] = box.maxY + turn + Math.max(0, wayY);
    }
  }

  private void grow() {
    int n = count * 2;
    body = Arrays.copyOf(body, n);
    x = Arrays.copyOf(x, n);
    y = Arrays.copyOf(y, n);
    cos = Arrays.copyOf(cos, n);
    sin = Arrays.copyOf(sin, n);
    vx = Arrays.copyOf(vx, n);
    vy = Arrays.copyOf(vy, n);
    w = Arrays.copyOf(w, n);
    invMass = Arrays.copyOf(invMass, n);
    movable = Arrays.copyOf(movable, n);
    invInertia = Arrays.copyOf(invInertia, n);
    gravity = Arrays.copyOf(gravity, n);
    impulseX = Arrays.copyOf(impulseX, n);
    impulseY = Arrays.copyOf(impulseY, n);
    impulseW = Arrays.copyOf(impulseW, n);
    localX = Arrays.copyOf(localX, n);
    localY = Arrays.copyOf(localY, n);
    oldX = Arrays.copyOf(oldX, n);
    oldY = Arrays.copyOf(oldY, n);
    oldCos = Arrays.copyOf(oldCos, n);
    oldSin = Arrays.copyOf(oldSin, n);
    firstPart = Arrays.copyOf(firstPart, n + 1);
  }

  private void growParts() {
    int n = partCount * 2;
    part = Arrays.copyOf(part, n);
    owner = Arrays.copyOf(owner, n);
    friction = Arrays.copyOf(friction, n);
    minX = Arrays.copyOf(minX, n);
    minY = Arrays.copyOf(minY, n);
    maxX = Arrays.copyOf(maxX, n);
    maxY = Arrays.copyOf(maxY, n);
  }

  /** Moves the bodies by a substep, as the world will, except for contacts between them. */
  void move(float gx, float gy, float h) {
    for (int i = 0; i < count; i++) {
      oldX[i] = x[i];
      oldY[i] = y[i];
      oldCos[i] = cos[i];
      oldSin[i] = sin[i];
      vx[i] += gravity[i] * gx * h;
      vy[i] += gravity[i] * gy * h;
      if (vx[i] != 0 || vy[i] != 0 || w[i] != 0) {
        shift(i, vx[i] * h, vy[i] * h, w[i] * h);
      }
    }
  }

  private void shift(int i, float dx, float dy, float turn) {
    x[i] += dx;
    y[i] += dy;
    if (turn != 0) {
      // A rotation by 2 atan(turn / 2), which has length one for every turn.
      float half = 0.5f * turn;
      float scale = 1 / (1 + half * half);
      float c = (1 - half * half) * scale;
      float s = turn * scale;
      float newCos = c * cos[i] - s * sin[i];
      sin[i] = s * cos[i] + c * sin[i];
      cos[i] = newCos;
    }
  }

  /**
   * Applies an impulse to a body at a point relative to its centre. It changes the velocity and the
   * motion of this substep.
   */
  void applyImpulse(int i, float rx, float ry, float jx, float jy, float h) {
    float dvx = invMass[i] * jx;
    float dvy = invMass[i] * jy;
    float moment = rx * jy - ry * jx;
    float dw = invInertia[i] * moment;
    vx[i] += dvx;
    vy[i] += dvy;
    w[i] += dw;
    shift(i, dvx * h, dvy * h, dw * h);
    impulseX[i] += jx;
    impulseY[i] += jy;
    impulseW[i] += moment;
  }

  /** Applies the impulses to the world's bodies. */
  void end() {
    for (int i = 0; i < count; i++) {
      if (invMass[i] > 0 && (impulseX[i] != 0 || impulseY[i] != 0)) {
        body[i].applyImpulse(impulseX[i], impulseY[i]);
        body[i].applyAngularImpulse((float) impulseW[i]);
      }
    }
    Arrays.fill(body, 0, count, null);
    Arrays.fill(part, 0, partCount, null);
  }
}
