package carom.physics.particles;

import carom.physics.World;
import carom.physics.collision.SignedDistance;
import carom.physics.collision.distance.Cast;
import carom.physics.collision.distance.CastHit;
import carom.physics.geometry.Convex;
import carom.physics.geometry.Segment;
import carom.physics.math.Transform;
import java.util.Arrays;

/**
 * Particles against bodies: which may meet in a step, and keeping them apart in each substep.
 *
 * <p>Each particle gets a room for the step: the box of its way as it flies now, and a spacing all
 * around it. It never leaves its room, and all that reaches into the room is looked at in every
 * substep, so nothing is missed. Within a substep those that go further than half their radius are
 * also cast as a ray, and all at lines, which have no inside to come out of.
 */
final class ParticleContacts {
  private static final int BLOCK = 32;
  private static final Transform HERE = new Transform();

  final NearBodies bodies = new NearBodies();
  private final SignedDistance surface = new SignedDistance();
  private final Cast cast = new Cast();
  private final CastHit hit = new CastHit();

  private float[] minX = new float[0];
  private float[] minY = new float[0];
  private float[] maxX = new float[0];
  private float[] maxY = new float[0];

  private int[] particle = new int[64];
  private int[] part = new int[64];
  private int count;

  private float radius;
  private float inverseMass;
  private float ownFriction;

  // The surface of the contact at hand, in the part's frame.
  private float distance;
  private float normalX;
  private float normalY;

  /** Finds what may meet. */
  void find(World<?> world, ParticleStore p, ParticleDef def, float gx, float gy, float dt) {
    radius = 0.5f * def.spacing;
    inverseMass = 1 / (def.density * def.spacing * def.spacing);
    ownFriction = def.friction;
    if (minX.length < p.capacity()) {
      minX = new float[p.capacity()];
      minY = new float[p.capacity()];
      maxX = new float[p.capacity()];
      maxY = new float[p.capacity()];
    }
    count = 0;
    bodies.begin(world, def, dt);
    int first = 0;
    while (first < p.count) {
      first = findBlock(world, p, def.spacing, gx, gy, dt, first);
    }
  }

  /**
   * Neighbours in the order are neighbours in the world: asks for up to a block of them at once.
   */
  private int findBlock(
      World<?> world, ParticleStore p, float room, float gx, float gy, float dt, int first) {
    float left = Float.POSITIVE_INFINITY;
    float low = Float.POSITIVE_INFINITY;
    float right = Float.NEGATIVE_INFINITY;
    float high = Float.NEGATIVE_INFINITY;
    int end = first;
    while (end < p.count && end < first + BLOCK) {
      float x = p.x[end];
      float y = p.y[end];
      if (end > first && Math.abs(x - p.x[end - 1]) + Math.abs(y - p.y[end - 1]) > 8 * room) {
        break;
      }
      float toX = x + dt * (p.vx[end] + gx * dt);
      float toY = y + dt * (p.vy[end] + gy * dt);
      minX[end] = Math.min(x, toX) - room;
      minY[end] = Math.min(y, toY) - room;
      maxX[end] = Math.max(x, toX) + room;
      maxY[end] = Math.max(y, toY) + room;
      left = Math.min(left, minX[end]);
      low = Math.min(low, minY[end]);
      right = Math.max(right, maxX[end]);
      high = Math.max(high, maxY[end]);
      end++;
    }
    int found = bodies.query(world, left - radius, low - radius, right + radius, high + radius);
    for (int i = first; i < end; i++) {
      for (int b = 0; b < found; b++) {
        int body = bodies.found(b);
        for (int k = bodies.firstPart(body); k < bodies.endPart(body); k++) {
          if (bodies.overlaps(
              k, minX[i] - radius, minY[i] - radius, maxX[i] + radius, maxY[i] + radius)) {
            add(i, k);
          }
        }
      }
    }
    return end;
  }

  private void add(int i, int k) {
    if (count == particle.length) {
      particle = Arrays.copyOf(particle, count * 2);
      part = Arrays.copyOf(part, count * 2);
    }
    particle[count] = i;
    part[count++] = k;
  }

  /** Keeps every particle in its room. */
  void confine(ParticleStore p) {
    for (int i = 0; i < p.count; i++) {
      p.x[i] = Math.min(Math.max(p.x[i], minX[i]), maxX[i]);
      p.y[i] = Math.min(Math.max(p.y[i], minY[i]), maxY[i]);
    }
  }

