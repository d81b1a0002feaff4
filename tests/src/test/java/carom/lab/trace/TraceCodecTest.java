package carom.lab.trace;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.net.codec.Quantizer;
import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The codec of traces, against the only oracle there is: what went in. */
final class TraceCodecTest {
  private static final long SEED = 5_600_143;

  /** Bodies that rest, fly, fall and spin, are knocked about, and sometimes jump anywhere. */
  private static final class Motion {
    final Random random;
    final int bodies;
    final double[][] s;

    Motion(long seed, int bodies) {
      random = new Random(seed);
      this.bodies = bodies;
      s = new double[6][bodies];
      for (int i = 0; i < bodies; i++) {
        s[0][i] = random.nextInt(4_000);
        s[1][i] = random.nextInt(4_000);
      }
    }

    void next(int[][] state) {
      for (int i = 0; i < bodies; i++) {
        if (i % 3 != 0) {
          if (random.nextInt(40) == 0) {
            s[3][i] = random.nextGaussian() * 20;
            s[4][i] = random.nextGaussian() * 20;
            s[5][i] = random.nextGaussian() * 30;
          }
          if (i % 3 == 2) {
            s[4][i] -= 1.4;
          }
          for (int f = 0; f < 3; f++) {
            s[f][i] += s[f + 3][i];
          }
        }
        if (random.nextInt(500) == 0) {
          s[0][i] = random.nextInt(2 * Quantizer.MAX_POSITION) - Quantizer.MAX_POSITION;
        }
        for (int f = 0; f < state.length; f++) {
          int value = (int) Math.round(s[f][i]);
          state[f][i] =
              switch (f) {
                case 2 -> value & Quantizer.ANGLE_STEPS - 1;
                case 0, 1 -> clamp(value, Quantizer.MAX_POSITION);
                case 5 -> clamp(100 * value, Trace.MAX_OMEGA);
                default -> clamp(1_000 * value, Trace.MAX_VELOCITY);
              };
        }
      }
    }

    private static int clamp(int value, int max) {
      return Math.max(-max, Math.min(max, value));
    }
  }

  @ParameterizedTest
  @CsvSource({"1,1,3", "1,6,6", "40,1,6", "60,6,3", "60,6,6", "25,17,3", "10,64,6"})
  void everySnapshotComesOutAsItWentIn(int bodies, int lag, int fields) {
    TraceCodec encoder = new TraceCodec(bodies, lag, 60, fields);
    TraceCodec decoder = new TraceCodec(bodies, lag, 60, fields);
    Motion motion = new Motion(SEED, bodies);
    int[][] state = new int[fields][bodies];
    int[][] decoded = new int[fields][bodies];
    byte[] bytes = new byte[encoder.maxBytes()];
    for (int n = 0; n < 4 * lag + 150; n++) {
      motion.next(state);
      int length = encoder.encode(state, bytes);
      assertTrue(decoder.decode(Arrays.copyOf(bytes, length), length, decoded), "snapshot " + n);
      assertArrayEquals(state, decoded, "snapshot " + n);
    }
  }

  @Test
  void theEndsOfAllRangesAreCoded() {
    int bodies = 8;
    TraceCodec encoder = new TraceCodec(bodies, 2, 30, 6);
    TraceCodec decoder = new TraceCodec(bodies, 2, 30, 6);
    int[] ends = {
      Quantizer.MAX_POSITION,
      Quantizer.MAX_POSITION,
      Quantizer.ANGLE_STEPS - 1,
      Trace.MAX_VELOCITY,
      Trace.MAX_VELOCITY,
      Trace.MAX_OMEGA
    };
    Random random = new Random(SEED);
    int[][] state = new int[6][bodies];
    int[][] decoded = new int[6][bodies];
    byte[] bytes = new byte[encoder.maxBytes()];
    for (int n = 0; n < 200; n++) {
      for (int f = 0; f < 6; f++) {
        for (int i = 0; i < bodies; i++) {
          int sign = random.nextInt(3) - 1;
          state[f][i] = f == 2 ? Math.abs(sign) * ends[f] : sign * ends[f];
        }
      }
      int length = encoder.encode(state, bytes);
      assertTrue(decoder.decode(bytes, length, decoded));
      assertArrayEquals(state, decoded);
    }
    state[3][5] = Trace.MAX_VELOCITY + 1;
    assertThrows(IllegalArgumentException.class, () -> encoder.encode(state, bytes));
  }

