package carom.server;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.net.protocol.InputDatagram;
import carom.net.snapshot.SnapshotEncoder;
import carom.net.snapshot.exact.NearState;
import carom.server.config.ServerConfig;
import java.util.BitSet;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * Goal: the exact state of the predicted set, the own body, events and records share the budget of
 * a session. Method: a player in the middle of a pile that the game stirs all the time, so that far
 * more rows and records wait than the budget takes, in virtual time.
 */
class NearBudgetTest {
  private static final int BALLS = 300;
  private static final int SECONDS = 8;

  /** Length of the whole run, s: a datagram more or less counts for little in its mean. */
  private static final int ALL_SECONDS = 20;

  /** What may leave at once after a quiet time. */
  private static final int DEPTH_BITS = 4 * 8 * SnapshotEncoder.MAX_DATAGRAM_BYTES;

  @ParameterizedTest
  @CsvSource({"32000, 450", "48000, 250", "128000, 60"})
  void nearUpdatesAndRecordsShareTheBudget(int bitsPerSecond, int oldestTicks) {
    TestGame game = new TestGame(BALLS);
    game.crowded = true;
    ServerConfig config = ServerConfig.defaults().with(ServerConfig.BUDGET, bitsPerSecond / 1_000);
    try (Rig rig = new Rig(config, game)) {
      FakeClient client = rig.connect().hello("Ann");
      client.near = InputDatagram.NEAR_ALL;
      Updates updates = new Updates(client);
      client.onDecoded = updates::see;
      long[] bytes = new long[60 * ALL_SECONDS];
      for (int i = 0; i < bytes.length; i++) {
        rig.step();
        bytes[i] = client.bytes;
        long second = 8 * (bytes[i] - (i < 60 ? 0 : bytes[i - 60]));
        assertTrue(second <= bitsPerSecond + DEPTH_BITS, "step=" + i + " bits=" + second);
        if (i == 60 * SECONDS - 1) {
          assertTrue(updates.rows >= SECONDS * bitsPerSecond / 2_000, "rows=" + updates.rows);
          assertTrue(updates.whole >= SECONDS / 4, "came as a whole: " + updates.whole);
        }
      }
      assertEquals(0, client.undecodable);
      double mean = 8.0 * (bytes[bytes.length - 1] - bytes[119]) / (ALL_SECONDS - 2);
      assertEquals(bitsPerSecond, mean, 0.02 * bitsPerSecond);
      for (int slot = 0; slot < BALLS; slot++) {
        assertNotNull(client.decoder.history(slot), "slot=" + slot + " was never told");
        int age = rig.room.tick() - client.decoder.history(slot).tick(0);
        assertTrue(age <= oldestTicks, "slot=" + slot + " age=" + age);
      }
      String why = RoomTest.ask(rig, 0, 1);
      assertTrue(why.matches(".* ahead=\\d+ near=\\d+ nearRowsWaiting=\\d+ .*"), why);
    }
  }

  /** What a client gets of exact state of what is near. */
  private static final class Updates {
    private final FakeClient client;
    private final BitSet held = new BitSet();
    private int baseTick = -1;
    private int rows;
    private int whole;

    Updates(FakeClient client) {
      this.client = client;
    }

    void see() {
      if (!client.decoder.hasOwn() || !client.decoder.own().near().updating()) {
        return;
      }
      NearState near = client.decoder.own().near();
      int base = client.decoder.tick() - near.age();
      if (base != baseTick) {
        held.clear();
        baseTick = base;
      }
      rows += near.partRows();
      boolean was = held.cardinality() == near.totalRows();
      held.set(near.firstRow(), near.firstRow() + near.partRows());
      whole += !was && held.cardinality() == near.totalRows() ? 1 : 0;
    }
  }
}
