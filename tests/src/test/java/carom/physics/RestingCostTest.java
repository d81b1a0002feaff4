package carom.physics;

import static carom.physics.Scenes.DT;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.physics.dynamics.body.BodyStore;
import carom.physics.geometry.Box;
import carom.physics.geometry.Circle;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Nothing in a step touches a body that sleeps or is static, unless something awake is near. */
class RestingCostTest {
  private static final int AWAKE = 20;

  /** Discs that fly and meet in a closed space, and far from them boxes that stand and sleep. */
  private static World<String> world(int resting) {
    World<String> w = new World<>(new WorldDef().withGravity(0, 0));
    for (int i = 0; i < 4; i++) {
      float x = i < 2 ? (i == 0 ? -11 : 11) : 0;
      float y = i < 2 ? 0 : i == 2 ? -11 : 11;
      w.createBody(
          new BodyDef(BodyType.STATIC)
              .shape(new Box(i < 2 ? 1 : 11, i < 2 ? 11 : 1))
              .position(x, y),
          "wall");
    }
    Material elastic = Material.DEFAULT.withRestitution(1).withFriction(0);
    for (int i = 0; i < AWAKE; i++) {
      Body<String> disc =
          w.createBody(
              new BodyDef(BodyType.DYNAMIC)
                  .shape(new Circle(0.4f), elastic)
                  .position(-7 + 3 * (i % 5), -6 + 3 * (i / 5)),
              "disc");
      disc.setVelocity(5 - i % 7, 3 - i % 5);
    }
    for (int i = 0; i < resting; i++) {
      float x = 100 + i % 300 * 2;
      float y = i / 300 * 2;
      BodyType type = i % 5 == 0 ? BodyType.STATIC : BodyType.DYNAMIC;
      w.createBody(
          new BodyDef(type).shape(new Box(0.5f, 0.5f)).position(x, y).awake(false), "rests");
    }
    return w;
  }

  /** What rests is overwritten by numbers that would spoil whatever they went into. */
  @Test
  void whatRestsIsNeitherReadNorWritten() {
    int resting = 3000;
    World<String> poisoned = world(resting);
    World<String> clean = world(resting);
    for (int i = 0; i < 10; i++) {
      poisoned.step(DT);
      clean.step(DT);
    }
    BodyStore bodies = poisoned.dynamics().bodies();
    List<float[]> fields =
        List.of(
            bodies.x,
            bodies.y,
            bodies.cos,
            bodies.sin,
            bodies.vx,
            bodies.vy,
            bodies.w,
            bodies.forceX,
            bodies.forceY,
            bodies.torque,
            bodies.impulseX,
            bodies.impulseY,
            bodies.impulseW,
            bodies.mass,
            bodies.invMass,
            bodies.inertia,
            bodies.invInertia,
            bodies.sleepTime,
            bodies.linearDamping,
            bodies.gravityScale);
    int from = 4 + AWAKE;
    float poison = Float.intBitsToFloat(0x7fc0dead);
    for (float[] field : fields) {
      for (int body = from; body < from + resting; body++) {
        field[body] = poison;
      }
    }
    for (int i = 0; i < 200; i++) {
      poisoned.step(DT);
      clean.step(DT);
    }
    assertEquals(AWAKE, clean.profile().awake());
    assertTrue(clean.profile().pairs() > 0);
    for (int i = 0; i < from; i++) {
      assertEquals(clean.body(i).x(), poisoned.body(i).x(), "body " + i);
      assertEquals(clean.body(i).y(), poisoned.body(i).y(), "body " + i);
      assertEquals(clean.body(i).velocityX(), poisoned.body(i).velocityX(), "body " + i);
      assertFalse(Float.isNaN(poisoned.body(i).x()), "body " + i);
    }
    for (float[] field : fields) {
      for (int body = from; body < from + resting; body++) {
        assertEquals(0x7fc0dead, Float.floatToRawIntBits(field[body]), "body " + body);
      }
    }
  }

  @Test
  void aHundredThousandThatRestAreAsMuchWorkAsAHundred() {
    World<String> few = world(100);
    World<String> many = world(100_000);
    for (int i = 0; i < 60; i++) {
      few.step(DT);
      many.step(DT);
      StepProfile a = few.profile();
      StepProfile b = many.profile();
      assertEquals(a.awake(), b.awake());
      assertEquals(a.pairs(), b.pairs());
      assertEquals(a.contacts(), b.contacts());
    }
  }
}
