package carom.lab.soak;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.client.ClientConfig;
import carom.client.PredictionMode;
import carom.net.transport.Impairment;
import carom.server.room.Room;
import carom.testkit.Scripts;
import carom.testkit.SimulatedClient;
import carom.testkit.Stepper;
import java.nio.file.Path;
import java.util.EnumSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * A fresh slice of a soak in every run: other seeds each time, unless {@code -Dcarom.seed} says.
 */
final class SoakTest {
  private static final long SEED = Long.getLong("carom.seed", System.nanoTime());

  @TempDir private Path folder;

  @Test
  void aServerAndSixteenClientsThatPredictLiveThroughTwentySeconds() throws Exception {
    soak(20, Soak.Play.PREDICTING);
  }

  @Test
  void aServerAndSixteenClientsLiveThroughFortySeconds() throws Exception {
    soak(40, Soak.Play.INTERPOLATING);
  }

  @Test
  void aServerAndSixteenClientsThatDecodeNothingLiveThroughAMinute() throws Exception {
    soak(60, Soak.Play.INPUT_ONLY);
  }

  /** Found by a soak: headers and own state took all that such a line lets through. */
  @Test
  void onASlowLineEveryBodyIsHeardOfWithinTwoSeconds() {
    try (Stepper stepper = Stepper.of("arena")) {
      for (int i = 0; i < 9; i++) {
        stepper.join("p" + i, Impairment.NONE, Scripts.wander(i));
      }
      Impairment line = Impairment.NONE.withLatency(60, 5).withBandwidth(24);
      ClientConfig config =
          ClientConfig.of("slow")
              .withServer("localhost", stepper.tcpPort(), stepper.udpPort())
              .with(ClientConfig.PREDICTION, PredictionMode.NONE);
      SimulatedClient slow = stepper.add(config, line, Scripts.wander(9));
      EntityWatch watch = new EntityWatch();
      long compared = 0;
      int tick = 0;
      int guests = 0;
      double begunS = stepper.nowNs() * 1e-9;
      while (stepper.nowNs() * 1e-9 - begunS < 25) {
        stepper.step();
        Room room = stepper.room();
        if (room.tick() == tick) {
          continue;
        }
        tick = room.tick();
        watch.follow(room);
        compared += watch.check(slow);
        if (tick % 150 == 0) {
          SimulatedClient guest = stepper.clients().get(guests % 9);
          guest.leave(); // its body goes, and that of a newcomer appears
          stepper.remove(guest);
          stepper.add(
              config.with(ClientConfig.NAME, "guest" + guests++),
              Impairment.NONE,
              Scripts.wander(guests));
        }
      }
      assertTrue(guests > 5 && compared > 10_000, "guests=" + guests + " compared=" + compared);
    }
  }

  private void soak(double seconds, Soak.Play play) throws Exception {
    System.out.printf("soak: seed=%d seconds=%.0f play=%s%n", SEED, seconds, play);
    Soak soak = new Soak(new Soak.Settings(SEED, seconds, 16, play, folder, true));
    try {
      soak.run(Incident.script(SEED, seconds, 16));
      assertEquals(List.of(), soak.unseenQueues(), "bounds that no queue was compared with");
    } catch (AssertionError | RuntimeException e) {
      throw new AssertionError(
          String.format(
              Locale.ROOT, "at %.2f s; to see it again: -Dcarom.seed=%d", soak.elapsedS(), SEED),
          e);
    }
  }

  @Test
  void equalSeedsGiveEqualScriptsAndLongerOnesGoOn() {
    List<Incident> script = Incident.script(SEED, 600, 16);
    assertEquals(script, Incident.script(SEED, 600, 16));
    List<Incident> shorter = Incident.script(SEED, 60, 16);
    assertEquals(script.subList(0, shorter.size()), shorter);
    Set<Incident.Kind> kinds = EnumSet.noneOf(Incident.Kind.class);
    script.forEach(incident -> kinds.add(incident.kind()));
    assertTrue(kinds.size() > 10, "kinds=" + kinds + " seed=" + SEED);
  }
}
