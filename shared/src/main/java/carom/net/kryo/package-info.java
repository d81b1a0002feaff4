/**
 * The only home of KryoNet and Kryo: links over TCP and UDP that an open port can be trusted with.
 *
 * <p>KryoNet is driven through its public API only; its own threads, serializers and defaults are
 * not used. What each class does and why: {@code KryoServerTransport} (update loop, admission,
 * sweeps), {@code ServerConnection} (what one stranger may do), {@code Frame} (the bytes around a
 * message or a datagram).
 *
 * <p>Imports {@code carom.net.protocol}, {@code carom.net.transport}, KryoNet, Kryo, JCTools and
 * the JDK only.
 *
 * <p>Read first: {@link carom.net.kryo.KryoServerTransport}, {@link
 * carom.net.kryo.KryoClientTransport}, {@link carom.net.kryo.KryoLimits}.
 */
package carom.net.kryo;
