package carom.physics.dynamics.contact;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;

import java.util.Arrays;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

final class RowShiftsTest {
  @Test
  void movesEveryRowWhereItBelongs() {
    RowShifts shifts = new RowShifts();
    for (long seed = 1; seed <= 300; seed++) {
      SplittableRandom r = new SplittableRandom(seed);
      int n = r.nextInt(200);
      int drop = r.nextInt(100);
      int come = r.nextInt(100);
      float[] expected = new float[3 * n + 50];
      int to = 0;
      int fresh = 0;
      shifts.clear(false);
      for (int row = 0; row <= n; row++) {
        for (int k = r.nextInt(3); k > 0 && r.nextInt(100) < come; k--) {
          shifts.insert(fresh++, to);
          expected[to++] = -fresh;
        }
        if (row < n && r.nextInt(100) >= drop) {
          shifts.keep(row, to);
          expected[to++] = row;
        }
      }
      float[] floats = new float[3 * expected.length];
      long[] longs = new long[expected.length];
      for (int row = 0; row < n; row++) {
        Arrays.fill(floats, 3 * row, 3 * row + 3, row);
        longs[row] = row;
      }
      shifts.plan(floats, floats, 3);
      shifts.plan(longs, longs, 1);
      shifts.carryOut(null);
      for (int i = 0; i < fresh; i++) {
        Arrays.fill(floats, 3 * shifts.inserted[i], 3 * shifts.inserted[i] + 3, -(i + 1));
        longs[shifts.inserted[i]] = -(i + 1);
      }
      float[] copied = new float[to];
      float[] thrice = new float[3 * to];
      for (int i = 0; i < to; i++) {
        copied[i] = longs[i];
        Arrays.fill(thrice, 3 * i, 3 * i + 3, expected[i]);
      }
      assertArrayEquals(thrice, Arrays.copyOf(floats, 3 * to), "seed=" + seed);
      assertArrayEquals(Arrays.copyOf(expected, to), copied, "seed=" + seed);
    }
  }
}
