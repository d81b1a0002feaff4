package carom.scenario;

import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.client.ClientConfig;
import carom.client.PredictionMode;
import carom.client.view.ClientView;
import carom.net.transport.Impairment;
import carom.physics.QueryHit;
import carom.server.session.Session;
import carom.sim.entity.HostEntity;
import carom.testkit.SimulatedClient;
import carom.testkit.Stepper;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * Goal: the server judges by what a client showed. Method: one player runs, another watches over a
 * bad network; where its picture has the runner when it presses, the server must find it for the
 * tick of that input.
 */
final class SeenByScenarioTest {
  private double worst;
  private int looks;

  private void watch(Impairment impairment, int seconds) {
    try (Stepper stepper = Stepper.of("arena")) {
      float[] shown = new float[4096 * 2]; // where the runner was shown, by tick of the input
      SimulatedClient runner =
          stepper.join(
              "runner",
              Impairment.NONE,
              (view, tick, out) -> out.move(0, tick / 40 % 2 == 0 ? 1 : -1));
      int[] runnerBody = {stepper.body(runner).id()};
      SimulatedClient watcher =
          stepper.add(
              ClientConfig.of("watcher")
                  .withServer("localhost", 0, 0)
                  .with(ClientConfig.PREDICTION, PredictionMode.NONE),
              impairment.withSeed(Stepper.SEED),
              (view, tick, out) -> {
                shown[(tick & 4095) * 2] = Float.NaN;
                for (int i = 0; i < view.entityCount(); i++) {
                  ClientView.Drawn drawn = view.entity(i);
                  if (drawn.id() == runnerBody[0]) {
                    shown[(tick & 4095) * 2] = drawn.x();
                    shown[(tick & 4095) * 2 + 1] = drawn.y();
                  }
                }
              });
      stepper.awaitPlaying(watcher);
      stepper.run(2);
      QueryHit<HostEntity> hit = new QueryHit<>();
      int last = 0;
      long end = stepper.nowNs() + seconds * 1_000_000_000L;
      while (stepper.nowNs() < end) {
        stepper.step();
        HostEntity body = stepper.body(runner);
        runnerBody[0] = body.id();
        int tick = stepper.room().tick();
        Session session = stepper.room().session(stepper.player(watcher).id());
        boolean late = stepper.player(watcher).viewDelay() >= 15 * 16;
        if (tick == last || late || session.inputs().marginTicks() < 0) {
          continue; // its input was missing, or its picture older than what the server looks back
        }
        last = tick;
        float x = shown[(tick & 4095) * 2];
        float y = shown[(tick & 4095) * 2 + 1];
        if (!Float.isNaN(x)) {
          boolean found =
              stepper
                  .room()
                  .asSeenBy(session)
                  .nearest(x, y, 5, (b, shape) -> b == body.body(), hit);
          assertTrue(found, stepper::describe);
          worst = Math.max(worst, hit.distance());
          looks++;
        }
      }
    }
  }

  @ParameterizedTest
  @CsvSource({"0, 0, 0", "30, 0, 0", "40, 10, 2"})
  void theServerFindsABodyWhereTheClientShowedIt(double latency, double jitter, double loss) {
    watch(Impairment.NONE.withLatency(latency, jitter).withLoss(loss), 4);
    String what = "seed=" + Stepper.SEED + " looks=" + looks + " worst=" + worst;
    assertTrue(looks > 150, what);
    // The runner has a radius of 0.6 m and makes 0.125 m a tick: its shown centre must lie inside.
    assertTrue(worst == 0, what);
  }
}
