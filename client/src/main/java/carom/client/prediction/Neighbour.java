package carom.client.prediction;

import carom.client.interpolation.Pose;
import carom.physics.Body;
import carom.sim.Archetype;
import carom.sim.Entity;
import java.util.Arrays;

/** One predicted body: the own one, or one near it. */
final class Neighbour {
  /** Time in which a body changes from drawn in the past to drawn in the present, seconds. */
  private static final float BLEND_SECONDS = 0.15f;

  final int id;
  final int generation;
  final Archetype archetype;
  final int ownerId;
  final VisualError error = new VisualError();
  final Pose before = new Pose();

  /** Pose a tick ago. */
  final Pose previous = new Pose();

  private final int[] ringTick = new int[Prediction.RING];
  private final float[] ring = new float[Prediction.RING * 6];
  Entity entity;
  boolean wanted = true;
  boolean placed;

  /**
   * Whether it only follows its course: what it leans on is not predicted, so forces on it mean
   * nothing.
   */
  boolean held;

  /** The owner's newest known input, packed, and its tick; -1 when none is known. */
  long input;

  int inputTick = -1;

  private float weight;

  Neighbour(int id, int generation, Archetype archetype, int ownerId, float weight) {
    this.id = id;
    this.generation = generation;
    this.archetype = archetype;
    this.ownerId = ownerId;
    this.weight = weight;
    Arrays.fill(ringTick, -1);
  }

  Body<Entity> body() {
    return entity.body();
  }

  /** Remembers the state after a tick. */
  void keep(int tick) {
    int slot = tick & (Prediction.RING - 1);
    int at = slot * 6;
    Body<Entity> body = body();
    ringTick[slot] = tick;
    ring[at] = body.x();
    ring[at + 1] = body.y();
    ring[at + 2] = body.angle();
    ring[at + 3] = body.velocityX();
    ring[at + 4] = body.velocityY();
    ring[at + 5] = body.angularVelocity();
  }

  /** What was predicted for a tick; false when nothing was. */
  boolean at(int tick, Pose out) {
    int slot = tick & (Prediction.RING - 1);
    if (ringTick[slot] != tick) {
      return false;
    }
    int at = slot * 6;
    out.set(ring[at], ring[at + 1], ring[at + 2], ring[at + 3], ring[at + 4], ring[at + 5]);
    return true;
  }

  /** After a step of the world: a held body goes on as it went before the step. */
  void holdCourse(float seconds) {
    if (!held) {
      return;
    }
    Body<Entity> body = body();
    body.setPose(
        previous.x + previous.vx * seconds,
        previous.y + previous.vy * seconds,
        previous.angle + previous.omega * seconds);
    body.setVelocity(previous.vx, previous.vy);
    body.setAngularVelocity(previous.omega);
  }

  void pose(Pose out) {
    read(body(), out);
  }

  static void read(Body<Entity> body, Pose out) {
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
    weight = wanted ? Math.min(1, weight + step) : Math.max(0, weight - step);
  }

  /** Share of the prediction in what is drawn, 0..1, without corners in time. */
  float share() {
    return weight * weight * (3 - 2 * weight);
  }

  boolean faded() {
    return !wanted && weight == 0;
  }
}
