/**
 * Figures about a connection and its predictions: recorders that the client writes, and a read-only
 * face for users.
 *
 * <p>Imports {@code carom.client.clock} and {@code carom.client.prediction}. One thread. Read
 * first: {@link carom.client.stats.NetStats}, {@link carom.client.stats.NetStatsRecorder}, {@link
 * carom.client.stats.TrafficRecorder}.
 */
package carom.client.stats;
