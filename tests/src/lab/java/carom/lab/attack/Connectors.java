package carom.lab.attack;

import carom.net.frame.Frame;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.nio.channels.DatagramChannel;
import java.nio.channels.SelectionKey;
import java.nio.channels.Selector;
import java.nio.channels.SocketChannel;
import java.util.concurrent.atomic.AtomicLong;

/**
 * Hosts that open connections to a server as fast as they are told, from many addresses of this
 * machine, and hold each until the server closes it. One thread.
 */
final class Connectors implements Runnable {
  /** Largest number of sockets at once; the oldest gives way to the next. */
  private static final int MOST = 8_192;

  private final InetSocketAddress server;
  private final int firstHost;
  private final int hosts;
  private final double perSecond;
  private final boolean registers;
  private final ByteBuffer in = ByteBuffer.allocate(256);
  private final SocketChannel[] held = new SocketChannel[MOST];

  final AtomicLong tried = new AtomicLong();
  final AtomicLong greeted = new AtomicLong();
  final AtomicLong failed = new AtomicLong();
  volatile boolean stops;

  /**
   * Creates hosts that don't connect yet.
   *
   * @param firstHost number of the first host
   * @param hosts how many there are
   * @param perSecond connections per second of all of them
   * @param registers whether they also register an address by UDP, without any work
   */
  Connectors(
      InetSocketAddress server, int firstHost, int hosts, double perSecond, boolean registers) {
    this.server = server;
    this.firstHost = firstHost;
    this.hosts = hosts;
    this.perSecond = perSecond;
    this.registers = registers;
  }

  /** Returns the address of a host: each has a /24 network of its own. */
  static InetAddress address(int host) throws IOException {
    return InetAddress.getByAddress(
        new byte[] {127, (byte) (1 + host / 250), (byte) (1 + host % 250), 9});
  }

  @Override
  public void run() {
    try (Selector selector = Selector.open();
        DatagramChannel udp = DatagramChannel.open()) {
      long start = System.nanoTime();
      while (!stops) {
        long due = (long) ((System.nanoTime() - start) * 1e-9 * perSecond);
        for (int i = 0; i < 64 && tried.get() < due; i++) {
          connect(selector);
        }
        selector.select(key -> serve(key, udp), 1);
      }
      for (SocketChannel channel : held) {
        if (channel != null) {
          channel.close();
        }
      }
    } catch (IOException e) {
      throw new java.io.UncheckedIOException(e);
    }
  }

  private void connect(Selector selector) throws IOException {
    int number = (int) tried.getAndIncrement();
    int place = number % MOST;
    if (held[place] != null) {
      held[place].close();
    }
    SocketChannel channel = SocketChannel.open();
    held[place] = channel;
    try {
      channel.configureBlocking(false);
      channel.bind(new InetSocketAddress(address(firstHost + number % hosts), 0));
      channel.connect(server);
      channel.register(selector, SelectionKey.OP_CONNECT);
    } catch (IOException e) {
      failed.incrementAndGet();
      channel.close();
    }
  }

  private void serve(SelectionKey key, DatagramChannel udp) {
    SocketChannel channel = (SocketChannel) key.channel();
    try {
      if (key.isConnectable() && channel.finishConnect()) {
        key.interestOps(SelectionKey.OP_READ);
      } else if (key.isReadable()) {
        read(channel, udp);
      }
    } catch (IOException | RuntimeException e) {
      failed.incrementAndGet();
      close(channel);
    }
  }

  private void read(SocketChannel channel, DatagramChannel udp) throws IOException {
    int length = channel.read(in.clear());
    if (length < 0) {
      channel.close();
    } else if (length > Frame.GREETING_BYTES && in.get(4) == Frame.REGISTER_TCP) {
      greeted.incrementAndGet();
      if (registers) {
        in.flip().position(5);
        ByteBuffer registration = ByteBuffer.allocate(Frame.REGISTRATION_BYTES);
        registration.put(Frame.REGISTER_UDP).putInt(in.getInt()).putLong(in.getLong()).putLong(0);
        int port = Short.toUnsignedInt(in.getShort());
        udp.send(registration.flip(), new InetSocketAddress(server.getAddress(), port));
      }
    }
  }

  private static void close(SocketChannel channel) {
    try {
      channel.close();
    } catch (IOException e) {
      throw new java.io.UncheckedIOException(e);
    }
  }
}
