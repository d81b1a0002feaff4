package carom.physics.particles;

/** How particles of a kind act on each other. */
abstract sealed class PairSolver permits Water, Sand {
  /** Distance of neighbours at rest in a triangular grid, m. */
  abstract float pitch();

  /** Returns how far to look for pairs, with room for what changes during a step, m. */
  abstract float reach();

  /** Once per step, after pairs were found. */
  abstract void begin(ParticleStore p, Neighbours pairs, float dt);

  /** Once per substep, after particles moved. */
  abstract void solve(ParticleStore p, Neighbours pairs, float h);
}
