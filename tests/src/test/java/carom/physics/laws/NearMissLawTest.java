package carom.physics.laws;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.physics.Body;
import carom.physics.BodyDef;
import carom.physics.BodyType;
import carom.physics.Collision;
import carom.physics.CollisionListener;
import carom.physics.Filter;
import carom.physics.Material;
import carom.physics.World;
import carom.physics.WorldDef;
import carom.physics.collision.ClosestPoints;
import carom.physics.collision.Distance;
import carom.physics.geometry.Convex;
import carom.physics.geometry.Shape;
import carom.physics.math.Transform;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/**
 * The law of near misses: a pair in free flight that misses by more than a tenth of a millimetre at
 * all times changes nothing. Both bodies go on as they do without each other, bit for bit, and
 * nothing is told.
 */
final class NearMissLawTest {
  private static final int[] RATES = {30, 60, 120};
  private static final int WORLDS = 4000;

  /** What counts as a miss, and as one near enough to be of interest, m. */
  private static final float MISS = 1.05e-4f;

  private static final float NEAR = .015f;

  private final Distance distance = new Distance();
  private final ClosestPoints closest = new ClosestPoints();

  private final Transform poseA = new Transform();
  private final Transform poseB = new Transform();

  /** A body at its start. */
  private record Start(
      BodyType type,
      Shape shape,
      float x,
      float y,
      float angle,
      float vx,
      float vy,
      float spin,
      boolean bullet) {
    Start at(double newX, double newY) {
      return new Start(type, shape, (float) newX, (float) newY, angle, vx, vy, spin, bullet);
    }

    BodyDef def(Filter filter) {
      return new BodyDef(type)
          .shape(shape, Material.DEFAULT, filter)
          .position(x, y)
          .angle(angle)
          .velocity(vx, vy)
          .angularVelocity(spin)
          .bullet(bullet);
    }
  }

  /** Two bodies that are about to pass each other. */
  private record Pair(WorldDef def, float dt, Start a, Start b) {
    World<String> world(Filter filter) {
      return world(def, filter);
    }

    /** Makes a world whose steps are as long as a substep of the others. */
    World<String> fine() {
      return world(def.withSubsteps(1), Filter.NOTHING);
    }

    private World<String> world(WorldDef settings, Filter filter) {
      World<String> w = new World<>(settings);
      w.createBody(a.def(filter), "a");
      w.createBody(b.def(filter), "b");
      return w;
    }
  }

  /** Counts what is told. */
  private static final class Counter implements CollisionListener<String> {
    private int told;

    @Override
    public void begin(Collision<String> c) {
      told++;
    }

    @Override
    public void hit(Collision<String> c) {
      told++;
    }
  }

  @Test
  void whatMissesChangesNothing() {
    int misses = 0;
    for (int seed = 0; seed < WORLDS; seed++) {
      SplittableRandom random = new SplittableRandom(seed);
      int ticks = 5 + random.nextInt(15);
      Pair pair = aim(draw(random), random, ticks);
      double least = leastDistance(pair, 2 * ticks + 1);
      if (least > MISS && least < NEAR) {
        misses++;
        check(pair, 2 * ticks, "seed=" + seed + " least=" + least + " " + pair);
      }
    }
    assertTrue(misses > WORLDS / 8, "misses=" + misses);
  }

  private static Pair draw(SplittableRandom random) {
    WorldDef def = new WorldDef().withSleeping(false).withSubsteps(1 << random.nextInt(4));
    def = random.nextBoolean() ? def : def.withGravity(0, 0);
    BodyType type = BodyType.values()[random.nextInt(3)];
    double speed = Math.pow(10, random.nextDouble(-1, 2.2));
    double way = random.nextDouble(2 * Math.PI);
    float vx = (float) (speed * Math.cos(way));
    float vy = (float) (speed * Math.sin(way));
    Shape shape = RandomShapes.draw(random, type == BodyType.DYNAMIC);
    boolean fixed = type == BodyType.STATIC;
    Start a =
        new Start(
            type,
            shape,
            0,
            0,
            in(random, 3),
            fixed ? 0 : in(random, 3),
            fixed ? 0 : in(random, 3),
            fixed ? 0 : in(random, 4),
            false);
    float spin = random.nextBoolean() ? 0 : in(random, 8);
    Start b =
        new Start(
            BodyType.DYNAMIC,
            RandomShapes.draw(random, true),
            0,
            0,
            in(random, 3),
            vx,
            vy,
            spin,
            random.nextBoolean());
    return new Pair(def, 1f / RATES[random.nextInt(RATES.length)], a, b);
  }

