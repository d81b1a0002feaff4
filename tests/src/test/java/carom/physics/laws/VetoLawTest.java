package carom.physics.laws;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
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
import carom.physics.effects.OneWay;
import carom.physics.geometry.Box;
import carom.physics.geometry.Circle;
import carom.physics.geometry.Segment;
import carom.physics.geometry.Shape;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/**
 * The law of vetoes: what {@code preSolve} lets pass equals what isn't there, bit for bit, however
 * fast bodies are.
 */
final class VetoLawTest {
  private static final float DT = 1 / 60f;
  private static final int WORLDS = 500;
  private static final int TICKS = 40;
  private static final int GHOSTS = 8;
  private static final int MOVERS = 4;
  private static final String GHOST = "ghost";

  /** Refuses all contacts of ghosts, and counts them. */
  private static final class Refusal implements CollisionListener<String> {
    private int refused;
    private int swept;

    @Override
    public boolean preSolve(Collision<String> c) {
      c.setFriction(.5f); // does nothing in a swept question, and is allowed
      boolean passes = c.self().user().equals(GHOST) || c.other().user().equals(GHOST);
      refused += passes ? 1 : 0;
      swept += passes && c.isSwept() ? 1 : 0;
      return !passes;
    }
  }

  @Test
  void whatIsVetoedEqualsWhatIsNotThere() {
    int refused = 0;
    int swept = 0;
    for (int seed = 0; seed < WORLDS; seed++) {
      World<String> vetoed = world(new SplittableRandom(seed), Filter.DEFAULT);
      World<String> without = world(new SplittableRandom(seed), Filter.NOTHING);
      Refusal refusal = assertEqual(vetoed, without, TICKS, seed);
      refused += refusal.refused;
      swept += refusal.swept;
    }
    assertTrue(refused > 10 * WORLDS, "refused=" + refused);
    assertTrue(swept > WORLDS / 2, "swept=" + swept);
  }

  private static Refusal assertEqual(
      World<String> vetoed, World<String> without, int ticks, int seed) {
    Refusal refusal = new Refusal();
    vetoed.listener(refusal);
    without.listener(new Refusal());
    for (int tick = 0; tick < ticks; tick++) {
      vetoed.step(DT);
      without.step(DT);
      for (int i = 0; i < vetoed.slotCount(); i++) {
        String where = "seed=" + seed + " tick=" + tick + " body=" + i;
        assertEquals(state(without.body(i)), state(vetoed.body(i)), where);
      }
    }
    return refusal;
  }

  private static World<String> world(SplittableRandom random, Filter ofGhosts) {
    WorldDef def = new WorldDef().withSleeping(false);
    World<String> w = new World<>(random.nextBoolean() ? def : def.withGravity(0, 0));
    Material m = new Material(1, .4f, random.nextInt(3) * .5f);
    w.createBody(new BodyDef().shape(new Box(40, 1), m).position(0, -8), "floor");
    w.createBody(new BodyDef().shape(new Box(1, 40), m).position(25, 0), "wall");
    for (int i = 0; i < GHOSTS + MOVERS; i++) {
      boolean ghost = random.nextInt(GHOSTS + MOVERS) < GHOSTS;
      BodyType type = ghost ? BodyType.values()[random.nextInt(3)] : BodyType.DYNAMIC;
      Shape shape = RandomShapes.draw(random, type == BodyType.DYNAMIC);
      double speed = type == BodyType.STATIC ? 0 : Math.pow(10, random.nextDouble(0, 2.3));
      double way = random.nextDouble(-.5, .5) + random.nextInt(2) * Math.PI;
      BodyDef body =
          new BodyDef(type)
              .shape(shape, m, ghost ? ofGhosts : Filter.DEFAULT)
              .position((float) random.nextDouble(-15, 15), (float) random.nextDouble(-3, 3))
              .angle((float) random.nextDouble(-3, 3))
              .velocity((float) (speed * Math.cos(way)), (float) (speed * Math.sin(way)))
              .angularVelocity((float) random.nextDouble(-9, 9))
              .bullet(random.nextBoolean());
      w.createBody(body, ghost ? GHOST : "mover");
    }
    return w;
  }

  private static String state(Body<String> b) {
    return b.x()
        + " "
        + b.y()
        + " "
        + b.cos()
        + " "
        + b.sin()
        + " "
        + b.velocityX()
        + " "
        + b.velocityY()
        + " "
        + b.angularVelocity();
  }

