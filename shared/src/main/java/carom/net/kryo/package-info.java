/**
 * The only home of KryoNet and Kryo: links over TCP and UDP that an open port can be trusted with.
 *
 * <p>KryoNet is driven through its public API only; its own threads, serializers and defaults are
 * not used. On the server it carries TCP; UDP goes through a socket of our own, because KryoNet
 * reads one datagram per {@code select} and searches all connections for its sender. What each
 * class does and why: {@code ServerNetwork} (update loop, admission, sweeps), {@code DatagramPort}
 * (the UDP socket), {@code ServerConnection} (what one stranger may do), {@code FrameCodec} (frames
 * as KryoNet has them).
 *
 * <p>Imports {@code carom.net.protocol}, {@code carom.net.transport}, {@code carom.net.frame},
 * KryoNet, Kryo, JCTools and the JDK only.
 *
 * <p>Read first: {@link carom.net.kryo.KryoServerTransport}, {@link
 * carom.net.kryo.KryoClientTransport}, {@link carom.net.kryo.KryoLimits}.
 */
package carom.net.kryo;
