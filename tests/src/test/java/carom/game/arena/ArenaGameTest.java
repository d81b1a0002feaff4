package carom.game.arena;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.game.GamesTest;
import carom.physics.Body;
import carom.physics.math.SimRandom;
import carom.sim.MatchClock;
import carom.sim.MatchPhase;
import carom.sim.Role;
import carom.sim.SimulationHost;
import carom.sim.entity.HostEntity;
import carom.sim.entity.HostPlayer;
import carom.sim.entity.Input;
import carom.sim.level.Level;
import carom.sim.outbox.NextMatch;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Goal: the arena's rules. Method: the shipped level, scripted players. */
class ArenaGameTest {
  private final SimulationHost s = GamesTest.start("arena", 1, Role.AUTHORITY);
  private final List<String> notices = new ArrayList<>();

  private void run(int ticks) {
    for (int i = 0; i < ticks; i++) {
      s.step();
      s.outbox().drainNotices(notices::add);
    }
  }

  private HostEntity ball() {
    return find("ball");
  }

  private HostEntity find(String archetype) {
    for (int id = 0; id < s.entityCapacity(); id++) {
      if (s.entity(id) != null && s.entity(id).archetype().name().equals(archetype)) {
        return s.entity(id);
      }
    }
    return null;
  }

  private int count(String archetype) {
    int count = 0;
    for (int id = 0; id < s.entityCapacity(); id++) {
      if (s.entity(id) != null && s.entity(id).archetype().name().equals(archetype)) {
        count++;
      }
    }
    return count;
  }

  private static void put(HostEntity e, float x, float y) {
    e.body().setPose(x, y, 0);
    e.body().setVelocity(0, 0);
  }

  @Test
  void glidesToFullSpeedAndStops() {
    HostPlayer p = s.join("ann");
    put(p.entity(), -10, 0);
    p.input().move(1, 0);
    run(30);
    assertEquals(ArenaGame.SPEED, p.entity().body().velocityX(), 0.2f);
    p.input().move(0, 0);
    run(30);
    assertEquals(0, p.entity().body().velocityX(), 0.1f);
  }

  @Test
  void diagonalsAreNotFaster() {
    HostPlayer p = s.join("ann");
    put(p.entity(), -12, -6);
    p.input().move(1, 1);
    run(30);
    Body<HostEntity> b = p.entity().body();
    double speed = Math.hypot(b.velocityX(), b.velocityY());
    assertEquals(ArenaGame.SPEED, speed, 0.2);
  }

  @Test
  void dashesOncePerCooldownAndPress() {
    HostPlayer p = s.join("ann");
    put(p.entity(), -10, 0);
    p.input().aim((float) Math.PI / 2).hold(Input.ACTION, true);
    run(5);
    Body<HostEntity> b = p.entity().body();
    assertTrue(b.velocityY() > 12, "vy=" + b.velocityY());
    run(60);
    assertEquals(0, b.velocityY(), 0.5f, "holding the button doesn't dash again");
    put(p.entity(), -10, 0);
    p.input().hold(Input.ACTION, false);
    run(10);
    p.input().hold(Input.ACTION, true);
    run(5);
    assertTrue(b.velocityY() > 12, "vy=" + b.velocityY());
    p.input().hold(Input.ACTION, false);
    run(30);
    p.input().hold(Input.ACTION, true);
    run(5);
    assertEquals(0, b.velocityY(), 0.5f, "too early");
  }

  @Test
  void boostIsFasterUntilTheStoreIsEmptyAndFillsAgain() {
    HostPlayer p = s.join("ann");
    put(p.entity(), -16, 0);
    p.input().move(1, 0).hold(ArenaGame.BOOSTS, true);
    run(40);
    assertEquals(ArenaGame.BOOST_SPEED, p.entity().velocityX(), 0.3f);
    assertEquals(0.3f, p.get(ArenaFields.BOOST), 0.051f);
    put(p.entity(), -16, 0);
    run(80);
    assertEquals(ArenaGame.SPEED, p.entity().velocityX(), 0.3f, "the store is empty");
    assertEquals(0, p.get(ArenaFields.BOOST));
    p.input().move(0, 0).hold(ArenaGame.BOOSTS, false);
    run(150);
    assertEquals(0.5f, p.get(ArenaFields.BOOST), 0.051f);
    run(160);
    assertEquals(1, p.get(ArenaFields.BOOST));
  }

  /** Returns how far to the left of its way a ball is that a disc pushed to the right. */
  private float bend(int buttons) {
    HostPlayer p = s.player(0);
    put(ball(), -8, 0);
    ball().body().setAngularVelocity(0);
    put(p.entity(), -10, 0);
    p.input().move(1, 0).buttons(buttons | Input.ACTION);
    run(15);
    p.input().move(-1, 0).buttons(0);
    run(45);
    assertTrue(ball().x() > 0, "x=" + ball().x());
    float y = ball().y();
    run(60);
    return y;
  }

