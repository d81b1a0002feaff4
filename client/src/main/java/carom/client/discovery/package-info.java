/**
 * Servers of the local network: asks for them by A2S status queries that are broadcast, and reads
 * the answers, which anybody may have written.
 *
 * <p>Imports {@code carom.client.link} and {@code carom.text}. {@link
 * carom.client.discovery.LanSearch} has a thread; the rest is immutable. Read first: {@link
 * carom.client.discovery.LanSearch}, {@link carom.client.discovery.StatusAnswer}.
 */
package carom.client.discovery;
