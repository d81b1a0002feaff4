/**
 * Schedules ticks and snapshots: when ticks are due, which sessions a tick sends snapshots to, and
 * warnings when there is no time.
 *
 * <p>Allowed imports: {@code carom.server.metrics}, slf4j, the JDK. Read first: {@link
 * carom.server.schedule.TickLoop}, {@link carom.server.schedule.SendTurns}.
 */
package carom.server.schedule;
