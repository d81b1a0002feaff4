package carom.physics;

import static carom.physics.Scenes.DT;
import static carom.physics.Scenes.box;
import static carom.physics.Scenes.steps;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.physics.archive.ArchiveReader;
import carom.physics.archive.ArchiveWriter;
import carom.physics.geometry.Box;
import carom.physics.geometry.Circle;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Points and vectors of a body's frame, velocities at points, and bodies moved to a target. */
class BodyFrameTest {
  private static final Material M = Material.DEFAULT;

  /** A body at (3, 4), a quarter turn on: its (1, 0) is the world's (0, 1). */
  @Test
  void aQuarterTurnTurnsPointsAndVectors() {
    World<String> w = Scenes.space();
    Body<String> b = box(w, 3, 4, 1, 1, M);
    b.setMass(1, 1, 0.5f, 0.25f);
    b.setPose(3, 4, 0, 1);
    assertEquals(3, b.worldPointX(0, 0), 1e-6);
    assertEquals(4, b.worldPointY(0, 0), 1e-6);
    assertEquals(1, b.worldPointX(7, 2), 1e-6);
    assertEquals(11, b.worldPointY(7, 2), 1e-6);
    assertEquals(-2, b.worldVectorX(7, 2));
    assertEquals(7, b.worldVectorY(7, 2));
    assertEquals(7, b.localPointX(1, 11), 1e-6);
    assertEquals(2, b.localPointY(1, 11), 1e-6);
    assertEquals(7, b.localVectorX(-2, 7));
    assertEquals(2, b.localVectorY(-2, 7));
  }

  @Test
  void thereAndBackIsTheSamePoint() {
    Random r = new Random(11);
    World<String> w = Scenes.space();
    Body<String> b = box(w, 0, 0, 1, 1, M);
    for (int i = 0; i < 200; i++) {
      b.setPose(r.nextFloat() * 20 - 10, r.nextFloat() * 20 - 10, r.nextFloat() * 7);
      float x = r.nextFloat() * 8 - 4;
      float y = r.nextFloat() * 8 - 4;
      float wx = b.worldPointX(x, y);
      float wy = b.worldPointY(x, y);
      assertEquals(x, b.localPointX(wx, wy), 1e-5);
      assertEquals(y, b.localPointY(wx, wy), 1e-5);
      double angle = Math.atan2(b.sin(), b.cos());
      assertEquals(b.x() + Math.cos(angle) * x - Math.sin(angle) * y, wx, 1e-4);
      assertEquals(b.y() + Math.sin(angle) * x + Math.cos(angle) * y, wy, 1e-4);
    }
  }

  /**
   * The rim of a disc that rolls without slipping rests on the ground and is twice as fast above.
   */
  @Test
  void theVelocityAtAPointIsThatOfARollingRim() {
    World<String> w = Scenes.space();
    Body<String> b = Scenes.disc(w, 5, 2, 0.5f, M);
    b.setVelocity(3, 0);
    b.setAngularVelocity(-6);
    assertEquals(0, b.velocityAtX(5, 1.5f), 1e-6);
    assertEquals(6, b.velocityAtX(5, 2.5f), 1e-6);
    assertEquals(3, b.velocityAtY(4.5f, 2), 1e-6);
    assertThrows(IllegalArgumentException.class, () -> b.velocityAtX(Float.NaN, 0));
    w.destroyBody(b);
    assertThrows(IllegalStateException.class, () -> b.velocityAtY(0, 0));
    assertThrows(IllegalStateException.class, () -> b.worldPointX(0, 0));
    assertThrows(IllegalStateException.class, () -> b.localPointY(0, 0));
  }

  @ParameterizedTest
  @ValueSource(floats = {0.5f, 3.1f, -3.1f, 6.5f, 0})
  void aKinematicBodyReachesItsTargetInOneStep(float angle) {
    World<String> w = new World<>(new WorldDef());
    Body<String> b =
        w.createBody(
            new BodyDef(BodyType.KINEMATIC).position(1, 2).angle(0.25f).shape(new Box(1, 0.1f)),
            "b");
    b.moveTo(1.25f, 1.5f, angle, DT);
    w.step(DT);
    assertEquals(1.25, b.x(), 1e-6);
    assertEquals(1.5, b.y(), 1e-6);
    double off = Math.atan2(b.sin(), b.cos()) - angle;
    assertEquals(0, Math.IEEEremainder(off, 2 * Math.PI), 0.01);
    for (int i = 0; i < 40; i++) {
      b.moveTo(1.25f, 1.5f, angle, DT);
      w.step(DT);
    }
    assertEquals(0, b.velocityX());
    assertEquals(0, b.angularVelocity());
    assertFalse(b.awake());
    assertEquals(Math.cos(angle), b.cos(), 1e-5);
  }

