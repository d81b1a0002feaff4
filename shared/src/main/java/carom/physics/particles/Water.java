package carom.physics.particles;

import java.util.Arrays;

/**
 * Solver for water. The density of a particle, {@code sum of (1 - r / h)^2} over itself and its
 * neighbours, must not exceed that of the triangular grid in which each particle has the area
 * {@code spacing^2}.
 *
 * <p>Let C be the density divided by that of rest, minus 1, where positive. A particle's multiplier
 * is {@code C / sum of |dC/dx|^2}, and a pair moves by the sum of both multipliers times the
 * gradient (Macklin and M&uuml;ller 2013); the density of rest cancels out. One pass per substep
 * moves all particles at once (Jacobi).
 */
final class Water extends PairSolver {
  /** Radius of the kernel, in spacings. */
  private static final float KERNEL = 1.75f;

  /**
   * Part of a correction that is applied, because a particle takes part in a dozen constraints that
   * all push at once. With 1 the water boils, with 0.6 it never comes quite to rest, and with 0.2
   * deep water stays compressed by a fifth.
   */
  private static final float RELAXATION = 0.35f;

  /**
   * Part of their relative speed along the connecting line that close neighbours lose in a substep.
   * Without it, strongly compressed water springs back.
   */
  private static final float DAMPING = 0.3f;

  /** Largest multiplier, in squared kernel radii. A deeper overlap takes several substeps. */
  private static final float MOST = 0.05f;

  /** Factor of the search distance over the kernel's radius. */
  private static final float MARGIN = 1.15f;

  /**
   * Distance of neighbours in a triangular grid of one particle per unit of area: sqrt(2/sqrt 3).
   */
  private static final float PITCH = 1.0745699f;

  private final float spacing;
  private final float kernel;
  private final float restDensity;

  /** Sum of 1 - r / h over the neighbours at rest. */
  private final float restWeight;

  private final float viscosity;
  private final float cohesion;
  private final float floor;
  private final float most;

  private float[] density = new float[0];
  private float[] gradX = new float[0];
  private float[] gradY = new float[0];
  private float[] weight = new float[0];
  private float[] normalX = new float[0];
  private float[] normalY = new float[0];

  Water(ParticleDef def) {
    spacing = def.spacing;
    kernel = KERNEL * spacing;
    viscosity = def.viscosity;
    cohesion = def.cohesion;
    double sum = 1;
    double linear = 0;
    double slopes = 0;
    for (int row = -4; row <= 4; row++) {
      for (int column = -6; column <= 6; column++) {
        double dx = PITCH * (column + 0.5 * (row & 1));
        double dy = PITCH * row * Math.sqrt(0.75);
        double q = 1 - Math.sqrt(dx * dx + dy * dy) / KERNEL;
        if (q > 0 && q < 1) {
          sum += q * q;
          linear += q;
          slopes += 4 * q * q;
        }
      }
    }
    restDensity = (float) sum;
    restWeight = (float) linear;
    floor = (float) (0.1 * slopes / ((double) kernel * kernel));
    most = MOST * kernel * kernel;
  }

  @Override
  float pitch() {
    return PITCH * spacing;
  }

  @Override
  float reach() {
    return kernel * MARGIN;
  }

  /** Applies viscosity and cohesion once per step. Pairs exchange velocity one after the other. */
  @Override
  void begin(ParticleStore p, Neighbours pairs, float dt) {
    reserve(p, pairs);
    float share = viscosity * dt / ((1 + viscosity * dt) * restWeight);
    float pull = cohesion * dt;
    float inverseKernel = 1 / kernel;
    if (share == 0 && pull == 0) {
      return;
    }
    float[] x = pairs.x;
    float[] y = pairs.y;
    float[] vx = p.vx;
    float[] vy = p.vy;
    for (int i = 0; i < p.count; i++) {
      for (int k = pairs.start[i]; k < pairs.start[i + 1]; k++) {
        int j = pairs.partner[k];
        float dx = x[i] - x[j];
        float dy = y[i] - y[j];
        float r = (float) Math.sqrt(dx * dx + dy * dy);
        float q = Math.max(0, 1 - r * inverseKernel);
        float c = share * q;
        // strongest at half the kernel's radius, 0 at both ends
        float a = r > 0 ? pull * 4 * q * (1 - q) / r : 0;
        float ux = c * (vx[j] - vx[i]) - a * dx;
        float uy = c * (vy[j] - vy[i]) - a * dy;
        vx[i] += ux;
        vy[i] += uy;
        vx[j] -= ux;
        vy[j] -= uy;
      }
    }
  }

