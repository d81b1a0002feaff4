package carom.physics.truth;

import static carom.physics.truth.Lab.DT;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.physics.Body;
import carom.physics.BodyDef;
import carom.physics.World;
import carom.physics.math.Limits;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.function.Executable;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * How true motion is far from the origin, as {@code docs/engine/PHYSICS.md} states it. A step adds
 * to a coordinate what its float can hold, always rounded the same way.
 */
final class FarMotionTest {
  @ParameterizedTest
  @CsvSource({
    "1000, 0.1, .015",
    "4000, 0.1, .03",
    "10000, 0.1, .18",
    "10000, 1, .005",
    "32000, 0.1, .18",
    "32000, 1, .06",
    "32000, 10, .02",
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

  @Test
  void aBodyIsNotPutWhereSlowMotionWouldStandStill() {
    World<String> w = Lab.space();
    Body<String> b = Lab.disc(w, Limits.MAX_POSITION, -Limits.MAX_POSITION, .5, Lab.ICE);
    for (float far : new float[] {Math.nextUp(Limits.MAX_POSITION), 1e5f, -1e5f, Float.NaN}) {
      List<Executable> ways =
          List.of(
              () -> Lab.disc(w, far, 0, .5, Lab.ICE),
              () -> new BodyDef().position(0, far),
              () -> b.setPose(far, 0, 0),
              () -> b.setCenterPose(0, far, 1, 0));
      for (Executable way : ways) {
        String message = assertThrows(IllegalArgumentException.class, way).getMessage();
        assertTrue(message.contains("=" + far + " is outside -32768..32768 m"), message);
      }
    }
    assertEquals(1, w.bodyCount());
    assertEquals(Limits.MAX_POSITION, b.x());
  }

  @Test
  void aBodyThatReachesTheEdgeStopsThereAndComesBack() {
    World<String> w = Lab.space();
    Body<String> b = Lab.disc(w, 32_000, 0, .5, Lab.ICE);
    b.setVelocity(500, 3);
    for (int i = 0; i < 180; i++) {
      w.step(DT);
    }
    assertEquals(Limits.MAX_POSITION, b.x());
    assertEquals(0, b.velocityX());
    b.setVelocity(-60, 0);
    for (int i = 0; i < 60; i++) {
      w.step(DT);
    }
    assertEquals(Limits.MAX_POSITION - 60, b.x(), .5);
  }
}
