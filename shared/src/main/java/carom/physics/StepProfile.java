package carom.physics;

/**
 * What the last step had to do, as counters (the engine knows no clock).
 *
 * @param bodies bodies in the world
 * @param awake bodies that are not static
 * @param pairs pairs of shape parts whose fat AABBs overlap
 * @param contacts pairs that touch
 */
public record StepProfile(int bodies, int awake, int pairs, int contacts) {}
