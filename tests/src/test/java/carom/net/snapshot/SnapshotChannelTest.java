package carom.net.snapshot;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.net.snapshot.exact.RelayedInputs;
import carom.net.snapshot.frame.PlayerSet;
import org.junit.jupiter.api.Test;

/**
 * Goal: whatever the network does, what a client has for an entity and a tick is exactly what the
 * server had, and when the world rests the client has all of it. Method: encoder and decoder over a
 * seeded bad channel for thousands of ticks, the scene as oracle.
 */
class SnapshotChannelTest {

  private static void settle(Channel channel, int ticks) {
    for (int i = 0; i < ticks; i++) {
      channel.scene.tick++;
      channel.scene.capture();
      channel.tick();
    }
  }

  private static void run(Channel channel, int ticks) {
    for (int i = 0; i < ticks; i++) {
      channel.scene.step();
      channel.tick();
    }
    channel.checkHistories();
  }

  private static void runAndSettle(Channel channel, int ticks) {
    run(channel, ticks);
    settle(channel, 400);
    channel.checkHistories();
    channel.checkConverged();
  }

  @Test
  void whoHearsAgainAfterLossKnowsAllInputsInBetween() {
    // Goal: others' inputs are known without gaps although datagrams are lost, and some ahead.
    // Method: a third is lost; of the ticks behind each decoded one, nearly all must be known.
    Channel channel = new Channel(new Scene(20, 0, 21), 22);
    channel.lossPercent = 30;
    channel.latencyTicks = 4;
    run(channel, 3_000);
    assertTrue(channel.inputsKnown > 20_000, channel.name + " known=" + channel.inputsKnown);
    assertTrue(channel.inputsWaiting > 2_000, channel.name + " waiting=" + channel.inputsWaiting);
    RelayedInputs inputs = channel.decoder.inputs();
    int gaps = 0;
    PlayerSet relayed = channel.decoder.own().relayed();
    int newest = channel.decoder.newestTick();
    for (int p = relayed.next(0); p >= 0; p = relayed.next(p + 1)) {
      for (int back = 0; back < 20; back++) {
        gaps += inputs.knows(p, newest - back) ? 0 : 1;
      }
    }
    assertTrue(gaps <= 20, channel.name + " gaps=" + gaps);
  }

  @Test
  void agreesOnAPerfectNetwork() {
    Channel channel = new Channel(new Scene(200, 0, 11), 12);
    channel.latencyTicks = 0;
    runAndSettle(channel, 3_000);
    assertEquals(0, channel.count(DecodeStatus.NO_BASELINE), channel.name);
    assertEquals(0, channel.count(DecodeStatus.DAMAGED), channel.name);
    assertEquals(channel.datagrams, channel.count(DecodeStatus.OK), channel.name);
  }

  @Test
  void agreesUnderLossJitterReorderAndDuplicates() {
    for (int seed = 1; seed <= 6; seed++) {
      Channel channel = new Channel(new Scene(120, 1000 * seed, seed), 100 + seed);
      channel.lossPercent = 5 * (seed - 1);
      channel.duplicatePercent = 5;
      channel.reorderPercent = 10;
      channel.jitterTicks = 4;
      channel.latencyTicks = 2 * seed;
      runAndSettle(channel, 2_000);
      assertTrue(channel.count(DecodeStatus.DUPLICATE) > 0, channel.name);
      assertEquals(0, channel.count(DecodeStatus.NO_BASELINE), channel.name);
    }
  }

  @Test
  void neverUsesABaselineTheClientLacksAfterBlackouts() {
    Channel channel = new Channel(new Scene(60, 0, 21), 22);
    for (int round = 0; round < 20; round++) {
      channel.lossPercent = round % 2 == 0 ? 0 : 100;
      run(channel, 10 + 17 * round);
    }
    channel.lossPercent = 0;
    runAndSettle(channel, 100);
    assertEquals(0, channel.count(DecodeStatus.NO_BASELINE), channel.name);
  }

  @Test
  void survivesRoundTripsLongerThanTheRing() {
    Channel channel = new Channel(new Scene(40, 0, 41), 42);
    channel.latencyTicks = 50;
    channel.jitterTicks = 20;
    // NO_BASELINE is allowed here: what is overtaken by 20 ticks may name a state that the client
    // has dropped.
    runAndSettle(channel, 1_500);
  }

  @Test
  void wrapsSequenceNumbersAndTicks() {
    Scene scene = new Scene(6, 65_536 - 500, 51);
    Channel channel = new Channel(scene, 52);
    channel.lossPercent = 3;
    channel.jitterTicks = 2;
    for (int i = 0; i < 70_000; i++) {
      scene.step();
      channel.tick();
    }
    assertTrue(channel.datagrams > 65_536 + 1_000, channel.name);
    runAndSettle(channel, 10);
    assertEquals(0, channel.count(DecodeStatus.NO_BASELINE), channel.name);
  }

