package carom.scenario;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.client.InputSource;
import carom.client.view.ClientView;
import carom.fixtures.Levels;
import carom.net.transport.Impairment;
import carom.physics.Body;
import carom.server.config.ServerConfig;
import carom.sim.entity.HostEntity;
import carom.sim.entity.Input;
import carom.sim.level.Appearance.Look;
import carom.testkit.Condition;
import carom.testkit.Scripts;
import carom.testkit.SimulatedClient;
import carom.testkit.Stepper;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/**
 * Goal: what players do has the effect they expect, on their screen, at the server and on the
 * others' screens. Method: small levels, scripted inputs, real clients and server in virtual time.
 */
class PlayScenarioTest {
  private static final float DISC_RADIUS = 0.6f;
  private static final float BALL_RADIUS = 0.7f;
  private static final Impairment FAR = Impairment.NONE.withLatency(50, 0);

  private static HostEntity ball(Stepper stepper) {
    var simulation = stepper.room().simulation();
    for (int id = 0; id < simulation.entityCapacity(); id++) {
      HostEntity entity = simulation.entity(id);
      if (entity != null && entity.archetype().appearance().look() == Look.BALL) {
        return entity;
      }
    }
    throw new AssertionError("no ball in play");
  }

  private static void place(Stepper stepper, SimulatedClient client, float x, float y) {
    Body<HostEntity> body = stepper.body(client).body();
    body.setPose(x, y, 0);
    body.setVelocity(0, 0);
  }

  @ParameterizedTest
  @EnumSource(
      value = Condition.class,
      mode = EnumSource.Mode.EXCLUDE,
      names = "BLACKOUT_1_S") // there the server repeats the last input, as it should
  void theBodyGoesWhereTheStickPointsAndTheServerAgrees(Condition condition) {
    // Goal: right is right, for the player and for everybody. Method: hold the stick for half a
    // second, let go, wait; compare the start, the player's picture and the server.
    try (Stepper stepper = Stepper.of(Levels.emptyArena(), ServerConfig.defaults())) {
      SimulatedClient client =
          stepper.join("p", condition.impairment(Stepper.SEED), InputSource.IDLE);
      stepper.run(3);
      place(stepper, client, -6, -3);
      stepper.run(2);
      client.play(Scripts.hold(0.8f, 0.6f));
      stepper.run(0.5);
      client.play(InputSource.IDLE);
      stepper.run(4);
      Body<HostEntity> body = stepper.body(client).body();
      double along = 0.8 * (body.x() + 6) + 0.6 * (body.y() + 3);
      double across = -0.6 * (body.x() + 6) + 0.8 * (body.y() + 3);
      String about = condition + " along=" + along + " across=" + across;
      assertTrue(along > 2.5 && along < 8, about); // a lost end of a push lasts 0.5 s at most
      assertEquals(0, across, 0.05, about);
      ClientView.Drawn own = client.view().own();
      assertEquals(body.x(), own.x(), 1e-6, about);
      assertEquals(body.y(), own.y(), 1e-6, about);
    }
  }

  @Test
  void aJumpRisesFallsAndEndsOnTheFloorExactlyWhereTheServerSays() {
    // Goal: gravity, jumping and standing look the same on both sides.
    // Method: stand, press jump once, look at the top, land, stand.
    try (Stepper stepper = Stepper.of(Levels.emptyPlatformer(), ServerConfig.defaults())) {
      SimulatedClient client = stepper.join("p", FAR, InputSource.IDLE);
      stepper.run(2);
      float floor = client.view().own().y();
      client.play((view, tick, out) -> out.hold(Input.JUMP, true));
      float top = floor;
      for (int i = 0; i < 40; i++) {
        stepper.run(1 / 60.0);
        top = Math.max(top, client.view().own().y());
      }
      client.play(InputSource.IDLE);
      stepper.run(2);
      assertTrue(top - floor > 1.5, "jumped " + (top - floor) + " m");
      assertEquals(floor, client.view().own().y(), 0.01);
      assertEquals(stepper.body(client).body().y(), client.view().own().y(), 1e-3);
    }
  }

