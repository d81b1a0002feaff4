/**
 * The narrow phase: the manifold of every contact, anew in every step.
 *
 * <p>May import {@code dynamics.body}, {@code contact} and {@code store}, and {@code collision}.
 * Read first: {@code NarrowPhase}, {@code Seams}.
 */
package carom.physics.dynamics.narrow;
