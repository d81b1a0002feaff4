/**
 * Links that speak in frames, whoever drives their sockets: the bytes around messages and
 * datagrams, the bounded inbox between the network's threads and the owner, and a client's way in.
 *
 * <p>Imports {@code carom.net.protocol}, {@code carom.net.transport}, JCTools and the JDK only.
 *
 * <p>Read first: {@link carom.net.frame.Frame}, {@link carom.net.frame.FramedLink}, {@link
 * carom.net.frame.ClientEnd}.
 */
package carom.net.frame;
