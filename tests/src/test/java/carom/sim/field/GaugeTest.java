package carom.sim.field;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.client.InputSource;
import carom.client.field.FieldView;
import carom.client.view.ClientView;
import carom.game.Games;
import carom.net.transport.Impairment;
import carom.sim.entity.HostPlayer;
import carom.sim.event.Audience;
import carom.testkit.SimulatedClient;
import carom.testkit.Stepper;
import org.junit.jupiter.api.Test;

/** Goal: what a game declares is what a client can show. Method: declarations; a game's client. */
final class GaugeTest {
  @Test
  void aClientReadsTheHealthOfAllPlayersByTheGaugesOfTheGame() {
    Gauge health = Games.create("rockets").gauges().get(0);
    try (Stepper stepper = Stepper.of("rockets")) {
      SimulatedClient ann = stepper.join("Ann", Impairment.NONE, InputSource.IDLE);
      SimulatedClient bob = stepper.join("Bob", Impairment.NONE, InputSource.IDLE);
      ClientView view = ann.view();
      HostPlayer hurt = stepper.player(bob);
      assertEquals(1, health.share(view.player(hurt.id())));
      hurt.add((Count) health.field(), -45);
      stepper.run(1);
      FieldView seen = view.player(hurt.id());
      assertEquals(0.55f, health.share(seen));
      assertEquals(1, health.share(view.player(view.playerId())), "Ann's own");
    }
  }

  @Test
  void aBarGoesFromTheLeastValueToTheGreatest() {
    assertEquals(Gauge.Kind.BAR, Gauge.bar("heat", Field.count("heat", -20, 60)).kind());
    Countdown left = Field.countdown("left").of(Scope.MATCH).to(Audience.ALL);
    assertEquals(Gauge.Kind.CLOCK, Gauge.clock(left).kind());
    assertEquals(Gauge.Kind.NUMBER, Gauge.number("left", left).kind());
  }

  @Test
  void whatNoClientCouldShowIsRefusedByItsName() {
    Count health = Field.count("health", 0, 9);
    refused("no player is told player.health", () -> Gauge.bar("h", health.to(Audience.NOBODY)));
    refused("match.health", () -> Gauge.bar("h", health.of(Scope.MATCH)));
    refused("player.health has one value", () -> Gauge.teamScore(health));
    refused("player.left", () -> Gauge.clock(Field.countdown("left")));
  }

  private static void refused(String part, Runnable declaration) {
    String message = assertThrows(IllegalArgumentException.class, declaration::run).getMessage();
    assertTrue(message.contains(part), message);
  }
}
