package carom.lab.mixed;

import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.suite.Needs;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/**
 * Goal: own clients, stock KryoNet and WebSocket show the same room. Method: half a minute of
 * {@code ./gradlew mixed}, on real ports.
 */
@Needs("sockets")
@Timeout(180)
final class MixedRoomTest {
  @Test
  void allShowWhatTheServerHas() throws Exception {
    StringBuilder said = new StringBuilder();
    long seed = System.nanoTime();
    try (MixedRoom room = new MixedRoom(2, seed)) {
      boolean good = room.run(27, line -> said.append(line).append('\n'));
      assertTrue(good, () -> "seed=" + seed + "\n" + said + room.wrong());
    }
  }
}
