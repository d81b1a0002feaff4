package carom.physics.dynamics.body;

import carom.physics.geometry.Convex;
import carom.physics.math.StateHash;

/**
 * Makes equal parts of different bodies one object: a pile of ten thousand crates then has one set
 * of vertices, which stays in the processor's cache, and needs less memory.
 *
 * <p>Remembers the last part of each hash value only, so that nothing has to be counted or
 * released; parts that miss each other are merely two objects. Shapes never change and are never
 * compared by identity, so results don't depend on it.
 */
final class ShapePool {
  private static final int PLACES = 256;

  private final Convex[] places = new Convex[PLACES];

  /** Returns a part of the same geometry, often one that is in use already. */
  Convex share(Convex part) {
    int place = (int) StateHash.finish(ShapeHash.mix(StateHash.SEED, part)) & (PLACES - 1);
    Convex known = places[place];
    if (known != null && known.isSame(part)) {
      return known;
    }
    places[place] = part;
    return part;
  }
}
