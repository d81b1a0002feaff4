/**
 * The interface of a spatial index of axis-aligned boxes, with its queries and visitors. It finds
 * the boxes that overlap a box, the boxes that a moving box meets, and the pairs that overlap. Two
 * simple indexes implement it: {@link carom.physics.broadphase.index.BruteForce}, the oracle of the
 * tests, and {@link carom.physics.broadphase.index.QuadTree}, for comparison.
 *
 * <p>May import {@code carom.physics.math}. Read first: {@link
 * carom.physics.broadphase.index.AabbArray}, {@link carom.physics.broadphase.index.SpatialIndex}.
 */
package carom.physics.broadphase.index;
