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
      Refusal refusal = new Refusal();
      vetoed.listener(refusal);
      without.listener(new Refusal());
      for (int tick = 0; tick < TICKS; tick++) {
        vetoed.step(DT);
        without.step(DT);
        for (int i = 0; i < vetoed.slotCount(); i++) {
          String where = "seed=" + seed + " tick=" + tick + " body=" + i;
          assertEquals(state(without.body(i)), state(vetoed.body(i)), where);
        }
      }
      refused += refusal.refused;
      swept += refusal.swept;
    }
    assertTrue(refused > 10 * WORLDS, "refused=" + refused);
    assertTrue(swept > WORLDS / 2, "swept=" + swept);
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

  /**
   * A tile that is let pass covers no corner of its neighbour: a box tips over that as if alone.
   */
  @Test
  void aVetoedTileCoversNoCorner() {
    Body<String> vetoed = tipping(Filter.DEFAULT);
    Body<String> without = tipping(Filter.NOTHING);
    assertEquals(without.x(), vetoed.x(), .05);
    assertEquals(without.y(), vetoed.y(), .05);
    assertTrue(vetoed.y() < -2, "y=" + vetoed.y());
  }

  private static Body<String> tipping(Filter ofGhost) {
    World<String> w = new World<>(new WorldDef());
    w.listener(new Refusal());
    w.createBody(new BodyDef().shape(new Box(2, .5f)).position(-2, -.5f), "tile");
    w.createBody(
        new BodyDef().shape(new Box(2, .5f), Material.DEFAULT, ofGhost).position(2, -.5f), GHOST);
    BodyDef def = new BodyDef(BodyType.DYNAMIC).shape(new Box(.5f, .25f)).velocity(4, 0);
    Body<String> box = w.createBody(def.position(-.6f, .25f), "box");
    for (int i = 0; i < 90; i++) {
      w.step(DT);
    }
    return box;
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
