/**
 * Games that the client starts on its own machine: server, bots and client in one process. It is
 * the only package that knows both server and client, which find it by {@code ServiceLoader}.
 *
 * <p>Imports {@code carom.server..}, {@code carom.client.app}, {@code carom.client.bots}, {@code
 * carom.client} and what they share. Read first: {@link carom.launcher.LocalServers}.
 */
package carom.launcher;
