package carom.physics;

import static carom.physics.Scenes.DT;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.physics.effects.OneWay;
import carom.physics.geometry.Box;
import carom.physics.geometry.Capsule;
import carom.physics.geometry.Circle;
import carom.physics.geometry.Shape;
import carom.physics.math.Trig;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** A one-way platform lets pass from every angle, and holds what comes from above. */
class OneWayTest {
  private static final List<Shape> SHAPES =
      List.of(new Circle(.4f), new Box(.4f, .3f), new Capsule(-.3f, 0, .3f, 0, .3f));

  private static World<String> world() {
    World<String> w = new World<>(new WorldDef().withGravity(0, 0));
    w.createBody(new BodyDef().shape(new Box(500, .1f)), "platform");
    w.listener(new OneWay<>((body, shape) -> body.user().equals("platform")));
    return w;
  }

  /** Degrees from the vertical; up to 80 the way goes along the platform more than through it. */
  @ParameterizedTest
  @ValueSource(floats = {-80, -60, -45, -30, -10, 0, 5, 20, 45, 70, 80})
  void passesFromBelowAndHoldsFromAbove(float degrees) {
    float angle = degrees * (float) Math.PI / 180;
    for (Shape shape : SHAPES) {
      for (float speed : new float[] {2, 7, 25, 90, 300}) {
        for (float turn : new float[] {0, .4f, 1.57f}) {
          String what = shape + " degrees=" + degrees + " speed=" + speed + " turn=" + turn;
          float vx = speed * Trig.sin(angle);
          float vy = speed * Trig.cos(angle);
          int ticks = 30 + (int) (3 / (vy * DT));

          World<String> w = world();
          Body<String> riser =
              w.createBody(dynamic(shape).position(0, -1.2f).angle(turn).velocity(vx, vy), "rider");
          for (int i = 0; i < ticks; i++) {
            w.step(DT);
          }
          assertTrue(riser.y() > .5f, what + " y=" + riser.y());
          assertEquals(vx, riser.velocityX(), 1e-3f * speed, what);
          assertEquals(vy, riser.velocityY(), 1e-3f * speed, what);

          if (turn == .4f && !(shape instanceof Circle)) {
            continue; // what lands on a corner at speed may spin through: the rule knows no corners
          }
          w = world();
          Body<String> faller =
              w.createBody(dynamic(shape).position(0, 1.2f).angle(turn).velocity(vx, -vy), "rider");
          for (int i = 0; i < ticks; i++) {
            w.step(DT);
            assertTrue(faller.y() > .1f, what + " fell to y=" + faller.y());
          }
        }
      }
    }
  }

  private static BodyDef dynamic(Shape shape) {
    return new BodyDef(BodyType.DYNAMIC).shape(shape, Material.DEFAULT.withFriction(0));
  }

  /** A platform of one body among other shapes of it, and another way up. */
  @Test
  void oneShapeMayBeAPlatformAndAnyWayUp() {
    World<String> w = new World<>(new WorldDef().withGravity(10, 0));
    w.createBody(
        new BodyDef()
            .shape(new Box(.1f, 5, 0, 5), Material.DEFAULT.withTag(1))
            .shape(new Box(.1f, 5, 0, -5), Material.DEFAULT),
        "wall");
    w.listener(
        new CollisionListener<>() {
          @Override
          public boolean preSolve(Collision<String> c) {
            return c.selfMaterial().tag() != 1 || OneWay.holds(c, true, -1, 0);
          }
        });
    Body<String> passes =
        w.createBody(dynamic(new Circle(.4f)).position(2, 3).velocity(-9, 0), "r");
    Body<String> stays =
        w.createBody(dynamic(new Circle(.4f)).position(2, -3).velocity(-9, 0), "r");
    boolean passed = false;
    for (int i = 0; i < 180; i++) {
      w.step(DT);
      passed |= passes.x() < -.5f;
      assertTrue(stays.x() > .4f, "the other shape is solid: x=" + stays.x());
    }
    assertTrue(passed);
    assertEquals(-.5f, passes.x(), .02f);
  }

  @Test
  void noRuleOfPlatformsIsRefused() {
    String message =
        assertThrows(IllegalArgumentException.class, () -> new OneWay<String>(null)).getMessage();
    assertEquals("platforms=null; say which shapes are one-way platforms", message);
  }
}
