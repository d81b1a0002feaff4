/**
 * The threads of a server: those of the lobby and the rooms, and the one that builds matches.
 *
 * <p>Allowed imports: the JDK.
 *
 * <p>Read first: {@link carom.server.threads.Worker}.
 */
package carom.server.threads;
