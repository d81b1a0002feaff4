package carom.net.codec;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import carom.physics.math.Trig;
import carom.physics.simd.VectorModule;
import carom.suite.Optimized;
import java.util.Random;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Numbers side by side give the bits that they give one after the other. */
@Optimized("compares vector kernels with scalar code")
class ColumnLanesTest {
  private static final int BATCHES = 3_000;

  private final long seed = System.nanoTime();
  private final Random random = new Random(seed);
  private final ColumnLanes lanes = ColumnLanes.FOUND;

  @BeforeEach
  void withTheVectorModule() {
    assumeTrue(VectorModule.describe().startsWith("vector kernels"));
    assertNotNull(lanes);
  }

  /** Of all sizes, halves and their neighbours among them, and what is no number. */
  private float number(int scale) {
    float half = (random.nextInt(1 << random.nextInt(1, 23)) + .5f) / scale;
    float any =
        switch (random.nextInt(8)) {
          case 0 -> half;
          case 1 -> Math.nextUp(half);
          case 2 -> Math.nextDown(half);
          case 3 -> random.nextInt(5_000);
          case 4 -> random.nextFloat();
          case 5 -> random.nextFloat() * Float.MIN_NORMAL;
          case 6 -> random.nextInt(40) > 0 ? 0 : Float.intBitsToFloat(random.nextInt());
          default -> random.nextFloat() * 4_096;
        };
    return random.nextBoolean() ? any : -any;
  }

  @Test
  void stepsAreThoseOfTheScalarCode() {
    int width = lanes.width();
    int[][] units = {
      {Quantizer.POSITION_STEPS, Quantizer.MAX_POSITION},
      {8, 1 << 14},
      {32, 1 << 15}
    };
    float[] from = new float[width];
    int[] expected = new int[width];
    int[] got = new int[width];
    int sure = 0;
    for (int batch = 0; batch < BATCHES; batch++) {
      int[] unit = units[batch % units.length];
      for (int i = 0; i < width; i++) {
        from[i] = number(unit[0]);
      }
      Quantizer.clampColumn(from, 0, width, unit[0], unit[1], expected);
      float most = Math.min(unit[1], 1 << 21);
      boolean small = lanes.round(from, 0, unit[0], most, got);
      boolean allSmall = true;
      for (int i = 0; i < width; i++) {
        allSmall &= Math.abs(from[i] * unit[0]) <= most;
        if (small) {
          assertEquals(expected[i], got[i], "seed=" + seed + " number=" + from[i]);
        }
      }
      assertEquals(allSmall, small, "seed=" + seed);
      sure += small ? 1 : 0;
    }
    assertTrue(sure > 0 && sure < BATCHES, "sure=" + sure + " seed=" + seed);
  }

  @Test
  void anglesAreExactWhereTheyAreSure() {
    int width = lanes.width();
    float[] cos = new float[width];
    float[] sin = new float[width];
    int[] got = new int[width];
    int uncertain = 0;
    for (int batch = 0; batch < BATCHES; batch++) {
      for (int i = 0; i < width; i++) {
        double angle = random.nextInt(2) == 0 ? random.nextInt(2048) * Math.PI / 1024 : 0;
        angle += (random.nextFloat() - .5f) * Math.pow(10, -random.nextInt(8));
        cos[i] = (float) Math.cos(angle);
        sin[i] = (float) Math.sin(angle);
      }
      lanes.turn(cos, sin, 0, Trig.ROUGH, got);
      for (int i = 0; i < width; i++) {
        int exact = Quantizer.angle(Trig.atan2(sin[i], cos[i]));
        if (got[i] < 0) {
          uncertain++;
        } else {
          assertEquals(exact, got[i], "seed=" + seed + " cos=" + cos[i] + " sin=" + sin[i]);
        }
      }
    }
    assertTrue(uncertain < BATCHES * width / 2, "uncertain=" + uncertain + " seed=" + seed);
  }

  @Test
  void directionsThatAreNoneAreAsInTheScalarCode() {
    int width = lanes.width();
    float[] odd = {0f, -0f, 1, -1, Float.NaN, Float.POSITIVE_INFINITY, Float.NEGATIVE_INFINITY};
    float[] cos = new float[width];
    float[] sin = new float[width];
    int[] got = new int[width];
    for (float x : odd) {
      for (float y : odd) {
        cos[3] = x;
        sin[3] = y;
        lanes.turn(cos, sin, 0, Trig.ROUGH, got);
        int expected = Quantizer.angleOfTurn(Trig.roughTurn(y, x), Trig.ROUGH);
        assertEquals(expected, got[3], "x=" + x + " y=" + y);
      }
    }
  }

  /** Whole columns, of which at first only a part goes through the kernels. */
  @Test
  void columnsAreThoseOfTheScalarCode() {
    int n = 5_003;
    float[] from = new float[n];
    int[] expected = new int[n];
    int[] got = new int[n];
    for (int round = 0; round < 20; round++) {
      for (int i = 0; i < n; i++) {
        from[i] = number(Quantizer.POSITION_STEPS);
        expected[i] = Quantizer.position(from[i]);
      }
      Quantizer.positions(from, n, got);
      for (int i = 0; i < n; i++) {
        assertEquals(expected[i], got[i], "seed=" + seed + " number=" + from[i]);
      }
    }
  }
}
