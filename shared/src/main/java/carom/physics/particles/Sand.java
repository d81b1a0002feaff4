package carom.physics.particles;

/**
 * Solver for sand: discs that don't overlap and have friction. It solves the pairs one after the
 * other, each with the results of those before (Gauss-Seidel), twice per substep.
 */
final class Sand extends PairSolver {
  private static final int ITERATIONS = 2;
  private static final float MARGIN = 1.3f;

  private final float diameter;
  private final float friction;

  Sand(ParticleDef def) {
    diameter = def.spacing;
    friction = def.friction;
  }

  @Override
  float pitch() {
    return diameter;
  }

  @Override
  float reach() {
    return diameter * MARGIN;
  }

  @Override
  void begin(ParticleStore p, Neighbours pairs, float dt) {
    // No state is kept between steps.
  }

  @Override
  void solve(ParticleStore p, Neighbours pairs, float h) {
    for (int i = 0; i < ITERATIONS; i++) {
      pass(p, pairs, h);
    }
  }

  /**
   * Solves each pair once. Half of the overlap is undone at each grain. Friction undoes the
   * tangential motion, limited to the coefficient times the overlap.
   */
  private void pass(ParticleStore p, Neighbours pairs, float h) {
    float[] x = p.x;
    float[] y = p.y;
    float[] vx = p.vx;
    float[] vy = p.vy;
    for (int i = 0; i < p.count; i++) {
      for (int k = pairs.start[i]; k < pairs.start[i + 1]; k++) {
        int j = pairs.partner[k];
        float dx = x[i] - x[j];
        float dy = y[i] - y[j];
        float squared = dx * dx + dy * dy;
        if (squared >= diameter * diameter) {
          continue;
        }
        float r = (float) Math.sqrt(squared);
        float nx = r > 0 ? dx / r : 0;
        float ny = r > 0 ? dy / r : 1;
        float depth = diameter - r;
        float relX = vx[i] - vx[j];
        float relY = vy[i] - vy[j];
        float tangentMove = (relY * nx - relX * ny) * h;
        float frictionMove = Math.max(-friction * depth, Math.min(-tangentMove, friction * depth));
        float half = 0.5f * depth;
        float halfFriction = 0.5f * frictionMove;
        float ux = half * nx - halfFriction * ny;
        float uy = half * ny + halfFriction * nx;
        x[i] += ux;
        y[i] += uy;
        x[j] -= ux;
        y[j] -= uy;
        float inverse = 1 / h;
        vx[i] += ux * inverse;
        vy[i] += uy * inverse;
        vx[j] -= ux * inverse;
        vy[j] -= uy * inverse;
      }
    }
  }
}
