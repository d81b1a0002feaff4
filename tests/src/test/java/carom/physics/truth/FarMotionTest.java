package carom.physics.truth;

import static carom.physics.truth.Lab.DT;
import static org.junit.jupiter.api.Assertions.assertEquals;

import carom.physics.Body;
import carom.physics.World;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * How true motion is far from the origin, as {@code docs/PHYSICS.md} states it. A step adds to a
 * coordinate what its float can hold, always rounded the same way.
 */
final class FarMotionTest {
  @ParameterizedTest
  @CsvSource({
    "1000, 0.1, .015",
    "4000, 0.1, .03",
    "10000, 0.1, .18",
    "10000, 1, .005",
    "32000, 0.1, .18",
    "100000, 1, .07",
    "100000, 10, .02",
  })
  void aBodyKeepsItsSpeedWithinWhatFloatsResolve(float x, float speed, double share) {
    World<String> w = Lab.space();
    Body<String> b = Lab.disc(w, x, 0, .5, Lab.ICE);
    b.setVelocity(speed, 0);
    for (int i = 0; i < 600; i++) {
      w.step(DT);
    }
    assertEquals(10 * speed, b.x() - x, share * 10 * speed);
  }
}
