package carom.lab.attack;

import carom.net.admission.WorkProof;
import carom.net.frame.Frame;
import carom.net.seal.Encryption;
import carom.net.seal.ExchangeKey;
import carom.net.seal.KeyExchange;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.nio.channels.DatagramChannel;
import java.nio.channels.SelectionKey;
import java.nio.channels.Selector;
import java.nio.channels.SocketChannel;
import java.security.GeneralSecurityException;
import java.util.concurrent.LinkedBlockingDeque;
import java.util.concurrent.atomic.AtomicLong;

/**
 * Hosts that open connections to a server as fast as they are told, from many addresses of this
 * machine, and hold each until the server closes it. One thread, and one that does the work that
 * the server demands, if they do it.
 */
final class Connectors implements Runnable {
  /** The effort that hosts make once the server has greeted them. */
  enum Effort {
    /** The connections say nothing. */
    SILENT,
    /** The connections register by UDP, without any work. */
    REGISTER,
    /** The connections do the work, the newest first, register and offer a key. */
    WORK
  }

  /** Most connections that wait until their work is done; the oldest is forgotten. */
  private static final int MOST_WAITING = 256;

  /** Largest number of sockets at once; the oldest gives way to the next. */
  private static final int MOST = 8_192;

  /** Place of the bits of work in a greeting: behind link, token, port and encryption. */
  private static final int WORK_BITS_AT = 4 + 8 + 2 + 1;

  private final InetSocketAddress server;
  private final int firstHost;
  private final int hosts;
  private final double perSecond;
  private final Effort effort;
  private final ByteBuffer in = ByteBuffer.allocate(256);
  private final SocketChannel[] held = new SocketChannel[MOST];

  final AtomicLong tried = new AtomicLong();
  final AtomicLong greeted = new AtomicLong();
  final AtomicLong failed = new AtomicLong();

  /** Connections whose work is done. */
  final AtomicLong solved = new AtomicLong();

  /** Connections for which a key was offered. */
  final AtomicLong offered = new AtomicLong();

  /** Most bits of work that a greeting has demanded. */
  final AtomicLong mostBits = new AtomicLong();

  /** Greetings of connections whose work waits. */
  private final LinkedBlockingDeque<byte[]> waiting = new LinkedBlockingDeque<>(MOST_WAITING);

  volatile boolean stops;

  /**
   * Creates hosts that don't connect yet.
   *
   * @param firstHost number of the first host
   * @param hosts how many there are
   * @param perSecond connections per second of all of them
   * @param effort what they do further
   */
  Connectors(InetSocketAddress server, int firstHost, int hosts, double perSecond, Effort effort) {
    this.server = server;
    this.firstHost = firstHost;
    this.hosts = hosts;
    this.perSecond = perSecond;
    this.effort = effort;
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
      if (effort == Effort.WORK) {
        Thread worker = new Thread(this::work, "attacker-works");
        worker.setDaemon(true);
        worker.start();
      }
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
        read(key, channel, udp);
      }
    } catch (IOException | RuntimeException e) {
      failed.incrementAndGet();
      close(channel);
    }
  }

  private void read(SelectionKey key, SocketChannel channel, DatagramChannel udp)
      throws IOException {
    int length = channel.read(in.clear());
    if (length < 0) {
      channel.close();
    } else if (key.attachment() == null
        && length > Frame.GREETING_BYTES
        && in.get(Frame.LENGTH_BYTES) == Frame.REGISTER_TCP) {
      greeted.incrementAndGet();
      byte[] greeting = new byte[Frame.GREETING_BYTES];
      in.flip().position(Frame.LENGTH_BYTES + 1).get(greeting);
      mostBits.accumulateAndGet(greeting[WORK_BITS_AT], Math::max);
      if (effort == Effort.REGISTER) {
        register(udp, greeting, 0);
      } else if (effort == Effort.WORK) {
        key.attach(greeting); // what comes later may look like another one
        while (!waiting.offerFirst(greeting)) {
          waiting.pollLast();
        }
      }
    } else if (length > Frame.LENGTH_BYTES
        && in.get(Frame.LENGTH_BYTES) == Frame.REGISTER_UDP
        && key.attachment() instanceof byte[] greeting) {
      offer(channel, greeting);
    }
  }

  private void register(DatagramChannel udp, byte[] greeting, long solution) throws IOException {
    ByteBuffer fields = ByteBuffer.wrap(greeting);
    ByteBuffer registration = ByteBuffer.allocate(Frame.REGISTRATION_BYTES);
    registration.put(Frame.REGISTER_UDP).putInt(fields.getInt()).putLong(fields.getLong());
    registration.putLong(solution);
    int port = Short.toUnsignedInt(fields.getShort());
    udp.send(registration.clear(), new InetSocketAddress(server.getAddress(), port));
  }

  /** Does the work of the newest connection and registers it, again and again. */
  private void work() {
    WorkProof proof = new WorkProof();
    try (DatagramChannel udp = DatagramChannel.open()) {
      while (!stops) {
        byte[] greeting = waiting.takeFirst();
        ByteBuffer fields = ByteBuffer.wrap(greeting);
        int bits = greeting[WORK_BITS_AT];
        register(udp, greeting, proof.solve(fields.getInt(), fields.getLong(), bits));
        solved.incrementAndGet();
      }
    } catch (IOException e) {
      throw new java.io.UncheckedIOException(e);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  /** Offers a key, for which the server computes one. */
  private void offer(SocketChannel channel, byte[] greeting) throws IOException {
    byte[] serverKey = new byte[ExchangeKey.BYTES];
    ByteBuffer.wrap(greeting).position(WORK_BITS_AT + 1).get(serverKey);
    byte[] offer;
    try {
      offer = new KeyExchange.Offer(Encryption.ON, serverKey, greeting).bytes();
    } catch (GeneralSecurityException e) {
      throw new IOException("the server's key is none", e);
    }
    ByteBuffer frame = ByteBuffer.allocate(Frame.LENGTH_BYTES + 1 + offer.length);
    frame.putInt(1 + offer.length).put(Frame.KEY_OFFER).put(offer);
    channel.write(frame.flip());
    offered.incrementAndGet();
  }

  private static void close(SocketChannel channel) {
    try {
      channel.close();
    } catch (IOException e) {
      throw new java.io.UncheckedIOException(e);
    }
  }
}
