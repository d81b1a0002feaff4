/**
 * Recordings of rooms as files. Blocks leave the room's thread by a bounded queue, and another
 * thread compresses and writes them.
 *
 * <p>Allowed imports: {@code carom.replay}, {@code carom.text}, the JDK.
 *
 * <p>Read first: {@link carom.server.recording.RecordingFile}.
 */
package carom.server.recording;
