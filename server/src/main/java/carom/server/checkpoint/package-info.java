/**
 * Checkpoints of rooms, from which a server that was killed goes on: the state of a match every few
 * seconds, the inputs since, and who plays.
 *
 * <p>Allowed imports: {@code carom.net.protocol}, {@code carom.net.snapshot.frame}, {@code
 * carom.physics.archive}, {@code carom.replay}, {@code carom.server.config}, {@code
 * carom.server.match}, {@code carom.server.match}, {@code carom.server.session}, {@code carom.sim},
 * {@code carom.text}, the JDK.
 *
 * <p>Read first: {@link carom.server.checkpoint.RoomCheckpoints}, {@link
 * carom.server.checkpoint.SlotFolder}, {@link carom.server.checkpoint.SavedRoom}.
 */
package carom.server.checkpoint;
