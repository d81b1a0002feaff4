package carom.game.cars;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.game.Games;
import carom.sim.MatchClock;
import carom.sim.MatchPhase;
import carom.sim.Role;
import carom.sim.SimulationHost;
import carom.sim.entity.Entity;
import carom.sim.entity.HostPlayer;
import carom.sim.entity.Input;
import carom.sim.level.Level;
import carom.sim.level.LevelException;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Goal: the rules of a race. Method: the shipped levels; two players who do as they are told. */
final class CarsGameTest {
  private SimulationHost s = start("cars");
  private HostPlayer ann = s.join("ann");
  private HostPlayer ben = s.join("ben");

  private static SimulationHost start(String level) {
    try {
      return new SimulationHost(Games.create("cars"), Level.builtIn(level), 1, 60, Role.AUTHORITY);
    } catch (LevelException e) {
      throw new AssertionError(e);
    }
  }

  private void run(double seconds) {
    for (int i = 0; i < 60 * seconds; i++) {
      s.step();
    }
  }

  private void begin() {
    run(3.1);
    assertEquals(MatchPhase.PLAYING, MatchClock.phase(s));
  }

  private static void put(HostPlayer p, float x, float y, float angle) {
    p.entity().teleport(x, y, angle);
    for (String part : new String[] {"chassis", "rear", "front"}) {
      p.entity().part(part).setVelocity(0, 0);
      p.entity().part(part).setAngularVelocity(0);
    }
  }

  @Test
  void standsInTheCountdownThenDrivesAndBoostsFaster() {
    ann.input().move(1, 0);
    run(2.5);
    assertEquals(6, ann.entity().x(), 0.2);
    put(ann, 290, CarsGame.HEIGHT, 0); // level ground
    put(ben, 290, CarsGame.HEIGHT, 0);
    run(0.6);
    ann.input().move(1, 0);
    ben.input().move(1, 0).hold(Input.ACTION, true);
    run(1);
    assertTrue(ann.entity().x() > 293, "x=" + ann.entity().x());
    assertTrue(ben.entity().x() > ann.entity().x() + 2, "x=" + ben.entity().x());
    assertTrue(ben.get(CarsFields.NITRO) < 0.1f, "nitro=" + ben.get(CarsFields.NITRO));
  }

  @Test
  void aCarOnItsRoofIsTowedToTheNextGateAndWaits() {
    begin();
    put(ann, 12, 1, 3.1f);
    run(3);
    assertEquals(1, ann.get(CarsFields.GATE));
    assertEquals(30, ann.entity().x(), 1);
    assertTrue(ann.entity().cos() > 0.7f);
    assertTrue(ann.get(CarsFields.HELD) > 0);
    ann.input().move(1, 0);
    run(4);
    assertTrue(ann.entity().x() > 34, "x=" + ann.entity().x());
  }

  @Test
  void aFlipInTheAirFillsTheTank() {
    begin();
    put(ann, 300, 9, 0);
    float before = ann.get(CarsFields.NITRO);
    ann.entity().setVelocity(0, 8);
    ann.entity().setAngularVelocity(0);
    boolean flipped = false;
    for (int i = 0; i < 150; i++) {
      float turned = ann.get(CarsFields.TURNED);
      flipped |= turned >= 3;
      ann.input().move(0, flipped && ann.entity().cos() > 0.8f ? 0 : 1);
      s.step();
    }
    assertTrue(flipped);
    assertTrue(ann.get(CarsFields.NITRO) > before + 0.35f, "nitro=" + ann.get(CarsFields.NITRO));
  }

  @Test
  void aBridgeBreaksUnderABlowAndIsBuiltAgainWhileNobodyIsNear() {
    begin();
    Entity before = s.get(CarsFields.BRIDGE, 0);
    assertNotNull(before.joint("hinge.6"));
    put(ann, 163, 24, 0);
    put(ben, 163, 22, 0);
    run(1.8);
    assertTrue(s.get(CarsFields.BROKEN, 0));
    assertTrue(ann.entity().y() < 6, "y=" + ann.entity().y());
    put(ann, 6, 1, 0);
    put(ben, 6, 1, 0);
    run(5.5);
    assertFalse(s.get(CarsFields.BROKEN, 0));
    assertNotNull(s.get(CarsFields.BRIDGE, 0).joint("hinge.6"));
  }

  @Test
  void aCrateBreaksAndComesBack() {
    begin();
    assertNotNull(s.get(CarsFields.CRATE, 0));
    put(ann, 224, 1.4f, 0);
    ann.input().move(1, 0).hold(Input.ACTION, true);
    run(1.5);
    assertNull(s.get(CarsFields.CRATE, 0));
    put(ann, 6, 1, 0);
    ann.input().clear();
    run(5.5);
    assertNotNull(s.get(CarsFields.CRATE, 0));
  }

  @Test
  void theFirstAfterThreeLapsWinsAndTheResultSaysByHowMuch() {
    begin();
    for (int lap = 1; lap <= CarsGame.LAPS; lap++) {
      assertEquals(lap, ann.get(CarsFields.LAP));
      put(ann, 308, CarsGame.HEIGHT, 0);
      run(0.1);
      assertEquals(1, ann.get(CarsFields.PLACE));
      ann.input().move(1, 0);
      run(1.6);
    }
    assertEquals(MatchPhase.OVER, MatchClock.phase(s));
    assertEquals(ann.id(), MatchClock.winner(s));
    List<String> said = new ArrayList<>();
    s.outbox().drainNotices(said::add);
    String last = said.get(said.size() - 1);
    assertTrue(last.matches("ann wins in [0-9.]+ s, [0-9]+ m ahead of ben"), last);
    assertEquals(2, ben.get(CarsFields.PLACE));
  }

  @Test
  void aCarDrivesThroughTheLoop() {
    s = start("quarry");
    ann = s.join("ann");
    put(ann, 14, 9 + CarsGame.HEIGHT, 0);
    float top = 0;
    for (int i = 0; i < 400 && ann.entity().x() < 66; i++) {
      ann.input().move(1, 0).hold(Input.ACTION, ann.entity().x() > 44);
      s.step();
      top = ann.entity().x() > 50 && ann.entity().cos() < -0.9f ? ann.entity().y() : top;
    }
    assertTrue(top > 6.5f, "top=" + top);
    assertTrue(ann.entity().x() >= 66, "x=" + ann.entity().x() + " y=" + ann.entity().y());
    assertEquals(0, ann.get(CarsFields.HELD));
  }
}
