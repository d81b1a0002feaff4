/**
 * Recorded motion of many bodies: its file, and the codec that makes the fewest bytes of it. Needs
 * no world, so that foreign recordings can be measured, too. No server or client uses it.
 *
 * <p>Imports {@code carom.net.codec} only; {@code SceneTrace} and {@code CodecCommand} the scenes
 * and picocli, too.
 *
 * <p>Read first: {@link carom.lab.trace.Trace}, {@link carom.lab.trace.TraceCodec}, {@link
 * carom.lab.trace.TraceReport}.
 */
package carom.lab.trace;
