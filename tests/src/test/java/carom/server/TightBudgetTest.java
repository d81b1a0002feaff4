package carom.server;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.net.snapshot.SnapshotEncoder;
import carom.net.snapshot.frame.FrameState;
import carom.server.config.ServerConfig;
import java.util.Arrays;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * Goal: with the smallest budget, 16 kbit/s, in a world that moves all the time, every body gets
 * its turn, important ones more often, and the own body is in each snapshot. Method: a player in
 * the middle of a pile that the game stirs, in virtual time; the measure is the age of each body's
 * newest state at the client.
 */
class TightBudgetTest {
  private static final int LEAST_BITS_PER_SECOND = 16_000;
  private static final int SECONDS = 8;

  /** What may leave at once after a quiet time. */
  private static final int DEPTH_BYTES = 4 * SnapshotEncoder.MAX_DATAGRAM_BYTES;

  @ParameterizedTest
  @CsvSource({"20, 6", "50, 60", "100, 180"})
  void nobodyStarvesAndWhatIsNearComesFirst(int balls, int oldestTicks) {
    TestGame game = new TestGame(balls);
    game.crowded = true;
    ServerConfig config =
        ServerConfig.defaults().with(ServerConfig.BUDGET, LEAST_BITS_PER_SECOND / 1_000);
    try (Rig rig = new Rig(config, game)) {
      FakeClient client = rig.connect().hello("Ann");
      for (int i = 0; i < 180; i++) {
        rig.step();
      }
      long near = 0;
      long far = 0;
      long bytes = client.bytes;
      double[] distances = new double[balls];
      for (int i = 0; i < 60 * SECONDS; i++) {
        rig.step();
        assertTrue(rig.room.tick() - client.decoder.newestTick() <= 6, "the own body is late");
        measure(rig.room.frames().newest(), client.decoder.own().slot(), distances);
        double[] sorted = distances.clone();
        Arrays.sort(sorted);
        for (int slot = 0; slot < balls; slot++) {
          int age = rig.room.tick() - client.decoder.history(slot).tick(0);
          assertTrue(age <= oldestTicks, "slot=" + slot + " age=" + age);
          near += distances[slot] < sorted[balls / 4] ? age : 0;
          far += distances[slot] >= sorted[balls - balls / 4] ? age : 0;
        }
      }
      assertEquals(0, client.undecodable);
      long most = LEAST_BITS_PER_SECOND / 8 * SECONDS + DEPTH_BYTES;
      assertTrue(client.bytes - bytes <= most, "bytes=" + (client.bytes - bytes));
      assertTrue(balls == 20 || near < far, "ages near " + near + ", far " + far);
    }
  }

  private static void measure(FrameState frame, int own, double[] distances) {
    for (int slot = 0; slot < distances.length; slot++) {
      distances[slot] = Math.hypot(frame.x(slot) - frame.x(own), frame.y(slot) - frame.y(own));
    }
  }
}
