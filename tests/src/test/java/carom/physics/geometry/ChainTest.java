package carom.physics.geometry;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

class ChainTest {
  /** Against all pairs by whole numbers, which are exact. */
  @Test
  void exactlyTheChainsThatCrossThemselvesOrTurnBackAreRefused() {
    int refused = 0;
    int chains = 4_000;
    for (int seed = 0; seed < chains; seed++) {
      SplittableRandom r = new SplittableRandom(seed);
      int points = 3 + r.nextInt(10);
      boolean loop = r.nextBoolean();
      int[] x = new int[points];
      int[] y = new int[points];
      float[] xy = new float[2 * points];
      for (int i = 0; i < points; i++) {
        do {
          x[i] = r.nextInt(-3, 4) + (r.nextInt(4) > 0 ? 4 * i : 0);
          y[i] = r.nextInt(-20, 21);
        } while (same(x, y, i, (i + points - 1) % points));
        xy[2 * i] = x[i];
        xy[2 * i + 1] = y[i];
      }
      if (same(x, y, 0, points - 1)) {
        continue;
      }
      boolean bad = crossesItself(x, y, loop) || turnsBack(x, y, loop);
      String told = "";
      try {
        Chain chain = loop ? Chain.loop(xy) : Chain.open(xy);
        assertEquals(points, chain.pointCount());
      } catch (IllegalArgumentException e) {
        told = e.getMessage();
        refused++;
      }
      assertEquals(bad, !told.isEmpty(), "seed=" + seed + " " + told);
    }
    assertTrue(refused > chains / 10 && refused < chains * 9 / 10, "refused=" + refused);
  }

  private static boolean same(int[] x, int[] y, int i, int j) {
    return x[i] == x[j] && y[i] == y[j];
  }

  private static boolean crossesItself(int[] x, int[] y, boolean loop) {
    int n = x.length;
    int segments = loop ? n : n - 1;
    for (int i = 0; i < segments; i++) {
      for (int j = i + 1; j < segments; j++) {
        int b = (i + 1) % n;
        int d = (j + 1) % n;
        if (side(x, y, i, b, j) * side(x, y, i, b, d) < 0
            && side(x, y, j, d, i) * side(x, y, j, d, b) < 0) {
          return true;
        }
      }
    }
    return false;
  }

  private static boolean turnsBack(int[] x, int[] y, boolean loop) {
    int n = x.length;
    for (int i = 0; i < (loop ? n : n - 2); i++) {
      int b = (i + 1) % n;
      int c = (i + 2) % n;
      int ahead = (x[b] - x[i]) * (x[c] - x[b]) + (y[b] - y[i]) * (y[c] - y[b]);
      if (side(x, y, i, b, c) == 0 && ahead < 0) {
        return true;
      }
    }
    return false;
  }

  private static int side(int[] x, int[] y, int a, int b, int c) {
    return Integer.signum((x[b] - x[a]) * (y[c] - y[a]) - (y[b] - y[a]) * (x[c] - x[a]));
  }
}
