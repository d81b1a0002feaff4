/**
 * Serves one client's prediction: it chooses the predicted set, tells the exact state of it where
 * the client can't compute it, and judges the client's reports of mispredictions.
 *
 * <pre>
 *   PredictedSet ──► PredictedSetChooser   which entities are near
 *        ├─────────► ExactUpdate           exact state of newcomers and of what the game moved
 *        │               ├──► UpdateRows       what an update holds
 *        │               └──► UpdateDelivery   which of it is sent, lost, acknowledged ┐ of the
 *        ├─────────► RulingDelivery        what the game's rules did to near bodies       ┘ encoder
 *        ├─────────► UpdateLimits          how many entities, how often
 *        └─────────► RelayChooser         whose inputs are relayed
 * </pre>
 *
 * <p>Allowed imports: {@code carom.sim}, {@code carom.physics}, {@code carom.net.snapshot..},
 * {@code carom.net.protocol}, the JDK.
 *
 * <p>Read first: {@link carom.server.prediction.PredictedSet}, {@link
 * carom.server.prediction.PredictionAudit}.
 */
package carom.server.prediction;
