/**
 * Links that carry messages and datagrams, independent of the medium. This package has the
 * in-process link and the seeded impaired one, so that every scenario runs without sockets in
 * virtual time. {@code carom.net.kryo} has the link over sockets.
 *
 * <p>Imports {@code carom.net.protocol} and the JDK only.
 *
 * <p>Read first: {@link carom.net.transport.Link}, {@link carom.net.transport.ServerTransport},
 * {@link carom.net.transport.InProcessNetwork}.
 */
package carom.net.transport;
