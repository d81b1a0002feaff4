package carom.physics.truth;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.physics.Body;
import carom.physics.BodyDef;
import carom.physics.BodyType;
import carom.physics.Material;
import carom.physics.World;
import carom.physics.WorldDef;
import carom.physics.geometry.Box;
import carom.physics.geometry.Chain;
import carom.physics.geometry.Circle;
import carom.physics.geometry.Compound;
import carom.physics.geometry.Polygon;
import carom.physics.geometry.Segment;
import carom.physics.geometry.Shape;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.BiConsumer;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * A ground made of pieces is one ground: a body without friction that slides over 50 m of it keeps
 * its speed and its height. What really stands out still stops it.
 */
final class SeamTest {
  private static final float[] SPEEDS = {2, 3.1f, 5, 10, 20};
  private static final int LENGTH = 54;

  /** Ways to lay a floor at y = 0 from x = -2 on. */
  private enum Floor {
    BOXES((w, r) -> row(w, r, new Box(.5f, .5f, 0, -.5f), 1, 0)),
    SMALL_BOXES((w, r) -> row(w, r, new Box(.125f, .125f, 0, -.125f), .25f, 0)),
    TILES_OF_8_CM((w, r) -> row(w, r, new Box(.04f, .25f, 0, -.25f), .08f, 0)),
    TILES_OF_5_CM((w, r) -> row(w, r, new Box(.025f, .25f, 0, -.25f), .05f, 0)),
    THIN_BOXES((w, r) -> row(w, r, new Box(.5f, .02f, 0, -.02f), 1, 0)),
    OVERLAPPING_BOXES((w, r) -> row(w, r, new Box(.55f, .5f, 0, -.5f), 1, 0)),
    WEDGES((w, r) -> row(w, r, Polygon.of(-.5f, 0, -.2f, -1, .2f, -1, .5f, 0), 1, 0)),
    TRAPEZOIDS(
        (w, r) -> {
          row(w, r, Polygon.of(-.5f, 0, -.5f, -1, .2f, -1, .5f, 0), 2, 0);
          row(w, r, Polygon.of(-.5f, 0, -.2f, -1, .5f, -1, .5f, 0), 2, 1);
        }),
    BOXES_AND_POLYGONS(
        (w, r) -> {
          row(w, r, new Box(.5f, 1, 0, -1), 2, 0);
          row(w, r, Polygon.of(-.5f, 0, -.5f, -1, 0, -2, .5f, -1, .5f, 0), 2, 1);
        }),
    SEGMENTS((w, r) -> row(w, r, new Segment(.5f, 0, -.5f, 0), 1, 0)),
    CHAINS((w, r) -> row(w, r, Chain.open(-3, 0, -1, 0, 0, 0, 2.5f, 0), 5.5f, 0)),
    CHAIN((w, r) -> row(w, r, Chain.open(-3, 0, -1, 0, 0, 0, 2.5f, 0, 30, 0, 60, 0), 100, 0)),
    COMPOUNDS(
        (w, r) ->
            row(w, r, Compound.of(new Box(.5f, .5f, 0, -.5f), new Box(.5f, .5f, 1, -.5f)), 2, 0)),
    ONE_BOX((w, r) -> row(w, r, new Box(60, 1, 0, -1), 200, 0));

    private final BiConsumer<World<String>, float[]> layer;

    Floor(BiConsumer<World<String>, float[]> layer) {
      this.layer = layer;
    }
  }

  /** Lays pieces along the direction (r[0], r[1]). */
  private static void row(World<String> w, float[] r, Shape piece, float pitch, float offset) {
    for (float x = -2 + offset; x < LENGTH; x += pitch) {
      w.createBody(
          new BodyDef()
              .shape(piece, Lab.ICE)
              .position(r[0] * x, r[1] * x)
              .angle((float) Math.atan2(r[1], r[0])),
          "piece at " + x);
    }
  }

  private static List<Shape> sliders() {
    return List.of(
        new Circle(.5f),
        new Box(.5f, .5f),
        new Circle(.2f),
        new Box(.3f, .15f),
        Polygon.of(-.2f, -.5f, .2f, -.5f, .4f, 0, 0, .5f, -.4f, 0));
  }

