/**
 * Domains: the parts of the world that threads solve side by side, and the phases in which they do.
 *
 * <p>May import {@code carom.physics.threads} and {@code dynamics.body}, {@code contact} and {@code
 * pairs}. Read first: {@code docs/engine/THREADS.md}, then {@code Domains} (which body belongs
 * where), {@code SolverSlots} (where that lies in memory), {@code DomainPhases} (which thread waits
 * for which).
 */
package carom.physics.dynamics.domain;