  /** A lift that goes up 1 m in 60 steps carries what stands on it, and doesn't throw it up. */
  @Test
  void whatStandsOnALiftGoesWithIt() {
    World<String> w = new World<>(new WorldDef());
    Body<String> lift =
        w.createBody(
            new BodyDef(BodyType.KINEMATIC).position(0, -0.5f).shape(new Box(2, 0.5f)), "lift");
    Body<String> load = box(w, 0, 0.25f, 0.25f, 0.25f, M);
    steps(w, 30);
    for (int i = 1; i <= 120; i++) {
      lift.moveTo(0, -0.5f + Math.min(i, 60) / 60f, 0, DT);
      w.step(DT);
    }
    assertEquals(0.5, lift.y(), 1e-5);
    assertEquals(1.25, load.y(), 0.01);
    assertEquals(0, load.velocityY(), 0.01);
  }

  @Test
  void aTargetTooFarIsApproachedAtTheLimit() {
    World<String> w = new World<>(new WorldDef().withMaxSpeed(10));
    Body<String> b = w.createBody(new BodyDef(BodyType.KINEMATIC).shape(new Circle(1)), "b");
    b.moveTo(1e7f, 0, 0, DT);
    w.step(DT);
    assertEquals(10 / 60.0, b.x(), 1e-4);
    assertThrows(IllegalArgumentException.class, () -> b.moveTo(Float.NaN, 0, 0, DT));
    assertThrows(IllegalArgumentException.class, () -> b.moveTo(0, 2e7f, 0, DT));
    assertThrows(IllegalArgumentException.class, () -> b.moveTo(0, 0, 1e6f, DT));
    assertThrows(IllegalArgumentException.class, () -> b.moveTo(0, 0, 0, 0));
  }

  @Test
  void aStaticBodyStays() {
    World<String> w = Scenes.floor(M);
    long before = w.stateHash();
    w.body(0).moveTo(5, 5, 1, DT);
    assertEquals(before, w.stateHash());
  }

  /** Two blocks slide alike; the one that counts as at rest below 1 m/s falls asleep first. */
  @Test
  void aBodySleepsByItsOwnSpeed() {
    World<String> w = Scenes.space();
    Body<String> drowsy =
        w.createBody(
            new BodyDef(BodyType.DYNAMIC).shape(new Circle(1)).velocity(0.5f, 0).sleepSpeed(1),
            "drowsy");
    Body<String> lively = Scenes.disc(w, 0, 50, 1, M);
    Body<String> usual = Scenes.disc(w, 0, 90, 1, M);
    lively.setVelocity(0.02f, 0);
    usual.setVelocity(0.02f, 0);
    assertEquals(0.05f, lively.sleepSpeed());
    lively.setSleepSpeed(0.01f);
    assertEquals(0.01f, lively.sleepSpeed());
    assertEquals(1, drowsy.sleepSpeed());
    steps(w, 25);
    assertTrue(drowsy.awake());
    steps(w, 10);
    assertFalse(drowsy.awake());
    assertFalse(usual.awake());
    assertTrue(lively.awake());
    steps(w, 200);
    assertTrue(lively.awake());
    assertThrows(IllegalArgumentException.class, () -> lively.setSleepSpeed(-1));
    assertThrows(
        IllegalArgumentException.class, () -> new BodyDef(BodyType.DYNAMIC).sleepSpeed(Float.NaN));
  }

  @Test
  void anOwnSleepSpeedIsPartOfTheState() {
    World<String> w = Scenes.space();
    Body<String> b = box(w, 0, 0, 1, 1, M);
    long plain = w.stateHash();
    WorldState saved = w.save(null);
    b.setSleepSpeed(0.05f);
    long own = w.stateHash();
    assertTrue(plain != own);
    ArchiveWriter out = new ArchiveWriter();
    w.save(null).write(out);
    w.restore(saved);
    assertEquals(plain, w.stateHash());
    World<String> copy = new World<>(w.def());
    copy.restore(copy.read(new ArchiveReader(out.toBytes()), slot -> "copy"));
    assertEquals(own, copy.stateHash());
    assertEquals(0.05f, copy.body(0).sleepSpeed());
  }
}
