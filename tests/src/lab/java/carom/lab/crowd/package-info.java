/**
 * Sockets for hundreds of clients in one process, which {@code carom-bots} plays with.
 *
 * <p>Imports {@code carom.net} only. Read first: {@link carom.lab.crowd.CrowdTransport}.
 */
package carom.lab.crowd;
