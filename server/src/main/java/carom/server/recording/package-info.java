/**
 * Recordings of rooms as files: blocks leave the room's thread by a bounded queue and are
 * compressed and written by a thread of their own.
 *
 * <p>Allowed imports: {@code carom.replay}, the JDK.
 *
 * <p>Read first: {@link carom.server.recording.RecordingFile}.
 */
package carom.server.recording;
