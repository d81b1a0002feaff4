package carom.physics.laws;

import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.physics.Body;
import carom.physics.BodyDef;
import carom.physics.BodyType;
import carom.physics.Filter;
import carom.physics.JointDef;
import carom.physics.Material;
import carom.physics.World;
import carom.physics.WorldDef;
import carom.physics.geometry.Box;
import carom.physics.geometry.Chain;
import carom.physics.geometry.Circle;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * The law of energy where groups of joints touch each other, free bodies and the ground: all of
 * them together have never more than was put in, by 1 % and 1 mJ.
 */
final class TouchLawTest {
  private static final float GRAVITY = 10;
  private static final float[] RATES = {30, 60, 60, 120};
  private static final int[] SUBSTEPS = {2, 4, 4, 16};

  /** A row of discs that touch, each on a joint of another kind, above the ground: 200 times. */
  @ParameterizedTest
  @CsvSource({"6, -0.34", "7, -0.30", "7, -0.34"})
  void groupsThatTouchGiveWhatTheyHave(int discs, float ground) {
    for (float speed : new float[] {0.5f, 1.2f, 4}) {
      World<String> w = new World<>(new WorldDef().withGravity(0, -GRAVITY).withSleeping(false));
      w.createBody(new BodyDef().shape(Chain.open(14, ground, -14, ground)), "ground");
      for (int i = 0; i < discs; i++) {
        Body<String> b = disc(w, 0.4858f * i, 0, 0.2424f, new Material(0.4f, 0.5f, 0), apart(0));
        float x = b.x();
        float y = 1.4544f;
        w.createJoint(
            switch (i) {
              case 0 -> JointDef.revolute(null, b, x, y).spring(1.2f, 2);
              case 1 -> JointDef.distance(null, b, x, y, x + 0.035f, 0.014f);
              case 3 -> JointDef.revolute(null, b, x, y).spring(54, 2);
              case 4 -> JointDef.weld(null, b, x, y).spring(1.448f, 0.1f);
              default -> JointDef.rope(null, b, x, y, x + 0.02f, 0, 1.814f);
            });
        b.setVelocity(i == 0 ? -speed : 0, 0);
      }
      assertPassive(w, 60, -ground, "discs=" + discs + " speed=" + speed);
    }
  }

  /** Wheels that continuous collision puts back stretch their springs: the car pays for it. */
  @Test
  void carsThatFallFastGainNothing() {
    for (int seed : new int[] {1, 2, 3, 514, 668, 913}) {
      SplittableRandom random = new SplittableRandom(seed);
      World<String> w = world(random);
      float size = (float) random.nextDouble(.2, 2);
      Material m = new Material(1, (float) random.nextDouble(), 0);
      w.createBody(new BodyDef().position(0, -5).shape(new Box(500, 1), m), "ground");
      for (int i = -3; i < 3; i++) {
        BodyDef tile = new BodyDef().position(3 * i * size, -size);
        w.createBody(tile.shape(new Box(1.5f * size, size), m), "tile");
      }
      Filter apart = apart(1);
      float y = size * (1 + random.nextInt(9));
      BodyDef def =
          new BodyDef(BodyType.DYNAMIC).position(0, y).shape(new Box(size, .2f), m, apart);
      Body<String> car = w.createBody(def, "car");
      float speed = (float) (25 * random.nextDouble() * Math.sqrt(size));
      car.setVelocity((float) random.nextDouble(-5, 5), -speed);
      car.setAngularVelocity((float) random.nextDouble(-3, 3));
      int wheels = 2 + random.nextInt(3);
      for (int i = 0; i < wheels; i++) {
        float x = size * (1.8f * i / (wheels - 1) - .9f);
        Body<String> b = disc(w, x, y - .3f * size, .3f * size, m, apart);
        b.setVelocity(0, -speed);
        float hertz = (float) Math.pow(60, random.nextDouble());
        float axis = (float) random.nextDouble(-.2, .2);
        float damping = random.nextInt(3) * .2f;
        w.createJoint(JointDef.wheel(car, b, x, y - .3f * size, axis, 1).spring(hertz, damping));
      }
      assertPassive(w, RATES[random.nextInt(RATES.length)], y, "seed=" + seed);
    }
  }

  private static World<String> world(SplittableRandom random) {
    WorldDef def = new WorldDef().withGravity(0, -GRAVITY).withSleeping(false);
    return new World<>(def.withSubsteps(SUBSTEPS[random.nextInt(SUBSTEPS.length)]));
  }

  private static Filter apart(int group) {
    return Filter.DEFAULT.withGroup(-group);
  }

  private static Body<String> disc(
      World<String> w, float x, float y, float radius, Material m, Filter filter) {
    BodyDef def = new BodyDef(BodyType.DYNAMIC).position(x, y);
    return w.createBody(def.shape(new Circle(radius), m, filter), "disc");
  }

  private static void assertPassive(World<String> w, float rate, float height, String what) {
    double before = energy(w, 0);
    double most = 0.01 * energy(w, height) + 0.001;
    for (int i = 0; i < 3 * rate; i++) {
      w.step(1 / rate);
      double gained = energy(w, 0) - before;
      String told = what + " step=" + i + " gained=" + gained + " J, at most " + most;
      assertTrue(gained <= most, told);
    }
  }

  /** Returns the kinetic energy and, as all bodies can fall so far more, the potential one. */
  private static double energy(World<String> w, float fall) {
    double[] sum = new double[1];
    w.forEachBody(
        b -> {
          if (b.type() == BodyType.DYNAMIC) {
            double vx = b.velocityX();
            double vy = b.velocityY();
            double turn = b.angularVelocity();
            sum[0] += 0.5 * b.mass() * (vx * vx + vy * vy) + 0.5 * b.inertia() * turn * turn;
            sum[0] += (double) b.mass() * GRAVITY * (b.centerY() + fall);
          }
        });
    return sum[0];
  }
}
