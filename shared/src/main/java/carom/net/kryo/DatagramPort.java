package carom.net.kryo;

import carom.net.frame.Frame;
import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.StandardSocketOptions;
import java.nio.ByteBuffer;
import java.nio.channels.DatagramChannel;
import java.nio.channels.SelectionKey;
import java.nio.channels.Selector;
import java.util.concurrent.locks.LockSupport;

/**
 * The server's UDP socket with the daemon thread that reads it. KryoNet reads one datagram per
 * {@code select} and searches all connections for the sender, which is too slow for hundreds of
 * clients. This class reads all waiting datagrams at each wake-up, into one buffer.
 *
 * <p>Any thread may send. Sending waits for nothing and allocates nothing.
 */
final class DatagramPort implements Runnable {

  /**
   * Receiver of datagrams, called on the port's thread. The port counts what it throws and goes on.
   */
  interface Receiver {
    /**
     * Takes a datagram.
     *
     * @param from the sender's address, which may be forged
     * @param datagram the bytes, valid only during this call
     * @param nowNs time of arrival by {@link System#nanoTime}
     */
    void datagram(InetSocketAddress from, ByteBuffer datagram, long nowNs);
  }

  /**
   * Requested size of the socket buffers in bytes, as much as the system allows. A burst from all
   * clients at once should fit.
   */
  private static final int SOCKET_BUFFER_BYTES = 4 << 20;

  /**
   * Number of datagrams at one wake-up from which many clients are assumed to play. The thread then
   * sleeps a moment, so that datagrams gather, because a wake-up costs more than reading a
   * datagram.
   */
  private static final int CROWD = 4;

  private static final long GATHER_NANOS = 1_000_000L;

  /**
   * Number of datagrams in a row from which traffic counts as a flood. The thread then reads on
   * without sleeping, so that the socket's buffer doesn't fill up.
   */
  private static final int FLOOD = 128;

  private final DatagramChannel channel;
  private final Selector selector;
  private final Receiver receiver;
  private final KryoServerCounters counters;
  private final ByteBuffer in = ByteBuffer.allocateDirect(Frame.SERVER_BUFFER_BYTES);
  private final ByteBuffer out = ByteBuffer.allocateDirect(Frame.SERVER_BUFFER_BYTES);
  private final Thread thread = new Thread(this, "carom-server-datagrams");
  private volatile boolean closing;

  /**
   * Opens the port. {@link #start} begins to read.
   *
   * @param address an address of this machine, or the wildcard address, and a port number; 0 takes
   *     a free port
   * @throws IOException when the port can't be opened; nothing stays open then
   */
  DatagramPort(InetSocketAddress address, Receiver receiver, KryoServerCounters counters)
      throws IOException {
    this.receiver = receiver;
    this.counters = counters;
    thread.setDaemon(true);
    selector = Selector.open();
    DatagramChannel opened = null;
    try {
      opened = DatagramChannel.open();
      opened.setOption(StandardSocketOptions.SO_RCVBUF, SOCKET_BUFFER_BYTES);
      opened.setOption(StandardSocketOptions.SO_SNDBUF, SOCKET_BUFFER_BYTES);
      opened.bind(address);
      opened.configureBlocking(false);
      opened.register(selector, SelectionKey.OP_READ);
    } catch (IOException x) {
      if (opened != null) {
        opened.close();
      }
      selector.close();
      throw x;
    }
    channel = opened;
  }

  void start() {
    thread.start();
  }

  /** Returns the port's number. */
  int number() {
    return channel.socket().getLocalPort();
  }

  /**
   * Sends a tag and its fields. Returns false when the system doesn't take them now. Any thread may
   * call it.
   */
  boolean send(InetSocketAddress to, byte tag, byte[] bytes, int offset, int length) {
    synchronized (out) {
      out.clear().put(tag).put(bytes, offset, length).flip();
      try {
        return channel.send(out, to) > 0;
      } catch (IOException | RuntimeException x) {
        return false; // a datagram that can't be sent is lost, and nothing more happens
      }
    }
  }

  @Override
  public void run() {
    while (!closing) {
      try {
        selector.select(key -> {});
        int received;
        do {
          received = drain();
        } while (received > FLOOD);
        if (received >= CROWD) {
          LockSupport.parkNanos(GATHER_NANOS);
        }
      } catch (IOException | RuntimeException | Error x) { // the thread serves all clients
        if (!closing) {
          counters.error(x);
          LockSupport.parkNanos(GATHER_NANOS);
        }
      } finally {
        Thread.interrupted(); // an interrupted thread would never wait in select again
      }
    }
  }

  /** Reads waiting datagrams, at most FLOOD + 1, and returns how many. */
  private int drain() throws IOException {
    int received = 0;
    while (received <= FLOOD) {
      InetSocketAddress from = (InetSocketAddress) channel.receive(in.clear());
      if (from == null) {
        break;
      }
      received++;
      try {
        receiver.datagram(from, in.flip(), System.nanoTime());
      } catch (RuntimeException x) {
        counters.error(x);
      }
    }
    return received;
  }

  /** Closes the port and waits for the thread, if it was started. A second call does nothing. */
  void close() {
    closing = true;
    try {
      channel.close();
      selector.close(); // wakes the thread
    } catch (IOException x) {
      counters.error(x);
    }
    boolean interrupted = false;
    while (thread.isAlive()) {
      try {
        thread.join(1_000);
        break;
      } catch (InterruptedException x) {
        interrupted = true;
      }
    }
    if (interrupted) {
      Thread.currentThread().interrupt();
    }
  }
}
