package carom.net.codec;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.physics.math.Limits;
import java.util.Random;
import org.junit.jupiter.api.Test;

class QuantizerTest {

  @Test
  void everyStepComesBackToItself() {
    for (int steps = -Quantizer.MAX_POSITION; steps <= Quantizer.MAX_POSITION; steps += 4_097) {
      if (Math.abs(steps) <= 1 << 24) {
        assertEquals(steps, Quantizer.position(Quantizer.positionOf(steps)));
      }
    }
    for (int steps = 0; steps < Quantizer.ANGLE_STEPS; steps++) {
      assertEquals(steps, Quantizer.angle(Quantizer.angleOf(steps)));
    }
  }

  @Test
  void theErrorIsHalfAStep() {
    long seed = 99;
    Random random = new Random(seed);
    for (int i = 0; i < 10_000; i++) {
      float x = (random.nextFloat() - 0.5f) * 2_000;
      assertTrue(
          Math.abs(Quantizer.positionOf(Quantizer.position(x)) - x) <= 0.5 / 512 + 1e-4,
          "seed=" + seed + " x=" + x);
      float angle = (random.nextFloat() - 0.5f) * 100;
      double error =
          Math.IEEEremainder(Quantizer.angleOf(Quantizer.angle(angle)) - angle, 2 * Math.PI);
      assertTrue(Math.abs(error) <= Math.PI / 1024 + 1e-4, "seed=" + seed + " angle=" + angle);
    }
  }

  @Test
  void roundsHalvesUpLikeMathRound() {
    long seed = 5;
    Random random = new Random(seed);
    for (int i = 0; i < 200_000; i++) {
      float x = (random.nextInt(2_000_001) - 1_000_000) / 1_024f;
      x = i % 3 == 0 ? x : i % 3 == 1 ? Math.nextUp(x) : Math.nextDown(x);
      assertEquals(Math.round(x * 512.0), Quantizer.position(x), "seed=" + seed + " x=" + x);
      float tiny = Float.intBitsToFloat(random.nextInt());
      long rounded = Math.round(tiny * 512.0);
      long most = Quantizer.MAX_POSITION;
      assertEquals(Math.max(-most, Math.min(most, rounded)), Quantizer.position(tiny), "x=" + tiny);
    }
  }

  @Test
  void anAngleKnownAboutIsAStepOrUnknown() {
    int step = 1 << 16;
    assertEquals(0, Quantizer.angleOfTurn(0, 100));
    assertEquals(1, Quantizer.angleOfTurn(step, 100));
    assertEquals(1023, Quantizer.angleOfTurn(-step, 100));
    assertEquals(0, Quantizer.angleOfTurn(step / 2 - 101, 100));
    assertEquals(-1, Quantizer.angleOfTurn(step / 2 - 100, 100));
    assertEquals(-1, Quantizer.angleOfTurn(step / 2 + 100, 100));
    assertEquals(1, Quantizer.angleOfTurn(step / 2 + 101, 100));
    assertEquals(512, Quantizer.angleOfTurn(1 << 25, 100));
    assertEquals(512, Quantizer.angleOfTurn(-1 << 25, 100));
  }

  @Test
  void whatIsOutsideIsClampedAndNanIsZero() {
    assertEquals(Quantizer.MAX_POSITION, Quantizer.position(Float.POSITIVE_INFINITY));
    assertEquals(-Quantizer.MAX_POSITION, Quantizer.position(-1e30f));
    assertEquals(0, Quantizer.position(Float.NaN));
    assertEquals(0, Quantizer.angle(Float.NaN));
    assertEquals(0, Quantizer.angle(Float.NEGATIVE_INFINITY));
  }

  @Test
  void anglesWrapTheShortestWay() {
    assertEquals(-1, Quantizer.wrapAngle(1023));
    assertEquals(1, Quantizer.wrapAngle(-1023));
    assertEquals(-512, Quantizer.wrapAngle(512));
    assertEquals(511, Quantizer.wrapAngle(511));
    assertEquals((float) Math.PI, Quantizer.angleOf(512));
    assertEquals(1023, Quantizer.angle(-0.006f));
  }

  @Test
  void everyPlaceOfABodyHasAPositionOnTheWire() {
    float step = 1f / Quantizer.POSITION_STEPS;
    assertEquals(
        Limits.MAX_POSITION, Quantizer.MAX_POSITION / (double) Quantizer.POSITION_STEPS, step);
  }
}
