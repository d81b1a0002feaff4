/**
 * The server's end of KryoNet: the TCP acceptor, the update loop, what an unknown client may do,
 * and what bounds the datagrams of one link: a budget, a meter for floods, and the table from the
 * number in a datagram to its link.
 *
 * <pre>
 *   Acceptor ──► ServerNetwork ──► ServerConnection ──► an inbox per link
 *                (one thread)  ◄── DatagramPort, the UDP socket
 * </pre>
 *
 * <p>Imports {@code carom.net.kryo} for frames and messages, the packages of {@code carom.net} that
 * it imports, KryoNet, JCTools and the JDK only.
 *
 * <p>Read first: {@link carom.net.kryo.server.KryoServerTransport}, {@link
 * carom.net.kryo.server.KryoLimits}, {@link carom.net.kryo.server.ServerConnection}.
 */
package carom.net.kryo.server;
