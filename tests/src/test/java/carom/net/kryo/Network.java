package carom.net.kryo;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.net.frame.Trust;
import carom.net.kryo.server.KryoLimits;
import carom.net.kryo.server.KryoServerTransport;
import carom.net.transport.ClientTransport;
import carom.net.transport.Link;
import carom.net.transport.LinkHandler;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;

/** A server on free ports of this machine, with links to it; closes all of it. */
final class Network implements AutoCloseable {
  static final String HOST = "127.0.0.1";

  /** Both ends of one link, with what has arrived at each. */
  static final class Pair {
    final Link client;
    final Link server;
    final Inbox atClient = new Inbox();
    final Inbox atServer = new Inbox();

    Pair(Link client, Link server) {
      this.client = client;
      this.server = server;
    }

    void poll() {
      client.poll(atClient, 1_000);
      server.poll(atServer, 1_000);
    }
  }

  /** Keeps everything. */
  static final class Inbox implements LinkHandler {
    final List<Object> messages = new ArrayList<>();
    final List<byte[]> datagrams = new ArrayList<>();
    int closed;
    String reason;

    @Override
    public void message(Link link, Object message) {
      messages.add(message);
    }

    @Override
    public void datagram(Link link, byte[] bytes, int length) {
      datagrams.add(Arrays.copyOf(bytes, length));
    }

    @Override
    public void closed(Link link, String text) {
      closed++;
      reason = text;
    }
  }

  final KryoServerTransport server;
  final ClientTransport clients;

  Network() {
    this(KryoLimits.DEFAULT);
  }

  Network(KryoLimits limits) {
    this(limits, new KryoClientTransport(Trust.firstUse(), 1_500));
  }

  Network(KryoLimits limits, ClientTransport clients) {
    server = new KryoServerTransport(0, 0, limits);
    this.clients = clients;
  }

  Link connect() {
    return clients.connect(HOST, server.tcpPort(), server.udpPort());
  }

  Pair pair() {
    Link client = connect();
    Link[] accepted = new Link[1];
    eventually(
        () -> {
          if (accepted[0] == null) {
            accepted[0] = server.accept();
          }
          return client.state() != Link.State.CONNECTING && accepted[0] != null
              || client.state() == Link.State.CLOSED;
        },
        () -> "client=" + client + " reason=" + client.closeReason());
    assertEquals(Link.State.OPEN, client.state(), client::closeReason);
    return new Pair(client, accepted[0]);
  }

  static void eventually(BooleanSupplier condition, java.util.function.Supplier<String> what) {
    long deadline = System.nanoTime() + 5_000_000_000L;
    while (!condition.getAsBoolean()) {
      assertTrue(System.nanoTime() < deadline, what);
      pause(2);
    }
  }

  static void pause(int millis) {
    try {
      TimeUnit.MILLISECONDS.sleep(millis);
    } catch (InterruptedException x) {
      throw new AssertionError(x);
    }
  }

  @Override
  public void close() {
    clients.close();
    server.close();
  }
}
