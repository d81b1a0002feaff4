/**
 * The recording of a room: begins, ends, and goes on in another file when a match, a file or the
 * disk asks for one.
 *
 * <p>Allowed imports: {@code carom.net.protocol}, {@code carom.replay}, {@code
 * carom.server.metrics}, {@code carom.server.recording}, {@code carom.server.room.match}, {@code
 * carom.sim}, slf4j, the JDK.
 *
 * <p>Read first: {@link carom.server.room.recording.RoomRecording}.
 */
package carom.server.room.recording;
