package carom.net.snapshot;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.net.codec.RangeEncoder;
import carom.net.snapshot.frame.FrameRing;
import carom.net.snapshot.frame.FrameState;
import carom.net.snapshot.frame.QuantizedPose;
import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** What sessions share is what each of them would have worked out alone. */
final class DeltasTest {
  private static final int TICK_RATE = 60;
  private static final int SLOTS = 3_000;
  private static final int OLDEST = 20;
  private static final long SEED = 20_261_122;

  private final FrameRing ring = new FrameRing(SLOTS);
  private final Random random = new Random(SEED);
  private int tick;

  private void frame(int slots) {
    FrameState frame = ring.begin(++tick);
    for (int slot = 0; slot < slots; slot++) {
      int v = random.nextInt(-16_000, 16_000) >> random.nextInt(16);
      frame.putQuantized(slot, 1, 1, -1, random.nextInt(100_000), v, v & 1023, v == 0);
    }
    ring.end();
  }

  /** A baseline of so many ticks and as many poses as there are. */
  private int baseline(int age) {
    int stride = 1 + age % 3;
    for (int poses = 3; poses > 1; poses--) {
      if (ring.back(age + (poses - 1) * stride) != null) {
        return Baseline.of(age, poses, stride);
      }
    }
    return Baseline.of(age, 1, 0);
  }

  /** The same message, worked out alone. */
  private String alone(int age, int slot, int profile) {
    Predictor predictor = new Predictor(TICK_RATE);
    Track track = new Track();
    QuantizedPose actual = new QuantizedPose();
    QuantizedPose predicted = new QuantizedPose();
    QuantizedPose residual = new QuantizedPose();
    int baseline = baseline(age);
    for (int i = 0; i < Baseline.poses(baseline); i++) {
      ring.back(age + i * Baseline.stride(baseline)).pose(slot, track.pose(i));
    }
    ring.newest().pose(slot, actual);
    int rested = 0;
    while (track.newest.still
        && rested + 1 < age
        && !ring.back(age - rested - 1).changed().has(slot)) {
      rested++;
    }
    predictor.study(track, baseline);
    predictor.predict(track, profile, predicted);
    residual.setResidual(predicted, actual);
    byte[] bytes = new byte[300];
    RangeEncoder range = new RangeEncoder();
    range.reset(bytes, 0, bytes.length);
    DeltaCodec codec = new DeltaCodec();
    codec.profile(profile);
    codec.code(range, track, residual, rested);
    return Arrays.toString(Arrays.copyOf(bytes, range.finish()));
  }

  /** The delta as a message of its own. */
  private String message(Deltas deltas, int age, int slot) {
    byte[] bytes = new byte[300];
    RangeEncoder range = new RangeEncoder();
    range.reset(bytes, 0, bytes.length);
    deltas.write(range, deltas.of(ring.newest(), baseline(age), slot));
    return Arrays.toString(Arrays.copyOf(bytes, range.finish()));
  }

  @Test
  void aDeltaIsTheSameHoweverManyAskForIt() {
    frame(10);
    Deltas shared = new Deltas(ring, TICK_RATE);
    for (int round = 0; round < 40; round++) {
      frame(round < 20 ? 10 : 100); // more slots: its index grows
      for (int i = 0; i < 30; i++) {
        int age = 1 + random.nextInt(Math.min(round + 1, 9));
        int slot = random.nextInt(10);
        String message = message(shared, age, slot);
        assertEquals(
            alone(age, slot, shared.profile(slot)), message, "seed " + SEED + " tick " + tick);
        assertEquals(
            shared.of(ring.newest(), baseline(age), slot),
            shared.of(ring.newest(), baseline(age), slot));
      }
    }
  }

  @Test
  void whatHasNoRoomIsWorkedOutEachTime() {
    for (int i = 0; i <= OLDEST; i++) {
      frame(SLOTS);
    }
    Deltas shared = new Deltas(ring, TICK_RATE);
    for (int age = 1; age <= OLDEST; age++) {
      for (int slot = 0; slot < SLOTS; slot++) {
        shared.of(ring.newest(), baseline(age), slot);
      }
    }
    String last = message(shared, OLDEST, SLOTS - 1);
    String former = message(shared, OLDEST, SLOTS - 2);
    assertEquals(alone(OLDEST, SLOTS - 1, shared.profile(SLOTS - 1)), last);
    assertEquals(alone(OLDEST, SLOTS - 2, shared.profile(SLOTS - 2)), former);
    assertNotEquals(former, last);
    assertEquals(
        shared.of(ring.newest(), baseline(OLDEST), SLOTS - 1) >>> 8,
        shared.of(ring.newest(), baseline(OLDEST), SLOTS - 2) >>> 8,
        "the room has no end, or this test too few slots");
  }

