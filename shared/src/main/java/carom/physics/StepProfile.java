package carom.physics;

/**
 * Counters of the work of the last step. The engine reads no clock, so there are no times.
 *
 * @param bodies bodies in the world
 * @param awake bodies that are awake and not static; the others cost nothing
 * @param pairs pairs of shape parts whose fat AABBs overlap, of awake bodies with each other and
 *     with bodies at rest
 * @param contacts number of these pairs that touch
 */
public record StepProfile(int bodies, int awake, int pairs, int contacts) {}
