package carom.physics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.physics.collision.Collider;
import carom.physics.collision.Manifold;
import carom.physics.geometry.Box;
import carom.physics.geometry.Capsule;
import carom.physics.geometry.Chain;
import carom.physics.geometry.Circle;
import carom.physics.geometry.Convex;
import carom.physics.geometry.Polygon;
import carom.physics.geometry.Segment;
import carom.physics.geometry.Shape;
import carom.physics.math.Transform;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Chains, segments and capsules in a world. */
final class LineTest {
  private static final Material ICE = new Material(1, 0, 0);

  private static World<String> ground(Shape shape) {
    World<String> w = new World<>(new WorldDef());
    w.createBody(new BodyDef().shape(shape, ICE), "ground");
    return w;
  }

  private static Body<String> slider(World<String> w, Shape shape, float x, float y) {
    return w.createBody(
        new BodyDef(BodyType.DYNAMIC).shape(shape, ICE).position(x, y).velocity(6, 0), "slider");
  }

  private static Chain flat(int segments) {
    float[] xy = new float[2 * segments + 2];
    for (int i = 0; i <= segments; i++) {
      xy[2 * i] = 0.25f * i;
    }
    return Chain.open(xy);
  }

  /**
   * Goal: joints of a flat chain are not felt. Method: slide without friction over 80 of them;
   * speed, height and angle stay.
   */
  @Test
  void nothingCatchesOnTheJointsOfAFlatChain() {
    List<Shape> shapes =
        List.of(
            new Box(0.5f, 0.5f),
            new Circle(0.5f),
            new Capsule(-0.5f, 0, 0.5f, 0, 0.5f),
            Polygon.rounded(0.1f, -0.4f, -0.4f, 0.4f, -0.4f, 0.4f, 0.4f, -0.4f, 0.4f));
    for (Shape shape : shapes) {
      World<String> w = ground(flat(120));
      Body<String> b = slider(w, shape, 2, 0.5f);
      Scenes.steps(w, 20);
      for (int i = 0; i < 180; i++) {
        w.step(Scenes.DT);
        String message = shape + " step=" + i + " x=" + b.x();
        assertEquals(6, b.velocityX(), 1e-4, message);
        assertEquals(0, b.velocityY(), 1e-3, message);
        assertEquals(0.5f, b.y(), 0.006, message);
        assertEquals(0, b.angularVelocity(), 1e-3, message);
      }
      assertTrue(b.x() > 20, shape + " x=" + b.x());
    }
  }

  @Test
  void aFastFallOntoJointsGoesStraightUpAgain() {
    World<String> w = ground(flat(40));
    Body<String> b =
        w.createBody(
            new BodyDef(BodyType.DYNAMIC)
                .shape(new Box(0.4f, 0.4f), ICE)
                .position(5.1f, 0.5f)
                .velocity(0, -12),
            "box");
    Scenes.steps(w, 120);
    assertEquals(5.1f, b.x(), 1e-3);
    assertEquals(0, b.angle(), 0.01);
    assertEquals(0.4f, b.y(), 0.01);
  }

  @Test
  void chainsCarryFromTheFrontAndLetPassFromBehind() {
    World<String> w = ground(flat(20));
    Body<String> above = Scenes.disc(w, 2, 1, 0.3f, ICE);
    Body<String> below = Scenes.disc(w, 3, -1, 0.3f, ICE);
    below.setVelocity(0, 8);
    boolean passed = false;
    for (int i = 0; i < 120; i++) {
      w.step(Scenes.DT);
      passed |= below.y() > 0.5f;
    }
    assertTrue(passed, "rises through the ground");
    assertEquals(0.3f, above.y(), 0.01);
    assertEquals(0.3f, below.y(), 0.01, "and comes to rest on it");
  }

