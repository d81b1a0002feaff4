package carom.physics.mover;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.physics.Body;
import carom.physics.BodyDef;
import carom.physics.BodyType;
import carom.physics.World;
import carom.physics.WorldDef;
import carom.physics.WorldState;
import carom.physics.geometry.Box;
import carom.physics.geometry.Chain;
import carom.physics.geometry.Circle;
import carom.physics.geometry.Polygon;
import carom.physics.geometry.Shape;
import org.junit.jupiter.api.Test;

/** What a mover does in closed form: its speed, steps, slopes, platforms and pushes. */
final class MoverTest {
  private static final float DT = 1 / 60f;
  private static final float SKIN = 0.005f;

  /** Height of the middle of a mover that stands on level ground at 0. */
  private static final float STANDS = 0.9f + SKIN;

  private final World<String> world = new World<>(new WorldDef());

  private Body<String> still(float x, float y, Shape shape) {
    return world.createBody(new BodyDef(BodyType.STATIC).position(x, y).shape(shape), "static");
  }

  private static MoverDef<String> def() {
    return new MoverDef<>(1.8f, 0.3f);
  }

  private Mover<String> mover(MoverDef<String> def, float x, float y) {
    Mover<String> mover = new Mover<>(world, def);
    mover.setPosition(x, y);
    for (int i = 0; i < 120 && !mover.isOnGround(); i++) {
      fall(mover, 0);
    }
    return mover;
  }

  /** Moves as a game does: gravity in the air, none on the ground. */
  private static void fall(Mover<String> mover, float walk) {
    float vy = mover.isOnGround() ? 0 : mover.velocityY() - 10 * DT;
    mover.move(walk, vy, DT);
  }

  private void floor() {
    still(0, -1, new Box(200, 1));
  }

  /** Ground that rises to the right of 0 at an angle, level on the left. */
  private void slope(double degrees) {
    double a = Math.toRadians(degrees);
    float x = (float) (100 * Math.cos(a));
    float y = (float) (100 * Math.sin(a));
    still(0, 0, Chain.open(-50, 0, 0, 0, x, y));
  }

  @Test
  void aWalkOnLevelGroundHasTheExactSpeed() {
    floor();
    Mover<String> mover = mover(def(), 0, 1);
    float start = mover.x();
    float height = mover.y();
    assertEquals(STANDS, height, 1e-4f);
    for (int i = 0; i < 600; i++) {
      fall(mover, 7);
      assertTrue(mover.isOnGround());
      assertEquals(height, mover.y(), 1e-6f);
      assertEquals(7, mover.velocityX(), 1e-5f);
    }
    assertEquals(start + 70, mover.x(), 1e-3f);
  }

  @Test
  void rowsOfBoxesHaveNoEdges() {
    for (int i = -5; i < 100; i++) {
      still(i, -0.5f, new Box(0.5f, 0.5f));
    }
    Mover<String> mover = mover(def(), 0, 1);
    float start = mover.x();
    for (int i = 0; i < 600; i++) {
      fall(mover, 9);
      assertEquals(STANDS, mover.y(), 1e-4f, "tick " + i);
      assertFalse(mover.isAtWall());
    }
    assertEquals(start + 90, mover.x(), 2e-3f);
  }

  @Test
  void turnedRowsOfBoxesHaveNoEdges() {
    float a = 0.3f;
    for (int i = -5; i < 100; i++) {
      world.createBody(
          new BodyDef(BodyType.STATIC)
              .position((float) (i * Math.cos(a)), (float) (i * Math.sin(a)))
              .angle(a)
              .shape(new Box(0.5f, 0.5f)),
          "row");
    }
    Mover<String> mover = mover(def(), 1, 3);
    float x = mover.x();
    float y = mover.y();
    for (int i = 0; i < 600; i++) {
      fall(mover, 9);
      assertTrue(mover.isOnGround(), "tick " + i);
    }
    assertEquals(90 * Math.cos(a), mover.x() - x, 0.01);
    assertEquals(90 * Math.sin(a), mover.y() - y, 0.01);
  }

