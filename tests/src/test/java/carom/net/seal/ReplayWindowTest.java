package carom.net.seal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.HashSet;
import java.util.Set;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** Goal: no number counts twice. Method: a set that forgets nothing decides what is right. */
final class ReplayWindowTest {

  @Test
  void letsEachNumberInOnceWhateverTheOrder() {
    long seed = Long.getLong("carom.seed", System.nanoTime());
    SplittableRandom random = new SplittableRandom(seed);
    for (int run = 0; run < 40; run++) {
      ReplayWindow window = new ReplayWindow();
      Set<Long> seen = new HashSet<>();
      long newest = -1;
      long base = run % 4 == 0 ? LinkCipher.MAX_FRAMES - 50_000 : 0;
      int spread = 1 << 1 + random.nextInt(14);
      for (int i = 0; i < 5_000; i++) {
        long number =
            Math.max(0, Math.max(base, newest) + random.nextInt(2 * spread) - spread - spread / 2);
        if (random.nextInt(10) == 0) {
          number = newest + 1 + random.nextInt(3);
        }
        boolean old = newest - number >= ReplayWindow.SPAN;
        String what = "seed=" + seed + " run=" + run + " number=" + number + " newest=" + newest;
        assertEquals(!old && !seen.contains(number), window.isNew(number), what);
        if (random.nextInt(4) != 0 && window.isNew(number)) { // others turn out to be forged
          window.mark(number);
          seen.add(number);
          newest = Math.max(newest, number);
        }
      }
    }
  }

  @Test
  void aJumpForgetsNothingThatItNeeds() {
    ReplayWindow window = new ReplayWindow();
    window.mark(5);
    window.mark(5 + ReplayWindow.SPAN - 1);
    assertFalse(window.isNew(5));
    assertTrue(window.isNew(6));
    window.mark(10L * ReplayWindow.SPAN);
    assertTrue(window.isNew(10L * ReplayWindow.SPAN - ReplayWindow.SPAN + 1));
    assertFalse(window.isNew(9L * ReplayWindow.SPAN));
  }
}
