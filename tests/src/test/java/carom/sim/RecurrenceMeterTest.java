package carom.sim;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.sim.phase.Findings;
import carom.sim.phase.RecurrenceMeter;
import org.junit.jupiter.api.Test;

/** What a game does all the time is told once; what it does now and then isn't. */
final class RecurrenceMeterTest {
  @Test
  void everyTickIsRecurrentAfterTwentyAndToldOnce() {
    RecurrenceMeter meter = new RecurrenceMeter();
    int told = 0;
    for (int tick = 100; tick < 200; tick++) {
      told += meter.note(tick) ? 1 : 0;
      assertEquals(tick < 119 ? 0 : 1, told, "tick=" + tick);
    }
    assertEquals(100, meter.firstTick());
  }

  @Test
  void aSecondTimeInATickIsNoOther() {
    RecurrenceMeter meter = new RecurrenceMeter();
    for (int i = 0; i < 100; i++) {
      assertFalse(meter.note(7));
    }
  }

  @Test
  void everyFifthTickIsNone() {
    RecurrenceMeter meter = new RecurrenceMeter();
    for (int tick = 0; tick < 5_000; tick += 5) {
      assertFalse(meter.note(tick));
    }
  }

  @Test
  void aFindingIsKeptOnceAndThereIsAnEndToThem() {
    Findings findings = new Findings();
    findings.add("a", "text");
    findings.add("a", "another text");
    assertEquals(1, findings.count());
    assertEquals("text", findings.get(0));
    for (int i = 0; i < 100; i++) {
      findings.add("b" + i, "text " + i);
    }
    assertEquals(Findings.MOST, findings.count());
    assertTrue(!findings.isNew("c"));
  }
}
