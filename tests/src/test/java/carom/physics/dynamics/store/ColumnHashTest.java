package carom.physics.dynamics.store;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.physics.math.StateHash;
import java.util.Arrays;
import java.util.HashSet;
import java.util.Random;
import java.util.Set;
import org.junit.jupiter.api.Test;

class ColumnHashTest {
  /** Calls after which kernels are trusted with everything. */
  private static final int MANY = 2_000;

  private static final long START = 7;

  private final ColumnHash hash = new ColumnHash();
  private final Random random = new Random(5);

  private float[] column(int n) {
    float[] column = new float[n];
    for (int i = 0; i < n; i++) {
      column[i] = Float.intBitsToFloat(random.nextInt());
    }
    return column;
  }

  private static void flip(float[] column, int at, int bit) {
    column[at] = Float.intBitsToFloat(Float.floatToRawIntBits(column[at]) ^ 1 << bit);
  }

  /** The sum, spelt out. */
  private static long expected(float[] column, int n) {
    long sum = 0;
    for (int i = 0; i < n; i += 2) {
      long low = Float.floatToRawIntBits(column[i]) & 0xffffffffL;
      long high = i + 1 < n ? Float.floatToRawIntBits(column[i + 1]) & 0xffffffffL : 0;
      long factor = StateHash.finish((i / 2 + 1) * 0x9e3779b97f4a7c15L) | 1;
      long spread = (low + (high << 32)) * 0x9e3779b97f4a7c15L;
      sum += (spread ^ spread >>> 32) * factor;
    }
    return StateHash.mix(START, sum);
  }

  /** Goal: vectors show in no bit. Method: columns of all lengths, until vectors do all of them. */
  @Test
  void vectorsGiveTheSameBits() {
    for (int n : new int[] {0, 1, 2, 63, 511, 512, 513, 1000, 1023, 4096, 5001}) {
      float[] column = column(n + 9);
      long expected = expected(column, n);
      for (int call = 0; call < (n == 5001 ? MANY : 3); call++) {
        assertEquals(expected, hash.mix(START, column, n), "n=" + n + " call=" + call);
      }
    }
    for (int n = 500; n < 620; n++) {
      float[] column = column(n);
      assertEquals(expected(column, n), hash.mix(START, column, n), "n=" + n);
    }
  }

  /**
   * Goal: a short column costs no boxed vectors in a JVM that hashed long ones before. Method: what
   * kernels are called for, on either side of the calls after which they are trusted.
   */
  @Test
  void kernelsNeverSeeColumnsThatAreTooShortForThem() {
    ColumnsOnly lanes = new ColumnsOnly();
    float[] column = column(600);
    long[] sums = new long[ColumnHashLanes.SUMS];
    for (int call = 0; call < MANY; call++) {
      lanes.numbers = 0;
      assertEquals(0, lanes.column(column, new long[300], 40, sums));
      assertEquals(0, lanes.calls, "call=" + call);
      int done = lanes.column(column, new long[300], 600, sums);
      assertEquals(done, lanes.numbers, "call=" + call);
      lanes.calls = 0;
    }
  }

  /** Counts what it is given. */
  private static final class ColumnsOnly extends ColumnHashLanes {
    private int calls;
    private int numbers;

    @Override
    protected int warmUpSize() {
      return 1;
    }

    @Override
    protected void warmUp(float[] made) {}

    @Override
    public void column(float[] column, long[] factors, int from, int to, long[] sums) {
      calls++;
      numbers += to - from;
    }
  }

  @Test
  void oneOrTwoFlippedBitsGiveAnotherHash() {
    float[] column = column(600);
    int[] places = {0, 1, 2, 3, 530, 531, 599};
    Set<Long> seen = new HashSet<>();
    seen.add(hash.mix(START, column, 600));
    int tried = 1;
    for (int a = 0; a < places.length * 32; a++) {
      flip(column, places[a / 32], a % 32);
      seen.add(hash.mix(START, column, 600));
      tried++;
      for (int b = a + 1; b < places.length * 32; b++) {
        flip(column, places[b / 32], b % 32);
        seen.add(hash.mix(START, column, 600));
        tried++;
        flip(column, places[b / 32], b % 32);
      }
      flip(column, places[a / 32], a % 32);
    }
    assertEquals(tried, seen.size());
  }

  @Test
  void numbersThatChangePlacesGiveAnotherHashAndSoDoesTheSignOfZero() {
    Set<Long> seen = new HashSet<>();
    float[] column = new float[700];
    for (int i = 0; i < 700; i++) {
      for (float value : new float[] {1, 2, -0f}) {
        column[i] = value;
        assertTrue(seen.add(hash.mix(START, column, 700)), "i=" + i + " value=" + value);
      }
      column[i] = 0;
    }
  }

  @Test
  void aFlippedBitFlipsAboutHalfOfTheHash() {
    float[] column = column(1000);
    long before = hash.mix(START, column, 1000);
    long flipped = 0;
    for (int i = 0; i < 1000; i++) {
      int bit = random.nextInt(32);
      flip(column, i, bit);
      long after = StateHash.finish(hash.mix(START, column, 1000));
      flipped += Long.bitCount(after ^ StateHash.finish(before));
      flip(column, i, bit);
    }
    assertEquals(32, flipped / 1000.0, 0.5);
  }

  @Test
  void bytesCountByTheirPlaces() {
    byte[] column = new byte[41];
    random.nextBytes(column);
    Set<Long> seen = new HashSet<>();
    seen.add(hash.mix(START, column, 41));
    for (int i = 0; i < 41; i++) {
      for (int bit = 0; bit < 8; bit++) {
        column[i] ^= (byte) (1 << bit);
        assertTrue(seen.add(hash.mix(START, column, 41)), "i=" + i + " bit=" + bit);
        column[i] ^= (byte) (1 << bit);
      }
    }
    byte[] longer = Arrays.copyOf(column, 48);
    long before = hash.mix(START, longer, 41);
    longer[41] = 1;
    assertEquals(before, hash.mix(START, longer, 41), "what comes after them doesn't count");
    assertNotEquals(before, hash.mix(START, longer, 42));
  }
}
