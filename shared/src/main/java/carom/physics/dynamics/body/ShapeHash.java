package carom.physics.dynamics.body;

import carom.physics.geometry.Convex;
import carom.physics.geometry.Segment;
import carom.physics.math.StateHash;

/** Hashes geometry; shapes never change, so once per body is enough. */
final class ShapeHash {
  private ShapeHash() {}

  /** Adds the vertices and the radius. */
  static long mix(long hash, Convex shape) {
    int n = shape.vertexCount();
    long h = StateHash.mix(hash, shape.radius(), n);
    for (int i = 0; i < n; i++) {
      h = StateHash.mix(h, shape.vertexX(i), shape.vertexY(i));
    }
    if (shape instanceof Segment segment && segment.isOneSided()) {
      for (int end = 0; end < 2; end++) {
        h = StateHash.mix(h, segment.isLinked(end) ? 1 : 2);
        h = StateHash.mix(h, segment.ghostX(end), segment.ghostY(end));
      }
    }
    return h;
  }
}
