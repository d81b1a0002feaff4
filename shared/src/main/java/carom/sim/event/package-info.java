/**
 * Kinds of events of a game: how each looks and sounds, and who is told.
 *
 * <p>Imports {@code carom.physics.math} alone. Read first: {@link carom.sim.event.EventKinds},
 * {@link carom.sim.event.EventKind}.
 */
package carom.sim.event;
