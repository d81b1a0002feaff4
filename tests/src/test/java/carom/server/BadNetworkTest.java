package carom.server;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.game.Games;
import carom.net.kryo.KryoMessageCodec;
import carom.net.snapshot.DecodeStatus;
import carom.net.snapshot.EntityHistory;
import carom.net.snapshot.frame.FrameState;
import carom.net.transport.ImpairedLink;
import carom.net.transport.Impairment;
import carom.net.transport.InProcessNetwork;
import carom.server.config.ServerConfig;
import carom.server.metrics.Counter;
import carom.sim.level.Level;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * The games that ship, with clients that press random buttons over bad networks. Goal: whatever is
 * lost, what a client decodes is exactly the server's frame state of that tick, and the server
 * expels no client. Method: virtual time, and a comparison at each decoded datagram.
 */
class BadNetworkTest {
  private static final int SECONDS = 20;

  @ParameterizedTest
  @CsvSource({
    "arena, 0, 0, 0",
    "arena, 10, 50, 20",
    "arena, 2, 150, 50",
    "platformer, 10, 50, 20",
    "platformer, 30, 20, 10",
  })
  void whatIsDecodedIsExact(String name, double loss, double latencyMs, double jitterMs)
      throws Exception {
    long seed = Long.getLong("carom.seed", 11);
    Random random = new Random(seed);
    long[] nowNs = {0};
    InProcessNetwork network = new InProcessNetwork(new KryoMessageCodec());
    ServerConfig config =
        ServerConfig.defaults().with(ServerConfig.GAME, name).with(ServerConfig.STATUS_INTERVAL, 0);
    Level level = Level.builtIn(Games.create(name).defaultLevel());
    try (Server server =
        new Server(config, () -> Games.create(name), level, network.server(), () -> nowNs[0])) {
      Impairment bad =
          Impairment.NONE.withSeed(seed).withLoss(loss).withLatency(latencyMs, jitterMs);
      List<FakeClient> clients = new ArrayList<>();
      int[] compared = {0};
      for (int i = 0; i < 6; i++) {
        FakeClient client =
            new FakeClient(
                new ImpairedLink(
                    network.client().connect("", 0, 0),
                    bad.withSeed(seed + 2L * i),
                    bad.withSeed(seed + 2L * i + 1),
                    () -> nowNs[0]));
        client.leadTicks = 20;
        client.onDecoded = () -> compared[0] += assertExact(server, client, "seed=" + seed);
        client.hello("p" + i);
        clients.add(client);
      }
      for (int step = 0; step < SECONDS * 60; step++) {
        nowNs[0] += Rig.TICK_NS;
        for (FakeClient client : clients) {
          if (random.nextInt(20) == 0) {
            client.input.unpack(random.nextLong());
          }
          client.step(server.rooms().get(0).tick());
        }
        server.tick(nowNs[0]);
      }
      String about = "seed=" + seed + " " + server.status();
      assertTrue(compared[0] > 1_000, about);
      for (FakeClient client : clients) {
        assertNull(client.goodbye, about);
        assertNull(client.refused, about);
        assertEquals(0, client.statuses[DecodeStatus.DAMAGED.ordinal()], about);
        assertTrue(client.statuses[DecodeStatus.OK.ordinal()] > 600 * (1 - loss / 100), about);
      }
      assertEquals(0, server.count(Counter.GAME_FAILURES), about);
      assertEquals(0, server.count(Counter.SESSIONS_FAILED), about);
      assertEquals(6, server.count(Counter.PLAYERS), about);
    }
  }

  private static int assertExact(Server server, FakeClient client, String about) {
    int tick = client.decoder.tick();
    FrameState frame = server.rooms().get(0).frames().at(tick);
    if (frame == null) {
      return 0; // came so late that the server has forgotten it
    }
    for (int i = 0; i < client.decoder.touchedCount(); i++) {
      int slot = client.decoder.touchedSlot(i);
      EntityHistory history = client.decoder.history(slot);
      int at = history.indexAt(tick);
      String where = about + " tick=" + tick + " slot=" + slot;
      assertTrue(at >= 0, where);
      assertEquals(frame.alive(slot), history.alive(at), where);
      if (frame.alive(slot)) {
        assertEquals(frame.x(slot), history.x(at), where);
        assertEquals(frame.y(slot), history.y(at), where);
        assertEquals(frame.angle(slot), history.angle(at), where);
        assertEquals(frame.still(slot), history.still(at), where);
        assertEquals(frame.generation(slot), history.generation(at), where);
        assertEquals(frame.ownership(slot), history.ownership(at), where);
      }
    }
    return client.decoder.touchedCount();
  }
}
