/**
 * Messages between client and server as plain data, with limits, versions, reasons, session states
 * and the input datagram.
 *
 * <p>Imports {@code carom.net.codec}, {@code carom.physics.rows} for what a body's row holds, and
 * the JDK only. {@code docs/protocol/README.md} describes the bytes.
 *
 * <p>Read first: {@link carom.net.protocol.ServerMessage}, {@link
 * carom.net.protocol.ClientMessage}, {@link carom.net.protocol.ProtocolLimits}.
 */
package carom.net.protocol;
