package carom.server.level;

import carom.physics.Body;
import carom.physics.BodyType;
import carom.physics.World;
import carom.physics.collision.Collider;
import carom.physics.collision.Manifold;
import carom.physics.geometry.Convex;
import carom.physics.math.Aabb;
import carom.physics.math.Transform;
import carom.sim.entity.HostEntity;
import java.util.ArrayList;
import java.util.List;

/** Finds a static body that another one overlaps so far that it must be pushed out. */
final class DeepOverlap {
  /** A convex part with its pose. */
  private record Part(Body<HostEntity> body, Convex shape, Transform pose) {}

  private final Body<HostEntity> body;
  private final List<Part> own = new ArrayList<>();
  private final List<Part> walls = new ArrayList<>();

  DeepOverlap(World<HostEntity> world, Body<HostEntity> body) {
    this.body = body;
    Aabb box = new Aabb();
    body.aabb(box);
    world.queries().parts(box, null, this::sort);
  }

  private boolean sort(Body<HostEntity> of, int shape, Convex part, Transform pose) {
    boolean isWall = of.type() == BodyType.STATIC && !of.user().archetype().oneWay();
    if (of == body || isWall) {
      (isWall ? walls : own).add(new Part(of, part, new Transform().set(pose)));
    }
    return true;
  }

  /** Returns a static body in which the body is deeper than so many metres, or null. */
  HostEntity find(float depth) {
    Collider collider = new Collider();
    Manifold manifold = new Manifold();
    for (Part wall : walls) {
      for (Part part : own) {
        collider.collide(wall.shape, wall.pose, part.shape, part.pose, 0, manifold);
        if (manifold.count > 0 && manifold.minSeparation() < -depth && !isJoined(wall.body)) {
          return wall.body.user();
        }
      }
    }
    return null;
  }

  private boolean isJoined(Body<HostEntity> wall) {
    boolean[] joined = new boolean[1];
    body.forEachJoint(joint -> joined[0] |= joint.bodyA() == wall || joint.bodyB() == wall);
    return joined[0];
  }
}
