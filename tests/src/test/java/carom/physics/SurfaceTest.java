package carom.physics;

import static carom.physics.Scenes.DT;
import static carom.physics.Scenes.steps;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.physics.geometry.Box;
import carom.physics.geometry.Circle;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Rolling and conveyor belts against closed forms. */
final class SurfaceTest {
  private static final Material ROUGH = new Material(1, 1, 0);

  /** A slope through the origin, and a body that touches it there. */
  private static Body<String> onSlope(World<String> w, double angle, BodyDef def, double height) {
    float a = (float) angle;
    float sin = (float) Math.sin(angle);
    float cos = (float) Math.cos(angle);
    w.createBody(
        new BodyDef().shape(new Box(200, 1, 0, -1), ROUGH).angle(-a).position(0, 0), "slope");
    return w.createBody(
        def.position((float) height * sin, (float) height * cos).angle(-a), "roller");
  }

  /** Without slipping, and with I = m r^2 / 2: a = 2/3 g sin(angle). */
  @ParameterizedTest
  @ValueSource(doubles = {.1, .3, .6})
  void discRollsDownWithTwoThirdsOfTheSlide(double angle) {
    World<String> w = new World<>(new WorldDef());
    BodyDef def = new BodyDef(BodyType.DYNAMIC).shape(new Circle(.5f), ROUGH);
    Body<String> b = onSlope(w, angle, def, .5);
    steps(w, 120);
    double expected = 2 / 3.0 * 10 * Math.sin(angle) * 2;
    assertEquals(expected, Math.hypot(b.velocityX(), b.velocityY()), .01 * expected);
    assertEquals(-expected / .5, b.angularVelocity(), .01 * expected / .5);
  }

  /** m a = F, I w' = F r - c r m g, rolling: a = 2/3 c g, until it stands. */
  @Test
  void rollingResistanceSlowsDownBySteadyForce() {
    World<String> w = Scenes.floor(Material.DEFAULT);
    Body<String> b = Scenes.disc(w, 0, .5f, .5f, Material.DEFAULT.withRollingResistance(.09f));
    b.setVelocity(3, 0);
    b.setAngularVelocity(-6);
    steps(w, 120);
    assertEquals(3 - 2 / 3.0 * .09 * 10 * 2, b.velocityX(), .01);
    steps(w, 240);
    assertEquals(0, b.velocityX(), 1e-3);
    assertEquals(9 / (2 * 2 / 3.0 * .9), b.x(), .1);
    float stands = b.x();
    steps(w, 120);
    assertEquals(stands, b.x(), 1e-3);
  }

  /** Holds where the torque of the weight, m g r sin, is below c r m g cos. */
  @Test
  void rollingResistanceHoldsBelowItsAngle() {
    Material m = ROUGH.withRollingResistance(.2f);
    World<String> w = new World<>(new WorldDef());
    BodyDef def = new BodyDef(BodyType.DYNAMIC).shape(new Circle(.5f), m);
    Body<String> holds = onSlope(w, Math.atan(.19), def, .5);
    steps(w, 240);
    assertTrue(Math.abs(holds.x()) < .15, "x=" + holds.x());
    World<String> steep = new World<>(new WorldDef());
    Body<String> rolls = onSlope(steep, Math.atan(.22), def, .5);
    steps(steep, 240);
    assertTrue(rolls.x() > .3, "x=" + rolls.x());
  }

  /** v = mu g t up to the belt's speed, then along with it. */
  @ParameterizedTest
  @ValueSource(floats = {2, -2})
  void conveyorCarriesABoxToItsSpeed(float speed) {
    World<String> w = Scenes.floor(Material.DEFAULT.withFriction(.25f).withTangentSpeed(speed));
    Body<String> b = Scenes.box(w, 0, .5f, .5f, .5f, Material.DEFAULT.withFriction(1));
    float sign = Math.signum(speed);
    steps(w, 12);
    assertEquals(sign * .5 * 10 * .2, b.velocityX(), .05);
    steps(w, 108);
    assertEquals(speed, b.velocityX(), .01);
    assertEquals(sign * (4 - .4), b.x(), .05);
  }

  /** Below a ceiling the same belt runs the other way, and on a turned body along its side. */
  @Test
  void beltRunsClockwiseAroundItsShape() {
    World<String> w = new World<>(new WorldDef().withGravity(0, 10));
    w.createBody(
        new BodyDef().shape(new Box(100, 1), Material.DEFAULT.withTangentSpeed(2)), "ceiling");
    Body<String> b = Scenes.box(w, 0, -1.5f, .5f, .5f, Material.DEFAULT);
    steps(w, 120);
    assertEquals(-2, b.velocityX(), .01);
  }

  /** A crawler: the belt of a body drives the body. */
  @Test
  void beltOfADynamicBodyDrivesIt() {
    World<String> w = Scenes.floor(Material.DEFAULT);
    Body<String> b = Scenes.box(w, 0, .5f, 1, .5f, Material.DEFAULT.withTangentSpeed(3));
    steps(w, 120);
    assertEquals(3, b.velocityX(), .01);
  }

  /** Discs that roll badly on a belt. */
  static World<String> belts() {
    World<String> w = Scenes.floor(Material.DEFAULT.withTangentSpeed(1).withRollingResistance(.1f));
    for (int i = 0; i < 20; i++) {
      Scenes.disc(w, i * .3f, 1 + i * .4f, .25f, Material.DEFAULT.withRollingResistance(.3f));
    }
    return w;
  }

  @Test
  void rollingAndBeltsAreRestoredBitForBit() {
    World<String> w = belts();
    steps(w, 100);
    WorldState s = w.save(null);
    steps(w, 50);
    long hash = w.stateHash();
    w.restore(s);
    steps(w, 50);
    assertEquals(hash, w.stateHash());
    w.step(DT);
  }
}