  @Test
  void aWalkGoesUpAndDownStepsOfItsHeightAndKeepsItsSpeed() {
    floor();
    for (float step : new float[] {0.05f, 0.15f, 0.25f, 0.3f}) {
      Body<String> block = still(5, step - 0.5f, new Box(2, 0.5f));
      Mover<String> mover = mover(def(), 0, 1);
      float start = mover.x();
      float highest = 0;
      for (int i = 0; i < 120; i++) {
        fall(mover, 5);
        highest = Math.max(highest, mover.y());
        assertTrue(mover.isOnGround(), "step=" + step + " tick " + i);
      }
      assertEquals(STANDS + step, highest, 1e-3f, "step=" + step);
      assertEquals(STANDS, mover.y(), 1e-3f, "step=" + step);
      assertEquals(start + 10, mover.x(), 0.05f, "step=" + step);
      world.destroyBody(block);
    }
  }

  @Test
  void higherStepsAreWalls() {
    floor();
    for (float step : new float[] {0.302f, 0.35f, 0.5f, 1, 3}) {
      Body<String> block = still(5, step - 2, new Box(2, 2));
      for (float speed : new float[] {0.5f, 5, 40}) {
        Mover<String> mover = mover(def(), 0, 1);
        for (int i = 0; i < 600; i++) {
          fall(mover, speed);
        }
        assertEquals(STANDS, mover.y(), 1e-3f, "step=" + step + " speed=" + speed);
        assertEquals(3 - 0.3f - SKIN, mover.x(), 0.02f, "step=" + step + " speed=" + speed);
        assertTrue(mover.isAtWall());
        assertEquals(0, mover.velocityX(), 1e-4f);
      }
      world.destroyBody(block);
    }
  }

  @Test
  void aStepUnderALowCeilingIsAWall() {
    floor();
    still(5, 0.25f - 1, new Box(2, 1));
    Body<String> ceiling = still(5, 3, new Box(3, 1));
    Mover<String> mover = mover(def(), 0, 1);
    for (int i = 0; i < 60; i++) {
      fall(mover, 5);
    }
    assertTrue(mover.x() < 3, "at most its rounding is over the edge");
    assertTrue(mover.isAtWall() || mover.isAtCeiling());
    assertEquals(0, mover.velocityX(), 1e-4f);
    world.destroyBody(ceiling);
    fall(mover, 5);
    for (int i = 0; i < 30; i++) {
      fall(mover, 5);
    }
    assertEquals(STANDS + 0.25f, mover.y(), 1e-3f);
  }

  @Test
  void slopesEndAtTheGreatestAngle() {
    for (double limit : new double[] {20, 45, 60}) {
      for (double off : new double[] {-0.5, 0.5}) {
        World<String> w = new World<>(new WorldDef());
        double a = Math.toRadians(limit + off);
        float x = (float) (100 * Math.cos(a));
        float y = (float) (100 * Math.sin(a));
        w.createBody(new BodyDef(BodyType.STATIC).shape(Chain.open(-50, 0, 0, 0, x, y)), "slope");
        Mover<String> mover =
            new Mover<>(w, def().maxSlope((float) Math.toRadians(limit)).stepHeight(0.1f));
        mover.setPosition(-2, 1.2f);
        for (int i = 0; i < 240; i++) {
          fall(mover, 3);
        }
        String which = "limit " + limit + " slope " + (limit + off) + " " + mover.y();
        if (off < 0) {
          assertTrue(mover.y() > 3, which);
          assertEquals(3, Math.hypot(mover.velocityX(), mover.velocityY()), 1e-3, which);
          assertEquals(Math.cos(a), mover.groundNormalY(), 1e-4, which);
        } else {
          assertTrue(mover.y() < STANDS + 0.15f, which);
        }
      }
    }
  }

  @Test
  void aMoverThatStandsOnASlopeStaysThere() {
    slope(40);
    Mover<String> mover = mover(def(), 3, 5);
    float x = mover.x();
    float y = mover.y();
    for (int i = 0; i < 3600; i++) {
      fall(mover, 0);
    }
    assertEquals(x, mover.x(), 1e-5f);
    assertEquals(y, mover.y(), 1e-5f);
    assertTrue(mover.isOnGround());
  }

  @Test
  void aWalkDownASlopeStaysOnItAndHasTheSpeed() {
    slope(40);
    Mover<String> mover = mover(def(), 20, 30);
    float x = mover.x();
    for (int i = 0; i < 120; i++) {
      fall(mover, -6);
      assertTrue(mover.isOnGround(), "tick " + i);
    }
    assertEquals(-12 * Math.cos(Math.toRadians(40)), mover.x() - x, 0.01);
  }

