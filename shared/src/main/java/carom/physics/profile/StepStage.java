package carom.physics.profile;

import java.util.Locale;

/**
 * The parts a step consists of, for {@link StageListener}. A step enters some several times (once
 * per substep) and others not at all.
 */
public enum StepStage {
  /** Forces and impulses of the user, waking of what moving bodies hold, changed filters. */
  BEGIN,
  /** Fat boxes of parts that left theirs. */
  BOXES,
  /** Trees brought up to date, overlapping pairs found and merged into the contact table. */
  PAIRS,
  /** A manifold for each pair. */
  COLLIDE,
  /** Listeners: begin, end, pre-solve, post-solve, hits; broken joints. */
  EVENTS,
  /** Bodies and contacts made ready for the solver: colours, masses, softness. */
  PREPARE,
  /** Velocities and positions of bodies. */
  INTEGRATE,
  /** Contacts' impulses of the last substep applied again. */
  WARM,
  /** Contacts with bias. */
  SOLVE,
  /** Contacts without bias, and friction. */
  RELAX,
  /** All work on joints: prepare, warm start, both passes. */
  JOINTS,
  /** Restitution. */
  BOUNCE,
  /** Results written back to bodies and contacts. */
  FINISH,
  /** Fast bodies stopped at what they would pass through. */
  CONTINUOUS,
  /** Islands found and put to sleep. */
  SLEEP;

  @Override
  public String toString() {
    return name().toLowerCase(Locale.ROOT);
  }
}