  @Test
  void aSpinningDiscBendsTheWayOfTheBall() {
    s.join("ann");
    run(2);
    float straight = bend(0);
    float left = bend(ArenaGame.SPINS_LEFT);
    float right = bend(ArenaGame.SPINS_RIGHT);
    String all = "left=" + left + " straight=" + straight + " right=" + right;
    assertTrue(left > straight + 1 && right < straight - 1, all);
    assertEquals(straight, bend(ArenaGame.SPINS_LEFT | ArenaGame.SPINS_RIGHT), 0.3f, all);
  }

  @Test
  void frictionAtAWallTurnsSpinIntoSpeed() {
    s.join("ann");
    run(2);
    float[] along = new float[2];
    for (int i = 0; i < 2; i++) {
      put(ball(), -2, 10.2f);
      ball().body().setAngularVelocity(i == 0 ? -50 : 50);
      ball().body().setVelocity(0, 8);
      run(4);
      along[i] = ball().velocityX();
      assertEquals(0, Math.abs(ball().angularVelocity()), 45, "the wall took some of it");
    }
    assertTrue(along[0] < -1.5f && along[1] > 1.5f, along[0] + " " + along[1]);
  }

  @Test
  void aHeavyBallMovesADiscAndALightOneHardlyDoes() throws Exception {
    SimulationHost rink =
        new SimulationHost(new ArenaGame(), Level.builtIn("rink"), 1, 60, Role.AUTHORITY);
    HostPlayer p = rink.join("ann");
    rink.step();
    float[] pushed = new float[2];
    for (HostEntity ball : List.copyOf(balls(rink))) {
      put(p.entity(), 0, 0);
      ball.body().setPose(-3, 0, 0);
      ball.body().setVelocity(12, 0);
      float fastest = 0;
      for (int i = 0; i < 20; i++) {
        rink.step();
        fastest = Math.max(fastest, p.entity().velocityX());
      }
      ball.body().setPose(0, 8, 0);
      ball.body().setVelocity(0, 0);
      pushed[ball.archetype().name().equals("heavy ball") ? 1 : 0] = fastest;
    }
    assertTrue(pushed[1] > 10 && pushed[1] > 1.5f * pushed[0], pushed[1] + " " + pushed[0]);
  }

  private static List<HostEntity> balls(SimulationHost of) {
    List<HostEntity> balls = new ArrayList<>();
    for (int id = 0; id < of.entityCapacity(); id++) {
      if (of.entity(id) != null && of.entity(id).archetype().name().endsWith("ball")) {
        balls.add(of.entity(id));
      }
    }
    assertEquals(2, balls.size());
    return balls;
  }

  @Test
  void aPlayerPushesTheBallIntoTheGoalAndScores() {
    HostPlayer p = s.join("ann");
    run(2);
    put(ball(), 13, 0.2f);
    put(p.entity(), 11, 0.2f);
    for (int i = 0; i < 240 && p.score() == 0; i++) {
      p.input().move(1, ball() == null ? 0 : (ball().body().y() - p.entity().body().y()) * 2);
      run(1);
    }
    assertEquals(1, p.team());
    assertEquals(1, p.score());
    assertTrue(notices.contains("Goal for Red: ann (1 : 0)"), notices.toString());
    assertEquals(1, count("lamp.Red"));
    assertNull(ball());
    run(130);
    assertNotNull(ball());
    assertEquals(0, ball().body().x(), 0.5f);
  }

  @Test
  void anOwnGoalCountsForTheOthers() {
    HostPlayer p = s.join("ann");
    run(2);
    put(p.entity(), -15, 0);
    put(ball(), -16.35f, 0);
    p.input().move(-1, 0);
    run(90);
    assertEquals(0, p.score());
    assertTrue(notices.contains("Goal for Blue, own goal by ann (0 : 1)"), notices.toString());
  }

  @Test
  void fiveGoalsWinAndTheNextMatchIsAskedFor() {
    HostPlayer ann = s.join("ann");
    HostPlayer ben = s.join("ben");
    for (int goal = 0; goal < ArenaGame.GOALS_TO_WIN; goal++) {
      assertEquals(goal, count("lamp.Red"));
      run(130);
      put(ball(), 18.8f, 0);
      run(1);
    }
    run(1);
    assertEquals(ArenaGame.GOALS_TO_WIN, count("lamp.Red"));
    assertTrue(notices.contains("Red wins 5 : 0!"), notices.toString());
    assertEquals(MatchPhase.OVER, MatchClock.phase(s));
    assertEquals(1, MatchClock.winningTeam(s));
    assertEquals(1_516, ann.get(ArenaFields.RATING));
    assertEquals(1_484, ben.get(ArenaFields.RATING));
    run(200);
    assertNull(ball());
    assertNull(s.outbox().takeNextMatch());
    run(200);
    assertEquals(NextMatch.OF_ROTATION, s.outbox().takeNextMatch());
  }

