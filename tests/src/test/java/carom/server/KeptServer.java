package carom.server;

import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.net.kryo.KryoMessageCodec;
import carom.net.transport.InProcessNetwork;
import carom.server.config.RoomConfig;
import carom.server.config.ServerConfig;
import carom.server.match.HandedInMatch;
import carom.server.match.MatchLibrary;
import carom.server.room.Room;
import carom.sim.level.Level;
import carom.sim.level.LevelException;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;

/** A server in virtual time that keeps checkpoints, and what a crash leaves of it. */
final class KeptServer implements AutoCloseable {
  static final long TICK_NS = 16_666_667;
  static final ServerConfig CONFIG =
      ServerConfig.defaults().with(ServerConfig.STATUS_INTERVAL, 0).with(ServerConfig.GRACE, 600);

  /** Bodies, joints to each other and to the world, and an area; a chain that swings for long. */
  private static final String JOINTS =
      """
      {
        "name": "chain", "game": "test", "gravity": [0, -10],
        "bounds": { "min": [-1000, -1000], "max": [1000, 1000] },
        "spawns": [ { "name": "player", "at": [0, 0] } ],
        "bodies": [
          { "name": "plank", "at": [-4, 2], "shape": { "type": "box", "width": 0.9, "height": 0.2 },
            "repeat": { "columns": 3, "step": [1, 0] } }
        ],
        "joints": [
          { "type": "revolute", "b": "plank[0]", "at": [-4.5, 2] },
          { "type": "revolute", "a": "plank[0]", "b": "plank[1]", "at": [-3.5, 2], "breaks": { "force": 900 } },
          { "type": "revolute", "a": "plank[1]", "b": "plank[2]", "at": [-2.5, 2] },
          { "type": "rope", "b": "plank[2]", "from": [-1.5, 4], "to": [-1.5, 2], "length": 2.5 }
        ]
      }
      """;

  final Server server;
  final List<FakeClient> clients = new ArrayList<>();
  private final InProcessNetwork network = new InProcessNetwork(new KryoMessageCodec());
  long nowNs;

  /** Tick and hash of the state in which the server began. */
  final int resumedTick;

  final long resumedHash;

  /** Starts a server that keeps checkpoints in a folder each second; null for no checkpoints. */
  KeptServer(MatchLibrary library, List<String> levels, Path folder, long nowNs) {
    this(CONFIG, library, levels, folder, nowNs);
  }

  KeptServer(
      ServerConfig config, MatchLibrary library, List<String> levels, Path folder, long nowNs) {
    this.nowNs = nowNs;
    RoomConfig room = new RoomConfig("cup", "", levels, 8, 7, Map.of());
    server = new Server(config, List.of(room), library, network.server(), () -> this.nowNs);
    try {
      if (folder != null) {
        server.checkpoint(folder, 1);
      }
    } catch (IOException e) {
      server.close();
      throw new UncheckedIOException(e);
    }
    resumedTick = tick();
    resumedHash = hash();
    server.tick(nowNs);
  }

  /** Returns what finds the installed games, and the game of tests in a level with joints. */
  static MatchLibrary library() {
    return library(JOINTS, 0);
  }

  /** Returns what finds the installed games, and the game of tests in a level. */
  static MatchLibrary library(String level, int balls) {
    try {
      Level parsed = Level.parse("chain", level.getBytes(StandardCharsets.UTF_8));
      return new HandedInMatch(() -> new TestGame(balls), parsed);
    } catch (LevelException e) {
      throw new AssertionError(e);
    }
  }

  Room room() {
    return server.rooms().get(0);
  }

  int tick() {
    return room().simulation().tick();
  }

  long hash() {
    return room().simulation().stateHash();
  }

  void step() {
    nowNs += TICK_NS;
    for (FakeClient client : clients) {
      client.step(tick());
    }
    server.tick(nowNs);
  }

  void runTo(int tick) {
    while (tick() < tick) {
      step();
    }
  }

  FakeClient join(String name, long secret) {
    FakeClient client = new FakeClient(network.client().connect("", 0, 0)).hello(name, secret);
    clients.add(client);
    for (int i = 0; i < 120 && (client.decoder == null || !client.decoder.hasAck()); i++) {
      step();
    }
    assertTrue(client.decoder != null && client.decoder.hasAck(), () -> "" + client.messages);
    return client;
  }

  @Override
  public void close() {
    server.close();
  }
}
