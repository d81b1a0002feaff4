package carom.physics.effects;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.physics.Body;
import carom.physics.BodyDef;
import carom.physics.BodyType;
import carom.physics.Filter;
import carom.physics.JointDef;
import carom.physics.Material;
import carom.physics.ShapeDef;
import carom.physics.World;
import carom.physics.WorldDef;
import carom.physics.geometry.Box;
import carom.physics.geometry.Capsule;
import carom.physics.geometry.Circle;
import carom.physics.geometry.Polygon;
import carom.physics.geometry.Shape;
import carom.physics.math.Aabb;
import carom.physics.math.Transform;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Drag and lift per edge against closed forms. */
final class WindTest {
  private static final float DT = 1 / 60f;
  private static final Aabb AREA = new Aabb(-50, -50, 50, 50);

  private final World<String> world =
      new World<>(new WorldDef().withGravity(0, 0).withSleeping(false));

  private Body<String> body(Shape shape, float angle, float density) {
    return world.createBody(
        new BodyDef(BodyType.DYNAMIC)
            .shape(shape, Material.DEFAULT.withDensity(density))
            .angle(angle),
        "body");
  }

  private void step(Wind wind) {
    wind.apply(world, DT);
    world.step(DT);
  }

  @Test
  void aDiscHasTheDragOfItsWidth() {
    Body<String> b = body(new Circle(.5f), 0, 1e5f);
    step(new Wind(AREA, 3, 4).airDensity(2).drag(.5f));
    // 1/2 rho cd 2 r v^2, along the wind
    double force = .5 * 2 * .5 * 1 * 25;
    assertEquals(force * .6 * DT / b.mass(), b.velocityX(), 1e-4 * force * DT / b.mass());
    assertEquals(force * .8 * DT / b.mass(), b.velocityY(), 1e-4 * force * DT / b.mass());
    assertEquals(0, b.angularVelocity(), 1e-9);
  }

  @Test
  void aBoxFaceOnHasTheDragOfOneFaceAndNoLift() {
    Body<String> b = body(new Box(2, .5f), 0, 1e5f);
    step(new Wind(AREA, 10, 0));
    double force = .5 * 1.2 * 1 * 100;
    assertEquals(force * DT / b.mass(), b.velocityX(), 1e-4 * force * DT / b.mass());
    assertEquals(0, b.velocityY(), 1e-12);
    assertEquals(0, b.angularVelocity(), 1e-12);
  }

  @ParameterizedTest
  @ValueSource(ints = {1, 2, 3, 4, 5, 6, 7, 8})
  void itDoesNotMatterIntoWhichPartsABodyIsCut(int seed) {
    Random random = new Random(seed);
    float width = 0.5f + 2 * random.nextFloat();
    float height = 0.5f + 2 * random.nextFloat();
    float angle = 6 * random.nextFloat();
    Body<String> whole = body(new Box(width / 2, height / 2), angle, 1e5f);
    BodyDef def = new BodyDef(BodyType.DYNAMIC).position(10, 0).angle(angle);
    Material material = Material.DEFAULT.withDensity(1e5f);
    int columns = 1 + random.nextInt(4);
    int rows = 1 + random.nextInt(4);
    for (int i = 0; i < columns; i++) {
      for (int k = 0; k < rows; k++) {
        float x0 = width * (i / (float) columns - 0.5f);
        float x1 = width * ((i + 1) / (float) columns - 0.5f);
        float y0 = height * (k / (float) rows - 0.5f);
        float y1 = height * ((k + 1) / (float) rows - 0.5f);
        def.shape(Polygon.of(x0, y0, x1, y0, x1, y1, x0, y1), material);
      }
    }
    Body<String> cut = world.createBody(def, "cut");
    step(new Wind(AREA, 20, 5));
    double speed = Math.hypot(whole.velocityX(), whole.velocityY());
    assertTrue(speed > 0);
    assertEquals(whole.velocityX(), cut.velocityX(), 1e-3 * speed, columns + " x " + rows);
    assertEquals(whole.velocityY(), cut.velocityY(), 1e-3 * speed, columns + " x " + rows);
    assertEquals(whole.angularVelocity(), cut.angularVelocity(), 1e-3 * speed);
  }

  @ParameterizedTest
  @ValueSource(doubles = {10, 30, 45, 60, 80})
  void aPlateHasDragBySineAndLiftBySineTimesCosine(double degrees) {
    double a = Math.toRadians(degrees);
    // Its lower side faces a wind from the left; so thin that its ends don't count.
    Body<String> b = body(new Box(2, .002f), (float) -a, 1e7f);
    step(new Wind(AREA, 10, 0).drag(.7f).lift(1.5f));
    double q = .5 * 1.2 * 4 * 100;
    double drag = q * .7 * Math.sin(a);
    double lift = q * 1.5 * Math.sin(a) * Math.cos(a);
    assertEquals(drag, b.velocityX() * b.mass() / DT, .01 * q);
    assertEquals(lift, b.velocityY() * b.mass() / DT, .01 * q, "it rises as a kite");
  }

  @Test
  void aCapsuleHasFlanksAndRounding() {
    Body<String> b = body(new Capsule(-1, 0, 1, 0, .25f), 0, 1e5f);
    step(new Wind(AREA, 0, 10));
    double force = .5 * 1.2 * (2 + .5) * 100;
    assertEquals(force, b.velocityY() * b.mass() / DT, 1e-3 * force);
    assertEquals(0, b.velocityX(), 1e-12);
  }