  @Test
  void aSteepSlopeIsSlidDownAsOnIce() {
    slope(70);
    Mover<String> mover = new Mover<>(world, def());
    mover.setPosition(8, 28);
    while (mover.velocityX() == 0) {
      fall(mover, 0);
    }
    float x = mover.x();
    float y = mover.y();
    for (int i = 0; i < 40; i++) {
      mover.move(mover.velocityX(), mover.velocityY() - 10 * DT, DT);
      assertFalse(mover.isOnGround());
    }
    assertEquals(Math.tan(Math.toRadians(70)), (mover.y() - y) / (mover.x() - x), 0.02);
  }

  @Test
  void aMoverInAWedgeIsAtRest() {
    for (double degrees : new double[] {30, 60, 75}) {
      World<String> w = new World<>(new WorldDef());
      double a = Math.toRadians(degrees);
      float x = (float) (20 * Math.cos(a));
      float y = (float) (20 * Math.sin(a));
      w.createBody(new BodyDef(BodyType.STATIC).shape(Chain.open(-x, y, 0, 0, x, y)), "wedge");
      Mover<String> mover = new Mover<>(w, def());
      mover.setPosition(0.4f, 5);
      for (int i = 0; i < 300; i++) {
        mover.move(0, mover.isOnGround() ? 0 : -4, DT);
      }
      float restX = mover.x();
      float restY = mover.y();
      for (int i = 0; i < 300; i++) {
        mover.move(0, mover.isOnGround() ? 0 : -4, DT);
        assertEquals(restX, mover.x(), 1e-4f, "degrees " + degrees + " tick " + i);
        assertEquals(restY, mover.y(), 1e-4f, "degrees " + degrees + " tick " + i);
      }
      for (int i = 0; i < 300 && degrees > 50; i++) {
        mover.move(i % 2 == 0 ? 5 : -5, -4, DT);
        assertEquals(restX, mover.x(), 1e-3f, "degrees " + degrees + " tick " + i);
        assertEquals(restY, mover.y(), 1e-3f, "degrees " + degrees + " tick " + i);
      }
    }
  }

  @Test
  void aSlopingCeilingStopsAWalkWithoutPushingItIntoTheGround() {
    floor();
    still(0, 0, Polygon.of(3, 3, 15, 0.5f, 15, 3));
    Mover<String> mover = mover(def(), 0, 1);
    float last = -1;
    for (int i = 0; i < 300; i++) {
      fall(mover, 5);
      assertEquals(STANDS, mover.y(), 1e-3f, "tick " + i);
      assertTrue(mover.x() >= last - 1e-4f, "tick " + i);
      last = mover.x();
    }
    assertTrue(last > 4 && last < 9, "x=" + last);
  }

  @Test
  void nothingIsPassedAtHundredMetresPerSecond() {
    floor();
    still(30, 2, new Box(0.01f, 2));
    still(-30, 0, Chain.open(0, 4, 0, 0));
    still(0, 20, new Box(40, 0.01f));
    Mover<String> right = mover(def(), 0, 1);
    Mover<String> left = mover(def(), 0, 1);
    Mover<String> up = mover(def(), 0, 1);
    for (int i = 0; i < 60; i++) {
      fall(right, 100);
      fall(left, -100);
      up.move(0, 100, DT);
    }
    assertEquals(30 - 0.01f - 0.3f - SKIN, right.x(), 1e-3f);
    assertEquals(-30 + 0.3f + SKIN, left.x(), 1e-3f);
    assertEquals(20 - 0.01f - 0.9f - SKIN, up.y(), 1e-3f);
    assertTrue(up.isAtCeiling());
    assertEquals(STANDS, right.y(), 1e-3f);
    Mover<String> falls = new Mover<>(world, def());
    falls.setPosition(5, 15);
    for (int i = 0; i < 30; i++) {
      falls.move(0, falls.isOnGround() ? 0 : -100, DT);
    }
    assertEquals(STANDS, falls.y(), 1e-3f);
    assertTrue(falls.isOnGround());
  }

  @Test
  void aJumpFollowsItsParabola() {
    floor();
    Mover<String> mover = mover(def(), 0, 1);
    mover.move(3, 6, DT);
    assertFalse(mover.isOnGround());
    float vy = 6;
    double y = STANDS + 6 * DT;
    for (int i = 0; i < 60; i++) {
      vy -= 10 * DT;
      y += vy * DT;
      mover.move(3, vy, DT);
      assertEquals(y, mover.y(), 1e-3, "tick " + i);
    }
    for (int i = 0; i < 30; i++) {
      fall(mover, 3);
    }
    assertEquals(STANDS, mover.y(), 1e-4f);
    assertTrue(mover.isOnGround());
  }

