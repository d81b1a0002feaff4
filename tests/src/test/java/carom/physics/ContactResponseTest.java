package carom.physics;

import static carom.physics.Scenes.DT;
import static carom.physics.Scenes.box;
import static carom.physics.Scenes.disc;
import static carom.physics.Scenes.steps;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.physics.geometry.Box;
import carom.physics.geometry.Circle;
import carom.physics.geometry.Compound;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Collisions, friction and stacks against closed forms. */
final class ContactResponseTest {
  /** v1' = (m1 v1 + m2 v2 - m2 e (v1 - v2)) / (m1 + m2), and the mirror image. */
  @ParameterizedTest
  @CsvSource({"1,1,1", "1,1,0", "1,3,1", "3,1,0.5", "1,100,1", "2,1,0"})
  void headOnCollisionExchangesMomentum(float m1, float m2, float e) {
    World<String> w = Scenes.space();
    float area = (float) Math.PI * .25f;
    Body<String> a = disc(w, -1, 0, .5f, new Material(m1 / area, 0, e));
    Body<String> b = disc(w, 1, 0, .5f, new Material(m2 / area, 0, e));
    a.setVelocity(4, 0);
    b.setVelocity(-2, 0);
    steps(w, 60);
    double p = m1 * 4 - m2 * 2;
    assertEquals((p - m2 * e * 6) / (m1 + m2), a.velocityX(), 2e-3);
    assertEquals((p + m1 * e * 6) / (m1 + m2), b.velocityX(), 2e-3);
    assertEquals(0, a.velocityY(), 1e-6);
  }

  /** Only the component along the line of centres is exchanged. */
  @Test
  void obliqueDiscsExchangeNormalVelocityOnly() {
    World<String> w = Scenes.space();
    Material m = new Material(1, 0, 1);
    Body<String> a = disc(w, -1, 0, .5f, m);
    Body<String> b = disc(w, 0, .6f, .5f, m);
    a.setVelocity(3, 0);
    steps(w, 60);
    double p = a.velocityX() + b.velocityX();
    assertEquals(3, p, 1e-4);
    assertEquals(0, a.velocityY() + b.velocityY(), 1e-4);
    double energy =
        Math.pow(a.velocityX(), 2)
            + Math.pow(a.velocityY(), 2)
            + Math.pow(b.velocityX(), 2)
            + Math.pow(b.velocityY(), 2);
    assertEquals(9, energy, 1e-3);
    double dot = a.velocityX() * b.velocityX() + a.velocityY() * b.velocityY();
    assertEquals(0, dot, 1e-3, "equal masses part at a right angle");
  }

  @ParameterizedTest
  @ValueSource(floats = {1, 0.8f, 0.5f, 0.3f})
  void bounceHeightIsRestitutionSquaredTimesDropHeight(float e) {
    World<String> w = Scenes.floor(Material.DEFAULT);
    Body<String> b = disc(w, 0, 5.5f, .5f, new Material(1, 0, e));
    double expected = 5;
    double top = 0;
    int bounces = 0;
    boolean rising = false;
    for (int i = 0; i < 600 && bounces < 3; i++) {
      w.step(DT);
      if (b.velocityY() > 0) {
        rising = true;
        top = Math.max(top, b.y() - .5);
      } else if (rising) {
        rising = false;
        expected *= e * e;
        bounces++;
        if (expected > 0.1) {
          assertEquals(expected, top, 0.01 * expected + 0.002, "bounce " + bounces);
        }
        top = 0;
      }
    }
  }

  @Test
  void slowApproachDoesNotBounce() {
    World<String> w = Scenes.floor(Material.DEFAULT);
    Body<String> b = disc(w, 0, .53f, .5f, new Material(1, 0, 1));
    steps(w, 60);
    assertEquals(.5, b.y(), 0.005);
    assertEquals(0, b.velocityY(), 1e-3);
  }

  /** Gravity is tilted instead of the floor: the same physics. */
  @Test
  void restsOnSlopeBelowFrictionAngle() {
    double angle = Math.atan(0.5) - 0.02;
    World<String> w = slope(angle);
    Body<String> b = box(w, 0, .5f, .5f, .5f, new Material(1, .5f, 0));
    steps(w, 300);
    assertEquals(0, b.x(), 0.01);
    assertEquals(0, b.velocityX(), 1e-3);
  }

