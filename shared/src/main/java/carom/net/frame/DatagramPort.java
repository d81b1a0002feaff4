package carom.net.frame;

import java.io.IOException;
import java.net.Inet4Address;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.StandardProtocolFamily;
import java.net.StandardSocketOptions;
import java.nio.ByteBuffer;
import java.nio.channels.DatagramChannel;
import java.nio.channels.SelectionKey;
import java.nio.channels.Selector;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.locks.LockSupport;
import java.util.function.Consumer;

/**
 * The server's UDP socket, or one for each of several addresses, with the daemon thread that reads
 * them. KryoNet reads one datagram per {@code select} and searches all connections for the sender,
 * which is too slow for hundreds of clients. This class reads all waiting datagrams at each
 * wake-up, into one buffer.
 *
 * <p>Any thread may send. Sending waits for nothing and allocates nothing.
 */
public final class DatagramPort implements Runnable {

  /**
   * Hears of datagrams, called on the port's thread. The port counts what it throws and goes on.
   */
  public interface Listener {
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

  private final List<DatagramChannel> channels = new ArrayList<>();
  private final Selector selector;
  private final Listener listener;
  private final Consumer<Throwable> errors;
  private final ByteBuffer in;
  private final ByteBuffer out;
  private final Thread thread = new Thread(this, "carom-server-datagrams");
  private volatile boolean closing;

  /**
   * Opens the port. {@link #start} begins to read.
   *
   * @param addresses of this machine; null stands for all
   * @param port 0..65,535; 0 takes a free one, which is the same at all addresses
   * @param maxBytes bytes of the longest datagram; of a longer one the rest is cut off
   * @param listener takes the datagrams
   * @param errors learns of failures, which the port survives; any thread
   * @throws IOException when the port can't be opened; nothing stays open then
   */
  public DatagramPort(
      List<InetAddress> addresses,
      int port,
      int maxBytes,
      Listener listener,
      Consumer<Throwable> errors)
      throws IOException {
    this.listener = listener;
    this.errors = errors;
    in = ByteBuffer.allocateDirect(maxBytes);
    out = ByteBuffer.allocateDirect(maxBytes);
    thread.setDaemon(true);
    selector = Selector.open();
    try {
      for (InetAddress address : addresses) {
        DatagramChannel opened =
            address instanceof Inet4Address // Java takes 0.0.0.0 for all addresses, also of IPv6
                ? DatagramChannel.open(StandardProtocolFamily.INET)
                : DatagramChannel.open();
        channels.add(opened);
        opened.setOption(StandardSocketOptions.SO_RCVBUF, SOCKET_BUFFER_BYTES);
        opened.setOption(StandardSocketOptions.SO_SNDBUF, SOCKET_BUFFER_BYTES);
        opened.bind(new InetSocketAddress(address, channels.size() == 1 ? port : number()));
        opened.configureBlocking(false);
        opened.register(selector, SelectionKey.OP_READ);
      }
    } catch (IOException x) {
      closeAll();
      throw x;
    }
  }

  private void closeAll() throws IOException {
    for (DatagramChannel channel : channels) {
      channel.close();
    }
    selector.close(); // wakes the thread
  }

  /**
   * A client's address, and the socket that it sends to: answers must come from there. Equal to the
   * same address without it.
   */
  private static final class Via extends InetSocketAddress {
    private static final long serialVersionUID = 1;

    private final transient DatagramChannel channel;

    Via(InetSocketAddress address, DatagramChannel channel) {
      super(address.getAddress(), address.getPort());
      this.channel = channel;
    }
  }

  /** Begins to read. */
  public void start() {
    thread.start();
  }

  /** Returns the port's number. */
  public int number() {
    return channels.get(0).socket().getLocalPort();
  }

  /**
   * Sends the first bytes of an array. Returns false when the system doesn't take them now. Any
   * thread may call it.
   */
  public boolean send(InetSocketAddress to, byte[] bytes, int length) {
    synchronized (out) {
      out.clear().put(bytes, 0, length).flip();
      try {
        DatagramChannel channel = to instanceof Via via ? via.channel : channels.get(0);
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
          received = 0;
          for (int i = 0; i < channels.size(); i++) {
            received += drain(channels.get(i));
          }
        } while (received > FLOOD);
        if (received >= CROWD) {
          LockSupport.parkNanos(GATHER_NANOS);
        }
      } catch (IOException | RuntimeException | Error x) { // the thread serves all clients
        if (!closing) {
          errors.accept(x);
          LockSupport.parkNanos(GATHER_NANOS);
        }
      } finally {
        Thread.interrupted(); // an interrupted thread would never wait in select again
      }
    }
  }

  /** Reads waiting datagrams of a socket, at most FLOOD + 1, and returns how many. */
  private int drain(DatagramChannel channel) throws IOException {
    int received = 0;
    while (received <= FLOOD) {
      InetSocketAddress from = (InetSocketAddress) channel.receive(in.clear());
      if (from == null) {
        break;
      }
      received++;
      try {
        InetSocketAddress sender = channels.size() == 1 ? from : new Via(from, channel);
        listener.datagram(sender, in.flip(), System.nanoTime());
      } catch (RuntimeException | Error x) {
        errors.accept(x);
      }
    }
    return received;
  }

  /** Closes the port and waits for the thread, if it was started. A second call does nothing. */
  public void close() {
    closing = true;
    try {
      closeAll();
    } catch (IOException x) {
      errors.accept(x);
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