  @ParameterizedTest
  @EnumSource(Condition.class)
  void twoPlayersPushTheBallAndAllAgreeWhereItEnds(Condition condition) {
    // Goal: what two players do to one body ends the same for both. Method: both run into the ball
    // from two sides at an angle; when all is stopped, everything is equal everywhere.
    try (Stepper stepper = Stepper.of(Levels.arenaWithBall(), ServerConfig.defaults())) {
      SimulatedClient a = stepper.join("a", condition.impairment(Stepper.SEED), InputSource.IDLE);
      SimulatedClient b = stepper.join("b", condition.impairment(Stepper.SEED), InputSource.IDLE);
      stepper.run(1);
      place(stepper, a, -4, -2.2f);
      place(stepper, b, 3, -4.5f);
      final float startX = ball(stepper).body().x();
      final float startY = ball(stepper).body().y();
      stepper.run(1.5);
      a.play(Scripts.hold(1, 0));
      b.play(Scripts.hold(-0.7f, 0.7f));
      stepper.run(1.2);
      a.play(InputSource.IDLE);
      b.play(InputSource.IDLE);
      if (condition.hasBlackout()) {
        stepper.blackout(a, 1);
      }
      stepper.run(1);
      Body<HostEntity> ball = ball(stepper).body();
      ball.setVelocity(0, 0); // by itself it rolls until the game puts it back
      ball.setAngularVelocity(0);
      stepper.run(2);
      String about = condition + " " + stepper.describe();
      assertTrue(Math.hypot(ball.x() - startX, ball.y() - startY) > 1, "untouched, " + about);
      stepper.requireAllSame();
      for (SimulatedClient client : stepper.clients()) {
        ClientView.Drawn drawn = client.view().find(ball(stepper).id());
        assertEquals(ball.x(), drawn.x(), 0.005, about);
        assertEquals(ball.y(), drawn.y(), 0.005, about);
      }
    }
  }

  @Test
  void aBallIsPushedAtOnceHoweverFarTheServer() {
    // Goal: 100 ms away from the server the ball bounces off the own disc as if it were local.
    // Method: run at the ball; from the last picture before they touch, two ticks until it has
    // moved.
    try (Stepper stepper = Stepper.of(Levels.arenaWithBall(), ServerConfig.defaults())) {
      SimulatedClient client = stepper.join("p", FAR, InputSource.IDLE);
      stepper.run(1);
      place(stepper, client, -4, -2);
      stepper.run(2);
      int ballId = ball(stepper).id();
      float ballX = client.view().find(ballId).x();
      client.play(Scripts.hold(1, 0));
      double deepest = 0;
      double apartBefore = 0;
      int framesSinceTouch = -1;
      double moved = 0;
      float serverBallX = 0;
      for (int frame = 0; frame < 120 && framesSinceTouch < 2; frame++) {
        stepper.run(1 / 60.0);
        ClientView.Drawn own = client.view().own();
        ClientView.Drawn ball = client.view().find(ballId);
        double apart =
            Math.hypot(own.x() - ball.x(), own.y() - ball.y()) - DISC_RADIUS - BALL_RADIUS;
        deepest = Math.min(deepest, apart);
        boolean nextTouches = apart < apartBefore - apart; // it leaves in the tick of the impact
        if (framesSinceTouch >= 0 || nextTouches) {
          framesSinceTouch++;
        }
        apartBefore = apart;
        moved = ball.x() - ballX;
        serverBallX = ball(stepper).body().x();
      }
      assertEquals(2, framesSinceTouch, "the disc has reached the ball");
      assertTrue(moved > 0.05, "moved " + moved + " m in two ticks");
      assertEquals(ballX, serverBallX, 0.005, "the server knows nothing of it yet");
      assertTrue(deepest > -0.1, "the disc was drawn " + -deepest + " m inside the ball");
      stepper.run(3);
    }
  }

  @Test
  void othersSeeAPushedBallMoveSmoothly() {
    // Goal: a push by one player is a smooth movement for another. Method: the ball's drawn steps
    // at the onlooker stay near its speed.
    try (Stepper stepper = Stepper.of(Levels.arenaWithBall(), ServerConfig.defaults())) {
      SimulatedClient pusher = stepper.join("pusher", FAR, InputSource.IDLE);
      SimulatedClient onlooker = stepper.join("onlooker", FAR, InputSource.IDLE);
      stepper.run(1);
      place(stepper, pusher, -4, -2);
      place(stepper, onlooker, -7, 4.5f); // too far to predict the ball
      stepper.run(2);
      int ballId = ball(stepper).id();
      pusher.play(Scripts.hold(1, 0));
      float before = onlooker.view().find(ballId).x();
      for (int frame = 0; frame < 90; frame++) {
        stepper.run(1 / 60.0);
        ClientView.Drawn ball = onlooker.view().find(ballId);
        double step = Math.abs(ball.x() - before);
        before = ball.x();
        assertTrue(
            step < 0.1 + 1.5 * Math.abs(ball.velocityX()) / 60,
            "frame=" + frame + " step=" + step + " speed=" + ball.velocityX());
      }
    }
  }
}
