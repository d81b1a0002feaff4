/**
 * The KD-tree of boxes that the engine uses, and its refit and pair search in pieces for several
 * threads.
 *
 * <pre>
 *   KdTree ---- KdBuilder, Select   builds it from scratch
 *      |  \---- KdRefit, KdBounds   takes new boxes over
 *      |  \---- KdCast              boxes that move through it
 *      |  \---- KdJoin              pairs below two nodes
 *   PairSearch                      pairs of one or two trees, in pieces
 * </pre>
 *
 * <p>May import {@code carom.physics.math} and {@code broadphase.index}. Read first: {@link
 * carom.physics.broadphase.kd.KdTree}.
 */
package carom.physics.broadphase.kd;
