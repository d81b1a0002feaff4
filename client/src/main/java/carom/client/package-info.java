/**
 * A client of a Carom server: connects, loads the level, runs ahead of the server, predicts, draws
 * the past of the others, and offers a read-only picture of it all. Needs no window.
 *
 * <p>May use {@code carom.physics}, {@code carom.sim}, {@code carom.game} and {@code carom.net};
 * the window is {@code carom.client.desktop}, found as a service. Read first: {@link
 * carom.client.GameClient}, {@link carom.client.ClientView}, {@link carom.client.ClientConfig}.
 */
package carom.client;
