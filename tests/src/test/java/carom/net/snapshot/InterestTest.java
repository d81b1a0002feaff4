package carom.net.snapshot;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.net.codec.Quantizer;
import carom.net.snapshot.frame.FrameState;
import org.junit.jupiter.api.Test;

/**
 * Goal: a client is told about what it looks at and about nothing else, exactly, whatever the
 * network does and wherever it looks. Method: a window that wanders over a busy scene, the scene as
 * oracle.
 */
class InterestTest {

  private static final int METRE = Quantizer.POSITION_STEPS;

  /** Sees what is left of a border; what it knows it sees a quarter further. */
  private static final class Window implements Interest {
    int centre;
    int half = 10 * METRE;
    int asked;
    int favourite = -1;

    @Override
    public boolean everything() {
      return false;
    }

    @Override
    public boolean sees(FrameState frame, int slot, boolean known) {
      asked++;
      return Math.abs(frame.x(slot) - centre) <= (known ? half + half / 4 : half);
    }

    @Override
    public float priority(FrameState frame, int slot) {
      return slot == favourite ? 1_000 : 1;
    }
  }

  private final Window window = new Window();

  private void offer(Channel channel) {
    FrameState frame = channel.scene.ring.newest();
    for (int slot = 0; slot < frame.slotLimit(); slot++) {
      if (frame.alive(slot) && window.sees(frame, slot, false)) {
        channel.encoder.notice(slot);
      }
    }
  }

  private void step(Channel channel, boolean moving) {
    if (moving) {
      channel.scene.step();
    } else {
      channel.scene.tick++;
      channel.scene.capture();
    }
    offer(channel);
    channel.tick();
  }

  /** What the client shows is true, and all of the window is shown. */
  private void checkWindow(Channel channel) {
    for (int slot = 0; slot < channel.scene.slots; slot++) {
      int[] truth = channel.scene.bodies[slot];
      EntityHistory history = channel.decoder.history(slot);
      boolean shown = history != null && history.alive();
      String where = channel.name + " slot=" + slot;
      if (truth == null) {
        assertFalse(shown, where + " is a ghost");
      } else if (Math.abs(truth[3] - window.centre) <= window.half) {
        assertTrue(shown, where + " is missing");
      }
      if (shown) {
        assertEquals(truth[0], history.generation(0), where);
        assertEquals(truth[3], history.x(0), where);
        assertEquals(truth[4], history.y(0), where);
      }
    }
  }

  /** Where a slow line tells of few bodies at a time, all of them near the player. */
  private static final class Near implements Interest {
    @Override
    public boolean everything() {
      return true;
    }

    @Override
    public boolean sees(FrameState frame, int slot, boolean known) {
      return true;
    }

    @Override
    public float priority(FrameState frame, int slot) {
      return 3;
    }
  }

  /**
   * Goal: on a slow line, a body that is gone doesn't stay on the screen for seconds while others
   * move. A soak found one that was told after two.
   */
  @Test
  void aBodyThatIsGoneIsToldInASecondOnASlowLine() {
    for (int seed = 1; seed <= 5; seed++) {
      Scene scene = new Scene(60, 1, seed);
      for (int slot = 0; slot < scene.slots; slot++) {
        scene.spawn(slot);
      }
      scene.spawnPercent = 0;
      scene.diePercent = 0;
      scene.stopPercent = 0;
      scene.wakePercent = 100;
      Channel channel = new Channel(scene, 10 + seed, Scene.TICK_RATE, new Near());
      channel.latencyTicks = 6;
      channel.lossPercent = 5;
      channel.sendEvery = 4;
      channel.budget = 80;
      channel.withOwn = false;
      for (int i = 0; i < 600; i++) {
        step(channel, true);
      }
      int longest = 0;
      for (int slot = 5; slot < 60; slot += 5) {
        scene.bodies[slot] = null;
        int ticks = 0;
        for (; channel.decoder.history(slot).alive(); ticks++) {
          step(channel, true);
        }
        longest = Math.max(longest, ticks);
      }
      assertTrue(channel.maxWaiting > 30, channel.name + " waiting=" + channel.maxWaiting);
      assertTrue(longest <= 45, channel.name + " longest=" + longest);
    }
  }

