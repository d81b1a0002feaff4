package carom.physics.dynamics.continuous;

import carom.physics.collision.Sweep;
import carom.physics.dynamics.body.ActiveBodies;
import carom.physics.dynamics.body.BodyStore;
import carom.physics.math.Transform;

/**
 * The motion of a target in a step: none, one stretch, or two if the target itself was stopped at
 * something and carried along with it.
 */
final class TargetMotion {
  /** The motion up to {@link #split}. */
  Sweep first;

  /** The motion from {@link #split} on; means nothing if that is 1. */
  Sweep second;

  /** The time at which the second stretch begins, as a part of the step. */
  float split;

  private final BodyStore bodies;
  private final ActiveBodies active;
  private final FastBodies fast;
  private final Sweep own = new Sweep();
  private final Transform pose = new Transform();

  TargetMotion(BodyStore bodies, ActiveBodies active, FastBodies fast) {
    this.bodies = bodies;
    this.active = active;
    this.fast = fast;
  }

  /** Sets this to the motion of a body. */
  void of(int body) {
    Flight f = bodies.type[body] == BodyStore.STATIC ? null : fast.flightOf(body);
    split = 1;
    if (f != null) {
      split = f.split;
      first = f.beginning();
      second = f.second;
    } else {
      first = own;
      if (active.contains(body)) {
        fast.motion(body, own);
      } else {
        pose.set(bodies.x[body], bodies.y[body], bodies.cos[body], bodies.sin[body]);
        own.set(pose, 0, 0, 0);
      }
    }
  }

  /** Returns whether the target moves at all. */
  boolean moves() {
    return split < 1 || first.dx != 0 || first.dy != 0 || first.angleRad != 0;
  }

  /** Computes the target's pose at a time, a part of the step. */
  void at(float time, Transform out) {
    if (time <= split) {
      first.at(time / split, out);
    } else {
      second.at((time - split) / (1 - split), out);
    }
  }
}
