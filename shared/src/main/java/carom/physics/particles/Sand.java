package carom.physics.particles;

/**
 * Grains: discs that don't overlap and rub. Pairs are solved one after the other, each seeing what
 * the ones before did (Gauss-Seidel), twice per substep.
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
    // Nothing is remembered between steps.
  }

  @Override
  void solve(ParticleStore p, Neighbours pairs, float h) {
    for (int i = 0; i < ITERATIONS; i++) {
      pass(p, pairs, h);
    }
  }

  /**
   * Overlap is undone by halves, and friction, at most its coefficient times that, undoes sliding.
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
        float slide = (relY * nx - relX * ny) * h;
        float rub = Math.max(-friction * depth, Math.min(-slide, friction * depth));
        float half = 0.5f * depth;
        float halfRub = 0.5f * rub;
        float ux = half * nx - halfRub * ny;
        float uy = half * ny + halfRub * nx;
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
