/**
 * What a spatial index of axis-aligned boxes is: the boxes, the two questions ("what overlaps this
 * box?", "which pairs overlap?"), and what receives the answers. Two simple indexes show it: {@link
 * carom.physics.broadphase.index.BruteForce}, the oracle of the tests, and {@link
 * carom.physics.broadphase.index.QuadTree}, for comparison.
 *
 * <p>May import {@code carom.physics.math}. Read first: {@link
 * carom.physics.broadphase.index.AabbArray}, {@link carom.physics.broadphase.index.SpatialIndex}.
 */
package carom.physics.broadphase.index;
