/**
 * Joints: their parameters, their state, and their lists by body.
 *
 * <p>May import {@code carom.physics.archive}, {@code math} and {@code rows}, {@code dynamics.body}
 * and {@code store}. Read first: {@code JointStore}. {@code dynamics.jointsolver} solves them.
 */
package carom.physics.dynamics.joint;
