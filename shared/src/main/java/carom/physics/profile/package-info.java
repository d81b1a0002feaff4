/**
 * Stages of a step, for programs that measure how long each takes.
 *
 * <p>Imports nothing. Read first: {@code StepStage}, {@code StageListener}.
 */
package carom.physics.profile;
