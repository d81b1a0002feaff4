package carom.client.stats;

import carom.client.prediction.Prediction;
import carom.client.prediction.Reconciliation;

/**
 * Records how well a client predicts: exact predictions, rollbacks and corrections. Written by one
 * client; one thread.
 */
final class PredictionRecorder {
  /** A shorter shift of the own body can't be seen, metres. */
  private static final float LEAST_SHIFT = 0.001f;

  final RecentValues corrections = new RecentValues();
  final RecentValues replays = new RecentValues();

  long compared;
  long exact;
  int nearBodies;
  long awakeBodies;
  long exactBodies;
  long toldBodies;
  long disagreements;
  long rollbacks;
  long rollbackTicks;
  long replaysCutShort;
  long syncErrors;
  long shifts;
  long otherInputs;
  long rulings;
  long correctionCount;
  double correctionMetres;
  double largestCorrection;

  /** Adds the result of a reconciliation. */
  void reconciled(Prediction prediction) {
    Reconciliation result = prediction.result();
    if (result.compared()) {
      compared++;
      nearBodies = result.awakeBodies();
      exact += result.exact() ? 1 : 0;
      toldBodies += result.toldBodies();
      awakeBodies += result.awakeBodies();
      exactBodies += result.exactBodies();
    }
    if (result.replayedTicks() > 0) {
      rollbacks++;
      rollbackTicks += result.rolledBackTicks();
      replays.add(result.replayNs() / 1e6f);
    }
    otherInputs += result.otherInputs() ? 1 : 0;
    rulings += result.ruled() ? 1 : 0;
    shifts += result.shiftMetres() > LEAST_SHIFT ? 1 : 0;
    if (result.corrected()) {
      double metres = result.correctionMetres();
      correctionCount++;
      correctionMetres += metres;
      largestCorrection = Math.max(largestCorrection, metres);
    }
    corrections.add(result.correctionMetres());
    replaysCutShort = prediction.replaysCutShort();
    disagreements = prediction.agreement().disagreements();
    syncErrors = prediction.syncErrors();
  }
}
