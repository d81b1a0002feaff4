package carom.physics;

/**
 * What the last step had to do, as counters (the engine knows no clock).
 *
 * @param bodies bodies in the world
 * @param awake bodies that are awake and not static; the others cost nothing
 * @param pairs pairs of shape parts whose fat AABBs overlap, of awake bodies with each other and
 *     with what rests
 * @param contacts pairs of these that touch
 */
public record StepProfile(int bodies, int awake, int pairs, int contacts) {}
