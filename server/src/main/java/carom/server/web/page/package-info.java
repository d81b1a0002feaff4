/**
 * The operator's live page: rooms, charts, players, console, log and recordings in a browser.
 *
 * <pre>
 *   LivePage       the page's files, its WebSocket and its clock
 *     Viewer       one open page: what it may do, what it looks at and already knows
 *     RoomFeed     one room's pictures, shared by all who look at it
 *     RoomHistory  one row of figures a second
 *     Downloads    recordings, each for a ticket
 * </pre>
 *
 * <p>A viewer is a stranger until it has given the secret. What strangers send is bounded and
 * decoded by hand. No tick waits for any of this: a room makes a picture when it is asked for one,
 * and slow viewers miss pictures.
 *
 * <p>Allowed imports: {@code carom.server.picture}, {@code .http}, {@code .access}, {@code .login},
 * {@code .command}, {@code .console}, {@code .metrics}, {@code .room}, {@code carom.json}, {@code
 * carom.sim.level}, {@code carom.physics.geometry}, Undertow, Jackson's core, slf4j, the JDK. Read
 * first: {@link carom.server.web.page.LivePage}, {@link carom.server.web.page.Viewer}, {@link
 * carom.server.web.page.RoomFeed}.
 */
package carom.server.web.page;
