package carom.physics.dynamics;

import carom.physics.geometry.Convex;
import carom.physics.geometry.MassData;
import carom.physics.math.Aabb;
import carom.physics.math.Transform;

/** Hashes geometry; shapes never change, so once per body is enough. */
final class ShapeHash {
  private ShapeHash() {}

  /** Adds what tells shapes apart: the kind, the area and its distribution, and extents. */
  static long mix(long hash, Convex shape) {
    Aabb box = new Aabb();
    Transform pose = new Transform();
    long h = StateHash.mix(hash, shape.getClass().getSimpleName().length());
    for (int turn = 0; turn < 4; turn++) {
      pose.set(0, 0, turn * 0.4f);
      shape.aabb(pose, box);
      h = StateHash.mix(h, box.minX, box.minY);
      h = StateHash.mix(h, box.maxX, box.maxY);
    }
    MassData mass = shape.mass(1);
    h = StateHash.mix(h, mass.mass(), mass.inertia());
    return StateHash.mix(h, mass.centerX(), mass.centerY());
  }
}
