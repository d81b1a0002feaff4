package carom.physics.laws;

import static org.junit.jupiter.api.Assertions.assertEquals;

import carom.physics.Body;
import carom.physics.BodyDef;
import carom.physics.BodyType;
import carom.physics.Material;
import carom.physics.World;
import carom.physics.WorldDef;
import carom.physics.geometry.Box;
import carom.physics.geometry.Capsule;
import carom.physics.geometry.Circle;
import carom.physics.geometry.Polygon;
import carom.physics.geometry.Shape;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/**
 * The law of rolling friction: a plank, flat or rounded, on two rollers that turn inwards swings
 * with the amplitude that it began with, because friction that is constant takes as much as it
 * gives.
 */
final class FrictionLawTest {
  private static final float DT = 1 / 60f;
  private static final int WORLDS = 60;

  @Test
  void aPlankOnRollersKeepsItsAmplitude() {
    for (int seed = 0; seed < WORLDS; seed++) {
      SplittableRandom random = new SplittableRandom(seed);
      float friction = (float) random.nextDouble(.1, .5);
      float apart = (float) random.nextDouble(.8, 2);
      float speed = (float) random.nextDouble(4, 12);
      float start = .3f * apart;
      World<String> w = new World<>(new WorldDef().withSubsteps(seed % 3 == 0 ? 8 : 4));
      Material m = Material.DEFAULT.withFriction(friction);
      for (int side = -1; side <= 1; side += 2) {
        float radius = (float) random.nextDouble(.15, .5);
        BodyDef roller = new BodyDef(BodyType.KINEMATIC).shape(new Circle(radius), m);
        roller.position(side * apart, -radius).angularVelocity(side * speed / radius);
        w.createBody(roller, "roller");
      }
      float half = 3 * apart;
      Shape shape =
          switch (seed % 3) {
            case 0 -> new Box(half, .05f);
            case 1 -> new Capsule(-half, 0, half, 0, .05f);
            default -> Polygon.rounded(.02f, -half, -.03f, half, -.03f, half, .03f, -half, .03f);
          };
      BodyDef plank = new BodyDef(BodyType.DYNAMIC).shape(shape, m).position(start, .05f);
      Body<String> body = w.createBody(plank, "plank");
      double last = 0;
      for (int tick = 0; tick < 3000; tick++) {
        w.step(DT);
        last = tick < 2400 ? 0 : Math.max(last, Math.abs(body.x()));
      }
      assertEquals(start, last, .03 * start, "seed=" + seed + " friction=" + friction);
    }
  }
}