  private static float in(SplittableRandom random, double most) {
    return (float) random.nextDouble(-most, most);
  }

  /** Puts B where it will be a few millimetres from A after some ticks. */
  private Pair aim(Pair pair, SplittableRandom random, int ticks) {
    World<String> w = pair.world(Filter.NOTHING);
    for (int i = 0; i < ticks; i++) {
      w.step(pair.dt);
    }
    double angle =
        Math.atan2(
                w.body(1).velocityY() - w.body(0).velocityY(),
                w.body(1).velocityX() - w.body(0).velocityX())
            + .5 * Math.PI
            + random.nextDouble(-.1, .1);
    double gap = random.nextDouble(2e-4, 8e-3);
    Body<String> b = w.body(1);
    float movedX = b.x();
    float movedY = b.y();
    double away = 4;
    for (int i = 0; i < 30; i++) {
      b.setPose(
          (float) (w.body(0).x() + away * Math.cos(angle)),
          (float) (w.body(0).y() + away * Math.sin(angle)),
          b.angle());
      away -= distance(w.body(0), b) - gap;
    }
    return new Pair(pair.def, pair.dt, pair.a, pair.b.at(b.x() - movedX, b.y() - movedY));
  }

  private double distance(Body<String> a, Body<String> b) {
    poseA.set(a.x(), a.y(), a.cos(), a.sin());
    poseB.set(b.x(), b.y(), b.cos(), b.sin());
    return distance(a, b, poseA, poseB);
  }

  private double distance(Body<String> a, Body<String> b, Transform atA, Transform atB) {
    double least = Double.POSITIVE_INFINITY;
    for (Convex p : a.shape(0).parts()) {
      for (Convex q : b.shape(0).parts()) {
        least = Math.min(least, distance.between(p, atA, q, atB, closest));
      }
    }
    return least;
  }

  /** Returns how near the two come if they pass through each other, m. */
  private double leastDistance(Pair pair, int ticks) {
    World<String> w = pair.fine();
    Body<String> a = w.body(0);
    Body<String> b = w.body(1);
    double least = distance(a, b);
    int substeps = pair.def.substeps();
    for (int i = 0; i < ticks * substeps && least > MISS; i++) {
      Start fromA = here(a);
      Start fromB = here(b);
      w.step(pair.dt / substeps);
      double most = way(fromA, a) + way(fromB, b);
      // No point gets nearer faster than that, so nothing is skipped.
      for (double part = 0; part <= 1 && least > MISS; ) {
        between(fromA, a, (float) part, poseA);
        between(fromB, b, (float) part, poseB);
        double now = distance(a, b, poseA, poseB);
        least = Math.min(least, now);
        part += Math.max(now / (most + 1e-9), 1e-5);
      }
    }
    return least;
  }

  /** Returns how far any point of a body moved at most, m. */
  private static double way(Start from, Body<String> to) {
    double turn = Math.abs(Math.IEEEremainder(to.angle() - from.angle, 2 * Math.PI));
    return Math.hypot(to.x() - from.x, to.y() - from.y) + turn * to.shape(0).reach();
  }

  private static Start here(Body<String> b) {
    return new Start(b.type(), null, b.x(), b.y(), b.angle(), 0, 0, 0, false);
  }

  private static void between(Start from, Body<String> to, float part, Transform pose) {
    float turn = (float) Math.IEEEremainder(to.angle() - from.angle, 2 * Math.PI);
    float angle = from.angle + part * turn;
    pose.set(
        from.x + part * (to.x() - from.x),
        from.y + part * (to.y() - from.y),
        (float) Math.cos(angle),
        (float) Math.sin(angle));
  }

  private static void check(Pair pair, int ticks, String where) {
    World<String> both = pair.world(Filter.DEFAULT);
    World<String> alone = pair.world(Filter.NOTHING);
    Counter counter = new Counter();
    both.listener(counter);
    for (int i = 0; i < ticks; i++) {
      both.step(pair.dt);
      alone.step(pair.dt);
      for (int k = 0; k < 2; k++) {
        assertEquals(state(alone.body(k)), state(both.body(k)), where + " tick=" + i);
      }
    }
    assertEquals(0, counter.told, where);
  }

  private static String state(Body<String> b) {
    return b.x()
        + " "
        + b.y()
        + " "
        + b.angle()
        + " "
        + b.velocityX()
        + " "
        + b.velocityY()
        + " "
        + b.angularVelocity();
  }
}
