package carom.server;

import carom.net.kryo.KryoMessageCodec;
import carom.net.transport.InProcessNetwork;
import carom.server.config.ServerConfig;
import carom.server.metrics.Counter;
import carom.server.room.Room;
import java.util.ArrayList;
import java.util.List;

/** A server and its clients in one thread and in virtual time. */
final class Rig implements AutoCloseable {
  static final long TICK_NS = 16_666_667;

  final InProcessNetwork network = new InProcessNetwork(new KryoMessageCodec());
  final List<FakeClient> clients = new ArrayList<>();
  final TestGame game;
  final Server server;
  final Room room;
  long nowNs = 1_000_000_000L;

  Rig() {
    this(ServerConfig.defaults(), new TestGame(3));
  }

  Rig(ServerConfig config, TestGame game) {
    this.game = game;
    server =
        new Server(
            config.withStatusIntervalS(0), game, TestGame.level(), network.server(), () -> nowNs);
    room = server.room();
    server.tick(nowNs);
  }

  FakeClient connect() {
    FakeClient client = new FakeClient(network.client().connect("", 0, 0));
    clients.add(client);
    return client;
  }

  /** Connects and plays; fails the test when that takes longer than a virtual second. */
  FakeClient join(String name) {
    return join(name, 0);
  }

  FakeClient join(String name, long secret) {
    FakeClient client = connect().hello(name, secret);
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
    for (int i = clients.size() - 1; i >= 0; i--) {
      clients.get(i).step(room.tick());
    }
    server.tick(nowNs);
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
    return server.counters().get(counter);
  }

  @Override
  public void close() {
    server.close();
  }
}