  @Test
  void restIsNearlyFreeAndFreeFlightIsCheap() {
    int bodies = 300;
    TraceCodec encoder = new TraceCodec(bodies, 6, 60, 3);
    int[][] state = new int[3][bodies];
    byte[] bytes = new byte[encoder.maxBytes()];
    Random random = new Random(SEED);
    double[] vx = new double[bodies];
    for (int i = 0; i < bodies; i++) {
      state[0][i] = 1_000 * i;
      vx[i] = random.nextGaussian() * 30;
    }
    int rest = 0;
    for (int n = 0; n < 200; n++) {
      rest = encoder.encode(state, bytes);
    }
    assertTrue(rest <= 2, "rest=" + rest);
    int flight = 0;
    for (int n = 1; n < 300; n++) {
      for (int i = 0; i < bodies; i += 3) {
        state[0][i] = (int) Math.round(1_000 * i + n * vx[i]);
        state[1][i] = (int) Math.round(-0.7 * n * n);
      }
      flight = encoder.encode(state, bytes);
    }
    assertTrue(flight < 60, "100 bodies in flight: " + flight + " bytes");
  }

  @Test
  void hostileBytesAreAnsweredNotThrown() {
    Random random = new Random(SEED);
    int refused = 0;
    for (int round = 0; round < 60; round++) {
      int fields = round % 2 == 0 ? 3 : 6;
      TraceCodec encoder = new TraceCodec(20, 3, 60, fields);
      TraceCodec decoder = new TraceCodec(20, 3, 60, fields);
      Motion motion = new Motion(SEED + round, 20);
      int[][] state = new int[fields][20];
      int[][] decoded = new int[fields][20];
      byte[] bytes = new byte[encoder.maxBytes()];
      int good = random.nextInt(20);
      for (int n = 0; n < 60; n++) {
        motion.next(state);
        int length = encoder.encode(state, bytes);
        if (n >= good) {
          switch (random.nextInt(3)) {
            case 0 -> random.nextBytes(bytes);
            case 1 -> length = random.nextInt(length + 1);
            default -> bytes[random.nextInt(length + 1)] ^= (byte) (1 << random.nextInt(8));
          }
        }
        boolean ok = decoder.decode(bytes, length, decoded);
        if (!ok) {
          refused++;
          assertFalse(decoder.decode(bytes, length, decoded), "once lost, always lost");
          break;
        }
      }
    }
    assertTrue(refused > 50, "seed " + SEED + " refused=" + refused);
  }

  @Test
  void steadyCodingAllocatesNothing() {
    int bodies = 50;
    TraceCodec encoder = new TraceCodec(bodies, 4, 60, 6);
    TraceCodec decoder = new TraceCodec(bodies, 4, 60, 6);
    Motion motion = new Motion(SEED, bodies);
    int[][][] states = new int[400][6][bodies];
    for (int[][] state : states) {
      motion.next(state);
    }
    int[][] decoded = new int[6][bodies];
    byte[] bytes = new byte[encoder.maxBytes()];
    ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
    long before = 0;
    for (int n = 0; n < states.length; n++) {
      if (n == 100) {
        before = threads.getCurrentThreadAllocatedBytes();
      }
      int length = encoder.encode(states[n], bytes);
      if (!decoder.decode(bytes, length, decoded)) {
        throw new AssertionError("snapshot " + n);
      }
    }
    long allocated = threads.getCurrentThreadAllocatedBytes() - before;
    assertTrue(allocated < 300 * 8, "allocated=" + allocated);
  }

  @Test
  void wrongNumbersAreNamed() {
    assertProblem("bodies=0", () -> new TraceCodec(0, 6, 60, 3));
    assertProblem("lag=65", () -> new TraceCodec(1, 65, 60, 3));
    assertProblem("rate=0", () -> new TraceCodec(1, 6, 0, 3));
    assertProblem("fields=4", () -> new TraceCodec(1, 6, 60, 4));
    TraceCodec codec = new TraceCodec(1, 6, 60, 3);
    int[][] far = {{Quantizer.MAX_POSITION + 1}, {0}, {0}};
    assertProblem("value=" + far[0][0], () -> codec.encode(far, new byte[1_000]));
    int[][] near = {{1_234_567}, {7_654_321}, {77}};
    assertProblem("out.length=1", () -> codec.encode(near, new byte[1]));
  }

  private static void assertProblem(String part, Runnable what) {
    String message = assertThrows(IllegalArgumentException.class, what::run).getMessage();
    assertTrue(message.contains(part), message);
    assertEquals(message.strip(), message);
  }
}
