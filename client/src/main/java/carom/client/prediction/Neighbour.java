package carom.client.prediction;

import carom.client.interpolation.Pose;
import carom.client.interpolation.VisualError;
import carom.physics.Body;
import carom.sim.Entity;

/** The picture of one predicted body: the own one, or one near it. */
final class Neighbour {
  /** Time in which a body changes from drawn in the past to drawn in the present, seconds. */
  private static final float BLEND_SECONDS = 0.15f;

  final int id;
  final int generation;
  final VisualError error = new VisualError();

  /** Pose before a correction. */
  final Pose before = new Pose();

  /** Pose a tick ago. */
  final Pose previous = new Pose();

  /** Where it goes on when it is no longer simulated. */
  private final Pose course = new Pose();

  /** The simulated one; null once it is no longer predicted. */
  Entity entity;

  private float weight;
  private int teleports;

  Neighbour(int id, int generation, float weight) {
    this.id = id;
    this.generation = generation;
    this.weight = weight;
  }

  /** It is no longer simulated, and goes on from {@link #before} while it fades into the past. */
  void leave() {
    if (entity != null) {
      course.set(before);
      entity = null;
    }
  }

  /**
   * Says how often the body was teleported, as far as is known.
   *
   * @return whether it was since the last call: then no glide leads there
   */
  boolean teleports(int known) {
    boolean changed = known != teleports;
    teleports = known;
    return changed;
  }

  /** Where it is in the present. */
  void pose(Pose out) {
    if (entity == null) {
      out.set(course);
      return;
    }
    Body<Entity> body = entity.body();
    out.set(
        body.x(),
        body.y(),
        body.angle(),
        body.velocityX(),
        body.velocityY(),
        body.angularVelocity());
  }

  /** Lets time pass: errors fade, the weight moves to where it belongs. */
  void advance(float seconds) {
    error.fade(seconds);
    float step = seconds / BLEND_SECONDS;
    if (entity != null) {
      weight = Math.min(1, weight + step);
      return;
    }
    weight = Math.max(0, weight - step);
    previous.set(course);
    course.x += course.vx * seconds;
    course.y += course.vy * seconds;
    course.angle += course.omega * seconds;
  }

  /** Share of the prediction in what is drawn, 0..1, without corners in time. */
  float share() {
    return weight * weight * (3 - 2 * weight);
  }

  boolean faded() {
    return entity == null && weight == 0;
  }
}
