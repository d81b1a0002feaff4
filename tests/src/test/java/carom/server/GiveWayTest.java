package carom.server;

import static org.junit.jupiter.api.Assertions.assertEquals;

import carom.net.protocol.ServerMessage;
import carom.server.config.ServerConfig;
import carom.server.metrics.Counter;
import org.junit.jupiter.api.Test;

/** Goal: one newcomer takes the seat of one absent player only, however often the lobby asks. */
class GiveWayTest {
  private void probe(int rooms, int turnsPerTick) {
    try (Rig rig =
        new Rig(
            ServerConfig.defaults()
                .with(ServerConfig.ROOMS, rooms)
                .with(ServerConfig.MAX_PLAYERS, 4),
            () -> new TestGame(1))) {
      int places = 4 * rooms;
      FakeClient[] players = new FakeClient[places];
      for (int i = 0; i < places; i++) {
        players[i] = rig.join("p" + i);
      }
      for (FakeClient player : players) {
        player.link.close("killed");
      }
      rig.seconds(10.1);
      assertEquals(places, rig.count(Counter.PLAYERS_IN_GRACE));
      FakeClient newcomer = rig.connect().hello("newcomer");
      for (int i = 0; i < 60; i++) {
        for (int turn = 1; turn < turnsPerTick; turn++) {
          rig.server.tick(rig.nowNs + turn * 4_000_000L);
        }
        rig.step();
      }
      assertEquals(
          places - 1,
          rig.count(Counter.PLAYERS_IN_GRACE),
          "rooms="
              + rooms
              + " "
              + newcomer.messages.stream()
                  .filter(m -> m instanceof ServerMessage.Refused)
                  .toList());
    }
  }

  @Test
  void oneTurnPerTick() {
    probe(1, 1);
  }

  @Test
  void fourTurnsPerTickAsWithThreads() {
    probe(1, 4);
  }

  @Test
  void threeRooms() {
    probe(3, 1);
  }
}
