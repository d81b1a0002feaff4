package carom.lab.attack;

import carom.net.frame.Frame;
import carom.net.seal.DatagramSealer;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.nio.channels.DatagramChannel;
import java.util.Random;
import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.locks.LockSupport;

/**
 * A stranger who sends datagrams to a server's UDP port as fast as told: half of them garbage, a
 * quarter registrations without a connection, and a quarter forged ones that name links of players,
 * each of which costs the server a decryption that fails. One thread.
 */
final class StrangerFlood implements Flood {
  private static final int BYTES = 100;
  private static final long PAUSE_NS = 1_000_000L;

  /** Step from the number of a link to that of the next one. */
  private static final int NEXT_LINK = (1 << 14) + 1;

  private final InetSocketAddress server;
  private final int perSecond;
  private final int firstLink;
  private final int links;
  private final Random random = new Random(20);
  private final byte[] bytes = new byte[BYTES];
  private final ByteBuffer out = ByteBuffer.allocateDirect(BYTES);
  private volatile boolean stops;
  private final AtomicLong sent = new AtomicLong();
  private Thread thread;

  /**
   * Creates a stranger who is silent.
   *
   * @param firstLink number of a link; those of players follow
   * @param links how many of those there are
   */
  StrangerFlood(InetSocketAddress server, int perSecond, int firstLink, int links) {
    this.server = server;
    this.perSecond = perSecond;
    this.firstLink = firstLink;
    this.links = links;
  }

  @Override
  public String name() {
    return "strangers, " + perSecond + "/s";
  }

  @Override
  public void begin() {
    stops = false;
    thread = new Thread(this::send, "stranger");
    thread.setDaemon(true);
    thread.start();
  }

  @Override
  public void end() throws InterruptedException {
    stops = true;
    thread.join();
  }

  @Override
  public long sent() {
    return sent.get();
  }

  private void send() {
    try (DatagramChannel channel = DatagramChannel.open()) {
      channel.connect(server);
      long began = System.nanoTime();
      long before = sent.get();
      while (!stops) {
        long due = before + (long) ((System.nanoTime() - began) * 1e-9 * perSecond);
        while (sent.get() < due && !stops) {
          channel.write(next((int) sent.getAndIncrement()));
        }
        LockSupport.parkNanos(PAUSE_NS);
      }
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private ByteBuffer next(int number) {
    random.nextBytes(bytes);
    out.clear().put(bytes);
    if (number % 4 == 1) {
      out.put(0, Frame.REGISTER_UDP).flip().limit(Frame.REGISTRATION_BYTES);
    } else if (number % 4 == 3) {
      out.put(0, Frame.DATAGRAM).putInt(1, firstLink + NEXT_LINK * (number / 4 % links + 1));
      out.putShort(DatagramSealer.HEAD_BYTES - 6, (short) 0); // a counter that may come
      out.flip();
    } else {
      out.flip();
    }
    return out;
  }
}