  private byte[] run(Deltas deltas, int age, int word, long slots) {
    byte[] bytes = new byte[4_000];
    RangeEncoder range = new RangeEncoder();
    range.reset(bytes, 0, bytes.length);
    RecordCodec records = new RecordCodec();
    records.begin();
    deltas.writeRun(range, records, ring.newest(), baseline(age), word, slots);
    return Arrays.copyOf(bytes, range.finish());
  }

  /** Deltas keep what they computed first. A run must not show what was computed before it. */
  @Test
  void aRunIsTheSameWhicheverOfItsSlotsWereAskedForBefore() {
    for (int i = 0; i < 6; i++) {
      frame(200);
    }
    Deltas shared = new Deltas(ring, TICK_RATE);
    for (int round = 0; round < 60; round++) {
      frame(200);
      int word = random.nextInt(3);
      int age = 1 + random.nextInt(5);
      long some = random.nextLong();
      long others = random.nextInt(3) == 0 ? -1 : some & random.nextLong() | 1;
      byte[] first = run(shared, age, word, some);
      byte[] second = run(shared, age, word, others);
      assertArrayEquals(first, run(shared, age, word, some), "seed " + SEED);
      Deltas anew = new Deltas(ring, TICK_RATE);
      for (int i = 0; i < 192; i += 32) {
        anew.of(ring.newest(), baseline(1), i);
      }
      if (shared.profile(word << 6) == anew.profile(word << 6)
          && shared.profile((word << 6) + 32) == anew.profile((word << 6) + 32)) {
        assertArrayEquals(second, run(anew, age, word, others), "seed " + SEED);
      }
      long fitting = shared.fitting(ring.newest(), baseline(age), word, some, 600);
      assertTrue(fitting != 0 && (fitting & ~some) == 0);
      assertTrue(run(shared, age, word, fitting).length <= 600 / 8 + 20);
    }
  }

  @Test
  void theDensityOfMostIsTakenUnlessAnotherSaysTheSlotsMuchShorter() {
    assertEquals(0, SlotCodec.density(-1, 0));
    long tenApart = 0x0410_4104_1041_0410L;
    assertEquals(4, SlotCodec.density(tenApart, 4), "a few bits are no reason");
    assertEquals(5, SlotCodec.density(tenApart, 0));
    assertTrue(SlotCodec.cost(0, -1) < 16, "less than a bit tells that all are in it");
    assertEquals(7, SlotCodec.density(1L << 20, 3), "one alone");
    assertTrue(SlotCodec.density(-1L >>> 24, 3) <= 1, "clustered");
  }

  @Test
  void bodiesThatMoveAlikeHaveTheProfileThatSaysItShortest() {
    Deltas shared = new Deltas(ring, TICK_RATE);
    for (int round = 0; round < 40; round++) {
      FrameState frame = ring.begin(++tick);
      for (int slot = 0; slot < 128; slot++) {
        int v = slot < 64 ? 64 : random.nextInt(-300, 300); // the first fly on, the others are hit
        int way = 8 * tick * v / 60;
        frame.putQuantized(slot, 1, 1, -1, way, -way, v & 1023, false);
      }
      ring.end();
      if (round > 6) {
        shared.of(ring.newest(), baseline(6), 0);
      }
    }
    assertEquals(shared.profile(0), shared.profile(63));
    assertNotEquals(shared.profile(0), shared.profile(127));
    for (int slot = 0; slot < 128; slot += 127) {
      int used = alone(6, slot, shared.profile(slot)).length();
      for (int i = 0; i < Profiles.COUNT; i++) {
        int length = alone(6, slot, i).length();
        assertTrue(length + 12 >= used, "slot=" + slot + " profile=" + i + ": " + length);
      }
    }
  }
}
