/**
 * The UDP sockets of both sides, and what bounds the datagrams of one link at the server. These
 * bounds are a budget, a meter for floods, and the table from the number in a datagram to its link.
 * Both sides have the choice between UDP and TCP for datagrams, and what bounds those over TCP. It
 * knows neither frames nor KryoNet.
 *
 * <p>Imports the JDK only.
 *
 * <p>Read first: {@link carom.net.datagram.DatagramPort}, {@link carom.net.datagram.LinkTable}.
 */
package carom.net.datagram;
