package carom.sim.scene;

import carom.physics.Body;
import carom.physics.BodyType;
import carom.physics.Joint;
import carom.physics.JointType;
import carom.physics.World;
import carom.physics.collision.Mtv;
import carom.physics.collision.Sat;
import carom.physics.math.Aabb;
import carom.physics.math.Transform;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/**
 * Measures whether a world is in a sane state, from the poses and velocities alone. A fast engine
 * whose bodies overlap, escape or gain energy has not done its work. Positions and speeds are those
 * of the dynamic bodies' centres of mass.
 *
 * @param kineticEnergy of all dynamic bodies, J
 * @param lowestY m; positive infinity without dynamic bodies
 * @param maxCoordinate largest distance from an axis, m
 * @param topSpeed m/s
 * @param nanCount number of dynamic bodies with a pose or velocity that is not finite
 * @param overlaps number of pairs of solid shapes that overlap, at least one of them dynamic
 * @param deepOverlaps number of overlaps deeper than {@link #DEEP}
 * @param maxDepth deepest overlap, m
 * @param meanDepth mean depth of all overlaps, m; 0 without any
 * @param worstJointGap largest distance between the two anchors of a revolute joint or weld, m
 */
public record SceneReport(
    double kineticEnergy,
    float lowestY,
    float maxCoordinate,
    float topSpeed,
    int nanCount,
    int overlaps,
    int deepOverlaps,
    float maxDepth,
    float meanDepth,
    float worstJointGap) {
  /** Depth from which on an overlap can be seen, m. */
  public static final float DEEP = 0.02f;

  /**
   * Measures a world. This takes longer than a step.
   *
   * @param world between two steps; not changed
   * @return the report
   */
  public static SceneReport of(World<?> world) {
    return new Survey<>(world).report();
  }

  @Override
  public String toString() {
    return String.format(
        Locale.ROOT,
        "energy=%.4g J lowest=%.3f m farthest=%.3f m top=%.3f m/s nan=%d overlaps=%d deep=%d"
            + " max=%.4f m mean=%.5f m gap=%.4f m",
        kineticEnergy,
        lowestY,
        maxCoordinate,
        topSpeed,
        nanCount,
        overlaps,
        deepOverlaps,
        maxDepth,
        meanDepth,
        worstJointGap);
  }

  /** Collects the figures of one report. */
  private static final class Survey<T> {
    private final World<T> world;
    private final Sat sat = new Sat();
    private final Mtv mtv = new Mtv();
    private final Aabb box = new Aabb();
    private final Transform pose = new Transform();
    private final Transform otherPose = new Transform();
    private final List<Body<T>> near = new ArrayList<>();
    private double energy;
    private float lowest = Float.POSITIVE_INFINITY;
    private float farthest;
    private double topSquare;
    private int nans;
    private int overlaps;
    private int deep;
    private float deepest;
    private double depths;
    private float gap;

    Survey(World<T> world) {
      this.world = world;
    }

    SceneReport report() {
      world.forEachBody(
          body -> {
            if (body.type() == BodyType.DYNAMIC) {
              motion(body);
            }
          });
      world.forEachJoint(this::gap);
      return new SceneReport(
          energy,
          lowest,
          farthest,
          (float) Math.sqrt(topSquare),
          nans,
          overlaps,
          deep,
          deepest,
          overlaps == 0 ? 0 : (float) (depths / overlaps),
          gap);
    }

    private void motion(Body<T> b) {
      double v2 = (double) b.velocityX() * b.velocityX() + (double) b.velocityY() * b.velocityY();
      double w2 = (double) b.angularVelocity() * b.angularVelocity();
      if (!Double.isFinite(v2 + w2) || !Float.isFinite(b.x() + b.y() + b.cos() + b.sin())) {
        nans++;
        return;
      }
      energy += 0.5 * (b.mass() * v2 + b.inertia() * w2);
      topSquare = Math.max(topSquare, v2);
      lowest = Math.min(lowest, b.centerY());
      farthest = Math.max(farthest, Math.max(Math.abs(b.centerX()), Math.abs(b.centerY())));
      if (b.shapeCount() > 0 && b.isEnabled()) {
        overlaps(b);
      }
    }

    private void overlaps(Body<T> body) {
      body.aabb(box);
      near.clear();
      world.queryAabb(
          box.minX,
          box.minY,
          box.maxX,
          box.maxY,
          other -> {
            // A pair of two dynamic bodies counts once.
            if (other.type() != BodyType.DYNAMIC || other.index() > body.index()) {
              near.add(other);
            }
            return true;
          });
      pose.set(body.x(), body.y(), body.cos(), body.sin());
      for (Body<T> other : near) {
        if (!joined(body, other)) {
          otherPose.set(other.x(), other.y(), other.cos(), other.sin());
          overlaps(body, other);
        }
      }
    }

    private void overlaps(Body<T> a, Body<T> b) {
      for (int i = 0; i < a.shapeCount(); i++) {
        for (int j = 0; j < b.shapeCount(); j++) {
          if (!a.sensor(i)
              && !b.sensor(j)
              && a.filter(i).meets(b.filter(j))
              && sat.mtv(a.shape(i), pose, b.shape(j), otherPose, mtv)) {
            float depth = mtv.length();
            overlaps++;
            deep += depth > DEEP ? 1 : 0;
            deepest = Math.max(deepest, depth);
            depths += depth;
          }
        }
      }
    }

    private static <T> boolean joined(Body<T> a, Body<T> b) {
      boolean[] found = new boolean[1];
      a.forEachJoint(j -> found[0] |= !j.collideConnected() && (j.bodyA() == b || j.bodyB() == b));
      return found[0];
    }

    private void gap(Joint<T> joint) {
      if (joint.type() == JointType.REVOLUTE || joint.type() == JointType.WELD) {
        double dx = (double) joint.anchorBX() - joint.anchorAX();
        double dy = (double) joint.anchorBY() - joint.anchorAY();
        gap = Math.max(gap, (float) Math.sqrt(dx * dx + dy * dy));
      }
    }
  }
}
