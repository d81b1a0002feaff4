/**
 * The threads of a server: those of the lobby and the rooms, the one that builds matches, and the
 * watchdog; when ticks are due, and warnings when there is no time.
 *
 * <p>Allowed imports: {@code carom.server.metrics}, slf4j, the JDK.
 *
 * <p>Read first: {@link carom.server.threads.Worker}, {@link carom.server.threads.TickLoop}.
 */
package carom.server.threads;
