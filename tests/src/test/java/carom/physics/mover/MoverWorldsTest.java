package carom.physics.mover;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.physics.BodyDef;
import carom.physics.BodyType;
import carom.physics.World;
import carom.physics.WorldDef;
import carom.physics.collision.ClosestPoints;
import carom.physics.collision.Distance;
import carom.physics.geometry.Box;
import carom.physics.geometry.Capsule;
import carom.physics.geometry.Circle;
import carom.physics.geometry.Convex;
import carom.physics.geometry.Polygon;
import carom.physics.geometry.Shape;
import carom.physics.math.Aabb;
import carom.physics.math.Transform;
import java.lang.management.ManagementFactory;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** Movers in random worlds: they never end in overlap, never leave a room, and allocate nothing. */
final class MoverWorldsTest {
  private static final float DT = 1 / 60f;

  private static Shape random(SplittableRandom random) {
    float a = (float) (0.1 + 1.5 * random.nextDouble());
    float b = (float) (0.1 + 1.5 * random.nextDouble());
    return switch (random.nextInt(4)) {
      case 0 -> new Box(a, b);
      case 1 -> new Circle(a);
      case 2 -> Capsule.upright(2 * a + b, a);
      default -> Polygon.of(-a, -b, a, -b, 0, b);
    };
  }

  /** A closed room of 40 by 20 m with shapes in it. */
  private static World<String> room(SplittableRandom random) {
    World<String> world = new World<>(new WorldDef());
    BodyDef walls = new BodyDef(BodyType.STATIC);
    walls.shape(new Box(0.05f, 20, -20, 0)).shape(new Box(0.05f, 20, 20, 0));
    walls.shape(new Box(20, 0.05f, 0, -10)).shape(new Box(20, 0.05f, 0, 10));
    world.createBody(walls, "walls");
    for (int i = 0; i < 40; i++) {
      float x = (float) (38 * random.nextDouble() - 19);
      float y = (float) (18 * random.nextDouble() - 9);
      if (Math.hypot(x, y) > 3.5) {
        world.createBody(
            new BodyDef(BodyType.STATIC)
                .position(x, y)
                .angle((float) (6 * random.nextDouble()))
                .shape(random(random)),
            "rock");
      }
    }
    return world;
  }

  private static float gap(World<String> world, Mover<String> mover, float height, float radius) {
    Convex capsule = Capsule.upright(height, radius);
    Transform at = new Transform().set(mover.x(), mover.y(), 1, 0);
    Distance distance = new Distance();
    ClosestPoints points = new ClosestPoints();
    float[] least = {Float.POSITIVE_INFINITY};
    Aabb area = new Aabb();
    capsule.aabb(at, area);
    world
        .queries()
        .parts(
            area.grow(0.1f),
            null,
            (body, shape, part, pose) -> {
              least[0] = Math.min(least[0], distance.between(capsule, at, part, pose, points));
              return true;
            });
    return least[0];
  }

  @Test
  void moversInRandomWorldsNeverOverlapAndNeverPassAWall() {
    long seed = Long.getLong("carom.seed", System.nanoTime());
    System.out.println("MoverWorldsTest seed=" + seed);
    SplittableRandom random = new SplittableRandom(seed);
    for (int round = 0; round < 60; round++) {
      World<String> world = room(random);
      float radius = (float) (0.1 + 0.4 * random.nextDouble());
      float height = 2 * radius + 0.01f + (float) random.nextDouble();
      Mover<String> mover =
          new Mover<>(
              world,
              new MoverDef<String>(height, radius)
                  .stepHeight((float) random.nextDouble())
                  .snapDistance((float) random.nextDouble()));
      float most = random.nextInt(4) == 0 ? 100 : 12;
      float walk = 0;
      for (int i = 0; i < 300; i++) {
        walk = random.nextInt(10) == 0 ? (float) (2 * random.nextDouble() - 1) * most : walk;
        float vy = mover.isOnGround() ? 0 : mover.velocityY() - 10 * DT;
        vy = random.nextInt(20) == 0 ? (float) (2 * random.nextDouble() - 0.5f) * most : vy;
        mover.move(walk, vy, DT);
        String where =
            "seed=" + seed + " round " + round + " tick " + i + " at " + mover.x() + " "
                + mover.y();
        assertTrue(Math.abs(mover.x()) < 20 && Math.abs(mover.y()) < 10, where);
        assertTrue(gap(world, mover, height, radius) > 0, where);
      }
    }
  }

  @Test
  void movesAllocateNothing() {
    World<String> world = room(new SplittableRandom(1));
    Mover<String> mover = new Mover<>(world, new MoverDef<>(1.8f, 0.3f));
    com.sun.management.ThreadMXBean threads =
        (com.sun.management.ThreadMXBean) ManagementFactory.getThreadMXBean();
    run(mover, 3000);
    long before = threads.getCurrentThreadAllocatedBytes();
    run(mover, 3000);
    long bytes = threads.getCurrentThreadAllocatedBytes() - before;
    assertTrue(bytes < 2000, "bytes=" + bytes);
  }

  private static void run(Mover<String> mover, int ticks) {
    for (int i = 0; i < ticks; i++) {
      float walk = i / 200 % 2 == 0 ? 7 : -7;
      boolean jumps = mover.isOnGround() && i % 40 == 0;
      mover.move(walk, jumps ? 7 : mover.isOnGround() ? 0 : mover.velocityY() - 10 * DT, DT);
    }
  }

  @Test
  void equalMovesGiveEqualBitsWhateverElseIsInTheWorld() {
    long seed = Long.getLong("carom.seed", System.nanoTime());
    System.out.println("MoverWorldsTest seed=" + seed);
    World<String> one = room(new SplittableRandom(seed));
    World<String> two = room(new SplittableRandom(seed));
    two.createBody(new BodyDef(BodyType.STATIC).position(500, 0).shape(new Box(1, 1)), "far away");
    Mover<String> a = new Mover<>(one, new MoverDef<>(1.8f, 0.3f));
    Mover<String> b = new Mover<>(two, new MoverDef<>(1.8f, 0.3f));
    for (int i = 0; i < 600; i++) {
      float walk = i / 50 % 2 == 0 ? 7 : -7;
      a.move(walk, a.isOnGround() ? 5 : a.velocityY() - 10 * DT, DT);
      b.move(walk, b.isOnGround() ? 5 : b.velocityY() - 10 * DT, DT);
      assertEquals(a.x(), b.x(), "seed=" + seed + " tick " + i);
      assertEquals(a.y(), b.y(), "seed=" + seed + " tick " + i);
    }
  }
}
