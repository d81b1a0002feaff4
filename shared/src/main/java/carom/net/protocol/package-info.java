/**
 * What client and server say to each other, as plain data: messages, limits, versions, reasons,
 * session states, and the input datagram.
 *
 * <p>Imports {@code carom.net.codec}, {@code carom.physics.rows} for what a body's row holds, and
 * the JDK only. The bytes are in {@code docs/PROTOCOL.md}.
 *
 * <p>Read first: {@link carom.net.protocol.ServerMessage}, {@link
 * carom.net.protocol.ClientMessage}, {@link carom.net.protocol.Limits}.
 */
package carom.net.protocol;
