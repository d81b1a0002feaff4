package carom.physics.dynamics;

import carom.physics.geometry.Convex;

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
    return h;
  }
}
