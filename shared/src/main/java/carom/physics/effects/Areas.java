package carom.physics.effects;

import carom.physics.Body;
import carom.physics.World;
import carom.physics.math.Aabb;
import carom.physics.math.Limits;
import carom.physics.math.Transform;

/** Checks and actions common to all areas. */
final class Areas {
  /** Largest factor on an effect. */
  private static final float MAX_STRENGTH = 1e6f;

  private Areas() {}

  static void check(Aabb area) {
    if (Limits.notNull("area", area).isEmpty()) {
      throw new IllegalArgumentException("area=" + area + " is empty, needs min <= max");
    }
    Limits.coordinate("minX", area.minX);
    Limits.coordinate("minY", area.minY);
    Limits.coordinate("maxX", area.maxX);
    Limits.coordinate("maxY", area.maxY);
  }

  /** Checks what an effect is asked to act on. */
  static void check(World<?> world, Body<?> body, Transform frame, float strength, float dt) {
    Limits.notNull("world", world);
    Limits.notNull("body", body);
    Limits.notNull("frame", frame);
    Limits.range("strength", strength, -MAX_STRENGTH, MAX_STRENGTH);
    Limits.timeStep(dt);
  }

  /**
   * Applies an ambient force, cut to the largest there may be: an effect that has begun acts on all
   * of its bodies.
   */
  static void push(Body<?> body, double fx, double fy, double torque) {
    body.applyAmbientForce(cut(fx), cut(fy), cut(torque));
  }

  private static float cut(double force) {
    return (float) Math.max(-Limits.MAX_FORCE, Math.min(force, Limits.MAX_FORCE));
  }

  /** Computes the box around an area in a frame. */
  static void reach(Aabb area, Transform frame, Aabb out) {
    Limits.notNull("frame", frame);
    Limits.notNull("out", out).setEmpty();
    out.add(frame.worldX(area.minX, area.minY), frame.worldY(area.minX, area.minY));
    out.add(frame.worldX(area.maxX, area.minY), frame.worldY(area.maxX, area.minY));
    out.add(frame.worldX(area.maxX, area.maxY), frame.worldY(area.maxX, area.maxY));
    out.add(frame.worldX(area.minX, area.maxY), frame.worldY(area.minX, area.maxY));
  }

  static void wake(Nearby nearby, World<?> world, Aabb area) {
    nearby.find(world, area);
    for (int i = 0; i < nearby.count(); i++) {
      nearby.get(i).wake();
    }
    nearby.clear();
  }
}
