/**
 * Answers over HTTP whether a server is well and whether players may come, with its metrics and the
 * operator's live page: rooms, charts, players, console, log and recordings in a browser.
 *
 * <pre>
 *   WebServer      the port
 *     Metrics      what Prometheus reads
 *     LivePage     the page's files, its WebSocket and its clock
 *       Viewer       one open page: what it may do, what it looks at and already knows
 *       RoomFeed     one room's pictures, shared by all who look at it
 *       RoomHistory  one row of figures a second
 *       Downloads    recordings, each for a ticket
 *       LogTail      the last lines of the log
 * </pre>
 *
 * <p>A viewer is a stranger until it has given the secret. What strangers send is bounded and
 * decoded by hand. No tick waits for any of this: a room makes a picture when it is asked for one,
 * and slow viewers miss pictures.
 *
 * <p>Allowed imports: {@code carom.server..}, {@code carom.text}, {@code carom.net.protocol},
 * {@code carom.net.transport}, {@code carom.sim.level}, {@code carom.physics.geometry}, Micrometer,
 * Undertow with XNIO, Jackson's core, picocli, slf4j, the JDK. Read first: {@link
 * carom.server.web.WebServer}, {@link carom.server.web.LivePage}, {@link carom.server.web.Viewer}.
 */
package carom.server.web;
