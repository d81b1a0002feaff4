/**
 * Client-side prediction: a simulation of the own body and the bodies near it, run ahead of the
 * server and reconciled with the server's states. {@link carom.client.prediction.SnapshotRecords}
 * and its neighbours keep what snapshots have told: which entities there are, their quantised
 * states, the inputs of others, and what joints are.
 *
 * <p>Imports {@code carom.sim}, {@code carom.physics..}, {@code carom.net.snapshot}, {@code
 * carom.net.codec} and {@code carom.client.interpolation}. One thread. Read first: {@link
 * carom.client.prediction.Prediction}, {@link carom.client.prediction.Reconciler}, {@link
 * carom.client.prediction.Timeline}.
 */
package carom.client.prediction;
