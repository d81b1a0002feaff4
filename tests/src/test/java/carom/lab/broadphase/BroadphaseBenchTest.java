package carom.lab.broadphase;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.lab.broadphase.BroadphaseBench.Method;
import carom.lab.broadphase.BroadphaseBench.Row;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class BroadphaseBenchTest {
  private static final double SECONDS = 0.05;

  /** Few boxes are quick: the warm-up of 1,000 has more ticks than a row can hold. */
  @ParameterizedTest
  @EnumSource(Method.class)
  void ticksOfTheWarmUpDoNotCount(Method method) {
    int most = 2;
    Row row = BroadphaseBench.run(method, 50, false, SECONDS, () -> {}, most);
    assertTrue(row.ticks() >= 1 && row.ticks() <= most, row.toString());
    Row same = BroadphaseBench.run(Method.BRUTE_FORCE, 50, false, SECONDS, () -> {}, most);
    assertEquals(same.hash(), row.hash());
  }
}
