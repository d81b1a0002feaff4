/**
 * Carries what a game says to players and to the program around its simulation: events, messages,
 * notices, and what to play next. None of it is part of a simulation's state.
 *
 * <p>Allowed imports: {@code carom.physics}, {@code carom.physics.math}, {@code carom.sim.entity},
 * {@code carom.sim.level}, {@code carom.sim.event}, {@code carom.sim.message}, the JDK. Read first:
 * {@link carom.sim.outbox.Outbox}, {@link carom.sim.outbox.Event}.
 */
package carom.sim.outbox;
