package carom.physics.dynamics.continuous;

import carom.physics.collision.Sweep;
import carom.physics.dynamics.body.ShapeTable;
import carom.physics.geometry.Convex;
import carom.physics.math.Aabb;
import carom.physics.math.Transform;

/** A box that contains all that a part sweeps. */
final class SweptBox {
  private final ShapeTable parts;
  private final Aabb swept = new Aabb();
  private final Aabb tight = new Aabb();
  private final Transform pose = new Transform();

  SweptBox(ShapeTable parts) {
    this.parts = parts;
  }

  void setEmpty() {
    swept.setEmpty();
  }

  /** Adds what a part sweeps; what turning adds to the ends is bounded. */
  void add(int part, Sweep s) {
    Convex c = parts.convex[part];
    pose.set(s.x, s.y, s.cos, s.sin);
    c.aabb(pose, tight);
    swept.add(tight);
    if (s.dx == 0 && s.dy == 0 && s.angleRad == 0) {
      return;
    }
    s.at(1, pose);
    c.aabb(pose, tight);
    swept.add(tight);
    if (s.angleRad != 0) {
      float bulge = c.reach() * Math.min(2, 0.125f * s.angleRad * s.angleRad);
      swept.set(swept.minX - bulge, swept.minY - bulge, swept.maxX + bulge, swept.maxY + bulge);
    }
  }

  Aabb box() {
    return swept;
  }

  float minX() {
    return swept.minX;
  }

  float minY() {
    return swept.minY;
  }

  float maxX() {
    return swept.maxX;
  }

  float maxY() {
    return swept.maxY;
  }
}
