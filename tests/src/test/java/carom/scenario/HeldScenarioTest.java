package carom.scenario;

import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.game.playground.PlaygroundFields;
import carom.game.playground.PlaygroundGame;
import carom.net.transport.Impairment;
import carom.server.config.ServerConfig;
import carom.sim.entity.Entity;
import carom.sim.entity.HostPlayer;
import carom.sim.entity.Input;
import carom.sim.level.Level;
import carom.testkit.SimulatedClient;
import carom.testkit.Stepper;
import org.junit.jupiter.api.Test;

/**
 * Goal: a client predicts what another player's input pulls, although that player is further away
 * than what it predicts else. Method: Ben holds a box between himself and Ann, and swings it.
 */
final class HeldScenarioTest {
  private static final Impairment LINE = Impairment.NONE.withLatency(50, 0).withSeed(Stepper.SEED);

  @Test
  void theOneWhoHoldsABodyIsPredictedWithIt() throws Exception {
    try (Stepper stepper = Stepper.of(Level.builtIn("harbour"), ServerConfig.defaults())) {
      SimulatedClient ann = stepper.add("Ann", LINE, (view, tick, out) -> {});
      stepper.run(0.5);
      stepper.add(
          "Ben",
          LINE.withSeed(2),
          (view, tick, out) -> {
            if (view.own() != null) {
              out.aim((float) Math.PI)
                  .move(0.5f * (-15 + 8.3f - view.own().x()), tick / 60 % 2 == 0 ? 0.1f : -0.1f)
                  .hold(Input.ACTION, true)
                  .hold(PlaygroundGame.MAKE, tick % 60 == 0); // no room while it has one
            }
          });
      stepper.run(6); // the match begins, and forgets what was before
      HostPlayer ben = stepper.room().simulation().player(1);
      Entity held = ben.get(PlaygroundFields.HELD);
      assertTrue(held != null, "Ben holds nothing");
      float away = ben.entity().x() - stepper.room().simulation().player(0).entity().x();
      assertTrue(away > 8, "away=" + away);
      long before = ann.corrections();
      stepper.run(4);
      assertTrue(ann.rightPercent() > 98, "right=" + ann.rightPercent());
      assertTrue(ann.corrections() == before, "corrections=" + (ann.corrections() - before));
    }
  }
}
