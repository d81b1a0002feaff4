package carom.client.prediction;

import carom.client.interpolation.Pose;
import carom.client.interpolation.VisualError;
import carom.physics.Body;
import carom.sim.Entity;

/**
 * How one predicted body is drawn: its poses, what is left of corrections, and how far it has
 * blended from the interpolated past into the predicted present.
 */
final class PredictedBody {
  /** Time to blend between interpolated and predicted, seconds. */
  private static final float BLEND_SECONDS = 0.15f;

  final int id;
  final int generation;
  final VisualError error = new VisualError();

  /** Pose before the correction that is under way. */
  final Pose before = new Pose();

  /** Pose one tick ago. */
  final Pose previous = new Pose();

  /** Straight course of a body that is no longer simulated. */
  private final Pose course = new Pose();

  /** The simulated entity; null once the body has left the predicted set. */
  Entity entity;

  private float blend;
  private int teleports;

  PredictedBody(int id, int generation, float blend) {
    this.id = id;
    this.generation = generation;
    this.blend = blend;
  }

  /** Ends the simulation of this body. It moves straight on from {@link #before} and fades out. */
  void detach() {
    if (entity != null) {
      course.set(before);
      entity = null;
    }
  }

  /**
   * Updates the teleport counter.
   *
   * @return whether it differs from the one of the last call: then the picture must jump
   */
  boolean updateTeleports(int counter) {
    boolean changed = counter != teleports;
    teleports = counter;
    return changed;
  }

  /** Reads the present pose. */
  void readPose(Pose out) {
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

  /** Lets time pass: the visual error fades, the blend moves towards its goal. */
  void advance(float seconds) {
    error.fade(seconds);
    float step = seconds / BLEND_SECONDS;
    if (entity != null) {
      blend = Math.min(1, blend + step);
      return;
    }
    blend = Math.max(0, blend - step);
    previous.set(course);
    course.x += course.vx * seconds;
    course.y += course.vy * seconds;
    course.angle += course.omega * seconds;
  }

  /** Returns the weight of the prediction in the picture, 0..1, smooth in time. */
  float weight() {
    return blend * blend * (3 - 2 * blend);
  }

  /** Returns whether the body has left the predicted set and nothing of it is drawn any more. */
  boolean isFadedOut() {
    return entity == null && blend == 0;
  }
}
