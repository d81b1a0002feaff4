package carom.client.prediction;

/**
 * Checks that rollback is exact: rolls back a few ticks, resimulates them with the same inputs, and
 * compares hashes. For developers; makes each tick about ten times as expensive.
 */
final class SyncTester {
  /** Ticks that are rolled back. */
  static final int TICKS = 8;

  private final Timeline timeline;
  private final PlayerInputs inputs;
  private final PredictedPoses poses;
  private int tested = -1;
  private long errors;

  SyncTester(Timeline timeline, PlayerInputs inputs, PredictedPoses poses) {
    this.timeline = timeline;
    this.inputs = inputs;
    this.poses = poses;
  }

  /**
   * Runs the test up to the present tick, once for each, unless a tick in its range is missing or
   * was corrected. All that the server told must be reconciled: of a ruling or spawn that came
   * since, the ticks computed before know nothing.
   */
  void run() {
    int present = timeline.tick();
    int from = present - TICKS;
    if (present == tested) {
      return;
    }
    for (int t = from; t <= present; t++) {
      if (t < timeline.correctedTick() || !timeline.isSaved(t) || !inputs.has(t)) {
        return;
      }
    }
    tested = present;
    int expected = timeline.hash(present);
    poses.beginCorrection();
    timeline.restore(from);
    while (timeline.tick() < present) {
      if (timeline.tick() == present - 1) {
        poses.follow(true);
        poses.beginTick();
      }
      timeline.step(inputs.at(timeline.tick() + 1), true);
    }
    poses.follow(true); // what the ticks spawned are other objects now
    poses.endCorrection();
    if (timeline.hash(present) != expected) {
      errors++;
    }
  }

  /** Returns how many ticks came out with another hash. */
  long errors() {
    return errors;
  }
}
