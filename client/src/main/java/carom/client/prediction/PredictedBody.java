package carom.client.prediction;

import carom.client.interpolation.Pose;
import carom.client.interpolation.VisualError;
import carom.physics.Body;
import carom.sim.entity.HostEntity;
import carom.sim.level.Archetype;
import carom.sim.spawn.Origin;

/**
 * The picture of one predicted body: its poses, what is left of corrections, and how far it has
 * blended from the interpolated past into the predicted present.
 */
final class PredictedBody {
  /** Time to blend between interpolated and predicted, seconds. */
  private static final float BLEND_SECONDS = 0.15f;

  int id;
  int generation;
  Archetype archetype;
  final VisualError error = new VisualError();

  /** Pose before the correction that is under way. */
  final Pose before = new Pose();

  /** Pose one tick ago. */
  final Pose previous = new Pose();

  /** Straight course of a body that is no longer simulated. */
  private final Pose course = new Pose();

  /** True if the body belongs to the own player. */
  boolean isOwn;

  /** True if the body was simulated before the correction that is under way. */
  boolean wasThere;

  /** The simulated entity; null once the body has left the predicted set. */
  HostEntity entity;

  private float blend;
  private int teleports;

  PredictedBody(int id, int generation, Archetype archetype, float blend) {
    this.id = id;
    this.generation = generation;
    this.archetype = archetype;
    this.blend = blend;
  }

  /** Becomes the picture of another entity, which takes the place of this one. */
  void become(HostEntity other, int counter) {
    id = other.id();
    generation = other.generation();
    entity = other;
    teleports = counter;
  }

  /**
   * Ends the simulation of this body. It moves straight on and fades out.
   *
   * @param last where it was
   */
  void detach(Pose last) {
    if (entity != null) {
      course.set(last);
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
    Body<HostEntity> body = entity.body();
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

  /** Returns whether it is the picture of an entity that the server hasn't told yet. */
  boolean isProvisional() {
    return Origin.isProvisional(id);
  }

  /** Returns whether the body has left the predicted set and nothing of it is drawn any more. */
  boolean isFadedOut() {
    return entity == null && blend == 0;
  }
}
