package carom.physics.simd;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

/** Kernels are warmed up for an end, and for all that ask, whatever these have to do. */
class KernelWarmupTest {
  private static final int MOST_STEPS = 10_000;

  private static final class Counting extends VectorKernels {
    private int calls;

    @Override
    protected int warmUpSize() {
      return 3;
    }

    @Override
    protected void warmUp(float[] numbers) {
      assertEquals(3, numbers.length);
      for (float number : numbers) {
        assertEquals(1, number, "every call begins alike");
      }
      numbers[0] = Float.NaN;
      calls++;
    }
  }

  private final Counting kernels = new Counting();

  @Test
  void oneBlockPerStepWarmsAllKernelsUpInTheEnd() {
    int before = -1;
    int steps = 0;
    for (; kernels.calls != before; steps++) {
      before = kernels.calls;
      assertEquals(1, kernels.grant(1, 0));
      assertTrue(steps < MOST_STEPS, "calls=" + kernels.calls);
    }
    assertTrue(before > 10_000, "the compiler wants thousands, calls=" + before);
    assertEquals(500, kernels.grant(500, 9_000));
    assertEquals(before, kernels.calls);
  }

  @Test
  void realWorkAloneDoesNotEarnTrust() {
    for (int step = 0; step < 100; step++) {
      int granted = kernels.grant(3_000, 0);
      assertTrue(granted > 0 && granted < 100, "step=" + step + " granted=" + granted);
    }
  }

  @Test
  void firstCallsAreFewBecauseTheyAreSlow() {
    kernels.grant(10, 0);
    int first = kernels.calls;
    for (int step = 0; step < 200; step++) {
      kernels.grant(10, 0);
    }
    int before = kernels.calls;
    kernels.grant(10, 0);
    assertTrue(first > 0 && first * 4 < kernels.calls - before, "first=" + first);
  }

  @Test
  void largeWorldsWarmUpInFewerStepsAndSmallOnesGainByIt() {
    for (int step = 0; step < 100; step++) {
      kernels.grant(3_000, 48_000);
    }
    assertEquals(40, kernels.grant(40, 600));
  }

  @Test
  void untilAProgramTrustsThemOnlyItsOwnThreadIsGrantedWork() {
    boolean[] own = {false};
    int[] wanted = {0};
    kernels.waitForTrust(() -> own[0], () -> wanted[0]++);
    assertEquals(0, kernels.grant(4, 60));
    assertEquals(0, wanted[0], "a small step");
    assertEquals(0, kernels.grant(500, 9_000));
    assertEquals(1, wanted[0], "a large step");
    assertEquals(0, kernels.calls, "a world of others warms nothing up");
    own[0] = true;
    int granted = kernels.grant(500, 9_000);
    assertTrue(granted > 0 && granted < 100, "granted=" + granted);
    for (int step = 0; !kernels.isTrusted(); step++) {
      kernels.grant(500, 9_000);
      assertTrue(step < MOST_STEPS, "calls=" + kernels.calls);
    }
    assertEquals(500, kernels.grant(500, 9_000));
    own[0] = false;
    assertEquals(0, kernels.grant(500, 9_000), "until the program says so");
    kernels.trust();
    int before = kernels.calls;
    assertEquals(500, kernels.grant(500, 9_000));
    assertEquals(before, kernels.calls);
  }

  @Test
  void trustedKernelsDoNotWaitAgain() {
    kernels.trust();
    int[] wanted = {0};
    kernels.waitForTrust(() -> false, () -> wanted[0]++);
    assertEquals(1, wanted[0], "nothing is left to warm up");
    assertEquals(500, kernels.grant(500, 9_000));
  }
}
