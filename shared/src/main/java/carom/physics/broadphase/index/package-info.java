/**
 * The interface of a spatial index of axis-aligned boxes: the boxes, the queries (which boxes
 * overlap this one, which does a moving box meet, which pairs overlap), and the visitors that
 * receive the results. Two simple indexes implement it: {@link
 * carom.physics.broadphase.index.BruteForce}, the oracle of the tests, and {@link
 * carom.physics.broadphase.index.QuadTree}, for comparison.
 *
 * <p>May import {@code carom.physics.math}. Read first: {@link
 * carom.physics.broadphase.index.AabbArray}, {@link carom.physics.broadphase.index.SpatialIndex}.
 */
package carom.physics.broadphase.index;
