/**
 * Trees of revolute joints, welds and rods that are solved as a whole, because they carry far more
 * than they weigh.
 *
 * <p>May import {@code dynamics.body}, {@code joint}, {@code domain} and {@code store}. Read first:
 * {@code JointTrees}, {@code TreeSolver}, {@code TreeResponse} (what contacts need).
 */
package carom.physics.dynamics.jointtree;