  @Test
  void aWanderingWindowIsExactUnderLossJitterAndDuplicates() {
    for (int seed = 1; seed <= 5; seed++) {
      Scene scene = new Scene(300, 100, 900 + seed);
      Channel channel = new Channel(scene, 950 + seed, Scene.TICK_RATE, window);
      channel.lossPercent = 8 * (seed - 1);
      channel.duplicatePercent = 5;
      channel.reorderPercent = 10;
      channel.jitterTicks = 3;
      channel.latencyTicks = 2 * seed;
      channel.budget = seed % 2 == 0 ? 500 : Integer.MAX_VALUE;
      int left = 0;
      for (int i = 0; i < 2_500; i++) {
        window.centre = (int) (30 * METRE * Math.sin(i * 0.01));
        step(channel, true);
        left += countLeaving(channel);
      }
      channel.checkHistories();
      for (int i = 0; i < 400; i++) {
        step(channel, false);
      }
      channel.checkHistories();
      checkWindow(channel);
      assertTrue(left > 100, channel.name + " left=" + left);
      assertEquals(0, channel.count(DecodeStatus.NO_BASELINE), channel.name);
      assertEquals(0, channel.count(DecodeStatus.DAMAGED), channel.name);
    }
  }

  private static int countLeaving(Channel channel) {
    int count = 0;
    for (int i = 0; i < channel.decoder.touchedCount(); i++) {
      EntityHistory history = channel.decoder.history(channel.decoder.touchedSlot(i));
      count += history.outOfSight(0) ? 1 : 0;
    }
    return count;
  }

  @Test
  void whatRestsOutOfViewStaysKnownAndFreeUntilItMoves() {
    Channel channel = quietChannel();
    Scene scene = channel.scene;
    window.centre = 0;
    step(channel, false);
    for (int i = 0; i < 20; i++) {
      step(channel, false);
    }
    assertTrue(channel.decoder.history(1).alive());
    assertNull(channel.decoder.history(2), "never in view");
    window.centre = 500 * METRE;
    long records = channel.records;
    for (int i = 0; i < 20; i++) {
      step(channel, false);
    }
    assertEquals(records, channel.records, "nothing to say about what rests");
    assertTrue(channel.decoder.history(1).alive(), "still true");
    assertEquals(Explanation.Reason.UP_TO_DATE, channel.encoder.report().explain(1).reason());
    scene.bodies[1][3] += METRE;
    for (int i = 0; i < 20; i++) {
      step(channel, false);
    }
    assertFalse(channel.decoder.history(1).alive());
    assertTrue(channel.decoder.history(1).outOfSight(0));
    assertEquals(Explanation.Reason.OUT_OF_SIGHT, channel.encoder.report().explain(1).reason());
    records = channel.records;
    scene.bodies[1][3] += METRE;
    for (int i = 0; i < 20; i++) {
      step(channel, false);
    }
    assertEquals(records, channel.records, "out of sight, nothing more is said");
    window.centre = 0;
    for (int i = 0; i < 20; i++) {
      step(channel, false);
    }
    checkWindow(channel);
  }

  @Test
  void stayingTakesLessThanEntering() {
    Channel channel = quietChannel();
    channel.scene.bodies[1][3] = 9 * METRE;
    for (int i = 0; i < 60; i++) {
      channel.scene.bodies[1][3] += METRE / 8 * (i % 2 == 0 ? 1 : -1);
      window.centre = -(i % 3) * METRE;
      step(channel, false);
      assertFalse(i > 10 && !channel.decoder.history(1).alive(), "flickers at tick " + i);
    }
  }

  @Test
  void costGrowsWithWhatIsSeen() {
    Scene scene = new Scene(4_000, 0, 977);
    scene.spawnPercent = 100;
    scene.diePercent = 0;
    scene.wakePercent = 50;
    scene.stopPercent = 0;
    Channel channel = new Channel(scene, 978, Scene.TICK_RATE, window);
    window.half = METRE;
    for (int i = 0; i < 30; i++) {
      step(channel, true);
    }
    FrameState frame = scene.ring.newest();
    int inView = 0;
    for (int slot = 0; slot < frame.slotLimit(); slot++) {
      inView += window.sees(frame, slot, true) ? 1 : 0;
    }
    scene.step();
    window.asked = 0;
    channel.tick();
    assertTrue(inView < 400, "inView=" + inView);
    assertTrue(window.asked <= 2 * inView + 50, "asked=" + window.asked + " with inView=" + inView);
  }