  /** A bullet at 200 m/s through twenty allies flies 100 m in half a second. */
  @Test
  void aBulletPassesItsAllies() {
    World<String> w = new World<>(new WorldDef().withGravity(0, 0));
    w.listener(new Refusal());
    for (int i = 0; i < 20; i++) {
      w.createBody(
          new BodyDef(BodyType.DYNAMIC).shape(new Box(.25f, .5f)).position(3 + 4 * i, 0), GHOST);
    }
    Body<String> bullet =
        w.createBody(
            new BodyDef(BodyType.DYNAMIC).shape(new Circle(.1f)).bullet(true).velocity(200, 0),
            "bullet");
    for (int i = 0; i < 30; i++) {
      w.step(DT);
    }
    assertEquals(100, bullet.x(), 1e-3);
    assertEquals(200, bullet.velocityX());
  }

  /** Tiles that are let pass cover no corners of those beside them, nor stand for these. */
  @Test
  void vetoedTilesOfAFloorEqualHoles() {
    int refused = 0;
    for (int seed = 0; seed < WORLDS / 4; seed++) {
      World<String> vetoed = tiles(new SplittableRandom(seed), Filter.DEFAULT);
      World<String> without = tiles(new SplittableRandom(seed), Filter.NOTHING);
      refused += assertEqual(vetoed, without, 2 * TICKS, seed).refused;
    }
    assertTrue(refused > WORLDS, "refused=" + refused);
  }

  private static World<String> tiles(SplittableRandom random, Filter ofGhosts) {
    World<String> w = new World<>(new WorldDef().withSleeping(false));
    Material m = new Material(1, .4f, random.nextInt(3) * .3f);
    Shape tile = random.nextInt(3) == 0 ? new Segment(-.5f, .5f, .5f, .5f) : new Box(.5f, .5f);
    for (int i = 0; i < 12; i++) {
      boolean ghost = random.nextInt(3) == 0;
      Filter filter = ghost ? ofGhosts : Filter.DEFAULT;
      w.createBody(
          new BodyDef().position(i - 6, -.5f).shape(tile, m, filter), ghost ? GHOST : "tile");
    }
    w.createBody(new BodyDef().position(0, -6).shape(new Box(30, 1), m), "floor");
    for (int i = 0; i < 2; i++) {
      w.createBody(
          new BodyDef(BodyType.DYNAMIC)
              .shape(RandomShapes.draw(random, true), m)
              .position((float) random.nextDouble(-5, 5), (float) random.nextDouble(1, 2))
              .angle((float) random.nextDouble(-3, 3))
              .velocity((float) random.nextDouble(-10, 10), (float) random.nextDouble(-5, 2))
              .angularVelocity((float) random.nextDouble(-9, 9))
              .bullet(random.nextBoolean()),
          "mover");
    }
    return w;
  }

  /** A sleeper that is let pass sleeps on, from the first touch on. */
  @Test
  void aVetoWakesNoSleeper() {
    World<String> w = new World<>(new WorldDef());
    w.createBody(new BodyDef().shape(new Box(40, 1)).position(0, -1), "floor");
    BodyDef def = new BodyDef(BodyType.DYNAMIC).shape(new Box(.5f, .5f)).position(0, .5f);
    Body<String> sleeper = w.createBody(def, GHOST);
    for (int i = 0; i < 60; i++) {
      w.step(DT);
    }
    assertFalse(sleeper.awake());
    w.listener(new Refusal());
    w.createBody(new BodyDef(BodyType.DYNAMIC).shape(new Circle(.5f)).position(0, 3), "ball");
    w.createBody(
        new BodyDef(BodyType.KINEMATIC).shape(new Box(.5f, .2f)).position(-3, .5f).velocity(3, 0),
        "paddle");
    for (int i = 0; i < 120; i++) {
      w.step(DT);
      assertFalse(sleeper.awake(), "tick=" + i);
    }
  }

  /** Rising bodies pass one-way platforms without a halt, falling ones land. */
  @Test
  void jumpsPassOneWayPlatforms() {
    for (Shape platform : List.of(new Box(2, .1f), new Segment(-2, 0, 2, 0))) {
      for (Shape shape : List.of(new Box(.25f, .25f), new Circle(.25f))) {
        for (float speed : new float[] {8, 12, 20}) {
          World<String> w = new World<>(new WorldDef());
          w.listener(new OneWay<>((body, part) -> body.user().equals(GHOST)));
          w.createBody(new BodyDef().shape(platform).position(0, 2), GHOST);
          World<String> free = new World<>(new WorldDef());
          BodyDef def = new BodyDef(BodyType.DYNAMIC).shape(shape).velocity(0, speed);
          Body<String> body = w.createBody(def, "jumper");
          Body<String> alone = free.createBody(def, "jumper");
          while (alone.velocityY() > 0) {
            w.step(DT);
            free.step(DT);
            assertEquals(alone.y(), body.y(), shape + " speed=" + speed);
          }
          for (int i = 0; i < 300; i++) {
            w.step(DT);
          }
          assertEquals(2, body.y(), .4, shape + " lands; speed=" + speed);
          assertFalse(body.y() < 2, shape + " speed=" + speed);
        }
      }
    }
  }
}
