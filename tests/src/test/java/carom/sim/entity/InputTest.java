package carom.sim.entity;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.physics.math.SimRandom;
import org.junit.jupiter.api.Test;

class InputTest {
  @Test
  void survivesPackingBitByBit() {
    SimRandom random = new SimRandom(1);
    for (int i = 0; i < 1000; i++) {
      Input in = new Input();
      in.buttons(random.nextInt(1 << 16))
          .move(random.between(-1.5f, 1.5f), random.between(-1.5f, 1.5f))
          .aim(random.between(-20, 20));
      Input out = new Input();
      out.unpack(in.pack());
      assertEquals(in, out, "seed 1, number " + i);
      assertEquals(in.moveX(), out.moveX());
      assertEquals(in.aim(), out.aim());
      assertEquals(0, in.pack() >>> Input.PACKED_BITS);
    }
  }

  @Test
  void anUnknownInputIsTheLastOneFading() {
    Input last = new Input().move(1, -0.5f).aim(2).hold(Input.JUMP, true);
    Input guess = new Input();
    float before = 1;
    for (int ticks = 0; ticks <= 30; ticks++) {
      guess.unpack(Input.faded(last.pack(), ticks, 30));
      assertTrue(guess.held(Input.JUMP));
      assertEquals(last.aim(), guess.aim());
      assertTrue(guess.moveX() <= before && guess.moveX() > 0, "ticks=" + ticks);
      assertEquals(-0.5f, guess.moveY() / guess.moveX(), ticks < 25 ? 0.1f : 0.5f);
      before = guess.moveX();
      if (ticks <= 10) {
        assertEquals(last, guess);
      }
    }
    assertTrue(before < 0.1f);
    assertEquals(0, Input.faded(last.pack(), 31, 30));
    assertEquals(last.pack(), Input.faded(last.pack(), 0, 0));
    assertEquals(0, Input.faded(last.pack(), 1, 0));
  }

  @Test
  void anyBitsAreALegalInput() {
    SimRandom random = new SimRandom(2);
    for (int i = 0; i < 1000; i++) {
      Input in = new Input();
      in.unpack(random.nextLong());
      assertTrue(Math.abs(in.moveX()) <= 1 && Math.abs(in.moveY()) <= 1);
      assertTrue(in.aim() >= 0 && in.aim() < 6.2832f);
      Input again = new Input();
      again.unpack(in.pack());
      assertEquals(in, again);
    }
  }

  @Test
  void wrongNumbersCountAsNothing() {
    Input in = new Input();
    in.move(Float.NaN, Float.POSITIVE_INFINITY).aim(Float.NaN);
    assertEquals(0, in.moveX());
    assertEquals(1, in.moveY());
    assertEquals(0, in.aim());
    assertEquals(0, in.aim(Float.NEGATIVE_INFINITY).aim());
  }

  @Test
  void aimWrapsAround() {
    float quarter = (float) Math.PI / 2;
    assertEquals(3 * quarter, new Input().aim(-quarter).aim(), 1e-4f);
    assertEquals(quarter, new Input().aim(5 * quarter).aim(), 1e-4f);
  }

  @Test
  void holdsAndReleasesSingleButtons() {
    Input in = new Input().hold(Input.JUMP, true).hold(Input.DOWN, true).hold(Input.JUMP, false);
    assertTrue(in.held(Input.DOWN));
    assertFalse(in.held(Input.JUMP));
    in.clear();
    assertEquals(0, in.pack());
  }

  @Test
  void tellsWhatWentDownAndUpSinceTheTickBefore() {
    Input in = new Input().hold(Input.JUMP, true);
    assertTrue(in.pressed(Input.JUMP));
    assertTrue(in.pressed(Input.JUMP | Input.UP));
    assertFalse(in.pressed(Input.UP));
    assertFalse(in.released(Input.JUMP));
    in.before(in.buttons());
    assertFalse(in.pressed(Input.JUMP));
    in.unpack(Input.UP);
    assertTrue(in.pressed(Input.UP));
    assertTrue(in.released(Input.JUMP));
    assertFalse(in.released(Input.UP));
    in.before(Input.UP | 1 << 20);
    assertEquals(Input.UP, in.before());
  }

  @Test
  void randomNumbersAreTheKnownSequenceAndEven() {
    SimRandom random = new SimRandom(1234567);
    assertEquals(6457827717110365317L, random.nextLong()); // published test vector of splitmix64
    assertEquals(3203168211198807973L, random.nextLong());
    int[] counts = new int[7];
    for (int i = 0; i < 70_000; i++) {
      counts[random.nextInt(7)]++;
      float f = random.nextFloat();
      assertTrue(f >= 0 && f < 1);
    }
    for (int count : counts) {
      assertEquals(10_000, count, 400);
    }
    assertThrows(IllegalArgumentException.class, () -> random.nextInt(0));
  }
}
