package carom.net.snapshot;

/**
 * Moves a state that both sides know to a later tick; what is sent is the difference to the truth.
 * Both sides must compute the same integers, so implementations use integer (or strict float)
 * arithmetic only. A better prediction saves bytes and never changes what is decoded.
 *
 * <p>Velocities come first: the client knows the true ones before the pose is predicted, and so can
 * the prediction.
 */
interface Predictor {

  /**
   * Predicts the three velocities in place; leaves the pose alone.
   *
   * @param state the baseline
   * @param age ticks, 1..{@link FrameRing#SIZE} - 1
   */
  void predictVelocity(Motion state, int age);

  /**
   * Predicts the pose in place, which may leave the range of positions.
   *
   * @param state the baseline
   * @param vx true velocity at the later tick
   * @param vy true velocity at the later tick
   * @param omega true angular velocity at the later tick
   * @param age ticks, 1..{@link FrameRing#SIZE} - 1
   */
  void predictPose(Motion state, int vx, int vy, int omega, int age);
}
