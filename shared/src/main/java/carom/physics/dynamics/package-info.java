/**
 * The heart of the engine: bodies, shapes and contacts as primitive arrays, and the solver that
 * moves them. Users of the engine see {@code carom.physics} instead.
 *
 * <p>May import {@code carom.physics.math}, {@code geometry}, {@code collision} and {@code
 * broadphase}. Read first: {@code Dynamics} (the order of a step) and the stages it calls: {@code
 * PairFinder}, {@code CollideStage}, {@code EventStage}, {@code Substeps}, {@code
 * ContinuousCollision}, {@code Sleeping}; then {@code ContactSolver} and {@code JointSolver} (the
 * model and its derivation) and {@code ContactTable} (what lasts from tick to tick, and in which
 * order).
 */
package carom.physics.dynamics;
