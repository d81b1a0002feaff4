/**
 * When ticks are due, and which sessions a tick sends snapshots to.
 *
 * <p>Allowed imports: the JDK. Read first: {@link carom.server.schedule.TickLoop}, {@link
 * carom.server.schedule.SendTurns}.
 */
package carom.server.schedule;
