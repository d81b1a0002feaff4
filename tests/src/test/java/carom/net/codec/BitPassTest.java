package carom.net.codec;

import org.junit.jupiter.api.Test;

/** What all passes have in common. */
class BitPassTest {
  private static final int[] VALUES = {
    0, 1, -1, 2, 1 << 15, -(1 << 16), Integer.MAX_VALUE, Integer.MIN_VALUE
  };

  @Test
  void differencesOfAllWidthsComeBack() {
    SectionCheck<int[]> check =
        new SectionCheck<>(
            (c, value) -> value[0] = c.difference(value[0]),
            () -> new int[1],
            value -> "" + value[0]);
    for (int value : VALUES) {
      check.check(new int[] {value});
    }
  }

  @Test
  void numbersOfAllWidthsComeBack() {
    for (int bits = 1; bits <= Integer.SIZE; bits++) {
      int count = bits;
      SectionCheck<int[]> check =
          new SectionCheck<>(
              (c, value) -> value[0] = c.plain(value[0], count),
              () -> new int[1],
              value -> "" + value[0]);
      check.check(new int[] {-1 >>> Integer.SIZE - bits});
      check.check(new int[] {1 << bits - 1});
    }
  }
}
