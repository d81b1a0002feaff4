/**
 * The contact solver: soft contacts with substeps, coloured into blocks that are solved side by
 * side.
 *
 * <p>May import {@code dynamics.body}, {@code contact}, {@code pairs} and {@code parallel}. Read
 * first: {@code ContactSolver} (the model and its derivation), {@code ContactBlocks} (the layout),
 * {@code SolverBodies}.
 */
package carom.physics.dynamics.solver;
