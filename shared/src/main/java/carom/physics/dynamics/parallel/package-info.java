/**
 * How the threads of a world share a step, without showing in any result.
 *
 * <p>May import {@code carom.physics.threads}. Read first: {@code ParallelFor} (a stage cut into
 * pieces), {@code DomainPhases} (the solver's phases by domain).
 */
package carom.physics.dynamics.parallel;