  private static String slide(Floor floor, Shape shape, float speed, double angle) {
    float c = (float) Math.cos(angle);
    float s = (float) Math.sin(angle);
    World<String> w = new World<>(new WorldDef().withSleeping(false).withGravity(10 * s, -10 * c));
    floor.layer.accept(w, new float[] {c, s});
    float up =
        shape instanceof Circle disc
            ? disc.radius()
            : shape instanceof Box b ? b.halfHeight() : .5f;
    Body<String> b =
        w.createBody(
            new BodyDef(BodyType.DYNAMIC)
                .shape(shape, new Material(1, 0, 0))
                .position(-s * up, c * up)
                .angle((float) angle)
                .velocity(speed * c, speed * s),
            "slider");
    double highest = 0;
    double lowest = 0;
    for (int i = 0; i < (angle == 0 ? 50 : 15) / speed * 60; i++) {
      w.step(Lab.DT);
      double height = -s * b.x() + c * b.y() - up;
      highest = Math.max(highest, height);
      lowest = Math.min(lowest, height);
    }
    double along = c * b.velocityX() + s * b.velocityY();
    boolean fine = along > .999 * speed && along < 1.001 * speed && highest < .01 && lowest > -.02;
    return fine
        ? null
        : String.format(
            Locale.ROOT,
            "%s %s v=%s angle=%.2f: v=%.3f high=%.4f low=%.4f\n",
            floor,
            shape,
            speed,
            angle,
            along,
            highest,
            lowest);
  }

  @ParameterizedTest
  @EnumSource
  void seamsSlowNothing(Floor floor) {
    List<String> slowed = new ArrayList<>();
    for (double angle : new double[] {0, .3, -1, 2.5}) {
      for (Shape shape : sliders()) {
        for (float speed : SPEEDS) {
          String failure = slide(floor, shape, speed, angle);
          if (failure != null) {
            slowed.add(failure);
          }
        }
      }
    }
    assertEquals(List.of(), slowed);
  }

  /** Two or more sliders on a kinematic compound, which moves along itself. */
  @ParameterizedTest
  @ValueSource(floats = {0, 3})
  void seamsOfAMovingCompoundSlowNothing(float speed) {
    World<String> w = new World<>(new WorldDef().withSleeping(false));
    BodyDef platform = new BodyDef(BodyType.KINEMATIC).velocity(speed, 0);
    for (int x = -2; x < 40; x++) {
      platform.shape(new Box(.5f, .5f, x, -.5f), Lab.ICE);
    }
    w.createBody(platform, "platform");
    List<Body<String>> sliders = new ArrayList<>();
    for (Shape shape : List.of(new Circle(.5f), new Box(.5f, .5f), new Box(.3f, .5f))) {
      Body<String> b = Lab.body(w, shape, 2 * sliders.size(), .5, new Material(1, 0, 0));
      b.setVelocity(6, 0);
      sliders.add(b);
    }
    Lab.seconds(w, 5);
    for (Body<String> b : sliders) {
      assertEquals(6, b.velocityX(), .006, b.toString());
    }
  }

  /** A wall of tiles doesn't hold what falls along it and is pressed against it. */
  @Test
  void aWallOfTilesHoldsNothing() {
    for (Shape shape : sliders()) {
      World<String> w = new World<>(new WorldDef().withSleeping(false));
      for (int y = -60; y < 3; y++) {
        Lab.fixed(w, new Box(.5f, .5f), .5, y + .5, 0, Lab.ICE);
      }
      float half =
          shape instanceof Circle disc
              ? disc.radius()
              : shape instanceof Box b ? b.halfWidth() : .4f;
      Body<String> b = Lab.body(w, shape, -half, 0, new Material(1, 0, 0));
      for (int i = 0; i < 180; i++) {
        b.applyForce(20 * b.mass(), 0, b.x(), b.y());
        w.step(Lab.DT);
      }
      assertEquals(-30, b.velocityY(), .05, shape.toString());
    }
  }

