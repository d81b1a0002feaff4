package carom.physics.truth;

import carom.physics.Body;
import carom.physics.BodyType;
import carom.physics.World;
import carom.physics.collision.Mtv;
import carom.physics.collision.Sat;
import carom.physics.geometry.Convex;
import carom.physics.math.Aabb;
import carom.physics.math.Transform;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

/** Figures that tell whether a run is a result at all, from poses and shapes alone. */
final class Sanity {
  /** Overlapping pairs of parts, the deepest, and how many are deeper than 2 cm. */
  record Overlaps(int count, double deepest, int deep) {}

  private record Part(Body<?> body, Convex convex, Transform pose, Aabb box, int shape) {}

  private Sanity() {}

  /** Looks at all pairs of parts that may collide, by sweep and the separating axis theorem. */
  static Overlaps overlaps(World<?> w) {
    List<Part> parts = new ArrayList<>();
    w.forEachBody(b -> addParts(b, parts));
    parts.sort(Comparator.comparingDouble(p -> p.box.minX));
    Sat sat = new Sat();
    Mtv mtv = new Mtv();
    int count = 0;
    int deep = 0;
    double deepest = 0;
    for (int i = 0; i < parts.size(); i++) {
      Part p = parts.get(i);
      for (int k = i + 1; k < parts.size() && parts.get(k).box.minX <= p.box.maxX; k++) {
        Part q = parts.get(k);
        boolean still = p.body.type() != BodyType.DYNAMIC && q.body.type() != BodyType.DYNAMIC;
        if (p.body == q.body
            || still
            || !p.box.overlaps(q.box)
            || !p.body.filter(p.shape).meets(q.body.filter(q.shape))) {
          continue;
        }
        if (sat.mtv(p.convex, p.pose, q.convex, q.pose, mtv)) {
          count++;
          deepest = Math.max(deepest, mtv.length());
          deep += mtv.length() > .02 ? 1 : 0;
        }
      }
    }
    return new Overlaps(count, deepest, deep);
  }

  private static void addParts(Body<?> b, List<Part> parts) {
    Transform pose = new Transform().set(b.x(), b.y(), b.cos(), b.sin());
    for (int s = 0; s < b.shapeCount(); s++) {
      for (Convex convex : b.shape(s).parts()) {
        Aabb box = new Aabb();
        convex.aabb(pose, box);
        parts.add(new Part(b, convex, pose, box, s));
      }
    }
  }

  /** Widest gap between the anchors of any joint, m. */
  static double widestGap(World<?> w) {
    double[] widest = new double[1];
    w.forEachJoint(
        j ->
            widest[0] =
                Math.max(
                    widest[0],
                    Math.hypot(j.anchorBX() - j.anchorAX(), j.anchorBY() - j.anchorAY())));
    return widest[0];
  }

  /** Lowest y of any dynamic body. */
  static double lowest(World<?> w) {
    double[] lowest = {Double.POSITIVE_INFINITY};
    w.forEachBody(
        b -> lowest[0] = b.type() == BodyType.DYNAMIC ? Math.min(lowest[0], b.y()) : lowest[0]);
    return lowest[0];
  }
}
