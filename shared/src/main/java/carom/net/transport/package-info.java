/**
 * Links: how bytes and messages get from here to there, without saying by what. Two links stand
 * here: the in-process one and the seeded impaired one, so that every scenario runs without sockets
 * in virtual time; {@code carom.net.kryo} has the real one.
 *
 * <p>Imports {@code carom.net.protocol} and the JDK only.
 *
 * <p>Read first: {@link carom.net.transport.Link}, {@link carom.net.transport.ServerTransport},
 * {@link carom.net.transport.InProcessNetwork}.
 */
package carom.net.transport;
