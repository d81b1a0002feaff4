package carom.net.snapshot.frame;

import static org.junit.jupiter.api.Assertions.assertEquals;

import carom.net.snapshot.Dice;
import java.util.Arrays;
import org.junit.jupiter.api.Test;

/** Goal: layers are never seen. Method: an array with a tick for each slot, the same calls. */
final class SlotTicksTest {

  @Test
  void eachSlotHasTheNewestTickItWasGiven() {
    Dice dice = new Dice(41);
    SlotTicks ticks = new SlotTicks();
    ticks.ensure(192);
    int[] truth = new int[192];
    Arrays.fill(truth, SlotTicks.UNKNOWN);
    for (int round = 0; round < 20_000; round++) {
      int word = dice.below(3);
      long slots = dice.percent(30) ? -1 : dice.percent(50) ? dice.next() : 1L << dice.below(64);
      int tick = round / 10 + dice.below(12);
      if (dice.percent(3)) {
        int slot = dice.below(192);
        ticks.set(slot, dice.percent(50) ? SlotTicks.UNKNOWN : tick);
        truth[slot] = ticks.get(slot);
      }
      ticks.raise(word, slots, tick);
      for (int i = 0; i < 64; i++) {
        if ((slots >>> i & 1) != 0) {
          truth[64 * word + i] = Math.max(truth[64 * word + i], tick);
        }
      }
      for (int slot = 0; slot < 192; slot++) {
        assertEquals(truth[slot], ticks.get(slot), "round=" + round + " slot=" + slot);
      }
    }
    assertEquals(SlotTicks.UNKNOWN, ticks.get(500));
  }
}
