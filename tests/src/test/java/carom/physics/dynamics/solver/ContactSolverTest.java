package carom.physics.dynamics.solver;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.physics.Body;
import carom.physics.BodyDef;
import carom.physics.BodyType;
import carom.physics.World;
import carom.physics.WorldDef;
import carom.physics.geometry.Box;
import carom.physics.geometry.Circle;
import carom.physics.math.Trig;
import org.junit.jupiter.api.Test;

/** The solver's colours, seen from outside. */
class ContactSolverTest {
  private static final float DT = 1 / 60f;

  /** A disc that is touched by more others than there are colours still pushes all of them. */
  @Test
  void bodyWithMoreContactsThanColoursPushesThemAll() {
    World<Object> world = new World<>(new WorldDef().withGravity(0, 0));
    int around = 150;
    float radius = 10;
    world.createBody(dynamic(0, 0).shape(new Circle(radius)), null);
    float[] start = new float[around];
    for (int i = 0; i < around; i++) {
      float angle = (float) (2 * Math.PI * i / around);
      float far = radius + 0.19f;
      Body<Object> small =
          world.createBody(
              dynamic(far * Trig.cos(angle), far * Trig.sin(angle)).shape(new Circle(0.2f)), null);
      start[i] = distance(small);
    }
    float before = momentum(world);
    for (int tick = 0; tick < 30; tick++) {
      world.step(DT);
    }
    assertEquals(around + 1, world.bodyCount());
    for (int i = 0; i < around; i++) {
      assertTrue(distance(world.body(i + 1)) > start[i] + 0.004f, "disc=" + i + " was not pushed");
    }
    assertEquals(before, momentum(world), 1e-3f);
  }

  /** Discs (one point) and boxes (two points) of one pile are solved together. */
  @Test
  void contactsWithOneAndWithTwoPointsShareAPile() {
    World<Object> world = new World<>(new WorldDef());
    world.createBody(new BodyDef().position(0, -1).shape(new Box(20, 1)), null);
    for (int i = 0; i < 40; i++) {
      int row = i / 8;
      BodyDef def = dynamic((i % 8 - 4) * 1.02f, 0.6f + row * 1.1f);
      def.shape(i % 2 == 0 ? new Box(0.5f, 0.5f) : new Circle(0.5f));
      world.createBody(def, null);
    }
    for (int tick = 0; tick < 600; tick++) {
      world.step(DT);
    }
    float[] deepest = {0};
    world.forEachContact(
        (x, y, nx, ny, separation, impulse) -> deepest[0] = Math.min(deepest[0], separation));
    assertTrue(deepest[0] > -0.01f, "deepest=" + deepest[0]);
  }

  private static BodyDef dynamic(float x, float y) {
    return new BodyDef().type(BodyType.DYNAMIC).position(x, y);
  }

  private static float distance(Body<Object> body) {
    return (float) Math.sqrt(body.x() * body.x() + body.y() * body.y());
  }

  private static float momentum(World<Object> world) {
    float[] sum = {0};
    world.forEachBody(b -> sum[0] += b.mass() * (b.velocityX() + b.velocityY()));
    return sum[0];
  }
}
