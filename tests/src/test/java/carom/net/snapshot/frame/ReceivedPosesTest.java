package carom.net.snapshot.frame;

import static org.junit.jupiter.api.Assertions.assertEquals;

import carom.net.codec.Quantizer;
import carom.net.snapshot.Dice;
import java.util.HashMap;
import java.util.Map;
import org.junit.jupiter.api.Test;

/** Goal: a window of ticks, of one entity a slot. Method: a map of all poses, the same calls. */
final class ReceivedPosesTest {
  private static final int SLOTS = 192;
  private static final int ROUNDS = 20_000;

  private final ReceivedPoses received = new ReceivedPoses();
  private final QuantizedPose pose = new QuantizedPose();

  @Test
  void posesOfTheLastTicksAreReadAsTheyCame() {
    Dice dice = new Dice(23);
    Map<Long, int[]> truth = new HashMap<>();
    int[] newest = new int[SLOTS >> 6];
    int[] kinds = new int[SLOTS];
    for (int round = 0; round < ROUNDS; round++) {
      int slot = dice.below(SLOTS);
      int tick = 100 + round / 50 + dice.below(90);
      int kind = dice.percent(95) ? kinds[slot] : dice.below(1 << 28);
      int limit = Quantizer.MAX_POSITION;
      pose.set(
          dice.below(2 * limit + 1) - limit,
          dice.below(2 * limit + 1) - limit,
          dice.below(Quantizer.ANGLE_STEPS),
          dice.percent(20));
      int[] numbers = {pose.x, pose.y, pose.angle, pose.still ? 1 : 0};
      newest[slot >> 6] = Math.max(newest[slot >> 6], tick);
      received.add(slot, tick, kind, 7, pose);
      if (tick > newest[slot >> 6] - FrameRing.SIZE) {
        if (kind != kinds[slot]) {
          truth.keySet().removeIf(key -> key >>> 32 == slot);
          kinds[slot] = kind;
        }
        truth.putIfAbsent((long) slot << 32 | tick, numbers);
      }
      int asked = dice.below(SLOTS);
      for (int t = newest[asked >> 6] - 70; t < newest[asked >> 6] + 3; t++) {
        check(truth, asked, t, t > newest[asked >> 6] - FrameRing.SIZE, kinds[asked]);
      }
    }
  }

  private void check(Map<Long, int[]> truth, int slot, int tick, boolean inTime, int kind) {
    int[] numbers = inTime ? truth.get((long) slot << 32 | tick) : null;
    boolean held = (received.held(slot >> 6, tick) >>> slot & 1) != 0;
    String where = "slot=" + slot + " tick=" + tick;
    assertEquals(numbers != null, held, where);
    if (numbers != null) {
      received.read(slot, tick, pose);
      assertEquals(numbers[0], pose.x, where);
      assertEquals(numbers[1], pose.y, where);
      assertEquals(numbers[2], pose.angle, where);
      assertEquals(numbers[3] != 0, pose.still, where);
      assertEquals(kind, received.kind(slot), where);
      assertEquals(7, received.owner(slot), where);
    }
  }

  @Test
  void nothingIsHeldOfWordsThatNeverCame() {
    pose.set(1, 2, 3, false);
    received.add(70, 5, 1, 0, pose);
    assertEquals(1L << 70, received.held(1, 5));
    for (int word : new int[] {Integer.MIN_VALUE, -1, 0, 2, Integer.MAX_VALUE}) {
      assertEquals(0, received.held(word, 5), "word=" + word);
    }
    assertEquals(0, received.held(1, -59), "a tick of the same place");
  }
}