  /** Above it the acceleration is g (sin - mu cos), once the contact carries the weight. */
  @Test
  void slidesOnSlopeAboveFrictionAngle() {
    double angle = Math.atan(0.5) + 0.1;
    World<String> w = slope(angle);
    Body<String> b = box(w, 0, .5f, .5f, .5f, new Material(1, .5f, 0));
    steps(w, 20);
    float v = b.velocityX();
    steps(w, 120);
    double a = 10 * (Math.sin(angle) - 0.5 * Math.cos(angle));
    assertEquals(2 * a, b.velocityX() - v, 0.01 * 2 * a);
  }

  /** The floor itself is turned: rotated boxes take the general path. */
  @Test
  void turnedFloorActsAsTurnedGravity() {
    double angle = Math.atan(0.5) + 0.1;
    World<String> w = new World<>(new WorldDef());
    Material m = new Material(1, .5f, 0);
    w.createBody(new BodyDef().shape(new Box(100, 1), m).angle((float) -angle), null);
    float d = 1.5f;
    Body<String> b =
        w.createBody(
            new BodyDef(BodyType.DYNAMIC)
                .shape(new Box(.5f, .5f), m)
                .position(d * (float) Math.sin(angle), d * (float) Math.cos(angle))
                .angle((float) -angle),
            null);
    steps(w, 20);
    double v = Math.hypot(b.velocityX(), b.velocityY());
    steps(w, 120);
    double a = 10 * (Math.sin(angle) - 0.5 * Math.cos(angle));
    assertEquals(2 * a, Math.hypot(b.velocityX(), b.velocityY()) - v, 0.01 * 2 * a);
  }

  private static World<String> slope(double angle) {
    World<String> w =
        new World<>(
            new WorldDef()
                .withGravity((float) (10 * Math.sin(angle)), (float) (-10 * Math.cos(angle))));
    w.createBody(
        new BodyDef().shape(new Box(100, 1), new Material(1, .5f, 0)).position(0, -1), "floor");
    return w;
  }

  @Test
  void slidingBoxStopsAfterTheStoppingDistance() {
    World<String> w = Scenes.floor(new Material(1, .4f, 0));
    Body<String> b = box(w, 0, .2f, 1, .2f, new Material(1, .4f, 0));
    b.setVelocity(6, 0);
    steps(w, 180);
    double expected = 36 / (2 * .4 * 10);
    assertEquals(expected, b.x(), 0.02 * expected);
    assertEquals(0, b.velocityX(), 1e-3);
  }

  /** Rolling without slipping down a slope: a = 2/3 g sin. */
  @Test
  void discRollsWithTwoThirdsOfTheAcceleration() {
    double angle = 0.2;
    World<String> w = slope(angle);
    Body<String> b = disc(w, 0, .5f, .5f, new Material(1, .5f, 0));
    steps(w, 120);
    double v = 2 * 10 * Math.sin(angle) * 2 / 3;
    assertEquals(v, b.velocityX(), 0.02 * v);
    assertEquals(-v / .5, b.angularVelocity(), 0.02 * v / .5);
  }

  @Test
  void tenBoxesRestForAMinute() {
    World<String> w = Scenes.stack(10);
    Body<String> top = w.body(10);
    steps(w, 120);
    float y = top.y();
    float x = top.x();
    steps(w, 3480);
    assertEquals(y, top.y(), 0.01);
    assertEquals(x, top.x(), 0.01);
    assertEquals(9.5, top.y(), 0.06);
    assertTrue(Scenes.kineticEnergy(w) < 1e-4, "energy " + Scenes.kineticEnergy(w));
  }

  @Test
  void twentyBoxesRest() {
    World<String> w = Scenes.stack(20);
    steps(w, 1200);
    assertEquals(19.5, w.body(20).y(), 0.2);
    assertEquals(0, w.body(20).x(), 0.1);
    assertTrue(Scenes.kineticEnergy(w) < 1e-3, "energy " + Scenes.kineticEnergy(w));
  }

