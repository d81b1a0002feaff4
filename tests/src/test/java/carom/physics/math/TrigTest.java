package carom.physics.math;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

final class TrigTest {
  @Test
  void sineAndCosineAreWithinTheirBoundOverADenseRange() {
    for (double d = -1000; d < 1000; d += 0.00173) {
      check((float) d);
    }
    for (int bits = 0; bits < Float.floatToIntBits(3e38f); bits += 4099) {
      check(Float.intBitsToFloat(bits));
      check(-Float.intBitsToFloat(bits));
    }
  }

  private static void check(float a) {
    float s = Trig.sin(a);
    float c = Trig.cos(a);
    assertTrue(Math.abs(s - StrictMath.sin(a)) <= 6e-8, () -> "sin a=" + a);
    assertTrue(Math.abs(c - StrictMath.cos(a)) <= 6e-8, () -> "cos a=" + a);
    assertEquals(1, (double) s * s + (double) c * c, 1.3e-7, () -> "unit length, a=" + a);
  }

  @Test
  void arcTangentIsWithinItsBoundInEveryDirectionAndScale() {
    for (int i = 0; i < 400_000; i++) {
      double angle = -Math.PI + 2 * Math.PI * i / 400_000;
      float scale = i % 3 == 0 ? 1 : i % 3 == 1 ? 1e-30f : 1e30f;
      float x = (float) (scale * StrictMath.cos(angle));
      float y = (float) (scale * StrictMath.sin(angle));
      assertEquals(StrictMath.atan2(y, x), Trig.atan2(y, x), 2.5e-7, () -> "y=" + y + " x=" + x);
    }
  }

  @Test
  void aRoughTurnIsWithinItsBoundInEveryDirectionAndScale() {
    for (int i = 0; i < 400_000; i++) {
      double angle = -Math.PI + 2 * Math.PI * i / 400_000;
      float scale = i % 3 == 0 ? 1 : i % 3 == 1 ? 1e-28f : 1e28f;
      float x = (float) (scale * StrictMath.cos(angle));
      float y = (float) (scale * StrictMath.sin(angle));
      double exact = StrictMath.atan2(y, x) / (2 * Math.PI) * Trig.TURN;
      double error = Math.IEEEremainder(Trig.roughTurn(y, x) - exact, Trig.TURN);
      assertTrue(Math.abs(error) <= Trig.ROUGH, () -> "y=" + y + " x=" + x + " error=" + error);
    }
    for (float a : new float[] {0f, -0f, 1, -1}) {
      for (float b : new float[] {0f, -0f, 1, -1}) {
        double exact = StrictMath.atan2(a, b) / (2 * Math.PI) * Trig.TURN;
        if (a != 0 || b != 0) {
          assertEquals(0, Math.IEEEremainder(Trig.roughTurn(a, b) - exact, Trig.TURN), Trig.ROUGH);
        }
      }
    }
    assertTrue(Math.abs(Trig.roughTurn(Float.NaN, 1)) <= Trig.TURN / 2);
  }

  @Test
  void specialArgumentsAnswerAsDocumented() {
    assertTrue(Float.isNaN(Trig.sin(Float.NaN)) && Float.isNaN(Trig.cos(Float.NaN)));
    assertTrue(Float.isNaN(Trig.sin(Float.POSITIVE_INFINITY)));
    assertTrue(Float.isNaN(Trig.cos(Float.NEGATIVE_INFINITY)));
    assertTrue(Float.isNaN(Trig.atan2(Float.NaN, 1)) && Float.isNaN(Trig.atan2(1, Float.NaN)));
    assertEquals(0f, Trig.sin(0));
    assertEquals(1f, Trig.cos(0));
    assertEquals(0f, Trig.sin(-0f));
    assertEquals(0f, Trig.atan2(0, 0));
    assertEquals(0f, Trig.atan2(-0f, -0f));
    assertEquals((float) Math.PI, Trig.atan2(-0f, -1));
    assertEquals(
        (float) (Math.PI / 4), Trig.atan2(Float.POSITIVE_INFINITY, Float.POSITIVE_INFINITY));
  }

  @Test
  void intervalsPartTheShortWay() {
    Interval a = new Interval(0, 2);
    assertEquals(-0.5f, a.mtv(new Interval(1.5f, 5)));
    assertEquals(0.5f, a.mtv(new Interval(-3, 0.5f)));
    assertEquals(1.5f, a.mtv(new Interval(-4, 1.5f)));
    assertEquals(0f, a.mtv(new Interval(2, 3)));
    assertEquals(1f, a.separation(new Interval(3, 4)));
    assertEquals(-1f, new Interval(-2, 2).mtv(new Interval(1, 9)));
    a.project(new float[] {1, -2, 3}, new float[] {0, 5, 1}, 3, 0, 1);
    assertEquals(0f, a.min);
    assertEquals(5f, a.max);
  }

  @Test
  void transformsGoThereAndBack() {
    Transform t = new Transform(3, -4, 0.7f);
    assertEquals(1.25f, t.localX(t.worldX(1.25f, 2), t.worldY(1.25f, 2)), 1e-6f);
    assertEquals(2f, t.localY(t.worldX(1.25f, 2), t.worldY(1.25f, 2)), 1e-6f);
    assertEquals(0.7f, t.angle(), 1e-6f);
  }
}
