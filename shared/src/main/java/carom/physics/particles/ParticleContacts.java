package carom.physics.particles;

import carom.physics.World;
import carom.physics.collision.Cast;
import carom.physics.collision.CastHit;
import carom.physics.collision.SignedDistance;
import carom.physics.geometry.Convex;
import carom.physics.geometry.Segment;
import carom.physics.math.Transform;
import java.util.Arrays;

/**
 * Contacts between particles and bodies: the pairs that may touch in a step, and the push-out in
 * each substep.
 *
 * <p>For each step, a particle gets a box: the bounds of its expected path with a margin of one
 * spacing. The particle never leaves its box, and every part that reaches into the box is tested in
 * every substep, so no contact is missed. A particle that moves more than half its radius within a
 * substep is also cast as a ray. Against segments, which have no inside, every particle is.
 */
final class ParticleContacts {
  private static final int BLOCK = 32;
  private static final Transform IDENTITY = new Transform();

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

  // Surface point of the current contact, in the part's frame.
  private float distance;
  private float normalX;
  private float normalY;

  /** Finds the pairs that may touch in a step. */
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
   * Finds the pairs of a block of particles with one query. Particles that are neighbours in the
   * order are neighbours in the world.
   */
  private int findBlock(
      World<?> world, ParticleStore p, float margin, float gx, float gy, float dt, int first) {
    float left = Float.POSITIVE_INFINITY;
    float low = Float.POSITIVE_INFINITY;
    float right = Float.NEGATIVE_INFINITY;
    float high = Float.NEGATIVE_INFINITY;
    int end = first;
    while (end < p.count && end < first + BLOCK) {
      float x = p.x[end];
      float y = p.y[end];
      if (end > first && Math.abs(x - p.x[end - 1]) + Math.abs(y - p.y[end - 1]) > 8 * margin) {
        break;
      }
      float toX = x + dt * (p.vx[end] + gx * dt);
      float toY = y + dt * (p.vy[end] + gy * dt);
      minX[end] = Math.min(x, toX) - margin;
      minY[end] = Math.min(y, toY) - margin;
      maxX[end] = Math.max(x, toX) + margin;
      maxY[end] = Math.max(y, toY) + margin;
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

  /** Keeps every particle in its box. */
  void confine(ParticleStore p) {
    for (int i = 0; i < p.count; i++) {
      p.x[i] = Math.min(Math.max(p.x[i], minX[i]), maxX[i]);
      p.y[i] = Math.min(Math.max(p.y[i], minY[i]), maxY[i]);
    }
  }

  /**
   * Pushes particles out of bodies, in the order of the particles. Dynamic bodies come first and
   * all others second, so that no particle is pushed through a floor.
   *
   * @param oldX x of the particles before the substep
   * @param oldY y of the particles before the substep
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

  /** Returns whether a particle is closer to a part than its radius, or has passed through it. */
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
        && cast.ray(shape, IDENTITY, fromX, fromY, wayX, wayY, 1, hit)
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

  /** Returns whether (x, y) points to the open side of a one-sided segment. */
  private static boolean isBack(Convex shape, float x, float y) {
    return shape instanceof Segment
        && ((Segment) shape).isOneSided()
        && shape.normalX(0) * x + shape.normalY(0) * y < 0;
  }

  /**
   * Pushes a particle out along the normal, with friction. An overlap that arose in this substep is
   * stopped by an impulse, shared between particle and body by their masses, and changes
   * velocities. An older overlap only moves the particle, so that it isn't shot out. Friction is
   * limited to the coefficient times the normal impulse.
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
      float tangentSpeed = relY * nx - relX * ny;
      float reach = rx * nx + ry * ny;
      float most = mu * impulse;
      float frictionImpulse = -tangentSpeed / (k0 + bodies.invInertia[b] * reach * reach);
      frictionImpulse = Math.max(-most, Math.min(frictionImpulse, most));
      jx -= frictionImpulse * ny;
      jy += frictionImpulse * nx;
    }
    float dvx = inverseMass * jx;
    float dvy = inverseMass * jy;
    p.vx[i] += dvx;
    p.vy[i] += dvy;
    p.x[i] += dvx * h + (depth - in) * nx;
    p.y[i] += dvy * h + (depth - in) * ny;
    if (bodies.invMass[b] > 0) {
      bodies.applyImpulse(b, rx, ry, -jx, -jy, h);
    }
  }
}