  @Test
  void thePriorityDecidesWhoGoesFirstAndTheVerdictTellsIt() {
    Scene scene = new Scene(200, 0, 979);
    scene.spawnPercent = 100;
    scene.diePercent = 0;
    scene.stopPercent = 0;
    scene.wakePercent = 100;
    window.half = Quantizer.MAX_POSITION;
    window.favourite = 150;
    Channel channel = new Channel(scene, 980, Scene.TICK_RATE, window);
    channel.budget = 150;
    channel.withOwn = false;
    int favourites = 0;
    int overBudget = 0;
    for (int i = 0; i < 300; i++) {
      step(channel, true);
      if (i >= 100) {
        favourites +=
            channel.encoder.report().explain(150).reason() == Explanation.Reason.SENT ? 1 : 0;
        Explanation other = channel.encoder.report().explain(40);
        if (other.reason() == Explanation.Reason.OVER_BUDGET) {
          overBudget++;
          assertTrue(other.collected() <= other.needed() * 1.2f, other.toString());
          assertTrue(other.waiting() > 0, other.toString());
        }
      }
    }
    assertTrue(favourites >= 190, "favourites=" + favourites);
    assertTrue(overBudget > 100, "overBudget=" + overBudget);
    channel.checkHistories();
  }

  @Test
  void theLevelCostsNothingAndIsCorrectedWhereItIsWrong() {
    Scene scene = new Scene(64, 0, 983);
    scene.spawnPercent = 0;
    scene.diePercent = 0;
    scene.wakePercent = 0;
    for (int slot = 0; slot < 64; slot++) {
      scene.bodies[slot] = new int[] {0, 3, -1, slot * METRE, 0, 0, 0, 0, 0};
    }
    FrameState level =
        FrameState.of(
            64,
            f -> {
              for (int slot = 0; slot < 63; slot++) {
                f.putQuantized(slot, 0, 3, -1, slot * METRE, 0, 0, true);
              }
            });
    scene.ring.level(level);
    scene.bodies[7][3] += 1; // altered while the game was set up
    scene.bodies[8] = null;
    scene.tick = 0;
    scene.capture();
    for (int i = 0; i < 200; i++) {
      scene.tick++;
      if (i == 100) {
        scene.bodies[9][4] = 77; // long before the client comes
      }
      if (i == 190) {
        scene.bodies[10][4] = 78; // just before
      }
      scene.capture();
    }
    Channel channel = new Channel(scene, 984);
    channel.decoder.level(level);
    channel.firstTold = 1;
    for (int i = 0; i < 30; i++) {
      scene.tick++;
      scene.capture();
      channel.tick();
    }
    channel.checkConverged();
    assertEquals(5, channel.touched.size(), "slots=" + channel.touched);
    assertEquals(BaselineReason.QUIESCENT, channel.encoder.report().baseline(20));
    scene.bodies[20][4] = 79;
    scene.tick++;
    scene.capture();
    assertEquals(
        BaselineReason.ACKED, channel.encoder.report().baseline(20), "coded against the level");
    channel.tick();
    for (int i = 0; i < 30; i++) {
      scene.tick++;
      scene.capture();
      channel.tick();
    }
    channel.checkConverged();
    assertEquals(0, channel.count(DecodeStatus.NO_BASELINE), channel.name);
  }

  private Channel quietChannel() {
    Scene scene = new Scene(4, 0, 971);
    scene.spawnPercent = 0;
    scene.diePercent = 0;
    scene.wakePercent = 0;
    scene.bodies[1] = new int[] {1, 2, -1, METRE, 0, 0, 0, 0, 0};
    scene.bodies[2] = new int[] {1, 2, -1, 100 * METRE, 0, 0, 0, 0, 0};
    Channel channel = new Channel(scene, 972, Scene.TICK_RATE, window);
    channel.withOwn = false;
    return channel;
  }
}
