/**
 * Links over TCP and UDP, safe on open ports. Only this package and {@code server} below it use
 * KryoNet and Kryo.
 *
 * <p>They drive KryoNet through its public API and use none of its threads, serializers or
 * defaults. On the server, KryoNet carries TCP. UDP has a socket of its own, because KryoNet reads
 * one datagram per {@code select} and searches all connections for its sender. The main classes:
 * {@code FrameCodec} (KryoNet's objects as frames), {@code KryoMessageCodec} (messages as bytes),
 * {@code MessageSerializer} (fields that several have in common) and {@code ClientLink} (the
 * client's end).
 *
 * <p>Imports {@code carom.net.protocol}, {@code carom.net.transport}, {@code carom.net.frame},
 * {@code carom.net.seal}, {@code carom.net.codec}, KryoNet, Kryo, JCTools and the JDK only.
 *
 * <p>Read first: {@link carom.net.kryo.KryoClientTransport}, {@link carom.net.kryo.FrameCodec},
 * {@link carom.net.kryo.KryoMessageCodec}.
 */
package carom.net.kryo;
