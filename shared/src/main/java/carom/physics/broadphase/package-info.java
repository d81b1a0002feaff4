/**
 * Broadphase: which boxes overlap, without testing all of them against all.
 *
 * <p>Purpose: a spatial index over axis-aligned boxes that answers two questions, "what overlaps
 * this box?" and "which pairs overlap?". {@link carom.physics.broadphase.KdTree} is the engine's
 * own; {@link carom.physics.broadphase.QuadTree} is there for comparison and {@link
 * carom.physics.broadphase.BruteForce} as the oracle of the tests.
 *
 * <p>The set of pairs is a pure function of the boxes: it never depends on the shape of a tree or
 * on how it came to be. The <em>order</em> of pairs does, so a caller whose results depend on order
 * (the solver does) sorts them first.
 *
 * <p>Allowed imports: {@code carom.physics.math} and the JDK.
 *
 * <p>Read first: {@link carom.physics.broadphase.AabbArray}, {@link
 * carom.physics.broadphase.SpatialIndex}, {@link carom.physics.broadphase.KdTree}.
 */
package carom.physics.broadphase;
