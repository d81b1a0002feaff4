package carom.physics.dynamics;

import carom.physics.dynamics.body.ActiveBodies;
import carom.physics.dynamics.body.BodyStore;
import carom.physics.settings.Settings;

/**
 * Measures how long each active body has been at rest, in {@link BodyStore#sleepTime}, s. A
 * kinematic body that was put elsewhere by hand has the value {@link #MOVED} instead until the next
 * step has seen it, because it pushes what it touches although its velocity is zero.
 */
final class RestTime {
  /** The value that stands for a kinematic body put elsewhere by hand. */
  private static final float MOVED = -1;

  /** The same within the step that sees it. A callback of that step may put it elsewhere again. */
  private static final float SEEN = -2;

  private final Settings settings;
  private final BodyStore bodies;
  private final ActiveBodies active;

  /** True once a step has seen a body that was put elsewhere by hand. */
  private boolean anyMoved;

  RestTime(Settings settings, BodyStore bodies, ActiveBodies active) {
    this.settings = settings;
    this.bodies = bodies;
    this.active = active;
  }

  /** Marks a kinematic body as put elsewhere by hand; does nothing with other ones. */
  void markMoved(int body) {
    if (bodies.type[body] == BodyStore.KINEMATIC && settings.sleeping()) {
      bodies.sleepTime[body] = MOVED;
    }
  }

  /** Returns whether a body was put elsewhere by hand and no step has seen it. */
  boolean moved(int body) {
    return bodies.sleepTime[body] < 0;
  }

  /** Notes that a step has seen a kinematic body that moves. */
  void noteDriven(int body) {
    if (moved(body)) {
      anyMoved = true;
      bodies.sleepTime[body] = SEEN;
    }
  }

  /** Clears the marks of all bodies that a step has seen. */
  void forgetMoves() {
    if (!anyMoved) {
      return;
    }
    anyMoved = false;
    for (int i = 0; i < active.count; i++) {
      int body = active.list[i];
      if (bodies.sleepTime[body] == SEEN) {
        bodies.sleepTime[body] = 0;
      }
    }
  }

  /** Forgets that a step has seen moved bodies, for a state that is restored. */
  void reset() {
    anyMoved = false;
  }

  /** Starts an awake body's time anew; a mark stays. */
  void restart(int body) {
    bodies.sleepTime[body] = Math.min(bodies.sleepTime[body], 0);
  }

  /** Starts the time of a body that wakes; a mark stays. */
  void wake(int body) {
    bodies.sleepTime[body] = moved(body) ? MOVED : 0;
  }

  private float sleepSpeed(int body) {
    float own = bodies.sleepSpeed[body];
    return own == BodyStore.WORLDS ? settings.sleepSpeed() : own;
  }

  /** Adds a step's time if the body was slow; returns whether it may fall asleep. */
  boolean add(int body, float dt) {
    float vx = bodies.vx[body];
    float vy = bodies.vy[body];
    float most = bodies.type[body] == BodyStore.DYNAMIC ? sleepSpeed(body) : 0;
    float spin = bodies.reach[body] * bodies.w[body];
    boolean slow = vx * vx + vy * vy <= most * most && Math.abs(spin) <= most;
    if (moved(body)) {
      return false;
    }
    if (!slow || (bodies.flags[body] & BodyStore.SLEEPLESS) != 0) {
      bodies.sleepTime[body] = 0;
      return false;
    }
    float time = bodies.sleepTime[body] + dt;
    bodies.sleepTime[body] = Math.min(time, settings.sleepDelay());
    return time >= settings.sleepDelay();
  }
}
