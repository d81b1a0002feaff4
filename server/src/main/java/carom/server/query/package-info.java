/**
 * The standard protocols of game servers, for stock tools: A2S status queries over UDP, by which
 * server lists and local networks find a server, and Source RCON over TCP, a remote console.
 *
 * <p>Allowed imports: {@code carom.net.admission}, {@code carom.net.protocol}, {@code
 * carom.server.command}, {@code carom.server.config}, {@code carom.server.access}, {@code
 * carom.server.room}, {@code carom.server.session}, picocli, slf4j, the JDK. Read first: {@link
 * carom.server.query.StatusQuery}, {@link carom.server.query.StatusAnswers}, {@link
 * carom.server.query.RemoteConsole}.
 */
package carom.server.query;
