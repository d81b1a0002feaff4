/**
 * Domains: the parts of the world that threads solve side by side, and the phases in which they do;
 * and the bodies as the solvers see them: velocities, masses and what a step has moved, in the
 * order of the awake bodies. Contacts, joints and continuous collision share them.
 *
 * <p>May import {@code carom.physics.threads}, {@code settings} and {@code math} and {@code
 * dynamics.body}, {@code contact}, {@code pairs} and {@code store}. Read first: {@code
 * docs/engine/THREADS.md}, then {@code Domains} (which body belongs where), {@code SolverSlots}
 * (where that lies in memory), {@code SolverBodies} (what lies there), {@code DomainPhases} (which
 * thread waits for which).
 */
package carom.physics.dynamics.domain;
