/**
 * Solves joints: plain revolutes in lanes, heavy trees as a whole, all others one by one.
 *
 * <p>May import {@code carom.physics.math} and {@code simd}, and {@code dynamics.body}, {@code
 * joint}, {@code jointtree}, {@code solver}, {@code domain} and {@code store}. Read first: {@code
 * JointSolver}, {@code JointVisit}, {@code ConstraintRow}.
 */
package carom.physics.dynamics.jointsolver;
