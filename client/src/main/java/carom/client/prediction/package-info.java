/**
 * The present, foreseen: a simulation of the own body and what it may touch, run ahead of the
 * server and set right when the server says otherwise.
 *
 * <p>May use {@code carom.sim}, {@code carom.physics}, {@code carom.net.snapshot}, {@code
 * carom.net.codec} and {@code carom.client.interpolation}. One thread. Read first: {@link
 * carom.client.prediction.Prediction}, {@link carom.client.prediction.Neighbour}, {@link
 * carom.client.prediction.Mending}.
 */
package carom.client.prediction;