  @Test
  void whoIsAlonePractisesUntilASecondPlayerComes() {
    HostPlayer ann = s.join("ann");
    for (int goal = 0; goal < ArenaGame.GOALS_TO_WIN; goal++) {
      assertEquals(goal, count("lamp.Red"));
      run(130);
      put(ball(), 18.8f, 0);
      run(1);
    }
    assertEquals(0, count("lamp.Red"), "practice begins anew");
    run(130);
    ann.score(3);
    put(ball(), 18.8f, 0);
    run(1);
    assertEquals(1, count("lamp.Red"));
    assertNull(ball());
    assertEquals(MatchPhase.WARM_UP, MatchClock.phase(s));
    s.join("ben");
    run(1);
    assertEquals(MatchPhase.PLAYING, MatchClock.phase(s));
    assertEquals(0, count("lamp.Red"));
    assertEquals(0, ann.score());
    assertEquals(0, ball().body().x(), "play begins in the middle");
  }

  @Test
  void aMatchOfFiveMinutesEndsWithItsStanding() {
    HostPlayer ann = s.join("ann");
    HostPlayer ben = s.join("ben");
    ann.set(ArenaFields.RATING, 1_900);
    ben.set(ArenaFields.RATING, 1_500);
    run(130);
    put(ball(), -18.8f, 0);
    run(MatchClock.ticksLeft(s) - 1);
    assertEquals(MatchPhase.PLAYING, MatchClock.phase(s));
    assertEquals(1, MatchClock.ticksLeft(s));
    assertEquals(ArenaGame.MATCH_SECONDS * 60, s.tick(), 1);
    run(2);
    assertEquals(MatchPhase.OVER, MatchClock.phase(s));
    assertTrue(notices.contains("Blue wins 0 : 1!"), notices.toString());
    assertEquals(2, MatchClock.winningTeam(s));
    assertEquals(1_531, ben.get(ArenaFields.RATING), "the worse one gets the most");
    assertEquals(1_869, ann.get(ArenaFields.RATING));
  }

  @Test
  void teamsAreEvenAndStayEven() {
    for (int i = 0; i < 9; i++) {
      s.join("bot " + i);
    }
    run(2);
    for (int i = 0; i < 9; i += 2) {
      s.leave(s.player(i)); // all of team 1
    }
    put(ball(), 18.8f, 0);
    run(2);
    int red = 0;
    for (int i = 1; i < 9; i += 2) {
      red += s.player(i).team() == 1 ? 1 : 0;
      assertEquals(s.player(i).team(), s.player(i).entity().archetype().tag());
    }
    assertEquals(2, red);
  }

  @Test
  void moreBallsForMorePlayers() {
    run(5);
    assertEquals(1, count("ball"));
    for (int i = 0; i < 50; i++) {
      s.join("bot " + i);
    }
    run(5);
    assertEquals(4, count("ball"));
  }

  @Test
  void nobodyStartsInsideAnother() {
    for (int i = 0; i < 50; i++) {
      HostPlayer p = s.join("bot " + i);
      for (int other = 0; other < i; other++) {
        Body<HostEntity> a = p.entity().body();
        Body<HostEntity> b = s.player(other).entity().body();
        double distance = Math.hypot(a.x() - b.x(), a.y() - b.y());
        assertTrue(distance > 1.2, i + " and " + other + " distance=" + distance);
      }
    }
  }

  @Test
  void aForgottenBallReturnsToTheMiddle() {
    s.join("ann");
    run(2);
    put(ball(), 10, 9);
    run(6 * 60 + 3 * 60);
    assertEquals(0, ball().body().x(), 0.5f);
    assertTrue(notices.contains("The ball is back in the middle"), notices.toString());
  }

  @Test
  void lostPlayersAndCratesComeBack() {
    HostPlayer p = s.join("ann");
    put(p.entity(), 60, 0);
    HostEntity crate = find("crate");
    float x = crate.body().x();
    put(crate, 18.8f, 0);
    run(2);
    assertTrue(Math.abs(p.entity().body().x()) < 20);
    assertEquals(x, crate.body().x(), 0.1f);
  }

  /** Ball chasers for five minutes: goals fall, nobody is stuck for long. */
  @Test
  void chasersPlayRealMatches() {
    for (int i = 0; i < 8; i++) {
      s.join("bot " + i);
    }
    SimRandom random = new SimRandom(4);
    for (int tick = 0; tick < 5 * 60 * 60; tick++) {
      HostEntity ball = ball();
      for (int id = 0; id < s.playerCapacity(); id++) {
        chase(s.player(id), ball, random);
      }
      run(1);
    }
    long goals = notices.stream().filter(n -> n.startsWith("Goal")).count();
    assertTrue(goals >= 3 && goals <= 90, "goals=" + goals + " in five minutes");
  }

