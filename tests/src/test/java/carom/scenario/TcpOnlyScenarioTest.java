package carom.scenario;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.client.InputSource;
import carom.client.link.ConnectionPhase;
import carom.net.transport.Impairment;
import carom.testkit.Scripts;
import carom.testkit.SimulatedClient;
import carom.testkit.Stepper;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Goal: where UDP is dead, the same game is played over TCP, as exact and only later. Method: in
 * virtual time, a player over a network that loses every datagram and delays the rest by 150 ms
 * with jitter; the stepper compares each decoded state with the server's.
 */
class TcpOnlyScenarioTest {
  @ParameterizedTest
  @ValueSource(strings = {"arena", "cars", "platformer", "playground", "rockets", "shooter"})
  void predictionsStayExactWhereUdpIsDead(String game) {
    try (Stepper stepper = Stepper.of(game)) {
      Impairment dead = Impairment.NONE.withLoss(100).withLatency(150, 30);
      SimulatedClient player = stepper.add("player", dead, InputSource.IDLE);
      player.blockUdp(true);
      stepper.runUntil("it plays", () -> player.view().phase() == ConnectionPhase.PLAYING, 10);
      stepper.run(3);
      player.play(Scripts.hold(1, 0));
      stepper.run(2);
      player.play(Scripts.hold(-1, 0));
      stepper.run(2);
      player.play(InputSource.IDLE);
      stepper.run(1);
      assertTrue(player.stats().isOverTcp());
      assertTrue(player.compared() > 100, "compared=" + player.compared());
      assertEquals(0, player.corrections());
      assertEquals(100, player.rightPercent(), 1e-9);
      player.impair(Impairment.NONE.withLatency(150, 30));
      player.blockUdp(false);
      stepper.run(3);
      assertEquals(ConnectionPhase.PLAYING, player.view().phase());
      assertEquals(0, player.corrections(), "after UDP came back");
    }
  }
}
