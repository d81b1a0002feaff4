package carom.physics.threads;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

/** Steps are shared while that is faster, in virtual time. */
final class SharingTest {
  private static final int ALONE_NS = 5_000_000;

  private final Sharing sharing = new Sharing();
  private long now = -1_000_000_000_000L;

  /** Steps that take some time if shared, in which the caller waits; answers how many were. */
  private int steps(int count, int sharedNs, int waitNs) {
    int shared = 0;
    for (int i = 0; i < count; i++) {
      boolean shares = sharing.begins(now);
      now += shares ? sharedNs : ALONE_NS;
      if (shares) {
        shared++;
        sharing.waited(waitNs);
      }
      sharing.ends(now);
    }
    return shared;
  }

  @Test
  void allStepsAreSharedWhileNobodyWaits() {
    assertEquals(1000, steps(1000, 3_000_000, 1000));
    assertEquals(1000, steps(1000, 9_000_000, 1000), "a step may take long for its own reasons");
  }

  @Test
  void whoWaitsTriesBothAndKeepsTheFaster() {
    steps(1000, 9_000_000, 2_000_000);
    int shared = steps(1000, 9_000_000, 2_000_000);
    assertTrue(shared > 0 && shared <= 50, "shared=" + shared);
    steps(300, 3_000_000, 1000);
    assertEquals(1000, steps(1000, 3_000_000, 1000), "the crowd has gone");
    assertTrue(steps(1000, 4_000_000, 2_000_000) > 900, "waiting, and still faster");
  }

  @Test
  void oneBadTrialIsSoonForgotten() {
    steps(1 + Sharing.TRIAL_STEPS, 9_000_000, 2_000_000);
    int shared = steps(100, 3_000_000, 1000);
    assertTrue(shared > 70, "shared=" + shared);
  }

  @Test
  void twoWorldsByTurnsAreNotTakenForTwoWays() {
    steps(1, 9_000_000, 2_000_000);
    for (int step = 0; step < Sharing.TRIAL_STEPS; step++) {
      boolean shares = sharing.begins(now);
      int small = shares ? 400_000 : 500_000;
      now += step % 2 == 0 ? 10 * small : small;
      sharing.ends(now);
    }
    assertEquals(100, steps(100, 4_000_000, 1000), "sharing was faster in both worlds");
  }

  @Test
  void withoutAClockEverythingIsShared() {
    for (int i = 0; i < 500; i++) {
      assertTrue(sharing.begins(0));
      sharing.waited(0);
      sharing.ends(0);
    }
  }
}
