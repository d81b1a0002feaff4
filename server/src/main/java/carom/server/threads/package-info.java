/**
 * The threads of a server: those that lobby and rooms share, the one that builds matches, and the
 * watchdog; when ticks are due, and warnings when there is no time.
 *
 * <p>Allowed imports: {@code carom.server.metrics}, slf4j, the JDK.
 *
 * <p>Read first: {@link carom.server.threads.DutyPool}, {@link carom.server.threads.TurnSchedule},
 * {@link carom.server.threads.TickLoop}.
 */
package carom.server.threads;
