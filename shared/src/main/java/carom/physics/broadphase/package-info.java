/**
 * Boxes: trees that find the ones that overlap a box, the ones that a moving box meets, and the
 * pairs that overlap.
 *
 * <pre>
 *   SpatialIndex                      the interface, over an AabbArray
 *      |--- KdTree                    the engine's
 *      |      |--- KdBuilder, Select  builds it from scratch
 *      |      |--- KdRefit, KdBounds  takes new boxes over
 *      |      |--- KdCast             boxes that move through it
 *      |      \--- KdJoin             pairs below two nodes
 *      |--- BruteForce                the oracle of the tests
 *      \--- QuadTree                  for comparison
 *   PairSearch                        pairs of one or two KD-trees, in pieces, for several threads
 *   SpatialCollection                 for users of boxes: elements with boxes
 * </pre>
 *
 * <p>The engine's own search of pairs is {@code dynamics.pairs}; it uses the KD-tree directly. The
 * set of pairs is a pure function of the boxes: it never depends on the shape of a tree or on its
 * history. The <em>order</em> of pairs does, so a caller whose results depend on order, as the
 * solver's do, sorts them first.
 *
 * <p>May import {@code carom.physics.math}. Read first: {@link carom.physics.broadphase.AabbArray},
 * {@link carom.physics.broadphase.SpatialIndex}, {@link carom.physics.broadphase.KdTree}.
 */
package carom.physics.broadphase;
