/**
 * Snapshots: the world as integers once per tick, and per session the difference to what that
 * client is known to have. Acked deltas per entity: {@code docs/PROTOCOL.md} has the bytes and the
 * rules.
 *
 * <p>Each section of the datagram is a package of its own: {@code record}, {@code exact}, {@code
 * relay}, {@code event}; {@code frame} is what they describe. This package puts the sections
 * together and takes them apart, and chooses what a client is told. It sees arrays and bytes, no
 * worlds and no transport.
 *
 * <p>Read first: {@link carom.net.snapshot.SnapshotEncoder}, {@link
 * carom.net.snapshot.SnapshotDecoder}, {@link carom.net.snapshot.Selection}.
 */
package carom.net.snapshot;
