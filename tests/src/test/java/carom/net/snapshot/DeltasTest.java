package carom.net.snapshot;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;

import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** What sessions share is what each of them would have worked out alone. */
final class DeltasTest {
  private static final int TICK_RATE = 60;
  private static final int SLOTS = 3_000;
  private static final long SEED = 20_261_122;

  private final FrameRing ring = new FrameRing(SLOTS);
  private final Random random = new Random(SEED);
  private int tick;

  private void frame(int slots) {
    FrameState frame = ring.begin(++tick);
    for (int slot = 0; slot < slots; slot++) {
      int v = random.nextInt(-20_000, 20_000) >> random.nextInt(16);
      frame.putQuantized(slot, 1, 1, -1, random.nextInt(100_000), v, v & 1023, v, -v, v >> 3);
    }
    ring.end();
  }

  private char[] steps(Deltas deltas, int age, int slot) {
    int delta = deltas.of(ring.newest(), ring.back(age), slot);
    char[] steps = Arrays.copyOfRange(deltas.steps(), deltas.from(delta) - 2, deltas.to(delta));
    assertEquals(steps.length - 2, steps[1]);
    return steps;
  }

  @Test
  void aDeltaIsTheSameHoweverManyAskForIt() {
    frame(10);
    Deltas shared = ring.deltas(TICK_RATE);
    for (int round = 0; round < 40; round++) {
      frame(round < 20 ? 10 : 100); // more slots: its index grows
      for (int i = 0; i < 30; i++) {
        int age = 1 + random.nextInt(Math.min(round + 1, 9));
        int slot = random.nextInt(10);
        Deltas alone = new Deltas(TICK_RATE, 0, 0);
        assertEquals(
            Arrays.toString(steps(alone, age, slot)),
            Arrays.toString(steps(shared, age, slot)),
            "seed " + SEED + " tick " + tick);
        assertEquals(
            shared.of(ring.newest(), ring.back(age), slot),
            shared.of(ring.newest(), ring.back(age), slot));
      }
    }
  }

  @Test
  void whatHasNoRoomIsWorkedOutEachTime() {
    for (int i = 0; i < 10; i++) {
      frame(SLOTS);
    }
    Deltas shared = ring.deltas(TICK_RATE);
    for (int age = 1; age < 10; age++) {
      for (int slot = 0; slot < SLOTS; slot++) {
        shared.of(ring.newest(), ring.back(age), slot);
      }
    }
    Deltas alone = new Deltas(TICK_RATE, 0, 0);
    char[] last = steps(shared, 9, SLOTS - 1);
    char[] former = steps(shared, 9, SLOTS - 2);
    assertEquals(Arrays.toString(steps(alone, 9, SLOTS - 1)), Arrays.toString(last));
    assertEquals(Arrays.toString(steps(alone, 9, SLOTS - 2)), Arrays.toString(former));
    assertNotEquals(Arrays.toString(former), Arrays.toString(last));
    assertEquals(
        shared.of(ring.newest(), ring.back(9), SLOTS - 1),
        shared.of(ring.newest(), ring.back(9), SLOTS - 2),
        "the room has no end, or this test too few slots");
  }
}