  /** What stands out of the ground stops a slider: steps of 3 cm, walls on tiles and in them. */
  @ParameterizedTest
  @ValueSource(floats = {.03f, .1f, .5f, 1, 2.5f})
  void aStepStopsABox(float height) {
    for (double base : new double[] {0, -.05, -.5}) {
      for (Shape shape :
          List.of(
              new Box(.5f, .5f), new Box(.3f, .15f), Polygon.of(-.5f, -.5f, .5f, -.5f, 0, .3f))) {
        World<String> w = new World<>(new WorldDef().withSleeping(false));
        row(w, new float[] {1, 0}, new Box(.5f, .5f, 0, -.5f), 1, 0);
        double half = (height - base) / 2;
        Lab.fixed(w, new Box(.5f, (float) half), 10.3, base + half, 0, Lab.ICE);
        float up = shape instanceof Box b ? b.halfHeight() : .5f;
        Body<String> b = Lab.body(w, shape, 0, up, new Material(1, 0, 0));
        b.setVelocity(3, 0);
        Lab.seconds(w, 8);
        String where = shape + " base=" + base + " x=" + b.x() + " v=" + b.velocityX();
        assertTrue(b.velocityX() < .5, where);
        assertTrue(b.x() < 9.9, where);
      }
    }
  }

  /** A disc in the corner of floor and wall, both of tiles, stays there under pressure. */
  @Test
  void cornersHold() {
    for (Shape shape : sliders()) {
      World<String> w = new World<>(new WorldDef().withSleeping(false));
      row(w, new float[] {1, 0}, new Box(.5f, .5f, 0, -.5f), 1, 0);
      for (int y = 0; y < 5; y++) {
        Lab.fixed(w, new Box(.5f, .5f), 3, y + .5, 0, Lab.ICE);
      }
      Body<String> b = Lab.body(w, shape, 0, 1.5, new Material(1, 0, 0));
      for (int i = 0; i < 600; i++) {
        b.applyForce(20 * b.mass(), 0, b.x(), b.y());
        w.step(Lab.DT);
      }
      assertTrue(Lab.speed(b) < .01 && b.x() < 2.5 && b.x() > 1.9, b.toString());
      assertTrue(Lab.deepest(w) < .01, "deepest=" + Lab.deepest(w));
    }
  }

  /** A grain much smaller than its speed per step falls onto a seam and lies on it. */
  @Test
  void whatFallsOntoASeamLiesOnIt() {
    for (int i = 0; i < 20; i++) {
      World<String> w = new World<>(new WorldDef().withSleeping(false));
      row(w, new float[] {1, 0}, new Box(.5f, .5f, 0, -.5f), 1, 0);
      Shape shape = i % 2 == 0 ? new Box(.02f, .02f) : new Circle(.02f);
      Body<String> b = Lab.body(w, shape, .49 + .001 * i, 3, new Material(1, 0, 0));
      b.setVelocity(0, -i);
      Lab.seconds(w, 3);
      assertEquals(.02, b.y(), .01, "i=" + i);
      assertEquals(0, Lab.speed(b), .05, "i=" + i);
    }
  }

  /** Over a ridge between two pieces a disc rolls as over that of one chain. */
  @ParameterizedTest
  @ValueSource(floats = {.05f, .2f, .5f})
  void aRidgeOfTwoPiecesIsThatOfOne(float slope) {
    double[] end = new double[2];
    for (int pieces = 1; pieces <= 2; pieces++) {
      World<String> w = new World<>(new WorldDef().withSleeping(false));
      float drop = 8 * slope;
      if (pieces == 1) {
        Lab.fixed(w, Polygon.of(-8, -drop, 0, 0, 8, -drop, 0, -9), 0, 0, 0, Lab.ICE);
      } else {
        Lab.fixed(w, Polygon.of(-8, -drop, 0, 0, 0, -9), 0, 0, 0, Lab.ICE);
        Lab.fixed(w, Polygon.of(8, -drop, 0, 0, 0, -9), 0, 0, 0, Lab.ICE);
      }
      float up = .5f / (float) Math.cos(Math.atan(slope));
      Body<String> b = Lab.disc(w, -2, -2 * slope + up, .5, new Material(1, 0, 0));
      float v = (float) Math.sqrt(2 * 10 * 2 * slope) + 1;
      b.setVelocity(v, v * slope);
      Lab.seconds(w, 1.5);
      end[pieces - 1] = b.x();
      assertTrue(b.x() > 0, "slope=" + slope + " x=" + b.x());
    }
    assertEquals(end[0], end[1], .01, "slope=" + slope);
  }
}
