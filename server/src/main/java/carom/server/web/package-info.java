/**
 * Answers over HTTP whether a server is well and whether players may come, with its metrics and the
 * live page. It has a port of its own, and no tick waits for it.
 *
 * <p>Allowed imports: {@code carom.net.protocol}, {@code carom.net.transport}, {@code
 * carom.server.access}, {@code carom.server.command}, {@code carom.server.config}, {@code
 * carom.server.console}, {@code carom.server.http}, {@code carom.server.login}, {@code
 * carom.server.metrics}, {@code carom.server.room}, {@code carom.server.web.page}, Micrometer,
 * Undertow with XNIO, picocli, slf4j, the JDK. Read first: {@link carom.server.web.WebServer},
 * {@link carom.server.web.Metrics}.
 */
package carom.server.web;
