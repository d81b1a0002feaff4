/**
 * Replicates the world: the simulation is captured once a tick into a frame state that all sessions
 * share, and each session's sender encodes what its client lacks, within its budget.
 *
 * <p>Allowed imports: {@code carom.sim}, {@code carom.physics}, {@code carom.net.snapshot..},
 * {@code carom.net.transport}, {@code carom.server.config}, {@code carom.server.metrics}, {@code
 * carom.server.thin}, {@code carom.server.prediction}, the JDK.
 *
 * <p>Read first: {@link carom.server.replication.FrameCapture}, {@link
 * carom.server.replication.SessionReplication}, {@link carom.server.replication.SnapshotSender}.
 */
package carom.server.replication;
