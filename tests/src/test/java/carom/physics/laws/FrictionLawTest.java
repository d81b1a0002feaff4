package carom.physics.laws;

import static org.junit.jupiter.api.Assertions.assertEquals;

import carom.physics.Body;
import carom.physics.BodyDef;
import carom.physics.BodyType;
import carom.physics.Material;
import carom.physics.World;
import carom.physics.WorldDef;
import carom.physics.geometry.Box;
import carom.physics.geometry.Circle;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/**
 * The law of rolling friction: a plank on two rollers that turn inwards swings with the amplitude
 * that it began with, because friction that is constant takes as much as it gives.
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
      float radius = (float) random.nextDouble(.15, .5);
      float spin = (float) random.nextDouble(4, 12) / radius;
      float start = .3f * apart;
      World<String> w = new World<>(new WorldDef());
      Material m = Material.DEFAULT.withFriction(friction);
      for (int side = -1; side <= 1; side += 2) {
        BodyDef roller = new BodyDef(BodyType.KINEMATIC).shape(new Circle(radius), m);
        w.createBody(roller.position(side * apart, 0).angularVelocity(side * spin), "roller");
      }
      BodyDef plank = new BodyDef(BodyType.DYNAMIC).shape(new Box(3 * apart, .05f), m);
      Body<String> body = w.createBody(plank.position(start, radius + .05f), "plank");
      double last = 0;
      for (int tick = 0; tick < 3000; tick++) {
        w.step(DT);
        last = tick < 2400 ? 0 : Math.max(last, Math.abs(body.x()));
      }
      assertEquals(start, last, .03 * start, "seed=" + seed + " friction=" + friction);
    }
  }
}
