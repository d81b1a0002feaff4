package carom.server;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.net.kryo.KryoMessageCodec;
import carom.net.protocol.GoodbyeReason;
import carom.net.transport.InProcessNetwork;
import carom.net.transport.Link;
import carom.net.transport.LinkCounters;
import carom.net.transport.LinkHandler;
import carom.net.transport.ServerTransport;
import carom.server.config.ServerConfig;
import carom.server.metrics.Counter;
import carom.suite.Alone;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Alone("measures")
class ServerTest {
  private final InProcessNetwork network = new InProcessNetwork(new KryoMessageCodec());

  @Test
  @Timeout(20)
  void threadsKeepTheRateAndStopWithinTwoSeconds() throws Exception {
    ServerConfig config = ServerConfig.defaults();
    Server server =
        new Server(
            config, () -> new TestGame(10), TestGame.level(), network.server(), System::nanoTime);
    server.start();
    assertThrows(IllegalStateException.class, () -> server.tick(0));
    assertThrows(IllegalStateException.class, server::start);
    FakeClient client = new FakeClient(network.client().connect("", 0, 0)).hello("Ann");
    long begin = System.nanoTime();
    while (System.nanoTime() - begin < 1_500_000_000L) {
      client.step(server.rooms().get(0).tick());
      Thread.sleep(4);
    }
    double seconds = (System.nanoTime() - begin) / 1e9;
    assertTrue(client.datagrams > 20, "datagrams=" + client.datagrams);
    long ticks = server.count(Counter.TICKS);
    long dropped = server.count(Counter.TICKS_DROPPED);
    assertEquals(seconds * 60, ticks + dropped, 15);

    long stopNs = System.nanoTime();
    Thread closer = new Thread(server::close);
    closer.start();
    while (closer.isAlive()) {
      client.step(0);
      Thread.sleep(4);
    }
    long tookMs = (System.nanoTime() - stopNs) / 1_000_000;
    client.step(0);
    assertEquals(GoodbyeReason.SERVER_STOPPING, client.goodbye.reason());
    assertTrue(tookMs < 2_000, "tookMs=" + tookMs);
    server.awaitStop();
    assertFalse(server.hasFailed());
  }

  @Test
  @Timeout(20)
  void serverWhoseGameFailsForGoodEndsItself() throws Exception {
    TestGame game = new TestGame(1);
    game.failEvery = 1;
    try (Server server =
        new Server(
            ServerConfig.defaults(),
            () -> game,
            TestGame.level(),
            network.server(),
            System::nanoTime)) {
      server.start();
      server.awaitStop();
      assertTrue(server.hasFailed());
    }
  }

  @Test
  void linkThatThrowsEndsItsOwnSessionOnly() {
    long[] nowNs = {0};
    BreakableTransport transport = new BreakableTransport(network.server());
    try (Server server =
        new Server(
            ServerConfig.defaults(),
            () -> new TestGame(3),
            TestGame.level(),
            transport,
            () -> nowNs[0])) {
      FakeClient a = new FakeClient(network.client().connect("", 0, 0)).hello("a");
      FakeClient b = new FakeClient(network.client().connect("", 0, 0)).hello("b");
      for (int step = 0; step < 120; step++) {
        nowNs[0] += Rig.TICK_NS;
        if (step == 60) {
          assertEquals(2, server.count(Counter.PLAYERS));
          transport.last.broken = true; // b's
        }
        a.step(server.rooms().get(0).tick());
        b.step(server.rooms().get(0).tick());
        server.tick(nowNs[0]);
      }
      assertEquals(1, server.count(Counter.SESSIONS_FAILED));
      assertEquals(1, server.count(Counter.PLAYERS));
      assertNull(a.goodbye);
      assertEquals(0, a.undecodable);
      assertEquals(server.rooms().get(0).tick(), a.decoder.newestTick(), 1);
      assertEquals(1, server.rooms().get(0).seats().takenCount());
    }
  }

  @Test
  void timeThatInputsWaitInTheInboxCountsAsHeldByTheServer() {
    long[] nowNs = {0};
    BreakableTransport transport = new BreakableTransport(network.server());
    try (Server server =
        new Server(
            ServerConfig.defaults(),
            () -> new TestGame(3),
            TestGame.level(),
            transport,
            () -> nowNs[0])) {
      FakeClient client = new FakeClient(network.client().connect("", 0, 0)).hello("a");
      for (int step = 0; step < 60; step++) {
        nowNs[0] += Rig.TICK_NS;
        client.step(server.rooms().get(0).tick());
        server.tick(nowNs[0]);
        transport.last.waitedNs = 7_500_000;
      }
      assertTrue(client.decoder.feedback().present);
      assertEquals(7, client.decoder.feedback().holdMs);
    }
  }

  /** Links that throw from everything, once told to. */
  private static final class BreakableTransport implements ServerTransport {
    private final ServerTransport real;
    BreakableLink last;

    BreakableTransport(ServerTransport real) {
      this.real = real;
    }

    @Override
    public Link accept() {
      Link link = real.accept();
      return link == null ? null : (last = new BreakableLink(link));
    }

    @Override
    public int tcpPort() {
      return 0;
    }

    @Override
    public int udpPort() {
      return 0;
    }

    @Override
    public void close() {
      real.close();
    }
  }

  private static final class BreakableLink implements Link {
    private final Link real;
    boolean broken;
    long waitedNs;

    BreakableLink(Link real) {
      this.real = real;
    }

    private Link real() {
      if (broken) {
        throw new IllegalStateException("broken on purpose");
      }
      return real;
    }

    @Override
    public State state() {
      return real().state();
    }

    @Override
    public boolean send(Object message) {
      return real().send(message);
    }

    @Override
    public boolean sendDatagram(byte[] bytes, int offset, int length) {
      return real().sendDatagram(bytes, offset, length);
    }

    @Override
    public int poll(LinkHandler handler, int max) {
      return real()
          .poll(
              new LinkHandler() {
                @Override
                public void message(Link link, Object message) {
                  handler.message(BreakableLink.this, message);
                }

                @Override
                public void datagram(Link link, byte[] bytes, int length) {
                  handler.datagram(BreakableLink.this, bytes, length);
                }

                @Override
                public void closed(Link link, String reason) {
                  handler.closed(BreakableLink.this, reason);
                }
              },
              max);
    }

    @Override
    public void close(String reason) {
      real().close(reason);
    }

    @Override
    public long waitedNs() {
      return waitedNs;
    }

    @Override
    public String remote() {
      return "breakable";
    }

    @Override
    public String closeReason() {
      return real.closeReason();
    }

    @Override
    public LinkCounters counters() {
      return real.counters();
    }
  }
}