  @Test
  void aLedgeFartherDownThanTheSnapDistanceIsFallenFrom() {
    floor();
    still(-10, 0.5f, new Box(10, 0.5f));
    Mover<String> mover = mover(def().snapDistance(0.2f), -3, 3);
    boolean flew = false;
    for (int i = 0; i < 120; i++) {
      fall(mover, 4);
      flew |= !mover.isOnGround();
    }
    assertTrue(flew);
    assertEquals(STANDS, mover.y(), 1e-3f);
  }

  private Body<String> platform(float x, float y, Shape shape) {
    return world.createBody(
        new BodyDef(BodyType.KINEMATIC).position(x, y).sleepAllowed(false).shape(shape),
        "platform");
  }

  @Test
  void platformsThatMoveCarryWithoutDrift() {
    Body<String> platform = platform(0, 0, new Box(3, 0.25f));
    Mover<String> mover = mover(def(), 1, 2);
    float dx = mover.x() - platform.x();
    float dy = mover.y() - platform.y();
    for (int i = 0; i < 3600; i++) {
      double t = i * DT;
      platform.setVelocity((float) (4 * Math.cos(t)), (float) (3 * Math.sin(2.3 * t)));
      world.step(DT);
      fall(mover, 0);
      assertTrue(mover.isOnGround(), "tick " + i);
      assertSame(platform, mover.ground());
      assertEquals(dx, mover.x() - platform.x(), 1e-4f, "tick " + i);
      assertEquals(dy, mover.y() - platform.y(), 1e-4f, "tick " + i);
      assertEquals(platform.velocityX(), mover.velocityX(), 1e-4f);
    }
  }

  @Test
  void platformsThatTurnCarryWithoutDrift() {
    Body<String> platform = platform(0, 0, new Box(5, 0.25f));
    Mover<String> mover = mover(def(), 3, 2);
    float start = mover.x();
    for (int i = 0; i < 3600; i++) {
      float w = (float) (0.6 * Math.cos(2 * i * DT));
      platform.setAngularVelocity(w);
      world.step(DT);
      fall(mover, 0);
      assertTrue(mover.isOnGround(), "tick " + i);
      float foot = mover.x() * platform.cos() + (mover.y() - 0.6f) * platform.sin();
      assertEquals(start, foot, 5e-3f, "tick " + i);
    }
  }

  @Test
  void aWalkOnAPlatformIsRelativeToIt() {
    Body<String> platform = platform(0, 0, new Box(30, 0.25f));
    platform.setVelocity(2, 0);
    Mover<String> mover = mover(def(), -5, 2);
    float start = mover.x() - platform.x();
    for (int i = 0; i < 300; i++) {
      world.step(DT);
      fall(mover, 3);
    }
    assertEquals(start + 15, mover.x() - platform.x(), 2e-3f);
    assertEquals(5, mover.velocityX(), 1e-4f);
    mover.move(3, 5, DT);
    assertEquals(5, mover.velocityX(), 1e-4f, "a jump takes the platform's velocity along");
    assertEquals(5, mover.velocityY(), 1e-4f);
  }

  @Test
  void aLiftAgainstACeilingCrushes() {
    still(0, 4, new Box(5, 1));
    Body<String> lift = platform(0, 0, new Box(3, 0.25f));
    Mover<String> mover = mover(def(), 0, 2);
    boolean crushed = false;
    lift.setVelocity(0, 1);
    for (int i = 0; i < 90; i++) {
      world.step(DT);
      fall(mover, 0);
      crushed |= mover.isCrushed();
    }
    assertTrue(crushed);
    lift.setVelocity(0, -1);
    for (int i = 0; i < 60; i++) {
      world.step(DT);
      fall(mover, 0);
    }
    assertFalse(mover.isCrushed());
    assertTrue(mover.isOnGround());
    assertEquals(lift.y() + 0.25f + STANDS, mover.y(), 1e-3f);
  }

