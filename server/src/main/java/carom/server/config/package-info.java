/**
 * The settings of a server: one immutable record, which checks itself when it is built.
 *
 * <p>Allowed imports: the JDK. Read first: {@link carom.server.config.ServerConfig}.
 */
package carom.server.config;
