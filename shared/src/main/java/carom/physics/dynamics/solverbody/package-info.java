/**
 * The bodies as the solvers see them: velocities, masses and what a step has moved, in the order of
 * the awake bodies. Contacts, joints and continuous collision share them.
 *
 * <p>Imports what {@code carom.physics.dynamics.solver} imports, and not the solver.
 *
 * <p>Read first: {@link carom.physics.dynamics.solverbody.SolverBodies}.
 */
package carom.physics.dynamics.solverbody;