  /**
   * Pushes particles out of bodies, in the order of the particles: first out of what is dynamic,
   * then out of the rest, so that nothing is pressed through a floor.
   *
   * @param oldX where the particles were before the substep
   */
  void solve(ParticleStore p, float[] oldX, float[] oldY, float h) {
    solve(p, oldX, oldY, h, true);
    solve(p, oldX, oldY, h, false);
  }

  private void solve(ParticleStore p, float[] oldX, float[] oldY, float h, boolean movable) {
    for (int c = 0; c < count; c++) {
      int i = particle[c];
      int k = part[c];
      int b = bodies.owner[k];
      if (bodies.movable[b] != movable) {
        continue;
      }
      float cos = bodies.cos[b];
      float sin = bodies.sin[b];
      float dx = p.x[i] - bodies.x[b];
      float dy = p.y[i] - bodies.y[b];
      float lx = cos * dx + sin * dy - bodies.localX[b];
      float ly = cos * dy - sin * dx - bodies.localY[b];
      if (touches(oldX, oldY, i, k, b, lx, ly)) {
        float nx = cos * normalX - sin * normalY;
        float ny = sin * normalX + cos * normalY;
        push(p, i, k, b, nx, ny, h);
      }
    }
  }

  /** Whether a particle is closer to a part than its radius, or went through it. */
  private boolean touches(float[] oldX, float[] oldY, int i, int k, int b, float lx, float ly) {
    Convex shape = bodies.part[k];
    float dx = oldX[i] - bodies.oldX[b];
    float dy = oldY[i] - bodies.oldY[b];
    float cos = bodies.oldCos[b];
    float sin = bodies.oldSin[b];
    float fromX = cos * dx + sin * dy - bodies.localX[b];
    float fromY = cos * dy - sin * dx - bodies.localY[b];
    float wayX = lx - fromX;
    float wayY = ly - fromY;
    boolean line = shape instanceof Segment;
    if ((line || wayX * wayX + wayY * wayY > 0.25f * radius * radius)
        && cast.ray(shape, HERE, fromX, fromY, wayX, wayY, 1, hit)
        && !hit.isInside()) {
      normalX = hit.normalX;
      normalY = hit.normalY;
      distance = normalX * (lx - hit.x) + normalY * (ly - hit.y);
      return !isBack(shape, normalX, normalY);
    }
    distance = surface.measure(shape, lx, ly);
    normalX = surface.normalX;
    normalY = surface.normalY;
    return distance < radius && !isBack(shape, lx - shape.vertexX(0), ly - shape.vertexY(0));
  }

  /** Whether (x, y) points to the open side of a one-sided line. */
  private static boolean isBack(Convex shape, float x, float y) {
    return shape instanceof Segment
        && ((Segment) shape).isOneSided()
        && shape.normalX(0) * x + shape.normalY(0) * y < 0;
  }

  /**
   * Moves a particle out along the normal. What has come in during this substep is stopped,
   * particle and body by their masses, and counts as velocity; what was inside before is only
   * moved, so that no overlap is shot out. Then friction, at most that part of the normal impulse.
   */
  private void push(ParticleStore p, int i, int k, int b, float nx, float ny, float h) {
    float depth = radius - distance;
    float rx = p.x[i] - nx * distance - bodies.x[b];
    float ry = p.y[i] - ny * distance - bodies.y[b];
    float relX = p.vx[i] - (bodies.vx[b] - bodies.w[b] * ry);
    float relY = p.vy[i] - (bodies.vy[b] + bodies.w[b] * rx);
    float in = Math.min(depth, Math.max(0, -(relX * nx + relY * ny) * h));
    float arm = rx * ny - ry * nx;
    float k0 = inverseMass + bodies.invMass[b];
    float impulse = in / (h * (k0 + bodies.invInertia[b] * arm * arm));
    float jx = impulse * nx;
    float jy = impulse * ny;
    float mu = (float) Math.sqrt(ownFriction * bodies.friction[k]);
    if (mu > 0 && impulse > 0) {
      float slide = relY * nx - relX * ny;
      float reach = rx * nx + ry * ny;
      float most = mu * impulse;
      float rub = -slide / (k0 + bodies.invInertia[b] * reach * reach);
      rub = Math.max(-most, Math.min(rub, most));
      jx -= rub * ny;
      jy += rub * nx;
    }
    float dvx = inverseMass * jx;
    float dvy = inverseMass * jy;
    p.vx[i] += dvx;
    p.vy[i] += dvy;
    p.x[i] += dvx * h + (depth - in) * nx;
    p.y[i] += dvy * h + (depth - in) * ny;
    if (bodies.invMass[b] > 0) {
      bodies.kick(b, rx, ry, -jx, -jy, h);
    }
  }
}
