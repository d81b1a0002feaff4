/**
 * Recorded motion of many bodies: its file, and the codec that makes the fewest bytes of it. Needs
 * no world, so that foreign recordings can be measured, too.
 *
 * <p>Imports {@code net.codec} only.
 *
 * <p>Read first: {@link carom.net.trace.Trace}, {@link carom.net.trace.TraceCodec}, {@link
 * carom.net.trace.TraceReport}.
 */
package carom.net.trace;
