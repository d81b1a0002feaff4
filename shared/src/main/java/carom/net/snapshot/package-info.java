/**
 * Snapshots: the world as integers once per tick, and per session the difference to what that
 * client is known to have. Acked deltas per entity: {@code docs/PROTOCOL.md} has the bytes and the
 * rules.
 *
 * <p>Imports {@code carom.net.codec} and the JDK only: arrays in, bytes out, no worlds, no
 * transport.
 *
 * <p>Read first: {@link carom.net.snapshot.FrameState}, {@link carom.net.snapshot.SnapshotEncoder},
 * {@link carom.net.snapshot.SnapshotDecoder}.
 */
package carom.net.snapshot;
