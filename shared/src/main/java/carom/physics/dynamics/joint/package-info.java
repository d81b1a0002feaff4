/**
 * Joints: their parameters, their state, and how they are solved.
 *
 * <p>May import {@code dynamics.body}, {@code solver}, {@code store} and {@code parallel}. Read
 * first: {@code JointStore}, {@code JointSolver}, {@code JointVisit}.
 */
package carom.physics.dynamics.joint;
