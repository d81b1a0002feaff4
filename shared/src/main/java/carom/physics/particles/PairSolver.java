package carom.physics.particles;

/** Interaction between particles of one kind. */
abstract sealed class PairSolver permits Water, Sand {
  /** Returns the distance of neighbours at rest in a triangular grid, m. */
  abstract float pitch();

  /** Returns the search distance for pairs, with a margin for their motion during a step, m. */
  abstract float reach();

  /** Prepares a step. The particle system calls it once per step, after the search for pairs. */
  abstract void begin(ParticleStore p, Neighbours pairs, float dt);

  /** Solves a substep. The particle system calls it once per substep, after the particles moved. */
  abstract void solve(ParticleStore p, Neighbours pairs, float h);
}
