/**
 * Links over TCP and UDP, safe on open ports. This is the only package that uses KryoNet and Kryo.
 *
 * <p>It drives KryoNet through the public API only and uses none of its threads, serializers or
 * defaults. On the server, KryoNet carries TCP. UDP has a socket of its own, because KryoNet reads
 * one datagram per {@code select} and searches all connections for its sender. The main classes:
 * {@code ServerNetwork} (update loop, admission, sweeps), {@code DatagramPort} (the UDP socket),
 * {@code ServerConnection} (what an unknown client may do), {@code FrameCodec} (KryoNet's objects
 * as frames).
 *
 * <p>Imports {@code carom.net.protocol}, {@code carom.net.transport}, {@code carom.net.frame},
 * {@code carom.net.datagram}, {@code carom.net.admission}, {@code carom.net.seal}, {@code
 * carom.text}, KryoNet, Kryo, JCTools and the JDK only.
 *
 * <p>Read first: {@link carom.net.kryo.KryoServerTransport}, {@link
 * carom.net.kryo.KryoClientTransport}, {@link carom.net.kryo.KryoLimits}.
 */
package carom.net.kryo;
