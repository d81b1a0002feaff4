package carom.client.stats;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** Goal: the share of what was lost lately. Method: a list of all datagrams, the same acks. */
final class LossWindowTest {
  private static final long SEED = 31;
  private static final int SETTLED = 16;

  private final LossWindow window = new LossWindow();

  @Test
  void theShareIsThatOfTheLastDatagrams() {
    Random random = new Random(SEED);
    assertEquals(0, window.percent());
    for (int link = 0; link < 3; link++) {
      window.reset();
      List<Boolean> arrived = new ArrayList<>();
      int first = 65_000 + random.nextInt(1_000); // the numbers wrap
      for (int datagram = 0; datagram < 2_000; datagram++) {
        boolean came = datagram == 0 || random.nextInt(100) >= (datagram < 1_000 ? 30 : 2);
        arrived.add(came);
        if (came) {
          long bits = 0;
          for (int i = 0; i < 64 && datagram - 1 - i >= 0; i++) {
            bits |= arrived.get(datagram - 1 - i) ? 1L << i : 0;
          }
          window.acks(first + datagram & 0xffff, bits);
          String where = "seed=" + SEED + " link=" + link + " datagram=" + datagram;
          assertEquals(percent(arrived, datagram - SETTLED), window.percent(), 1e-9, where);
        }
      }
    }
  }

  private static double percent(List<Boolean> arrived, int last) {
    int count = 0;
    int lost = 0;
    for (int i = Math.max(0, last - LossWindow.SIZE + 1); i <= last; i++) {
      count++;
      lost += arrived.get(i) ? 0 : 1;
    }
    return count == 0 ? 0 : 100.0 * lost / count;
  }
}