  /** Goes behind the ball, then dashes through it; half of them keep back. */
  static void chase(HostPlayer p, HostEntity ball, SimRandom random) {
    Body<HostEntity> me = p.entity().body();
    float goal = p.team() == 1 ? 1 : -1;
    float ballX = ball == null ? 0 : ball.body().x();
    float ballY = ball == null ? 0 : ball.body().y();
    float awayX = ballX - goal * 18.7f;
    float awayY = ballY;
    float away = (float) Math.sqrt(awayX * awayX + awayY * awayY);
    awayX /= away;
    awayY /= away;
    float toX = ballX - me.x();
    float toY = ballY - me.y();
    float to = (float) Math.sqrt(toX * toX + toY * toY);
    boolean behind = -(toX * awayX + toY * awayY) > 0.85f * to;
    float x = behind ? ballX - awayX : ballX + awayX * 1.5f;
    float y = behind ? ballY - awayY : ballY + awayY * 1.5f;
    if (!behind && to < 1.6f) {
      x = me.x() - toY;
      y = me.y() + toX;
    }
    if (p.id() >= 4) {
      x = (x - goal * 18) / 2;
      y /= 2;
    }
    float dx = x - me.x();
    float dy = y - me.y();
    float length = (float) Math.sqrt(dx * dx + dy * dy) + 0.01f;
    p.input().move(dx / length, dy / length);
    p.input().hold(Input.ACTION, behind && to < 3 && random.nextInt(4) == 0);
  }

  @Test
  void aJoltPushesTheFirstThingInItsWay() {
    HostPlayer ann = s.join("ann");
    HostPlayer ben = s.join("ben");
    run(1);
    put(ann.entity(), -8, 0);
    put(ball(), -3, 0.2f);
    put(ben.entity(), 0, 0);
    ann.input().aim(0).hold(Input.SECOND, true);
    run(1);
    assertEquals(1, count("spark"));
    run(1);
    float mass = ball().body().mass();
    assertEquals(ArenaGame.JOLT_IMPULSE / mass, ball().body().velocityX(), 0.2f);
    assertEquals(0, ben.entity().body().velocityX(), "it is behind the ball");
    float speed = ball().body().velocityX();
    run(20);
    assertEquals(0, count("spark"));
    assertTrue(ball().body().velocityX() < speed, "holding the button gives one jolt");
  }

  @Test
  void aJoltNeedsTimeAndAFreshPress() {
    HostPlayer ann = s.join("ann");
    run(1);
    put(ann.entity(), -8, 0);
    int jolts = 0;
    int sparks = 0;
    for (int tick = 0; tick < s.ticks(ArenaGame.JOLT_COOLDOWN) * 2; tick++) {
      ann.input().aim((float) Math.PI / 2).hold(Input.SECOND, tick % 4 < 2);
      run(1);
      int now = count("spark");
      jolts += now > sparks ? 1 : 0;
      sparks = now;
    }
    assertEquals(2, jolts, "walls light up too");
  }

  @Test
  void aJoltMeetsWhatThePlayerSaw() {
    HostPlayer ann = s.join("ann");
    HostPlayer ben = s.join("ben");
    run(1);
    put(ball(), 0, -6);
    put(ann.entity(), -8, 0);
    put(ben.entity(), -2, -5);
    ben.input().move(0, 1);
    float seenY = 0;
    for (int tick = 0; tick < 60; tick++) {
      if (ben.entity().body().y() < 0) {
        seenY = ben.entity().body().y();
      } else {
        break;
      }
      run(1);
    }
    run(9); // ben is more than a metre farther now
    assertTrue(ben.entity().body().y() - seenY > 1, "ben moves");
    ann.input().aim((float) Math.atan2(seenY, 6)).hold(Input.SECOND, true);
    ann.viewDelay(11 * HostPlayer.VIEW_STEPS); // that of the picture with seenY
    float before = ben.entity().body().velocityX();
    run(2);
    assertTrue(ben.entity().body().velocityX() > before + 1, "seen there, hit where he is");
    run(100);
    ann.input().hold(Input.SECOND, false);
    run(1);
    put(ann.entity(), -8, 0);
    put(ben.entity(), -2, 5);
    ann.viewDelay(0);
    ann.input().aim(0).hold(Input.SECOND, true);
    before = ben.entity().body().velocityX();
    run(2);
    assertEquals(before, ben.entity().body().velocityX(), 1, "nobody was there");
  }
}
