/**
 * When ticks are due, which sessions a tick sends snapshots to, warnings when there is no time, and
 * the threads of rooms and of the matches that are built beside the ticks.
 *
 * <p>Allowed imports: {@code carom.server.metrics}, slf4j, the JDK. Read first: {@link
 * carom.server.schedule.TickLoop}, {@link carom.server.schedule.SendTurns}.
 */
package carom.server.schedule;
