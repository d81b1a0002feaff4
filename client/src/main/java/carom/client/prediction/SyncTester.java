package carom.client.prediction;

import carom.client.prediction.received.PlayerInputs;

/**
 * Checks that rollback is exact: rolls back a few ticks, resimulates them with the same inputs, and
 * compares hashes. For developers; makes each tick about ten times as expensive.
 */
final class SyncTester {
  /** Ticks that are rolled back. */
  static final int TICKS = 8;

  private final Timeline timeline;
  private final PlayerInputs inputs;
  private long errors;

  SyncTester(Timeline timeline, PlayerInputs inputs) {
    this.timeline = timeline;
    this.inputs = inputs;
  }

  /** Runs the test, unless a tick in its range is missing or was corrected. */
  void run() {
    int present = timeline.tick();
    int from = present - TICKS;
    for (int t = from; t <= present; t++) {
      if (t < timeline.correctedTick() || !timeline.isSaved(t) || !inputs.has(t)) {
        return;
      }
    }
    int expected = timeline.hash(present);
    timeline.restore(from);
    while (timeline.tick() < present) {
      timeline.step(inputs.at(timeline.tick() + 1), true);
    }
    if (timeline.hash(present) != expected) {
      errors++;
    }
  }

  /** Returns how many ticks came out with another hash. */
  long errors() {
    return errors;
  }
}
