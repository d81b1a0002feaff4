/**
 * Links over framed messages and datagrams, independent of what drives their sockets. The package
 * has the frames, the bounded inbox between the network's threads and the owner, the client's
 * handshake with its exchange of keys, the server's UDP socket, and the choice that both sides have
 * between UDP and TCP for datagrams.
 *
 * <p>Imports {@code carom.net.protocol}, {@code carom.net.transport}, {@code carom.net.seal},
 * {@code carom.net.admission}, {@code carom.text}, JCTools and the JDK only.
 *
 * <p>Read first: {@link carom.net.frame.Frame}, {@link carom.net.frame.FramedLink}, {@link
 * carom.net.frame.ClientEnd}.
 */
package carom.net.frame;
