/**
 * Interpolation: where a body was at a moment of the server's past, from the states that arrived
 * around it.
 *
 * <p>Imports {@code carom.net.snapshot} and {@code carom.net.codec}. One thread, no allocation.
 * Read first: {@link carom.client.interpolation.Interpolator}, {@link
 * carom.client.interpolation.StateHistory}, {@link carom.client.interpolation.Sample}.
 */
package carom.client.interpolation;