  @Test
  void anArenaOfAChainHoldsWhatIsInside() {
    World<String> w = ground(Chain.loop(-4, -3, 4, -3, 5, 0, 4, 3, -4, 3, -5, 0));
    Body<String> disc = Scenes.disc(w, 0, 0, 0.3f, new Material(1, 0, 1));
    Body<String> box = Scenes.box(w, 1, 0, 0.3f, 0.3f, new Material(1, 0, 1));
    Body<String> capsule =
        w.createBody(
            new BodyDef(BodyType.DYNAMIC).shape(Capsule.upright(1, 0.2f)).position(-1, 0), "c");
    disc.setVelocity(7, 5);
    box.setVelocity(-6, 4);
    capsule.setVelocity(3, -8);
    for (int i = 0; i < 600; i++) {
      w.step(Scenes.DT);
      w.forEachBody(
          b -> assertTrue(Math.abs(b.x()) < 5.1f && Math.abs(b.y()) < 3.1f, b + " leaves"));
    }
  }

  @Test
  void boxesRestOnHillsAndInValleysOfChains() {
    World<String> w = ground(Chain.open(-6, 2, -2, 0, 0, 0, 2, 0, 4, 1, 6, 1, 8, 0, 30, 0));
    Material rough = new Material(1, 0.8f, 0);
    Body<String> valley = Scenes.box(w, 0, 1, 0.5f, 0.5f, rough);
    Body<String> hill = Scenes.box(w, 5, 2, 0.5f, 0.5f, rough);
    Body<String> edge = Scenes.box(w, 6.2f, 2, 0.5f, 0.4f, rough);
    Scenes.steps(w, 180);
    assertEquals(0.5f, valley.y(), 0.01);
    assertEquals(1.5f, hill.y(), 0.01);
    assertTrue(edge.y() > 0.3f, "x=" + edge.x() + " y=" + edge.y());
    assertEquals(0, valley.velocityX() + valley.velocityY() + hill.velocityX(), 1e-3);
  }

  @Test
  void capsulesLieOnTwoPointsAndStackLikeBoxes() {
    World<String> w = Scenes.floor(Material.DEFAULT);
    Capsule plank = new Capsule(-0.8f, 0, 0.8f, 0, 0.2f);
    for (int i = 0; i < 6; i++) {
      w.createBody(
          new BodyDef(BodyType.DYNAMIC).shape(plank, Material.DEFAULT).position(0, 0.2f + 0.4f * i),
          "plank");
    }
    Scenes.steps(w, 300);
    assertTrue(Scenes.kineticEnergy(w) < 1e-3, "energy=" + Scenes.kineticEnergy(w));
    assertTrue(Scenes.deepest(w) < 0.02, "deepest=" + Scenes.deepest(w));
    Collider collider = new Collider();
    Manifold m = new Manifold();
    Box floor = new Box(5, 1);
    collider.collide(floor, new Transform(), plank, new Transform(0, 1.19f, 0), 0.02f, m);
    assertEquals(2, m.count);
    assertEquals(-0.01f, m.separation0, 1e-5);
    assertEquals(1.6f, Math.abs(m.x0 - m.x1), 1e-5);
    assertEquals(1 - 0.005f, m.y0, 1e-5);
  }

  @Test
  void linesEndToEndAreAsFarApartAsTheyAre() {
    Collider collider = new Collider();
    Manifold m = new Manifold();
    Convex a = new Capsule(0, 0, 1, 0, 0.1f);
    collider.collide(a, new Transform(), a, new Transform(1.5f, 0, 0), 1, m);
    assertEquals("1 1.0 0.0", m.count + " " + m.normalX + " " + m.normalY);
    assertEquals(0.3f, m.separation0, 1e-6);
    assertEquals(1.25f, m.x0, 1e-6);
  }

  @Test
  void linesAreRefusedForDynamicBodies() {
    World<String> w = new World<>(new WorldDef());
    BodyDef def = new BodyDef(BodyType.DYNAMIC).shape(new Circle(1)).shape(new Segment(0, 0, 1, 0));
    String message =
        assertThrows(IllegalArgumentException.class, () -> w.createBody(def, "x")).getMessage();
    assertTrue(message.contains("Segment(0.0 0.0, 1.0 0.0) has no mass"), message);
    w.createBody(new BodyDef(BodyType.KINEMATIC).shape(new Segment(0, 0, 1, 0)), "kinematic");
    assertEquals(1, w.bodyCount());
  }
}
