package carom.physics.simd;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

/** Kernels are rehearsed for an end, and for all steps that ask, whatever these are of. */
class RehearsedLanesTest {
  private static final int MOST_STEPS = 10_000;

  private static final class Counting extends RehearsedLanes {
    private int rehearsals;

    Counting(LaneTrust trust) {
      super(trust);
    }

    @Override
    public int scratchSize() {
      return 1;
    }

    @Override
    public int rehearsalSize() {
      return 3;
    }

    @Override
    public void rehearse(float[] numbers) {
      assertEquals(3, numbers.length);
      for (float number : numbers) {
        assertEquals(1, number, "every rehearsal begins alike");
      }
      numbers[0] = Float.NaN;
      rehearsals++;
    }
  }

  @Test
  void oneBlockPerStepHasAllKernelsRehearsedInTheEnd() {
    Counting lanes = new Counting(new LaneTrust());
    int before = -1;
    int steps = 0;
    for (; lanes.rehearsals != before; steps++) {
      before = lanes.rehearsals;
      lanes.used(lanes.trusted(1, 0));
      assertTrue(steps < MOST_STEPS, "rehearsals=" + lanes.rehearsals);
    }
    assertTrue(before > 10_000, "the compiler wants thousands, rehearsals=" + before);
    assertEquals(500, lanes.trusted(500, 9_000));
    assertEquals(before, lanes.rehearsals);
  }

  @Test
  void blocksAloneDoNotEarnTrust() {
    Counting lanes = new Counting(new LaneTrust());
    for (int step = 0; step < 100; step++) {
      assertTrue(lanes.trusted(3_000, 0) < 100, "step=" + step);
      lanes.used(3_000);
    }
  }

  @Test
  void worldsShareTheirTrustAndLargeOnesAreQuicker() {
    LaneTrust trust = new LaneTrust();
    Counting small = new Counting(trust);
    Counting large = new Counting(trust);
    for (int step = 0; step < 400; step++) {
      large.used(large.trusted(3_000, 48_000));
    }
    assertEquals(40, small.trusted(40, 600));
    assertEquals(0, small.rehearsals);
  }
}
