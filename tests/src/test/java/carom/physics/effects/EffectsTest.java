package carom.physics.effects;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.physics.Body;
import carom.physics.BodyDef;
import carom.physics.BodyType;
import carom.physics.Filter;
import carom.physics.Material;
import carom.physics.World;
import carom.physics.WorldDef;
import carom.physics.geometry.Box;
import carom.physics.geometry.Circle;
import carom.physics.math.Aabb;
import org.junit.jupiter.api.Test;

/** Areas of force, attractors and explosions against closed forms. */
final class EffectsTest {
  private static final float DT = 1 / 60f;

  private final World<String> world = new World<>(new WorldDef().withGravity(0, 0));

  private Body<String> box(float x, float y, float hw, float hh) {
    return world.createBody(
        new BodyDef(BodyType.DYNAMIC).shape(new Box(hw, hh)).position(x, y), "box");
  }

  @Test
  void forceMovesByMassAndAccelerationDoesNot() {
    Body<String> small = box(0, 0, .5f, .5f);
    Body<String> large = box(3, 0, 1, 1);
    Body<String> outside = box(10, 0, 1, 1);
    Aabb area = new Aabb(-5, -5, 5, 5);
    AreaEffect force = AreaEffect.force(area, 6, 0);
    AreaEffect lift = AreaEffect.acceleration(area, 0, 12);
    force.apply(world, DT);
    lift.apply(world, DT);
    world.step(DT);
    assertEquals(6 * DT / small.mass(), small.velocityX(), 1e-6);
    assertEquals(6 * DT / large.mass(), large.velocityX(), 1e-6);
    assertEquals(12 * DT, small.velocityY(), 1e-6);
    assertEquals(12 * DT, large.velocityY(), 1e-6);
    assertEquals(0, outside.velocityX());
  }

  @Test
  void windAndDragDivideTheDifferenceEachStep() {
    Body<String> leaf = box(0, 0, .1f, .1f);
    Body<String> stone = box(0, 20, 1, 1);
    stone.setVelocity(8, 0);
    stone.setAngularVelocity(4);
    AreaEffect wind = AreaEffect.wind(new Aabb(-5, -5, 5, 5), 3, 0, 30);
    AreaEffect mud = AreaEffect.drag(new Aabb(-5, 15, 5, 25), 6, 12);
    for (int i = 0; i < 20; i++) {
      wind.apply(world, DT);
      mud.apply(world, DT);
      world.step(DT);
    }
    assertEquals(3 * (1 - Math.pow(1 / 1.5, 20)), leaf.velocityX(), 1e-4);
    assertEquals(8 * Math.pow(1 / 1.1, 20), stone.velocityX(), 1e-4);
    assertEquals(4 * Math.pow(1 / 1.2, 20), stone.angularVelocity(), 1e-4);
  }

  @Test
  void attractorFollowsItsLaw() {
    Body<String> body = box(4, 0, .5f, .5f);
    Attractor a = new Attractor(0, 0, 10).strength(8);
    a.apply(world, DT);
    world.step(DT);
    assertEquals(-8 * DT, body.velocityX(), 1e-5);
    body.setVelocity(0, 0);
    body.setPose(4, 0, 0);
    a.falloff(Attractor.Falloff.LINEAR, 1).apply(world, DT);
    world.step(DT);
    assertEquals(-8 * 0.6 * DT, body.velocityX(), 1e-5);
    body.setVelocity(0, 0);
    body.setPose(4, 0, 0);
    a.falloff(Attractor.Falloff.INVERSE_SQUARE, 2).swirl(4).apply(world, DT);
    world.step(DT);
    assertEquals(-2 * DT, body.velocityX(), 1e-5);
    assertEquals(1 * DT, body.velocityY(), 1e-5);
    body.setVelocity(0, 0);
    body.setPose(0, 0, 0);
    a.apply(world, DT);
    world.step(DT);
    assertEquals(0, body.velocityX(), 1e-6);
  }

  /** A circular orbit under the inverse square: v^2 = k / r stays for a hundred turns. */
  @Test
  void orbitKeepsItsRadius() {
    Body<String> moon = box(5, 0, .1f, .1f);
    moon.setVelocity(0, (float) Math.sqrt(10 / 5.0));
    Attractor sun =
        new Attractor(0, 0, 20).strength(10).falloff(Attractor.Falloff.INVERSE_SQUARE, 1);
    for (int i = 0; i < 60 * 22 * 20; i++) {
      sun.apply(world, DT);
      world.step(DT);
      double r = Math.sqrt(moon.x() * moon.x() + moon.y() * moon.y());
      assertEquals(5, r, 0.1, "tick=" + i);
    }
  }

  @Test
  void explosionKicksByWidthAndDistanceAtTheNearestPoint() {
    Body<String> right = box(3, 0, 1, .5f);
    Body<String> above = box(0, 3, 1, .5f);
    Body<String> far = box(20, 0, 1, 1);
    new Explosion(0, 0, 8).impulse(40).explode(world);
    world.step(DT);
    assertEquals(40 * 1 * (1 - 2 / 8.0) / right.mass(), right.velocityX(), 1e-4);
    assertEquals(0, right.velocityY(), 1e-5);
    assertEquals(40 * 2 * (1 - 2.5 / 8) / above.mass(), above.velocityY(), 1e-4);
    assertEquals(0, far.velocityX());
    assertEquals(0, right.angularVelocity(), 1e-5);
  }

  @Test
  void explosionInsideThrowsOutwards() {
    Body<String> b = box(0.5f, 0, 1, 1);
    new Explosion(0, 0, 8).impulse(40).explode(world);
    world.step(DT);
    assertTrue(b.velocityX() > 10 && Math.abs(b.velocityY()) < 1e-3f, b.velocityX() + "");
  }

  @Test
  void staticsGiveShelterAndFiltersSpare() {
    Body<String> hidden = box(5, 0, .5f, .5f);
    Body<String> open = box(-5, 0, .5f, .5f);
    Body<String> spared =
        world.createBody(
            new BodyDef(BodyType.DYNAMIC)
                .shape(new Circle(.5f), Material.DEFAULT, new Filter(4, -1))
                .position(0, 5),
            null);
    world.createBody(new BodyDef().shape(new Box(.1f, 2)).position(2, 0), "wall");
    Explosion bang = new Explosion(0, 0, 10).impulse(10).categories(~4);
    bang.blockedByStatics(true).explode(world);
    world.step(DT);
    assertEquals(0, hidden.velocityX());
    assertTrue(open.velocityX() < -1);
    assertEquals(0, spared.velocityY());
    bang.blockedByStatics(false).explode(world);
    world.step(DT);
    assertTrue(hidden.velocityX() > 1);
  }

  @Test
  void badNumbersAreNamed() {
    assertNames("radius=0.0", () -> new Explosion(0, 0, 0));
    assertNames("impulse=NaN", () -> new Explosion(0, 0, 1).impulse(Float.NaN));
    assertNames("range=-1.0", () -> new Attractor(0, 0, -1));
    assertNames(
        "minimumRadius=0.0", () -> new Attractor(0, 0, 1).falloff(Attractor.Falloff.LINEAR, 0));
    assertNames("rate=-2.0", () -> AreaEffect.wind(new Aabb(), 0, 0, -2));
  }

  private static void assertNames(String what, Runnable call) {
    String message = assertThrows(IllegalArgumentException.class, call::run).getMessage();
    assertTrue(message.contains(what), message);
  }
}
