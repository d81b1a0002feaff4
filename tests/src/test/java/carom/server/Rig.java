package carom.server;

import carom.net.kryo.KryoMessageCodec;
import carom.net.transport.InProcessNetwork;
import carom.server.config.ServerConfig;
import carom.server.metrics.Counter;
import carom.server.room.Room;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Supplier;

/**
 * A server and its clients in one thread and in virtual time. {@code game} and {@code room} are the
 * first of {@code games} and {@code server.rooms()}.
 */
final class Rig implements AutoCloseable {
  static final long TICK_NS = 16_666_667;

  final InProcessNetwork network = new InProcessNetwork(new KryoMessageCodec());
  final List<FakeClient> clients = new ArrayList<>();
  final List<TestGame> games = new ArrayList<>();
  final TestGame game;
  final Server server;
  final Room room;
  long nowNs = 1_000_000_000L;

  Rig() {
    this(ServerConfig.defaults(), new TestGame(3));
  }

  Rig(ServerConfig config, TestGame game) {
    this(config, () -> game);
  }

  Rig(ServerConfig config, Supplier<TestGame> supply) {
    server =
        new Server(
            config.with(ServerConfig.STATUS_INTERVAL, 0),
            () -> {
              games.add(supply.get());
              return games.get(games.size() - 1);
            },
            TestGame.level(),
            network.server(),
            () -> nowNs);
    game = games.get(0);
    room = server.rooms().get(0);
    server.tick(nowNs);
  }

  FakeClient connect() {
    FakeClient client = new FakeClient(network.client().connect("", 0, 0));
    clients.add(client);
    return client;
  }

  FakeClient connectFrom(String address) {
    FakeClient client = new FakeClient(network.connectFrom(address));
    clients.add(client);
    return client;
  }

  /** Plays from an address; fails the test when that takes longer than a virtual second. */
  FakeClient joinFrom(String address, String name) {
    return play(connectFrom(address).hello(name), name);
  }

  /** Connects and plays; fails the test when that takes longer than a virtual second. */
  FakeClient join(String name) {
    return join(name, 0);
  }

  FakeClient join(String name, long secret) {
    return play(connect().hello(name, secret), name);
  }

  private FakeClient play(FakeClient client, String name) {
    for (int i = 0; i < 60; i++) {
      step();
      if (client.decoder != null && client.decoder.hasAck()) {
        return client;
      }
    }
    throw new AssertionError("no snapshot for " + name + " within a second: " + client.messages);
  }

  void step() {
    nowNs += TICK_NS;
    int tick = tick();
    for (int i = clients.size() - 1; i >= 0; i--) {
      clients.get(i).step(tick);
    }
    server.tick(nowNs);
  }

  /** All rooms keep the same time unless they fail. */
  private int tick() {
    int tick = 0;
    for (Room each : server.rooms()) {
      tick = Math.max(tick, each.tick());
    }
    return tick;
  }

  void steps(int count) {
    for (int i = 0; i < count; i++) {
      step();
    }
  }

  void seconds(double seconds) {
    steps((int) Math.round(seconds * 60));
  }

  long count(Counter counter) {
    return server.count(counter);
  }

  @Override
  public void close() {
    server.close();
  }
}
