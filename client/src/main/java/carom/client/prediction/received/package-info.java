/**
 * Keeps what snapshots have told a prediction apart from exact states: which entities there are,
 * their quantised states, the inputs of others, and what joints are.
 *
 * <p>May import the snapshot packages, {@code carom.physics}, {@code carom.sim} and {@code
 * carom.client.interpolation}. Read first: {@link
 * carom.client.prediction.received.SnapshotRecords}.
 */
package carom.client.prediction.received;