  @Test
  void pyramidOfTwentyRowsStands() {
    World<String> w = Scenes.pyramid(20);
    steps(w, 600);
    assertEquals(19.5, w.body(w.bodyCount() - 1).y(), 0.2);
    assertTrue(Scenes.kineticEnergy(w) < 1e-2, "energy " + Scenes.kineticEnergy(w));
    assertTrue(Scenes.deepest(w) < 0.02, "overlap " + Scenes.deepest(w));
  }

  @Test
  void pileComesToRestWithoutDeepOverlap() {
    World<String> w = Scenes.pile(120, 7);
    steps(w, 900);
    assertTrue(Scenes.deepest(w) < 0.02, "overlap " + Scenes.deepest(w));
    assertTrue(Scenes.kineticEnergy(w) < 1, "energy " + Scenes.kineticEnergy(w));
    w.forEachBody(b -> assertTrue(b.y() > -1.1 && Math.abs(b.x()) < 7, b.toString()));
  }

  @Test
  void gasKeepsMomentumAndEnergy() {
    World<String> w = new World<>(new WorldDef().withGravity(0, 0).withRestitutionThreshold(0));
    Scenes.Rng r = new Scenes.Rng(11);
    Material m = new Material(1, 0, 1);
    for (int i = 0; i < 100; i++) {
      int row = i / 10;
      float x = (i % 10 - 4.5f) * .7f;
      float y = (row - 4.5f) * .7f;
      disc(w, x, y, .25f, m).setVelocity(r.in(-3, 3), r.in(-3, 3));
    }
    double energy = Scenes.kineticEnergy(w);
    double[] before = momentum(w);
    steps(w, 300);
    double[] after = momentum(w);
    assertEquals(before[0], after[0], 1e-3);
    assertEquals(before[1], after[1], 1e-3);
    assertEquals(energy, Scenes.kineticEnergy(w), 0.05 * energy);
  }

  private static double[] momentum(World<?> w) {
    double[] p = new double[2];
    w.forEachBody(
        b -> {
          p[0] += b.mass() * b.velocityX();
          p[1] += b.mass() * b.velocityY();
        });
    return p;
  }

  @Test
  void closedGasKeepsItsEnergy() {
    World<String> w = Scenes.gas(16, 3, 0);
    double energy = Scenes.kineticEnergy(w);
    steps(w, 300);
    assertEquals(energy, Scenes.kineticEnergy(w), 0.01 * energy);
  }

  @Test
  void compoundBehavesLikeTheBoxItIsMadeOf() {
    World<String> w = Scenes.floor(Material.DEFAULT);
    Body<String> whole = box(w, -5, 2, 1, .5f, Material.DEFAULT);
    Body<String> halves =
        w.createBody(
            new BodyDef(BodyType.DYNAMIC)
                .shape(Compound.of(new Box(.5f, .5f, -.5f, 0), new Box(.5f, .5f, .5f, 0)))
                .position(5, 2),
            null);
    assertEquals(whole.mass(), halves.mass(), 1e-5);
    assertEquals(whole.inertia(), halves.inertia(), 1e-5);
    steps(w, 240);
    assertEquals(whole.y(), halves.y(), 2e-3);
    assertEquals(0, halves.angle(), 1e-3);
  }

  @Test
  void centreOfMassFollowsDensity() {
    World<String> w = Scenes.space();
    Body<String> b =
        w.createBody(
            new BodyDef(BodyType.DYNAMIC)
                .shape(new Box(.5f, .5f, -1, 0), new Material(1, 0, 0))
                .shape(new Circle(.5f, 1, 0), new Material(3, 0, 0)),
            null);
    double disc = 3 * Math.PI * .25;
    assertEquals(1 + disc, b.mass(), 1e-4);
    assertEquals((disc - 1) / (1 + disc), b.centerX(), 1e-5);
  }

  @Test
  void restsFarFromTheOriginAsWell() {
    World<String> w = new World<>(new WorldDef());
    w.createBody(new BodyDef().shape(new Box(10, 1)).position(30000, -1), null);
    Body<String> b = box(w, 30000, .5f, .5f, .5f, Material.DEFAULT);
    steps(w, 300);
    assertEquals(.5, b.y(), 0.01);
    assertEquals(0, b.velocityX(), 1e-3);
  }
}
