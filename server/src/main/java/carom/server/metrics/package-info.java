/**
 * The counters of a server: written by the thread that does the work and read by any other.
 *
 * <p>Allowed imports: HdrHistogram, the JDK. Read first: {@link carom.server.metrics.Counter},
 * {@link carom.server.metrics.Counters}.
 */
package carom.server.metrics;