  private void reserve(ParticleStore p, Neighbours pairs) {
    if (density.length < p.capacity()) {
      density = new float[p.capacity()];
      gradX = new float[p.capacity()];
      gradY = new float[p.capacity()];
    }
    if (weight.length < pairs.pairs(p.count)) {
      weight = new float[pairs.partner.length];
      normalX = new float[pairs.partner.length];
      normalY = new float[pairs.partner.length];
    }
  }

  @Override
  void solve(ParticleStore p, Neighbours pairs, float h) {
    measure(p, pairs);
    float slope = 2 / kernel;
    for (int i = 0; i < p.count; i++) {
      float excess = density[i] - restDensity;
      float sum = gradX[i] * gradX[i] + gradY[i] * gradY[i];
      float rate = slope * slope * (density[i] - 1 + sum) + floor;
      // From here on, this array holds the multipliers.
      density[i] = excess > 0 ? RELAXATION * slope * Math.min(most, excess / rate) : 0;
    }
    push(p, pairs, 1 / h);
  }

  /**
   * Sums densities, gradients and squared gradients, and stores the weight and direction of each
   * pair.
   */
  private void measure(ParticleStore p, Neighbours pairs) {
    int n = p.count;
    Arrays.fill(density, 0, n, 1);
    Arrays.fill(gradX, 0, n, 0);
    Arrays.fill(gradY, 0, n, 0);
    float[] x = p.x;
    float[] y = p.y;
    float inverseKernel = 1 / kernel;
    float squaredKernel = kernel * kernel;
    for (int i = 0; i < n; i++) {
      float px = x[i];
      float py = y[i];
      float ownDensity = density[i];
      float ownX = gradX[i];
      float ownY = gradY[i];
      int end = pairs.start[i + 1];
      for (int k = pairs.start[i]; k < end; k++) {
        int j = pairs.partner[k];
        float dx = px - x[j];
        float dy = py - y[j];
        float squared = dx * dx + dy * dy;
        if (squared >= squaredKernel) {
          weight[k] = 0;
          continue;
        }
        float r = (float) Math.sqrt(squared);
        float q = 1 - r * inverseKernel;
        float over = q / Math.max(r, 1e-9f);
        // Two particles in one place separate upwards and downwards.
        float gx = over * dx;
        float gy = r > 1e-9f ? over * dy : q;
        weight[k] = q;
        normalX[k] = gx;
        normalY[k] = gy;
        ownDensity += q * q;
        ownX += gx;
        ownY += gy;
        density[j] += q * q;
        gradX[j] -= gx;
        gradY[j] -= gy;
      }
      density[i] = ownDensity;
      gradX[i] = ownX;
      gradY[i] = ownY;
    }
  }

  /** Moves pairs apart by the sum of their multipliers, and damps their approach and separation. */
  private void push(ParticleStore p, Neighbours pairs, float inverseH) {
    float[] x = p.x;
    float[] y = p.y;
    float[] vx = p.vx;
    float[] vy = p.vy;
    for (int i = 0; i < p.count; i++) {
      float own = density[i];
      float sumX = 0;
      float sumY = 0;
      float ownVx = vx[i];
      float ownVy = vy[i];
      int end = pairs.start[i + 1];
      for (int k = pairs.start[i]; k < end; k++) {
        int j = pairs.partner[k];
        if (weight[k] == 0) {
          continue;
        }
        float f = own + density[j];
        float gx = normalX[k];
        float gy = normalY[k];
        float rate = f * inverseH - DAMPING * ((ownVx - vx[j]) * gx + (ownVy - vy[j]) * gy);
        float ux = f * gx;
        float uy = f * gy;
        sumX += ux;
        sumY += uy;
        x[j] -= ux;
        y[j] -= uy;
        ownVx += rate * gx;
        ownVy += rate * gy;
        vx[j] -= rate * gx;
        vy[j] -= rate * gy;
      }
      x[i] += sumX;
      y[i] += sumY;
      vx[i] = ownVx;
      vy[i] = ownVy;
    }
  }
}
