package carom.physics.profile;

import java.util.Locale;

/**
 * The stages of a step, for {@link StageListener}. A step enters some stages several times, once
 * per substep, and others not at all.
 */
public enum StepStage {
  /**
   * Applies the user's forces and impulses and changed filters, and wakes what moving bodies hold.
   */
  BEGIN,
  /** Updates the fat boxes of parts that left theirs. */
  BOXES,
  /** Updates the trees, finds overlapping pairs and merges them into the contact table. */
  PAIRS,
  /** Computes a manifold for each pair. */
  COLLIDE,
  /** Calls listeners (begin, end, pre-solve, post-solve, hits) and breaks joints. */
  EVENTS,
  /** Prepares bodies and contacts for the solver: colours, masses and softness. */
  PREPARE,
  /** Integrates velocities and positions of bodies. */
  INTEGRATE,
  /** Applies the contact impulses of the last substep again (warm start). */
  WARM,
  /** Solves the contacts with bias. */
  SOLVE,
  /** Solves the contacts without bias, and friction. */
  RELAX,
  /** Does all work on joints: prepare, warm start and both passes. */
  JOINTS,
  /** Applies restitution. */
  BOUNCE,
  /** Writes the results back to bodies and contacts. */
  FINISH,
  /** Stops fast bodies at what they would pass through. */
  CONTINUOUS,
  /** Finds islands and puts them to sleep. */
  SLEEP;

  @Override
  public String toString() {
    return name().toLowerCase(Locale.ROOT);
  }
}
