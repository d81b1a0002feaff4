package carom.net.kryo;

import java.io.Closeable;
import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.PortUnreachableException;
import java.nio.ByteBuffer;
import java.nio.channels.ClosedSelectorException;
import java.nio.channels.DatagramChannel;
import java.nio.channels.SelectionKey;
import java.nio.channels.Selector;

/**
 * The UDP sockets of a client transport, one for each link, and the daemon thread that reads them
 * all. The thread begins with the first socket. Any thread may call the methods.
 */
final class ClientDatagrams implements AutoCloseable {

  /** Receiver of one socket's datagrams, called on the thread that reads. */
  public interface Receiver {
    /**
     * Takes a datagram from the server's address.
     *
     * @param datagram the bytes, valid only during this call
     */
    void datagram(ByteBuffer datagram);

    /** Learns that the server's machine has no such port. It may be called again and again. */
    void unreachable();
  }

  private static final int BATCH = 64;

  private final int maxBytes;
  private final ByteBuffer in;
  private Selector selector; // guarded by this, as are the two below
  private Thread thread;
  private boolean closed;

  /**
   * Creates a group without sockets.
   *
   * @param maxBytes bytes of the longest datagram; of a longer one the rest is cut off
   */
  public ClientDatagrams(int maxBytes) {
    this.maxBytes = maxBytes;
    in = ByteBuffer.allocateDirect(maxBytes);
  }

  /** One socket, which sends to one server and receives from it alone. */
  public final class Socket implements AutoCloseable {
    private final DatagramChannel channel;
    private final Receiver receiver;
    private final ByteBuffer out = ByteBuffer.allocateDirect(maxBytes); // guards the sending

    private Socket(DatagramChannel channel, Receiver receiver) {
      this.channel = channel;
      this.receiver = receiver;
    }

    /**
     * Sends a tag and bytes. It waits for nothing and allocates nothing. Returns false when the
     * datagram is lost here.
     */
    public boolean send(byte tag, byte[] bytes, int offset, int length) {
      synchronized (out) {
        out.clear().put(tag).put(bytes, offset, length).flip();
        try {
          return channel.write(out) > 0;
        } catch (IOException x) {
          return false; // also when the socket is closed
        }
      }
    }

    private void receive() {
      try {
        // A flood must not keep the other sockets from being read.
        for (int i = 0; i < BATCH && channel.read(in.clear()) > 0; i++) {
          receiver.datagram(in.flip());
        }
      } catch (PortUnreachableException x) {
        receiver.unreachable();
      } catch (IOException | RuntimeException lost) {
        // the next datagram may be fine
      }
    }

    @Override
    public void close() {
      closeQuietly(channel);
      wake(); // the system keeps the socket until the selector has let go of it
    }
  }

  /**
   * Opens a socket.
   *
   * @param server the server's UDP address
   * @throws IOException when the system gives no socket, or this group is closed
   */
  public Socket open(InetSocketAddress server, Receiver receiver) throws IOException {
    DatagramChannel channel = DatagramChannel.open();
    try {
      channel.configureBlocking(false);
      channel.connect(server);
      Socket socket = new Socket(channel, receiver);
      synchronized (this) {
        start();
        channel.register(selector, SelectionKey.OP_READ, socket);
        selector.wakeup();
      }
      return socket;
    } catch (IOException | RuntimeException x) {
      channel.close();
      throw x;
    }
  }

  private void start() throws IOException {
    if (closed) {
      throw new IOException("the transport is closed");
    }
    if (thread == null) {
      selector = Selector.open();
      thread = new Thread(() -> read(selector), "carom-client-datagrams");
      thread.setDaemon(true);
      thread.start();
    }
  }

  private static void closeQuietly(Closeable closeable) {
    try {
      closeable.close();
    } catch (IOException closedAllTheSame) {
      // nothing is lost
    }
  }

  private synchronized void wake() {
    if (selector != null) {
      selector.wakeup();
    }
  }

  private static void read(Selector selector) {
    while (selector.isOpen()) {
      try {
        selector.select(key -> ((Socket) key.attachment()).receive());
      } catch (IOException | ClosedSelectorException x) {
        return; // closed, or the system can't wait; the links then end by their deadlines
      } finally {
        Thread.interrupted(); // an interrupted thread would never wait in select again
      }
    }
  }

  /** Closes all sockets and waits for the thread to end. A second call does nothing. */
  @Override
  public void close() {
    Thread reader;
    synchronized (this) {
      closed = true;
      reader = thread;
      if (selector == null) {
        return;
      }
      selector.keys().forEach(key -> closeQuietly(key.channel()));
      closeQuietly(selector);
    }
    boolean interrupted = false;
    while (reader.isAlive()) {
      try {
        reader.join(1_000);
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
