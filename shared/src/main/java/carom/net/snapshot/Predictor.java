package carom.net.snapshot;

/**
 * Moves a state that both sides know to a later tick; what is sent is the difference to the truth.
 * Both sides must compute the same integers, so implementations use integer (or strict float)
 * arithmetic only. A better prediction saves bytes and never changes what is decoded.
 */
interface Predictor {

  /**
   * Predicts in place.
   *
   * @param state the baseline; afterwards the prediction, which may be out of range
   * @param age ticks, 1..{@link FrameRing#SIZE} - 1
   */
  void predict(Motion state, int age);
}
