/**
 * What an operator or an embedding program decides: one immutable record, validated when built.
 *
 * <p>Allowed imports: the JDK. Read first: {@link carom.server.config.ServerConfig}.
 */
package carom.server.config;
