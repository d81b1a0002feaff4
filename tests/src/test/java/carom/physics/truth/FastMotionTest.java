package carom.physics.truth;

import static carom.physics.truth.Lab.DT;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.physics.Body;
import carom.physics.BodyDef;
import carom.physics.BodyType;
import carom.physics.Collision;
import carom.physics.CollisionListener;
import carom.physics.Filter;
import carom.physics.Material;
import carom.physics.ShapeDef;
import carom.physics.World;
import carom.physics.WorldDef;
import carom.physics.WorldState;
import carom.physics.geometry.Box;
import carom.physics.geometry.Circle;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** What moves farther in a step than it is large still meets all that is in its way. */
final class FastMotionTest {
  private static final int TRIES = 20;

  /** What is heard of sensors, in order. */
  private static List<String> hear(World<String> w) {
    List<String> heard = new ArrayList<>();
    w.listener(
        new CollisionListener<>() {
          @Override
          public void begin(Collision<String> c) {
            add("begin", c);
          }

          @Override
          public void end(Collision<String> c) {
            add("end", c);
          }

          private void add(String what, Collision<String> c) {
            if (c.isSensor()) {
              heard.add(what + " " + c.self().user() + "-" + c.other().user());
            }
          }
        });
    return heard;
  }

  private static Body<String> sensor(World<String> w, BodyDef def, double halfWidth) {
    return w.createBody(
        def.shape(new ShapeDef(new Box((float) halfWidth, 2)).withSensor(true)), "sensor");
  }

  private static Body<String> bullet(World<String> w, double x, double vx, boolean isBullet) {
    return w.createBody(
        new BodyDef(BodyType.DYNAMIC)
            .shape(new Circle(.1f))
            .bullet(isBullet)
            .position((float) x, 0)
            .velocity((float) vx, 0),
        "bullet");
  }

  private static List<String> once(List<String> heard) {
    String pair = heard.isEmpty() ? "" : heard.get(0).substring("begin ".length());
    return List.of("begin " + pair, "end " + pair);
  }

  /** A step of 5 m over 1 m: wherever the steps fall, the sensor hears of it once. */
  @ParameterizedTest
  @CsvSource({
    "300,.5,true",
    "300,.5,false",
    "-300,.5,true",
    "300,.05,true",
    "1500,.5,false",
    "20,.5,true"
  })
  void aSensorHearsOfAllThatCrossesIt(double speed, double halfWidth, boolean isBullet) {
    for (int i = 0; i < TRIES; i++) {
      World<String> w = Lab.space();
      sensor(w, new BodyDef(), halfWidth);
      bullet(w, -Math.signum(speed) * (20 + speed / 60 * i / TRIES), speed, isBullet);
      List<String> heard = hear(w);
      Lab.steps(w, 240);
      assertEquals(once(heard), heard, "i=" + i);
    }
  }

  /** A sensor that comes along, on a body of any type, and one that flies itself. */
  @ParameterizedTest
  @CsvSource({"KINEMATIC,-80", "KINEMATIC,100", "DYNAMIC,-80", "DYNAMIC,0"})
  void aMovingSensorHearsOfAllThatCrossesIt(BodyType type, float speed) {
    for (int i = 0; i < TRIES; i++) {
      World<String> w = Lab.space();
      sensor(w, new BodyDef(type).velocity(speed, 0), .5);
      bullet(w, -20 - 5.0 * i / TRIES, 300, i % 2 == 0);
      List<String> heard = hear(w);
      Lab.steps(w, 30);
      assertEquals(once(heard), heard, "i=" + i);
    }
  }

  @Test
  void aSensorOnABulletHearsOfWhatItFliesThrough() {
    for (int i = 0; i < TRIES; i++) {
      World<String> w = Lab.space();
      Lab.fixed(w, new Box(.3f, 2), 0, 0, 0, Material.DEFAULT);
      sensor(
          w,
          new BodyDef(BodyType.DYNAMIC)
              .mass(1, 1, 0, 0)
              .position(-20 - 5f * i / TRIES, 0)
              .velocity(300, 0),
          .2);
      List<String> heard = hear(w);
      Lab.steps(w, 30);
      assertEquals(once(heard), heard, "i=" + i);
    }
  }

