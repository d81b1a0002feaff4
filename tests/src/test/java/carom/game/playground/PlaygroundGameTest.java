package carom.game.playground;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.game.Games;
import carom.game.playground.PlaygroundFields.Contest;
import carom.physics.JointType;
import carom.sim.MatchClock;
import carom.sim.MatchPhase;
import carom.sim.Role;
import carom.sim.SimulationHost;
import carom.sim.entity.Entity;
import carom.sim.entity.EntityJoint;
import carom.sim.entity.HostPlayer;
import carom.sim.entity.Input;
import carom.sim.level.Level;
import carom.sim.level.LevelException;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Goal: the rules of the playground. Method: a shipped level; players who do as they are told. */
final class PlaygroundGameTest {
  private static final float DOWN = (float) (-Math.PI / 2);

  private final SimulationHost s = start("harbour");
  private final HostPlayer ann = s.join("ann");

  private static SimulationHost start(String level) {
    try {
      return new SimulationHost(
          Games.create("playground"), Level.builtIn(level), 1, 60, Role.AUTHORITY);
    } catch (LevelException e) {
      throw new AssertionError(e);
    }
  }

  private void run(double seconds) {
    for (int i = 0; i < 60 * seconds; i++) {
      s.step();
    }
  }

  private void press(HostPlayer p, int button) {
    p.input().hold(button, true);
    s.step();
    p.input().hold(button, false);
    s.step();
  }

  private void put(HostPlayer p, float x, float y) {
    p.entity().teleport(x, y, 0);
    p.entity().part("hand").teleport(x + 1, y, 0);
    p.entity().setVelocity(0, 0);
  }

  private Entity make(int kind) {
    press(ann, PlaygroundGame.MAKE << kind);
    return ann.spawned(ann.spawnedCount() - 1);
  }

  private static List<EntityJoint> joints(Entity e) {
    List<EntityJoint> all = new ArrayList<>();
    e.forEachJoint(all::add);
    return all;
  }

  @Test
  void grabsWhatTheBeamMeetsCarriesItAndThrowsIt() {
    put(ann, -28, 9); // in the air over the shore
    ann.input().aim(0);
    Entity box = make(0);
    ann.input().hold(Input.ACTION, true);
    run(0.5);
    assertEquals(box, ann.get(PlaygroundFields.HELD));
    assertEquals(-26, box.x(), 0.4);
    assertEquals(9, box.y(), 0.4);
    ann.input().move(0, 1);
    run(1);
    ann.input().move(0, 0);
    run(0.5);
    assertTrue(box.y() > 15, "y=" + box.y());
    ann.input().hold(Input.UP, true);
    run(0.3);
    assertTrue(Math.abs(box.angularVelocity()) > 1.5f, "omega=" + box.angularVelocity());
    ann.input().hold(Input.UP, false);
    run(0.5);
    press(ann, Input.SECOND);
    assertNull(ann.get(PlaygroundFields.HELD));
    assertTrue(box.velocityX() > 12, "vx=" + box.velocityX());
  }

  @Test
  void aPlayerHasSoManyThingsAndTheOldestGoesFirst() {
    put(ann, -28, 20);
    ann.input().aim(DOWN);
    Entity first = make(0);
    for (int i = 1; i < PlaygroundGame.MAX_THINGS; i++) {
      put(ann, -55 + 1.3f * i, 20);
      make(i % 2);
    }
    assertEquals(PlaygroundGame.MAX_THINGS, ann.spawnedCount());
    assertEquals(first, ann.spawned(0));
    put(ann, 0, 20);
    make(1);
    assertEquals(PlaygroundGame.MAX_THINGS, ann.get(PlaygroundFields.THINGS));
    assertFalse(ann.spawned(0) == first);
  }

  /** Brings a wheel to a plank and joins both with a key; returns the joints of the wheel. */
  private List<EntityJoint> join(int key) {
    put(ann, -28, 12);
    ann.input().aim(0);
    Entity plank = make(2);
    plank.teleport(-26, 12.9f, 0);
    ann.input().hold(Input.ACTION, true);
    Entity wheel = make(3);
    run(0.1);
    plank.teleport(wheel.x(), wheel.y() + 0.7f, 0);
    plank.setVelocity(0, 0);
    assertEquals(wheel, ann.get(PlaygroundFields.HELD));
    press(ann, key);
    return joints(wheel);
  }

