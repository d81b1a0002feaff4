package carom.physics.geometry;

import carom.physics.archive.Archive;
import carom.physics.math.Limits;
import java.util.ArrayList;
import java.util.List;

/**
 * Archive format of shapes, bit for bit. It restores a polygon from its vertices and normals
 * instead of building it again, because a new build would round again.
 */
public final class ShapeArchive {
  private static final int CIRCLE = 0;
  private static final int BOX = 1;
  private static final int CAPSULE = 2;
  private static final int POLYGON = 3;
  private static final int SEGMENT = 4;
  private static final int CHAIN = 5;
  private static final int COMPOUND = 6;

  private static final float MOST = Shape.MAX_SIZE;

  private ShapeArchive() {}

  /**
   * Passes a shape through an archive.
   *
   * @param a the archive to write to or read from
   * @param shape ignored when reading
   * @return the given shape when writing, the one read when reading
   * @throws IllegalArgumentException if the data read is no valid shape
   */
  public static Shape pass(Archive a, Shape shape) {
    Limits.notNull("a", a);
    int kind = a.integer("kind of shape", a.reads() ? 0 : kindOf(shape), 0, COMPOUND);
    switch (kind) {
      case CHAIN:
        return passChain(a, (Chain) shape);
      case COMPOUND:
        return passCompound(a, (Compound) shape);
      default:
        return passConvex(a, kind, (Convex) shape);
    }
  }

  private static int kindOf(Shape shape) {
    if (shape instanceof Convex convex) {
      return kindOf(convex);
    }
    return shape instanceof Chain ? CHAIN : COMPOUND;
  }

  private static int kindOf(Convex convex) {
    if (convex instanceof Circle) {
      return CIRCLE;
    } else if (convex instanceof Box) {
      return BOX;
    } else if (convex instanceof Capsule) {
      return CAPSULE;
    }
    return convex instanceof Polygon ? POLYGON : SEGMENT;
  }

  private static Convex passConvex(Archive a, int kind, Convex c) {
    boolean reads = a.reads();
    switch (kind) {
      case CIRCLE:
        {
          float[] n = reads ? new float[3] : new float[] {c.radius(), c.vx[0], c.vy[0]};
          a.numbers("circle", n, n.length, MOST);
          return reads ? new Circle(n[0], n[1], n[2]) : c;
        }
      case BOX:
        {
          float[] n = reads ? new float[4] : numbers((Box) c);
          a.numbers("box", n, n.length, MOST);
          return reads ? new Box(n[0], n[1], n[2], n[3]) : c;
        }
      case CAPSULE:
        {
          float[] n =
              reads ? new float[5] : new float[] {c.vx[0], c.vy[0], c.vx[1], c.vy[1], c.radius()};
          a.numbers("capsule", n, n.length, MOST);
          return reads ? new Capsule(n[0], n[1], n[2], n[3], n[4]) : c;
        }
      case POLYGON:
        return passPolygon(a, (Polygon) c);
      default:
        return passSegment(a, (Segment) c);
    }
  }

  private static float[] numbers(Box b) {
    return new float[] {b.halfWidth(), b.halfHeight(), b.centerX(), b.centerY()};
  }

  private static Polygon passPolygon(Archive a, Polygon p) {
    boolean reads = a.reads();
    int n = a.count("polygon vertices", reads ? 0 : p.vx.length, Convex.MAX_VERTICES, 16);
    a.require(n >= 3, "polygon vertices=" + n + " are less than 3");
    float[] xs = reads ? new float[n] : p.vx;
    float[] ys = reads ? new float[n] : p.vy;
    float[] nx = reads ? new float[n] : p.nx;
    float[] ny = reads ? new float[n] : p.ny;
    a.numbers("polygon x", xs, n, MOST);
    a.numbers("polygon y", ys, n, MOST);
    a.numbers("polygon normal", nx, n, 1);
    a.numbers("polygon normal", ny, n, 1);
    float radius = a.number("polygon radius", reads ? 0 : p.radius(), 0, MOST);
    for (int i = 0; i < n; i++) {
      float square = nx[i] * nx[i] + ny[i] * ny[i];
      a.require(Math.abs(square - 1) < 1e-3f, "polygon normal of length^2=" + square);
    }
    return reads ? Polygon.exact(xs, ys, nx, ny, radius) : p;
  }

  private static Segment passSegment(Archive a, Segment s) {
    boolean reads = a.reads();
    float[] n =
        reads
            ? new float[8]
            : new float[] {
              s.vx[0], s.vy[0], s.vx[1], s.vy[1], s.ghostX(0), s.ghostY(0), s.ghostX(1), s.ghostY(1)
            };
    a.numbers("segment", n, n.length, 2 * MOST);
    boolean oneSided = a.flag("one-sided segment", !reads && s.isOneSided());
    boolean[] linked = new boolean[2];
    for (int end = 0; end < 2; end++) {
      linked[end] = a.flag("linked segment", !reads && s.isLinked(end));
    }
    if (!reads) {
      return s;
    }
    float[] ghostX = {n[4], n[6]};
    float[] ghostY = {n[5], n[7]};
    return new Segment(n[0], n[1], n[2], n[3], oneSided, linked, ghostX, ghostY);
  }

  private static Chain passChain(Archive a, Chain c) {
    boolean reads = a.reads();
    int points = a.count("chain points", reads ? 0 : c.pointCount(), Chain.MAX_SEGMENTS + 1, 8);
    boolean loop = a.flag("chain that is a loop", !reads && c.isLoop());
    float[] xy = new float[2 * points];
    for (int i = 0; !reads && i < points; i++) {
      xy[2 * i] = c.pointX(i);
      xy[2 * i + 1] = c.pointY(i);
    }
    a.numbers("chain point", xy, xy.length, MOST);
    float[] before = passBeyond(a, reads ? null : c.before());
    float[] after = passBeyond(a, reads ? null : c.after());
    if (!reads) {
      return c;
    }
    a.require(!loop || (before == null && after == null), "loop=true of a chain that goes on");
    Chain whole = loop ? Chain.loop(xy) : Chain.open(xy);
    return before == null && after == null ? whole : new Chain(xy, false, before, after);
  }

  /** Passes the point beyond an end of a chain through an archive, null if there is none. */
  private static float[] passBeyond(Archive a, float[] point) {
    if (!a.flag("chain that goes on", point != null)) {
      return null;
    }
    float[] xy = point == null ? new float[2] : point;
    a.numbers("point beyond a chain", xy, 2, MOST);
    return xy;
  }

  private static Compound passCompound(Archive a, Compound c) {
    boolean reads = a.reads();
    int count = a.count("compound parts", reads ? 0 : c.parts().size(), Compound.MAX_PARTS, 16);
    List<Convex> parts = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      Convex part = reads ? null : c.parts().get(i);
      int kind = a.integer("kind of part", reads ? 0 : kindOf(part), 0, SEGMENT);
      parts.add(passConvex(a, kind, part));
    }
    return reads ? Compound.of(parts) : c;
  }
}
