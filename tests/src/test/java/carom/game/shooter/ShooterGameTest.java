package carom.game.shooter;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.game.GamesTest;
import carom.sim.MatchClock;
import carom.sim.MatchPhase;
import carom.sim.Role;
import carom.sim.SimulationHost;
import carom.sim.entity.Entity;
import carom.sim.entity.HostPlayer;
import carom.sim.entity.Input;
import org.junit.jupiter.api.Test;

/** Goal: the rules of a match. Method: the shipped level; two players who do as they are told. */
final class ShooterGameTest {
  private static final float FLOOR = -2 + ShooterGame.PLAYER_HEIGHT / 2;

  private final SimulationHost s = GamesTest.start("shooter", 1, Role.AUTHORITY);
  private final HostPlayer ann = s.join("ann");
  private final HostPlayer ben = s.join("ben");

  private void run(int ticks) {
    for (int i = 0; i < ticks; i++) {
      s.step();
    }
  }

  /** Runs through the countdown, until nobody is safe any more. */
  private void begin() {
    run(182 + 100);
    assertEquals(MatchPhase.PLAYING, MatchClock.phase(s));
  }

  private static void put(HostPlayer p, float x, float y) {
    p.entity().body().setPose(x, y, 0);
    p.entity().body().setVelocity(0, 0);
  }

  private int count(String archetype) {
    int count = 0;
    for (Entity e : s.entities()) {
      count += e.archetype().name().equals(archetype) ? 1 : 0;
    }
    return count;
  }

  @Test
  void blowsGrowWithDamageAndAtItsMostAPlayerTumbles() {
    begin();
    float first = 0;
    float last = 0;
    int hits = 0;
    while (ben.isAlive()) {
      put(ann, -8, FLOOR);
      put(ben, -6, FLOOR);
      ann.input().aim(0).hold(Input.ACTION, true);
      int damage = ben.get(ShooterFields.DAMAGE);
      run(1);
      if (ben.get(ShooterFields.DAMAGE) > damage) {
        run(1); // a blow acts in the next step
      }
      if (ben.isAlive() && ben.get(ShooterFields.DAMAGE) > damage) {
        last = ben.entity().velocityX();
        first = hits++ == 0 ? last : first;
      }
      assertTrue(s.tick() < 1_200, "damage=" + damage);
    }
    assertTrue(first > 1 && last > 1.7 * first, "first=" + first + " last=" + last);
    assertEquals(ShooterGame.LIVES - 1, ben.get(ShooterFields.LIVES));
    assertEquals(1, ann.score());
    assertEquals(1, count("torso." + ben.id()));
    run(121);
    assertNotNull(ben.entity());
    run(60);
    assertEquals(0, count("torso." + ben.id()));
  }

  @Test
  void aShotThrowsItsPlayerBackAndAWeaponRunsEmpty() {
    begin();
    put(ann, -8, FLOOR);
    ann.set(ShooterFields.WEAPON, Weapon.LAUNCHER);
    ann.set(ShooterFields.AMMO, 1);
    ann.input().aim(0).hold(Input.ACTION, true);
    run(1);
    assertTrue(ann.entity().velocityX() < -2, "vx=" + ann.entity().velocityX());
    assertEquals(Weapon.PISTOL, ann.get(ShooterFields.WEAPON));
  }

  @Test
  void aPickUpIsTakenOnceAndComesBack() {
    begin();
    int before = count("shotgun");
    put(ann, -6.5f, 2.3f + ShooterGame.PLAYER_HEIGHT / 2);
    run(3);
    assertEquals(Weapon.SHOTGUN, ann.get(ShooterFields.WEAPON));
    assertEquals(Weapon.SHOTGUN.ammo, ann.get(ShooterFields.AMMO));
    assertEquals(before - 1, count("shotgun"));
    put(ann, -16, 0.8f);
    run(9 * 60 + 2);
    assertEquals(before, count("shotgun"));
  }

  @Test
  void coverBreaksUnderFire() {
    begin();
    int before = count("crate");
    for (int i = 0; i < 300 && count("crate") == before; i++) {
      put(ann, -5, FLOOR);
      ann.input().aim(0).hold(Input.ACTION, true);
      run(1);
    }
    assertEquals(before - 1, count("crate"));
  }

  @Test
  void jumpsOnceMoreInTheAirAndNotAThirdTime() {
    begin();
    put(ann, -5, FLOOR);
    run(5);
    float top = 0;
    int jumps = 0;
    for (int i = 0; i < 40; i++) { // and it is still in the air
      ann.input().hold(Input.JUMP, i % 10 == 0);
      float before = ann.entity().velocityY();
      run(1);
      jumps += ann.entity().velocityY() > before + 5 ? 1 : 0;
      top = Math.max(top, ann.entity().y());
    }
    assertEquals(2, jumps, "top=" + top);
  }

  @Test
  void suddenDeathLetsTheLavaRiseAndTheLastOneStandingWins() {
    run(182);
    int sudden = s.ticks(ShooterGame.MATCH_SECONDS - ShooterGame.SUDDEN_SECONDS);
    put(ann, 0, 8.9f + ShooterGame.PLAYER_HEIGHT / 2);
    put(ben, -3, FLOOR);
    run(sudden);
    assertTrue(s.get(ShooterFields.SUDDEN));
    while (ben.isAlive()) {
      run(1);
      assertTrue(s.tick() < 182 + sudden + 30 * 60, "ben stands in lava");
    }
    run(2);
    assertEquals(0, ben.get(ShooterFields.LIVES));
    assertEquals(MatchPhase.OVER, MatchClock.phase(s));
    assertEquals(ann.id(), MatchClock.winner(s));
    run(150);
    assertNull(ben.entity());
  }
}
