package carom.server;

import static org.junit.jupiter.api.Assertions.assertDoesNotThrow;

import carom.net.kryo.server.KryoLimits;
import carom.net.kryo.server.KryoServerTransport;
import carom.server.config.RoomConfig;
import carom.server.config.ServerConfig;
import carom.server.lobby.Lobby;
import carom.suite.Needs;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;

/**
 * Goal: a server starts with every combination of settings that are each inside its stated range.
 * Method: the ends of all ranges and random values between them; rooms, seats, the transport's
 * limits and its ports are made as the program makes them.
 */
@Needs("sockets")
class StatedRangesTest {
  private static final long SEED = Long.getLong("carom.seed", 37);

  private final Random random = new Random(SEED);

  private int in(int least, int most) {
    int choice = random.nextInt(4);
    return choice == 0 ? least : choice == 1 ? most : least + random.nextInt(most - least + 1);
  }

  private ServerConfig config(int rooms) {
    int players = in(1, Math.min(1_024, ServerConfig.MAX_PLACES / rooms));
    return ServerConfig.defaults()
        .with(ServerConfig.ROOMS, rooms)
        .with(ServerConfig.MAX_PLAYERS, players)
        .with(ServerConfig.TICK_RATE, in(10, 240))
        .with(ServerConfig.SNAPSHOT_RATE, in(1, 240))
        .with(ServerConfig.GRACE, in(0, 600))
        .with(ServerConfig.NETWORK_SHARE, in(1, 100))
        .with(ServerConfig.STATUS_INTERVAL, in(0, 86_400));
  }

  @Test
  void everyCombinationInsideTheStatedRangesHasItsLinks() {
    for (int i = 0; i < 400; i++) {
      ServerConfig config = config(in(1, ServerConfig.MAX_ROOMS));
      String told = "seed=" + SEED + " " + config;
      List<RoomConfig> rooms = RoomConfig.equalRooms(config, List.of());
      assertDoesNotThrow(() -> limits(RoomConfig.places(rooms)), told);
    }
  }

  @Test
  void theLargestServerOpensItsPorts() {
    ServerConfig largest = ServerConfig.defaults().with(ServerConfig.ROOMS, ServerConfig.MAX_ROOMS);
    int places = RoomConfig.places(RoomConfig.equalRooms(largest, List.of()));
    for (int pending : new int[] {1, 1_024, 4_096}) {
      new KryoServerTransport(0, 0, limits(places).withPending(pending)).close();
    }
  }

  private static KryoLimits limits(int places) {
    return KryoLimits.DEFAULT.withConnections(Lobby.mostLinks(places), places + 32);
  }
}
