package carom.physics.laws;

import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.physics.Body;
import carom.physics.BodyDef;
import carom.physics.BodyType;
import carom.physics.JointDef;
import carom.physics.MotionLocks;
import carom.physics.World;
import carom.physics.WorldDef;
import carom.physics.geometry.Box;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Goal: bodies whose motion is locked along axes get no energy from contacts that squeeze them, nor
 * from hinges between them. Method: heaps of boxes that overlap a little, some locked, some fixed,
 * a little tilted. Falling for a second gives 10 m/s. When contacts took a locked body for a free
 * one, a fourth of the heaps shot past 30 m/s and one in 18 past 500; when joints did, one in 14 of
 * the heaps with hinges and one in 26.
 */
class LockedJamTest {
  private static final int HEAPS = Integer.getInteger("carom.rounds", 300);
  private static final double MOST = 60;

  private static Body<String> box(World<String> world, Random random, int place) {
    int column = place % 3;
    int row = place / 3;
    BodyType type = BodyType.DYNAMIC;
    if (random.nextInt(4) == 0) {
      type = random.nextBoolean() ? BodyType.KINEMATIC : BodyType.STATIC;
    }
    BodyDef def =
        new BodyDef(type)
            .position(column - 1 + near(random, 0.02f), 0.5f * row + near(random, 0.02f))
            .angle(near(random, 0.04f))
            .shape(new Box(0.5f, 0.25f));
    if (type == BodyType.DYNAMIC && random.nextBoolean()) {
      def.motionLocks(
          new MotionLocks(random.nextBoolean(), random.nextBoolean(), random.nextBoolean()));
    }
    return world.createBody(def, "box");
  }

  private static float near(Random random, float most) {
    return (2 * random.nextFloat() - 1) * most;
  }

  @ParameterizedTest
  @ValueSource(ints = {0, 2})
  void lockedBodiesInAHeapGetNoFasterThanFreeOnes(int hinges) {
    long first = Long.getLong("carom.seed", 1);
    for (long seed = first; seed < first + HEAPS; seed++) {
      Random random = new Random(seed);
      World<String> world = new World<>(new WorldDef());
      List<Body<String>> boxes = new ArrayList<>();
      for (int count = 4 + random.nextInt(8); boxes.size() < count; ) {
        boxes.add(box(world, random, boxes.size()));
      }
      for (int i = 0; i < hinges; i++) {
        Body<String> a = boxes.get(random.nextInt(boxes.size()));
        Body<String> b = boxes.get(random.nextInt(boxes.size()));
        if (a != b) {
          world.createJoint(JointDef.revolute(a, b, a.x(), a.y()));
        }
      }
      for (int step = 0; step < 60; step++) {
        world.step(1 / 60f);
        for (Body<String> box : boxes) {
          double speed = Math.hypot(box.velocityX(), box.velocityY());
          assertTrue(speed < MOST, "seed=" + seed + " step=" + step + " speed=" + speed);
        }
      }
    }
  }
}
