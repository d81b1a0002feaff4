/**
 * Stages of a step cut into pieces that the threads of a world share, without showing in any
 * result.
 *
 * <p>May import {@code carom.physics.threads}. Read first: {@code docs/engine/THREADS.md}. Phases
 * by domain are in {@code dynamics.domain}.
 */
package carom.physics.dynamics.parallel;