  /** The bodies it passes over rest, asleep or not; neither is a bullet. */
  @ParameterizedTest
  @ValueSource(booleans = {true, false})
  void aFastSensorHearsOfWhatItPassesOver(boolean sleeping) {
    for (int i = 0; i < TRIES; i++) {
      World<String> w = new World<>(new WorldDef().withSleeping(sleeping).withGravity(0, 0));
      bullet(w, 0, 0, false);
      sensor(w, new BodyDef(BodyType.KINEMATIC).position(-150 - i * .1f, 0).velocity(150, 0), .05);
      List<String> heard = hear(w);
      Lab.steps(w, 90);
      assertEquals(once(heard), heard, "i=" + i);
    }
  }

  /** What stops the bullet keeps it from sensors behind; filters keep sensors deaf. */
  @Test
  void aSensorHearsNothingOfWhatDoesNotReachIt() {
    for (int i = 0; i < TRIES; i++) {
      World<String> w = Lab.space();
      Lab.fixed(w, new Box(.05f, 2), -1.5, 0, 0, Material.DEFAULT);
      sensor(w, new BodyDef(), .5);
      w.createBody(
          new BodyDef()
              .position(-4, 0)
              .shape(new ShapeDef(new Box(.5f, 2)).withSensor(true).withFilter(Filter.NOTHING)),
          "deaf");
      bullet(w, -20 - 5.0 * i / TRIES, 300, true);
      List<String> heard = hear(w);
      Lab.steps(w, 60);
      assertEquals(List.of(), heard, "i=" + i);
    }
  }

  /** Between the step of a crossing and its end the state can be saved and restored. */
  @Test
  void aCrossingBelongsToTheState() {
    World<String> w = Lab.space();
    sensor(w, new BodyDef(), .5);
    bullet(w, -22.5, 300, true);
    List<String> heard = hear(w);
    while (heard.isEmpty()) {
      w.step(DT);
    }
    WorldState saved = w.save(null);
    w.step(DT);
    long after = w.stateHash();
    assertEquals(once(heard), heard);
    w.restore(saved);
    w.step(DT);
    assertEquals(after, w.stateHash());
    assertEquals(3, heard.size(), "it ends again");
  }

  /** The paddle sweeps 1.7 m a step over a disc of 20 cm: it takes the disc along. */
  @ParameterizedTest
  @ValueSource(booleans = {true, false})
  void aFastPaddleTakesARestingBulletAlong(boolean sleeping) {
    for (int i = 0; i < TRIES; i++) {
      World<String> w = new World<>(new WorldDef().withSleeping(sleeping).withGravity(0, 0));
      Body<String> b = bullet(w, 0, 0, true);
      w.createBody(
          new BodyDef(BodyType.KINEMATIC)
              .shape(new Box(.05f, .5f))
              .position(-100 - 100f / 60 * i / TRIES, 0)
              .velocity(100, 0),
          "paddle");
      Lab.steps(w, 90);
      assertEquals(100, b.velocityX(), 1, "i=" + i);
      assertTrue(b.x() > 20, "i=" + i + " x=" + b.x());
    }
  }

  /** The same on the ground, and with a paddle that turns about a pivot. */
  @Test
  void aFastArmTakesARestingBulletAlong() {
    for (int i = 0; i < TRIES; i++) {
      World<String> w = new World<>(new WorldDef());
      Lab.fixed(w, new Box(200, 1), 0, -1, 0, Lab.ICE);
      Body<String> b = bullet(w, 0, 0, true);
      b.setPose(0, .1f, 0);
      w.createBody(
          new BodyDef(BodyType.KINEMATIC)
              .shape(new Box(5, .05f))
              .position(0, 5.1f)
              .angle(i * .1f)
              .angularVelocity(20),
          "arm");
      Lab.steps(w, 30);
      assertTrue(b.velocityX() > 50, "i=" + i + " vx=" + b.velocityX());
    }
  }
}