  @Test
  void aWallThatComesPushesTheMoverAlong() {
    floor();
    Body<String> wall = platform(-3, 2, new Box(0.5f, 1.5f));
    Mover<String> mover = mover(def(), 0, 1);
    wall.setVelocity(2, 0);
    for (int i = 0; i < 180; i++) {
      world.step(DT);
      fall(mover, 0);
    }
    assertEquals(wall.x() + 0.5f + 0.3f + SKIN, mover.x(), 2e-3f);
    assertEquals(STANDS, mover.y(), 2e-3f);
  }

  @Test
  void pushesHaveABoundedImpulse() {
    still(0, -1, new Box(200, 1));
    Body<String> crate =
        world.createBody(
            new BodyDef(BodyType.DYNAMIC)
                .position(2, 0.5f)
                .fixedRotation(true)
                .shape(new Box(0.5f, 0.5f), new carom.physics.Material(100, 0, 0)),
            "crate");
    Mover<String> weak = mover(def().pushForce(50), 0, 1);
    for (int i = 0; i < 60 && !weak.isAtWall(); i++) {
      fall(weak, 5);
      world.step(DT);
    }
    float before = crate.velocityX();
    for (int i = 0; i < 30; i++) {
      world.step(DT);
      float start = crate.velocityX();
      fall(weak, 5);
      world.step(DT);
      assertTrue(
          (crate.velocityX() - start) * crate.mass() <= 50 * DT * 1.001f, "at most force times dt");
    }
    assertTrue(crate.velocityX() > before + 0.1f);
    Mover<String> strong = mover(def().pushForce(1e6f), crate.x() - 2, 1);
    for (int i = 0; i < 120; i++) {
      fall(strong, 5);
      world.step(DT);
    }
    assertEquals(5, crate.velocityX(), 0.05f, "never faster than the mover");
    assertTrue(crate.x() - strong.x() > 0.79f);
  }

  @Test
  void withoutAForceACrateIsAWallAndStaysAsleep() {
    floor();
    Body<String> crate =
        world.createBody(
            new BodyDef(BodyType.DYNAMIC).position(2, 0.5f).shape(new Box(0.5f, 0.5f)), "crate");
    for (int i = 0; i < 120; i++) {
      world.step(DT);
    }
    assertFalse(crate.awake());
    float x = crate.x();
    Mover<String> mover = mover(def(), 0, 1);
    for (int i = 0; i < 120; i++) {
      fall(mover, 5);
      world.step(DT);
    }
    assertFalse(crate.awake());
    assertEquals(x, crate.x());
    assertEquals(x - 0.8f - SKIN, mover.x(), 0.01f);
  }

  @Test
  void aMoverWeighsOnWhatItStandsOn() {
    Body<String> seesaw =
        world.createBody(
            new BodyDef(BodyType.DYNAMIC).position(0, 0).shape(new Box(3, 0.1f)), "seesaw");
    world.createJoint(carom.physics.JointDef.revolute(null, seesaw, 0, 0));
    Mover<String> mover = mover(def().weight(700), 2, 1.5f);
    for (int i = 0; i < 20; i++) {
      world.step(DT);
      fall(mover, 0);
    }
    assertTrue(seesaw.angle() < -0.02f, "angle=" + seesaw.angle());
  }

  @Test
  void aOneWayPlatformIsPassedFromBelowAndCarriesFromAbove() {
    floor();
    still(0, 2, new Box(3, 0.1f));
    MoverDef<String> def = def().oneWay((body, shape) -> body.y() == 2);
    Mover<String> mover = mover(def, 0, 1);
    mover.move(0, 9, DT);
    float highest = 0;
    for (int i = 0; i < 120; i++) {
      fall(mover, 0);
      highest = Math.max(highest, mover.y());
    }
    assertTrue(highest > 3.5f, "highest=" + highest);
    assertEquals(2.1f + STANDS, mover.y(), 1e-3f);
    mover.setFilter((body, shape) -> body.y() != 2);
    for (int i = 0; i < 60; i++) {
      fall(mover, 0);
    }
    assertEquals(STANDS, mover.y(), 1e-3f, "a filter lets it drop through");
  }

  @Test
  void aOneWayLiftThatComesFromBelowTakesTheMoverAlong() {
    Body<String> lift = platform(0, 0, new Box(3, 0.1f));
    lift.setVelocity(0, 6);
    Mover<String> mover = new Mover<>(world, def().oneWay((body, shape) -> true));
    mover.setPosition(0, 5);
    for (int i = 0; i < 120; i++) {
      world.step(DT);
      fall(mover, 0);
    }
    assertTrue(mover.isOnGround());
    assertEquals(lift.y() + 0.1f + STANDS, mover.y(), 1e-3f);
  }