  @Test
  void nothingIsEverFasterThanTheWindHoweverLightAndBroad() {
    for (Shape shape :
        new Shape[] {new Circle(1), new Box(2, .01f), Polygon.regular(12, 2), new Box(1, 1)}) {
      Body<String> b = body(shape, .3f, 1e-3f);
      Wind gale = new Wind(AREA, 80, 0).lift(0);
      double before = 0;
      for (int i = 0; i < 30; i++) {
        step(gale);
        assertTrue(b.velocityX() >= before - 1e-3, shape + " v=" + b.velocityX());
        assertTrue(b.velocityX() <= 81, shape + " v=" + b.velocityX());
        before = b.velocityX();
      }
      assertTrue(b.velocityX() > 40, shape + " is taken along: v=" + b.velocityX());
      world.destroyBody(b);
    }
  }

  @Test
  void stillAirBrakesRotationByTheSpeedOfTheEdges() {
    Body<String> b = body(new Box(2, .02f), 0, 5);
    b.setAngularVelocity(20);
    Wind still = new Wind(AREA, 0, 0);
    double before = 20;
    for (int i = 0; i < 120; i++) {
      step(still);
      assertTrue(Math.abs(b.angularVelocity()) <= before, "w=" + b.angularVelocity());
      before = Math.abs(b.angularVelocity());
    }
    assertTrue(before < 20, "w=" + before);
    assertEquals(0, b.velocityX(), 1e-3);
  }

  @Test
  void aWeatherVaneTurnsIntoTheWind() {
    Body<String> post = world.createBody(new BodyDef(), "post");
    Body<String> vane =
        world.createBody(
            new BodyDef(BodyType.DYNAMIC)
                .shape(new Box(1, .05f), Material.DEFAULT)
                .shape(Polygon.of(-2, -.6f, -1, 0, -2, .6f), Material.DEFAULT)
                .angle(1.2f)
                .angularDamping(1),
            "vane");
    world.createJoint(JointDef.revolute(post, vane, 0, 0));
    Wind wind = new Wind(AREA, -12, 0);
    for (int i = 0; i < 1200; i++) {
      step(wind);
    }
    assertEquals(0, vane.angle(), .05, "it points against a wind from the right");
  }

  @Test
  void onlyEdgesInTheAreaFeelIt() {
    Body<String> b = body(new Box(.5f, 2), 0, 1e5f);
    step(new Wind(new Aabb(-5, 1.5f, 5, 5), 10, 0));
    assertEquals(0, b.velocityX(), "the points of the windward edge are outside");
    step(new Wind(new Aabb(-5, -.5f, 5, 5), 10, 0));
    double half = .5 * 1.2 * 2 * 100;
    assertEquals(half, b.velocityX() * b.mass() / DT, 1e-3 * half, "one of two");
  }

  @Test
  void aFrameCarriesAndTurnsItAndStrengthScalesIt() {
    Body<String> one = body(new Circle(.5f), 0, 1e5f);
    Wind wind = new Wind(new Aabb(-1, -1, 1, 1), 10, 0);
    Transform frame = new Transform(0, 0, (float) Math.PI / 2);
    wind.act(world, one, frame, .5f, DT);
    world.step(DT);
    double force = .5 * .5 * 1.2 * 100;
    assertEquals(force, one.velocityY() * one.mass() / DT, 1e-3 * force);
    assertEquals(0, one.velocityX() * one.mass() / DT, 1e-3 * force);
    Aabb box = new Aabb();
    wind.reach(new Transform(7, 0, 0), box);
    assertEquals("Aabb(6.0, -1.0 .. 8.0, 1.0)", box.toString());
  }

  @Test
  void categoriesSensorsAndSleepersAreLeftAlone() {
    Body<String> other =
        world.createBody(
            new BodyDef(BodyType.DYNAMIC)
                .shape(new Circle(.5f), Material.DEFAULT, new Filter(2, -1, 0)),
            "other");
    Body<String> sail =
        world.createBody(
            new BodyDef(BodyType.DYNAMIC)
                .shape(new Circle(.1f))
                .shape(
                    new ShapeDef(new Box(9, 9))
                        .withSensor(true)
                        .withMaterial(new Material(0, 0, 0)))
                .position(20, 0),
            "sail");
    step(new Wind(AREA, 10, 0).categories(1));
    assertEquals(0, other.velocityX());
    double force = .5 * 1.2 * .2 * 100;
    assertTrue(sail.velocityX() * sail.mass() / DT <= force, "the sensor catches no wind");

    World<String> resting = new World<>(new WorldDef().withGravity(0, 0));
    Body<String> asleep =
        resting.createBody(
            new BodyDef(BodyType.DYNAMIC).shape(new Circle(.5f)).awake(false), "asleep");
    Wind wind = new Wind(AREA, 10, 0);
    wind.apply(resting, DT);
    resting.step(DT);
    assertFalse(asleep.awake());
    wind.wake(resting);
    wind.apply(resting, DT);
    resting.step(DT);
    assertTrue(asleep.velocityX() > 0);
  }

  @Test
  void badNumbersAreRefusedByName() {
    Wind wind = new Wind(AREA, 1, 0);
    refused("drag=-1.0", () -> wind.drag(-1));
    refused("lift=1001.0", () -> wind.lift(1001));
    refused("airDensity=NaN", () -> wind.airDensity(Float.NaN));
    refused("vx=Infinity", () -> new Wind(AREA, Float.POSITIVE_INFINITY, 0));
  }

  private static void refused(String start, Runnable call) {
    String message = assertThrows(IllegalArgumentException.class, call::run).getMessage();
    assertTrue(message.startsWith(start), message);
  }
}
