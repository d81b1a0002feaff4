/**
 * What kinds of events a game has, how each looks and sounds, and who is told.
 *
 * <p>Imports nothing. Read first: {@link carom.sim.event.EventKinds}, {@link
 * carom.sim.event.EventKind}.
 */
package carom.sim.event;
