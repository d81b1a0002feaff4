/**
 * The heart of the engine: bodies, shapes and contacts as primitive arrays, and the solver that
 * moves them. Users of the engine see {@code carom.physics} instead.
 *
 * <p>May import {@code carom.physics.math}, {@code geometry}, {@code collision} and {@code
 * broadphase}. Read first: {@code Dynamics} (the order of a step), {@code ContactSolver} and {@code
 * JointSolver} (the model and its derivation), {@code ContactTable} (what lasts from tick to tick,
 * and in which order).
 */
package carom.physics.dynamics;