  @Test
  void aMoverThatIsPutOnTheGroundFindsIt() {
    floor();
    Mover<String> mover = new Mover<>(world, def());
    mover.setPosition(3, STANDS);
    assertTrue(mover.findGround());
    assertEquals(1, mover.groundNormalY());
    mover.setPosition(3, STANDS + 0.1f);
    assertFalse(mover.findGround());
    mover.setPosition(3, STANDS);
    mover.findGround();
    fall(mover, 6);
    assertEquals(3.1f, mover.x(), 1e-5f);
  }

  @Test
  void overlapIsLeftByTheShortestWay() {
    floor();
    still(3, 3, new Box(1, 1));
    Mover<String> mover = new Mover<>(world, def());
    mover.setPosition(1.9f, 3);
    mover.move(0, 0, DT);
    assertEquals(2 - 0.3f - SKIN, mover.x(), 1e-3f);
    assertEquals(3, mover.y(), 1e-3f);
    mover.setPosition(2.2f, 3);
    mover.move(0, 0, DT);
    assertEquals(2 - 0.3f - SKIN, mover.x(), 1e-3f);
    mover.setPosition(-5, 0.7f);
    mover.move(0, 0, DT);
    assertEquals(STANDS, mover.y(), 1e-3f);
  }

  @Test
  void aMoverStandsUprightUnderAnyGravity() {
    still(0, 0, new Circle(10));
    float angle = 2.1f;
    float ux = (float) Math.cos(angle);
    float uy = (float) Math.sin(angle);
    Mover<String> mover = new Mover<>(world, def().up(ux, uy));
    mover.setPosition(12 * ux, 12 * uy);
    for (int i = 0; i < 60; i++) {
      mover.move(-5 * ux, -5 * uy, DT);
    }
    assertTrue(mover.isOnGround());
    assertEquals(10 + STANDS, Math.hypot(mover.x(), mover.y()), 1e-3);
  }

  @Test
  void aStateThatIsWrittenBackGoesOnToTheBit() {
    floor();
    Body<String> platform = platform(4, 0.1f, new Box(2, 0.1f));
    platform.setVelocity(0.5f, 0.2f);
    Mover<String> mover = mover(def(), 0, 1);
    for (int i = 0; i < 60; i++) {
      world.step(DT);
      fall(mover, 5);
    }
    int[] saved = new int[Mover.INTS];
    mover.readRow(saved, 0);
    WorldState state = world.save(null);
    int[][] first = new int[60][Mover.INTS];
    for (int i = 0; i < 60; i++) {
      world.step(DT);
      fall(mover, i % 20 - 10);
      mover.readRow(first[i], 0);
    }
    world.restore(state);
    Mover<String> other = new Mover<>(world, def());
    other.writeRow(saved, 0);
    int[] row = new int[Mover.INTS];
    for (int i = 0; i < 60; i++) {
      world.step(DT);
      fall(other, i % 20 - 10);
      other.readRow(row, 0);
      assertArrayEquals(first[i], row, "tick " + i);
    }
  }

  @Test
  void aStateThatIsNoneIsRefused() {
    Mover<String> mover = new Mover<>(world, def());
    int[] row = new int[Mover.INTS];
    mover.readRow(row, 0);
    for (int i = 0; i < Mover.INTS; i++) {
      int[] bad = row.clone();
      bad[i] = i == 7 ? -2 : i == 4 ? 99 : Float.floatToRawIntBits(Float.NaN);
      if (i != 8) {
        assertThrows(IllegalArgumentException.class, () -> mover.writeRow(bad, 0), "int " + i);
      }
    }
    mover.writeRow(row, 0);
  }

  @Test
  void groundThatIsDestroyedIsFallenFrom() {
    Body<String> ground = still(0, 0, new Box(2, 0.5f));
    Mover<String> mover = mover(def(), 0, 2);
    assertSame(ground, mover.ground());
    world.destroyBody(ground);
    assertNull(mover.ground());
    for (int i = 0; i < 10; i++) {
      fall(mover, 0);
    }
    assertFalse(mover.isOnGround());
    assertTrue(mover.y() < 1.4f);
  }
}
