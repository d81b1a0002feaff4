/**
 * Games that the client starts on its own machine: server, bots and client in one process. It is
 * the only package that knows both server and client, which find it by {@code ServiceLoader}. It
 * also lays out projects of new games, whose {@code run} starts all of that ({@code carom new}).
 *
 * <p>Imports {@code carom.server..}, {@code carom.client.app}, {@code carom.client.bots}, {@code
 * carom.client} and what they share. Read first: {@link carom.launcher.LocalServers}, {@code
 * NewCommand}.
 */
package carom.launcher;
