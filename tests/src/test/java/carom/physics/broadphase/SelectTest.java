package carom.physics.broadphase;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

class SelectTest {
  private static long[] numbers(int shape, int n, SplittableRandom random) {
    long[] a = new long[n];
    for (int i = 0; i < n; i++) {
      a[i] =
          switch (shape) {
            case 0 -> i;
            case 1 -> n - i;
            case 2 -> Math.min(i, n - i) * 2L + (2 * i > n ? 1 : 0);
            case 3 -> i % 2 == 0 ? i : -i;
            case 4 -> (random.nextInt() >> 1) * (long) n + i;
            default -> (random.nextInt(3) << 20) * (long) n + i;
          };
    }
    return a;
  }

  @Test
  void nthPutsTheRightNumberInPlaceAndDividesTheOthers() {
    long seed = 31;
    SplittableRandom random = new SplittableRandom(seed);
    for (int n : new int[] {1, 2, 3, 12, 13, 14, 100, 399, 400, 401, 5000, 100_000}) {
      for (int shape = 0; shape < 6; shape++) {
        long[] a = numbers(shape, n, random);
        long[] sorted = a.clone();
        Arrays.sort(sorted);
        int k = shape % 2 == 0 ? n / 2 : random.nextInt(n);
        Select.nth(a, 0, n - 1, k);
        String where = "seed=" + seed + " n=" + n + " shape=" + shape + " k=" + k;
        assertEquals(sorted[k], a[k], where);
        for (int i = 0; i < n; i++) {
          assertTrue(i < k ? a[i] < a[k] : i == k || a[i] > a[k], where + " i=" + i);
        }
        Arrays.sort(a);
        assertTrue(Arrays.equals(sorted, a), where + ": the same numbers");
      }
    }
  }
}