  @Test
  void keepsTheBudgetAndForgetsNobody() {
    Channel channel = new Channel(new Scene(800, 0, 61), 62);
    channel.budget = 900;
    channel.lossPercent = 5;
    channel.scene.stopPercent = 0.1;
    for (int i = 0; i < 1_500; i++) {
      channel.scene.step();
      channel.tick();
      assertTrue(channel.maxBytesPerTick <= 900, channel.name + " " + channel.maxBytesPerTick);
    }
    assertTrue(channel.maxWaiting > 300, channel.name + " waiting=" + channel.maxWaiting);
    for (int slot = 0; slot < channel.scene.slots; slot++) {
      if (channel.scene.bodies[slot] != null) {
        int age = channel.scene.tick - Math.max(0, channel.encoder.report().sentTick(slot));
        BaselineReason baseline = channel.encoder.report().baseline(slot);
        assertTrue(
            baseline == BaselineReason.QUIESCENT || age < 40,
            channel.name + " slot=" + slot + " waits for ticks=" + age);
      }
    }
    channel.checkHistories();
    settle(channel, 200);
    channel.checkConverged();
  }

  @Test
  void manyDatagramsATickStandAlone() {
    Channel channel = new Channel(new Scene(3_000, 0, 71), 72);
    channel.scene.spawnPercent = 100;
    channel.scene.wakePercent = 50;
    channel.lossPercent = 20;
    run(channel, 120);
    assertTrue(channel.datagrams > 120 * 5, channel.name + " datagrams=" + channel.datagrams);
    settle(channel, 60);
    channel.checkConverged();
  }

  @Test
  void agreesAtLowerSendRates() {
    for (int every = 2; every <= 4; every++) {
      Channel channel = new Channel(new Scene(100, 7, 200 + every), 300 + every);
      channel.sendEvery = every;
      channel.lossPercent = 10;
      channel.jitterTicks = 5;
      runAndSettle(channel, 1_500);
      assertEquals(0, channel.count(DecodeStatus.NO_BASELINE), channel.name);
    }
  }

  @Test
  void agreesAtTheSlowestAndFastestTickRate() {
    for (int rate : new int[] {10, 240}) {
      Channel channel = new Channel(new Scene(50, 0, rate), rate + 1, rate);
      channel.lossPercent = 5;
      channel.latencyTicks = 10;
      runAndSettle(channel, 1_000);
      assertEquals(0, channel.count(DecodeStatus.DAMAGED), channel.name);
    }
  }

  @Test
  void slotsFarApartAndTheHighestAgree() {
    Scene scene = new Scene(65_535, 0, 401);
    scene.spawnPercent = 0;
    for (int slot : new int[] {0, 1, 17, 18, 35, 300, 600, 5_000, 65_533, 65_534}) {
      scene.spawn(slot);
    }
    Channel channel = new Channel(scene, 402);
    run(channel, 40);
    settle(channel, 20);
    channel.checkConverged();
    assertEquals(65_535, channel.decoder.slotLimit());
  }

  @Test
  void aWorldAtRestCostsNothingButAHeader() {
    Channel channel = new Channel(new Scene(500, 0, 91), 92);
    channel.withOwn = false;
    run(channel, 200);
    settle(channel, 50);
    assertTrue(channel.encoder.nothingNew(null), channel.name);
    long before = channel.bytes;
    long recordsBefore = channel.records;
    settle(channel, 100);
    assertEquals(recordsBefore, channel.records, channel.name);
    assertTrue(channel.bytes - before <= 100 * 11, channel.name + " " + (channel.bytes - before));
    channel.scene.push(firstAlive(channel.scene));
    channel.scene.tick++;
    channel.scene.capture();
    assertTrue(!channel.encoder.nothingNew(null), channel.name);
  }

  @Test
  void theEndOfARestIsInTheHistory() {
    Scene scene = new Scene(4, 0, 95);
    scene.spawnPercent = 0;
    scene.diePercent = 0;
    scene.wakePercent = 0;
    scene.spawn(2);
    scene.bodies[2][6] = 0;
    scene.bodies[2][7] = 0;
    scene.bodies[2][8] = 0;
    Channel channel = new Channel(scene, 96);
    run(channel, 300);
    EntityHistory history = channel.decoder.history(2);
    assertNotNull(history);
    int before = history.tick(0);
    assertTrue(before < 20, "a resting body is sent until acked only");
    scene.bodies[2][6] = 64;
    run(channel, 10);
    int index = history.indexAt(299);
    assertEquals(299, history.tick(index), "the last tick of its rest");
    assertEquals(history.x(history.indexAt(before)), history.x(index));
  }

  private static int firstAlive(Scene scene) {
    int slot = 0;
    while (scene.bodies[slot] == null) {
      slot++;
    }
    return slot;
  }
}
