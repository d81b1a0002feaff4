/**
 * Opens ports for HTTP by Undertow. It has few places for connections, deadlines, budgets of bytes,
 * encryption, and rules about which requests are welcome. The operators' page and the play port use
 * it. Clients of other servers are built here, too.
 *
 * <p>Allowed imports: {@code carom.net.transport}, {@code carom.net.frame}, {@code
 * carom.server.access}, {@code carom.text}, Undertow with XNIO, slf4j, the JDK.
 *
 * <p>Read first: {@link carom.server.http.HttpPort}, {@link carom.server.http.RequestGuard}, {@link
 * carom.server.http.Origins}.
 */
package carom.server.http;
