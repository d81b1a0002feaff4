package carom.server.session;

import static carom.server.session.InputBuffer.Arrival.ACCEPTED;
import static carom.server.session.InputBuffer.Arrival.DUPLICATE;
import static carom.server.session.InputBuffer.Arrival.TOO_EARLY;
import static carom.server.session.InputBuffer.Arrival.TOO_LATE;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.HashMap;
import java.util.Map;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class InputBufferTest {
  private final InputBuffer buffer = new InputBuffer(32, 3);

  /** The buffer has consumed up to tick 100 and holds an input for 105. */
  @ParameterizedTest
  @CsvSource({
    "101, ACCEPTED",
    "104, ACCEPTED",
    "105, DUPLICATE",
    "106, ACCEPTED",
    "132, ACCEPTED",
    "133, TOO_EARLY",
    "100000, TOO_EARLY",
    "2147483647, TOO_EARLY",
    "100, DUPLICATE",
    "98, TOO_LATE",
    "36, TOO_LATE",
    "-1, TOO_LATE",
    "-2147483500, TOO_LATE",
  })
  void acceptsExactlyTheWindow(int tick, InputBuffer.Arrival expected) {
    buffer.reset(99);
    buffer.offer(100, 7);
    buffer.consume(100);
    buffer.offer(105, 1);
    assertEquals(expected, buffer.offer(tick, 2));
  }

  @Test
  void showsWhatWaitsAndNothingElse() {
    buffer.reset(99);
    buffer.offer(101, 5);
    buffer.hold(101, 5, 9);
    assertFalse(buffer.isWaiting(100));
    assertTrue(buffer.isWaiting(101));
    assertEquals(5, buffer.waiting(101));
    assertFalse(buffer.isWaiting(102), "what is only said to hold may still change");
    assertFalse(buffer.isWaiting(101 + 64), "another use of the same place");
    buffer.consume(100);
    buffer.consume(101);
    assertFalse(buffer.isWaiting(101));
  }

  @Test
  void eachTickConsumesItsOwnInputOnce() {
    for (int tick = 5; tick >= 1; tick--) { // any order of arrival
      assertEquals(ACCEPTED, buffer.offer(tick, tick * 10L));
      assertEquals(DUPLICATE, buffer.offer(tick, 999));
    }
    for (int tick = 1; tick <= 5; tick++) {
      assertEquals(tick * 10L, buffer.consume(tick));
      assertFalse(buffer.lastWasMissing());
      assertEquals(DUPLICATE, buffer.offer(tick, 999));
    }
    assertEquals(0, buffer.missing());
    assertEquals(0, buffer.tooLate());
  }

  @Test
  void missingInputRepeatsTheLastThenTurnsNeutral() {
    buffer.offer(1, 42);
    assertEquals(42, buffer.consume(1));
    assertEquals(42, buffer.consume(2));
    assertTrue(buffer.lastWasMissing());
    assertEquals(42, buffer.consume(3));
    assertEquals(42, buffer.consume(4));
    assertEquals(0, buffer.consume(5));
    assertEquals(0, buffer.consume(6));
    assertEquals(5, buffer.missing());
    buffer.offer(7, 43);
    assertEquals(43, buffer.consume(7));
    assertEquals(43, buffer.consume(8));
  }

  @Test
  void aLateInputIsRepeatedFromThenOn() {
    buffer.offer(1, 42);
    buffer.consume(1);
    buffer.consume(2);
    assertEquals(TOO_LATE, buffer.offer(2, 43));
    assertEquals(43, buffer.consume(3), "the newest says more than the one before");
    buffer.offer(3, 44);
    buffer.hold(3, 44, 4);
    for (int tick = 4; tick <= 7; tick++) {
      assertEquals(44, buffer.consume(tick));
      assertTrue(buffer.lastWasHeld());
    }
    for (int tick = 8; tick <= 10; tick++) {
      assertEquals(44, buffer.consume(tick), "missing from the end of the hold on");
      assertTrue(buffer.lastWasMissing());
    }
    assertEquals(0, buffer.consume(11));
  }

  @Test
  void nothingIsMissedBeforeTheFirstInput() {
    buffer.consume(1);
    buffer.consume(2);
    assertEquals(0, buffer.missing());
    assertEquals(0, buffer.marginTicks());
  }

  @Test
  void lateInputCountsOncePerTickAndShowsInTheMargin() {
    buffer.offer(1, 1);
    for (int tick = 1; tick <= 10; tick++) {
      buffer.consume(tick);
    }
    assertEquals(-9, buffer.marginTicks());
    assertEquals(TOO_LATE, buffer.offer(8, 1));
    assertEquals(DUPLICATE, buffer.offer(8, 1));
    assertEquals(-2, buffer.marginTicks());
    assertEquals(1, buffer.tooLate());
  }

  @Test
  void marginIsHowFarTheNewestInputIsAhead() {
    buffer.offer(1, 0);
    buffer.offer(4, 0);
    buffer.offer(2, 0);
    assertEquals(4, buffer.marginTicks());
    buffer.consume(1);
    assertEquals(3, buffer.marginTicks());
  }

  @Test
  void clientThatIsTooEarlyLearnsThatItIsTooEarly() {
    for (int tick = 1; tick <= 20; tick++) {
      assertEquals(TOO_EARLY, buffer.offer(tick + 50, 0));
      buffer.consume(tick);
    }
    assertTrue(buffer.marginTicks() > 25, "margin=" + buffer.marginTicks());
    assertEquals(20, buffer.tooEarly());
  }

  @Test
  void resetForgetsInputsAndKeepsCounters() {
    buffer.offer(1, 5);
    buffer.offer(2, 6);
    buffer.consume(1);
    buffer.reset(1);
    assertEquals(0, buffer.consume(2));
    assertEquals(0, buffer.marginTicks());
    assertEquals(2, buffer.consumed());
  }

  @Test
  void ticksAreConsumedInOrderOnly() {
    assertThrows(IllegalStateException.class, () -> buffer.consume(2));
    buffer.consume(1);
    assertThrows(IllegalStateException.class, () -> buffer.consume(1));
  }

  @Test
  void worksAcrossTheWrapOfTheTick() {
    buffer.reset(Integer.MAX_VALUE - 1);
    assertEquals(ACCEPTED, buffer.offer(Integer.MIN_VALUE + 3, 4));
    assertEquals(ACCEPTED, buffer.offer(Integer.MAX_VALUE, 1));
    assertEquals(1, buffer.consume(Integer.MAX_VALUE));
    assertEquals(1, buffer.consume(Integer.MIN_VALUE));
    assertEquals(3, buffer.marginTicks());
  }

  @Test
  void behavesLikeAnObviousModelUnderRandomTraffic() {
    long seed = Long.getLong("carom.seed", 7);
    Random random = new Random(seed);
    Map<Integer, Long> model = new HashMap<>();
    long expectedMissing = 0;
    boolean any = false;
    for (int tick = 1; tick <= 5_000; tick++) {
      for (int n = random.nextInt(4); n > 0; n--) {
        int offered = tick - 8 + random.nextInt(60);
        long value = random.nextInt(1_000);
        if (buffer.offer(offered, value) == ACCEPTED) {
          assertTrue(offered >= tick && offered <= tick + 31, "seed=" + seed);
          assertFalse(model.containsKey(offered), "seed=" + seed);
          model.put(offered, value);
        }
        any = true;
      }
      long got = buffer.consume(tick);
      if (model.containsKey(tick)) {
        assertEquals(model.get(tick), got, "seed=" + seed + " tick=" + tick);
      } else {
        expectedMissing += any ? 1 : 0;
      }
    }
    assertEquals(expectedMissing, buffer.missing(), "seed=" + seed);
  }

  @Test
  void whatHoldsIsNeitherMissingNorFading() {
    buffer.offer(1, 77);
    buffer.hold(1, 77, 20);
    for (int tick = 1; tick <= 21; tick++) {
      assertEquals(77, buffer.consume(tick));
      assertFalse(buffer.lastWasMissing(), "tick=" + tick);
      assertEquals(tick > 1, buffer.lastWasHeld(), "tick=" + tick);
    }
    assertEquals(0, buffer.missing());
    assertEquals(0, buffer.arrivalMarginTicks(), "it came right for tick 1");
    buffer.consume(22);
    assertTrue(buffer.lastWasMissing());
    assertFalse(buffer.lastWasHeld());
  }

  @Test
  void aNewerInputEndsWhatHolds() {
    buffer.offer(1, 77);
    buffer.hold(1, 77, 20);
    buffer.consume(1);
    assertEquals(77, buffer.consume(2));
    buffer.offer(4, 5);
    buffer.hold(1, 77, 20); // overtaken: says nothing any more
    buffer.consume(3);
    assertTrue(buffer.lastWasMissing(), "nobody said that it holds until the newer one");
    assertEquals(5, buffer.consume(4));
    buffer.consume(5);
    assertTrue(buffer.lastWasMissing());
  }

  @Test
  void whatCameAfterItsTickIsComparedWithWhatHeld() {
    buffer.offer(1, 77);
    buffer.hold(1, 77, 20);
    for (int tick = 1; tick <= 3; tick++) {
      buffer.consume(tick);
    }
    assertEquals(InputBuffer.Arrival.CONFIRMED, buffer.offer(2, 77));
    assertEquals(DUPLICATE, buffer.offer(2, 77));
    assertEquals(0, buffer.missing());
    assertEquals(TOO_LATE, buffer.offer(3, 78));
    assertEquals(DUPLICATE, buffer.offer(3, 78));
    assertEquals(1, buffer.missing(), "the server had to do without it");
    assertEquals(1, buffer.tooLate());
  }

  /** Whatever is offered and said to hold in any order, each tick consumes what a model says. */
  @Test
  void holdsAsAModelDoes() {
    long seed = Long.getLong("carom.seed", 7);
    Random random = new Random(seed);
    for (int round = 0; round < 300; round++) {
      buffer.reset(0);
      Map<Integer, Long> known = new HashMap<>();
      int newest = 0;
      int until = 0;
      long held = 0;
      for (int tick = 1; tick <= 80; tick++) {
        for (int i = random.nextInt(3); i > 0; i--) {
          int at = Math.max(1, tick - 4 + random.nextInt(12));
          long input = 1L + random.nextInt(3);
          int ticks = random.nextInt(3) * random.nextInt(30);
          buffer.offer(at, input);
          if (at >= tick) {
            known.putIfAbsent(at, input);
          }
          if (newest == 0 || at > newest) {
            newest = at;
            until = at;
          }
          buffer.hold(at, input, ticks);
          if (at == newest) {
            until = at + ticks;
            held = input;
          }
        }
        long consumed = buffer.consume(tick);
        String about = "seed=" + seed + " round=" + round + " tick=" + tick;
        Long own = known.get(tick);
        boolean holds = own == null && newest != 0 && tick > newest && tick <= until;
        assertEquals(own == null && !holds, buffer.lastWasMissing(), about);
        assertEquals(holds, buffer.lastWasHeld(), about);
        if (own != null || holds) {
          assertEquals(own != null ? own : held, consumed, about);
        }
      }
    }
  }
}
