package carom.net.kryo.server;

import carom.net.admission.AddressGroup;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.channels.ClosedSelectorException;
import java.nio.channels.SelectionKey;
import java.nio.channels.Selector;
import java.nio.channels.SocketChannel;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;

/**
 * Reads the headers of connections that come by proxies, on a daemon thread of its own, before
 * KryoNet sees them. A connection waits {@value #DEADLINE_MS} ms for its header at most, and only
 * {@value #MOST_WAITING} at a time. What isn't a header closes the connection.
 */
final class ProxyGate implements AutoCloseable {
  private static final long DEADLINE_MS = 3_000;
  private static final int MOST_WAITING = 256;
  private static final long SWEEP_MS = 200;
  private static final long MINUTE_NANOS = 60_000_000_000L;

  /** A connection whose header has come; without an address it is the proxy's own. */
  record Arrival(SocketChannel channel, InetSocketAddress client) {}

  private static final class Waiting {
    private final ProxyHeader header = new ProxyHeader();
    private final long since = System.nanoTime();
  }

  private final ProxyRule rule;
  private final Runnable wake;
  private final Selector selector;
  private final Queue<SocketChannel> coming = new ConcurrentLinkedQueue<>();
  private final Queue<Arrival> arrived = new ConcurrentLinkedQueue<>();
  private final Thread thread = new Thread(this::run, "carom-server-proxies");

  // used by the gate's thread
  private long refused;
  private boolean told;
  private long toldAt;

  /**
   * Creates a gate and starts its thread.
   *
   * @param wake runs when {@link #next} has something; any thread
   */
  ProxyGate(ProxyRule rule, Runnable wake) throws IOException {
    this.rule = rule;
    this.wake = wake;
    selector = Selector.open();
    thread.setDaemon(true);
    thread.start();
  }

  /** Takes a connection that a proxy has opened. */
  void add(SocketChannel channel) {
    coming.add(channel);
    selector.wakeup();
  }

  /** Returns the next connection whose header has come, or null. */
  Arrival next() {
    return arrived.poll();
  }

  private void run() {
    while (selector.isOpen()) {
      try {
        if (selector.keys().isEmpty() && coming.isEmpty()) {
          selector.select(key -> {});
        } else {
          selector.select(this::read, SWEEP_MS);
        }
        for (SocketChannel channel; (channel = coming.poll()) != null; ) {
          begin(channel);
        }
        sweep(System.nanoTime());
      } catch (IOException | ClosedSelectorException e) {
        return; // closed
      } finally {
        Thread.interrupted(); // an interrupted thread would never wait in select again
      }
    }
  }

  private void begin(SocketChannel channel) {
    try {
      if (selector.keys().size() >= MOST_WAITING) {
        refuse(channel, "too many wait for their header");
        return;
      }
      channel.configureBlocking(false);
      read(channel.register(selector, SelectionKey.OP_READ, new Waiting()));
    } catch (IOException e) {
      refuse(channel, String.valueOf(e.getMessage()));
    }
  }

  private void read(SelectionKey key) {
    SocketChannel channel = (SocketChannel) key.channel();
    ProxyHeader header = ((Waiting) key.attachment()).header;
    try {
      int read;
      do {
        read = channel.read(header.target());
        if (read < 0) {
          refuse(channel, "it ended within the header");
          return;
        }
        if (header.isWhole()) {
          key.cancel();
          arrived.add(new Arrival(channel, header.client()));
          wake.run();
          return;
        }
      } while (read > 0);
    } catch (IllegalArgumentException e) {
      refuse(channel, e.getMessage());
    } catch (IOException e) {
      refuse(channel, "it ended within the header");
    }
  }

  private void sweep(long now) {
    for (SelectionKey key : selector.keys()) {
      if (key.isValid() && now - ((Waiting) key.attachment()).since > DEADLINE_MS * 1_000_000L) {
        refuse((SocketChannel) key.channel(), "no header came within " + DEADLINE_MS + " ms");
      }
    }
  }

  private void refuse(SocketChannel channel, String why) {
    InetAddress host = channel.socket().getInetAddress();
    String from = host == null ? "nobody" : AddressGroup.remote(host, channel.socket().getPort());
    try {
      channel.close();
    } catch (IOException e) {
      // it is closed either way
    }
    refused++;
    long now = System.nanoTime();
    if (!told || now - toldAt >= MINUTE_NANOS) {
      told = true;
      toldAt = now;
      rule.refused().accept(refused + " so far, the last from " + from + ": " + why);
    }
  }

  /** Closes the gate and all that waits in it. */
  @Override
  public void close() throws IOException {
    for (SelectionKey key : selector.keys().toArray(new SelectionKey[0])) {
      key.channel().close();
    }
    selector.close();
    for (SocketChannel channel; (channel = coming.poll()) != null; ) {
      channel.close();
    }
    for (Arrival arrival; (arrival = arrived.poll()) != null; ) {
      arrival.channel().close();
    }
  }
}
