/**
 * Broadphase for users of boxes: collections of elements with boxes, and a cache of the pairs that
 * overlap from tick to tick.
 *
 * <p>The engine's own search of pairs is {@code dynamics.pairs}; it uses the KD-tree of {@code
 * broadphase.kd} directly. The set of pairs is a pure function of the boxes: it never depends on
 * the shape of a tree or on its history. The <em>order</em> of pairs does, so a caller whose
 * results depend on order, as the solver's do, sorts them first.
 *
 * <p>May import {@code carom.physics.math}, {@code threads}, {@code broadphase.index} and {@code
 * broadphase.kd}. Read first: {@link carom.physics.broadphase.SpatialCollection}, {@link
 * carom.physics.broadphase.PairCache}.
 */
package carom.physics.broadphase;