  @Test
  void joinsWhatItHoldsWithWhatIsThereAndCutsIt() {
    assertEquals(JointType.WELD, join(PlaygroundGame.WELD).get(0).type());
    press(ann, PlaygroundGame.CUT);
    assertEquals(List.of(), joints(ann.get(PlaygroundFields.HELD)));
    press(ann, PlaygroundGame.HINGE);
    press(ann, PlaygroundGame.CUT);
    press(ann, PlaygroundGame.ROPE); // aims to the right: a tower stands there, or a wall
    assertTrue(joints(ann.get(PlaygroundFields.HELD)).size() <= 1);
  }

  @Test
  void aMotorTurnsWhileTheKeyIsHeldTheWayThePlayerFlies() {
    EntityJoint motor = join(PlaygroundGame.MOTOR).get(0);
    assertEquals(JointType.REVOLUTE, motor.type());
    ann.input().hold(Input.JUMP, true).move(0.2f, 0);
    run(0.2);
    assertTrue(motor.motorSpeed() < -5, "speed=" + motor.motorSpeed());
    ann.input().move(-0.2f, 0);
    run(0.2);
    assertTrue(motor.motorSpeed() > 5, "speed=" + motor.motorSpeed());
    ann.input().hold(Input.JUMP, false);
    run(0.2);
    assertEquals(0, motor.motorSpeed());
  }

  @Test
  void theOldestJointGoesFirst() {
    EntityJoint first = join(PlaygroundGame.HINGE).get(0);
    for (int i = 1; i < PlaygroundFields.MAX_LINKS; i++) {
      press(ann, PlaygroundGame.HINGE);
    }
    assertTrue(first.isValid());
    press(ann, PlaygroundGame.HINGE);
    assertFalse(first.isValid());
  }

  @Test
  void pointsOfAllContestsDecideAndTheResultSaysWhy() {
    HostPlayer ben = s.join("ben");
    run(3.1);
    assertEquals(MatchPhase.PLAYING, MatchClock.phase(s));
    assertEquals(Contest.BASKETS, s.get(PlaygroundFields.CONTEST));
    deliver();
    assertEquals(1, ann.get(PlaygroundFields.BASKETS));
    run(PlaygroundGame.CONTEST_SECONDS);
    assertEquals(Contest.TOWER, s.get(PlaygroundFields.CONTEST));
    put(ann, 26, 5.5f);
    ann.input().aim(DOWN);
    make(0);
    run(2);
    put(ann, 26, 6.5f);
    make(0);
    run(2);
    assertEquals(2, ann.get(PlaygroundFields.TOWER));
    run(PlaygroundGame.CONTEST_SECONDS - 4);
    assertEquals(Contest.STAR, s.get(PlaygroundFields.CONTEST));
    Entity star = s.get(PlaygroundFields.STAR);
    assertNotNull(star);
    grabStar(ann, star);
    run(2.5);
    assertEquals(ann, s.get(PlaygroundFields.KEEPER));
    assertEquals(2, ann.get(PlaygroundFields.STAR_SECONDS));
    grabStar(ben, star); // the last one to grab it has it
    run(0.1);
    assertEquals(ben, s.get(PlaygroundFields.KEEPER));
    assertNull(ann.get(PlaygroundFields.HELD));
    ben.input().clear();
    run(PlaygroundGame.CONTEST_SECONDS);
    assertEquals(MatchPhase.OVER, MatchClock.phase(s));
    assertEquals(ann.id(), MatchClock.winner(s));
    List<String> said = new ArrayList<>();
    s.outbox().drainNotices(said::add);
    assertEquals(
        "ann wins with 5: baskets 1, tower 2 m, star 2 s, 5 ahead of ben",
        said.get(said.size() - 1));
  }

  private void deliver() {
    Entity thing = null;
    for (Entity e : s.entities()) {
      thing = e.archetype().name().equals("pebble") ? e : thing;
    }
    put(ann, -14, 20.2f); // over a basket
    thing.teleport(-14, 18.2f, 0);
    thing.setVelocity(0, 0);
    ann.input().aim(DOWN).hold(Input.ACTION, true);
    run(0.2);
    ann.input().clear();
    run(1.5);
  }

  private void grabStar(HostPlayer p, Entity star) {
    put(p, star.x(), star.y() + 2.5f);
    p.input().aim(DOWN).hold(Input.ACTION, true);
    run(0.1);
    assertEquals(star, p.get(PlaygroundFields.HELD));
  }
}
