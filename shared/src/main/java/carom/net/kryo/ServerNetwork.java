package carom.net.kryo;

import carom.net.transport.Link;
import com.esotericsoftware.kryo.util.IntMap;
import com.esotericsoftware.kryonet.Connection;
import com.esotericsoftware.kryonet.FrameworkMessage.RegisterUDP;
import com.esotericsoftware.kryonet.Listener;
import com.esotericsoftware.kryonet.Server;
import java.io.IOException;
import java.net.Inet6Address;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.security.SecureRandom;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.locks.LockSupport;
import java.util.function.Consumer;
import org.jctools.queues.atomic.SpscAtomicArrayQueue;

/**
 * The server's network thread: drives KryoNet's server, which is never started by its own means,
 * and everything around it. Survives any error and counts it.
 */
final class ServerNetwork implements Runnable {
  private static final int SELECT_MILLIS =
      30; // above 25, or KryoNet sleeps on top after 100 quiet selects
  private static final long SWEEP_NANOS = 50_000_000L;
  private static final long SHUTDOWN_NANOS = 2 * SWEEP_NANOS + Frame.LINGER_NANOS;

  static {
    Setup.ensure();
  }

  final KryoLimits limits;
  final KryoMessageCodec codec = new KryoMessageCodec();
  final KryoServerCounters counters = new KryoServerCounters();
  int udpPort;
  private final Server server;
  private final SecureRandom random = new SecureRandom();
  private final SpscAtomicArrayQueue<Link> opened;
  private final ConcurrentLinkedQueue<ServerConnection> closing = new ConcurrentLinkedQueue<>();
  private volatile Thread thread;
  private volatile boolean stopping;

  // network thread
  private final List<ServerConnection> connections = new ArrayList<>();
  private final IntMap<ServerConnection> pending = new IntMap<>();
  private final Map<Object, Integer> perAddress = new HashMap<>();

  ServerNetwork(KryoLimits limits) {
    this.limits = limits;
    opened = new SpscAtomicArrayQueue<>(Math.max(4, limits.maxConnections()));
    server =
        new Server(limits.unsentBytes(), Frame.SERVER_BUFFER_BYTES, new ServerFrames()) {
          @Override
          protected Connection newConnection() {
            return new ServerConnection(ServerNetwork.this, random.nextLong(), random.nextLong());
          }
        };
    server.addListener(
        new Listener() {
          @Override
          public void connected(Connection connection) {
            ((ServerConnection) connection).addressKnown(System.nanoTime());
          }
        });
  }

  /** Opens both ports or none. Before {@link #start}. */
  void bind(int tcp, int udp) throws IOException {
    server.bind(tcp, udp);
    udpPort = udp;
  }

  /** Gives up what the constructor took, when the thread was never started. */
  void dispose() {
    try {
      server.dispose();
    } catch (IOException x) {
      counters.error(x);
    }
  }

  void start() {
    Thread started = new Thread(this, "carom-server-network");
    started.setDaemon(true);
    thread = started;
    started.start();
  }

  /** Closes everything and waits for the thread to end. Any thread but the network's. */
  void stop() {
    stopping = true;
    boolean interrupted = false;
    long deadline = System.nanoTime() + 5_000_000_000L;
    Thread running = thread;
    while (running.isAlive() && System.nanoTime() < deadline) {
      try {
        running.join(1_000);
      } catch (InterruptedException x) {
        interrupted = true;
      }
    }
    if (interrupted) {
      Thread.currentThread().interrupt();
    }
  }

  Link accept() {
    Link link = opened.poll();
    while (link != null && link.state() == Link.State.CLOSED) {
      link = opened.poll(); // came and went
    }
    return link;
  }

  boolean isNetworkThread() {
    return Thread.currentThread() == thread;
  }

  @Override
  public void run() {
    long nextSweep = System.nanoTime();
    while (!stopping) {
      nextSweep = step(SELECT_MILLIS, nextSweep);
    }
    long start = System.nanoTime();
    each(connection -> connection.dismissGently("the server is shutting down", start));
    while (!connections.isEmpty() && System.nanoTime() - start < SHUTDOWN_NANOS) {
      nextSweep = step(SELECT_MILLIS, nextSweep);
    }
    each(connection -> connection.closeNow("the server is shutting down"));
    try {
      server.stop();
    } catch (RuntimeException x) {
      counters.error(x);
    }
    dispose();
  }

  /** One turn of the loop; gives the time of the next sweep. */
  private long step(int selectMillis, long nextSweep) {
    try {
      server.update(selectMillis);
      drainCloseRequests();
      long now = System.nanoTime();
      if (now - nextSweep < 0) {
        return nextSweep;
      }
      each(connection -> connection.sweep(now));
      return now + SWEEP_NANOS;
    } catch (Throwable x) { // whatever it was, the others go on playing
      counters.error(x);
      LockSupport.parkNanos(1_000_000L);
      return nextSweep;
    } finally {
      Thread.interrupted(); // an interrupted thread would never wait in select again
    }
  }

  private void drainCloseRequests() {
    for (ServerConnection c = closing.poll(); c != null; c = closing.poll()) {
      c.closeAsRequested(System.nanoTime());
    }
  }

  private void each(Consumer<ServerConnection> action) {
    // Backwards, because an action may remove its connection.
    for (int i = connections.size() - 1; i >= 0; i--) {
      try {
        action.accept(connections.get(i));
      } catch (RuntimeException x) {
        counters.error(x);
      }
    }
  }

  void requestClose(ServerConnection connection) {
    closing.add(connection);
  }

  /**
   * Whether a connection that just came in may stay; it is told why not, and closed. Network
   * thread.
   */
  boolean admit(ServerConnection connection) {
    counters.accepted.incrementAndGet();
    connection.setTimeout(0); // sweep() does it, by frames and not by bytes
    connection.setKeepAliveTCP(Frame.KEEP_ALIVE_MILLIS);
    connection.setIdleThreshold(0); // nobody listens to idle()
    InetSocketAddress remote = connection.getRemoteAddressTCP();
    if (remote == null || remote.getAddress() == null) {
      connection.closeNow("connection lost");
      return false;
    }
    connection.remote(text(remote));
    connection.addressKey = addressKey(remote.getAddress());
    int before = connections.size();
    connections.add(connection);
    int sameAddress = perAddress.merge(connection.addressKey, 1, Integer::sum);
    String refusal = null;
    if (stopping) {
      refusal = "the server is shutting down";
    } else if (before >= limits.maxConnections()) {
      refusal = "the server is full (" + limits.maxConnections() + " connections)";
    } else if (sameAddress > limits.maxPerAddress()) {
      refusal = "too many connections from your address (" + limits.maxPerAddress() + ")";
    }
    if (refusal != null) {
      counters.refused.incrementAndGet();
      connection.dismiss(refusal);
      return false;
    }
    pending.put(connection.getID(), connection);
    return true;
  }

  private static String text(InetSocketAddress remote) {
    String address = remote.getAddress().getHostAddress();
    return (address.indexOf(':') < 0 ? address : "[" + address + "]") + ":" + remote.getPort();
  }

  /** One household: an IPv4 address, or an IPv6 /64 network. */
  private static Object addressKey(InetAddress address) {
    if (address instanceof Inet6Address) {
      return ByteBuffer.wrap(Arrays.copyOf(address.getAddress(), 8));
    }
    return address;
  }

  /**
   * The connection that waits for its UDP address under this id and token, or null. Network thread.
   */
  ServerConnection pending(int id, long token) {
    ServerConnection connection = pending.get(id);
    return connection != null && connection.token == token ? connection : null;
  }

  /**
   * The connection's UDP address is known: a second registration, such as a repeated one, means
   * nothing.
   */
  void registered(ServerConnection connection) {
    pending.remove(connection.getID());
  }

  void opened(ServerConnection connection, Link link) {
    if (!connection.openLink()) {
      return;
    }
    counters.opened.incrementAndGet();
    if (!opened.offer(link)) {
      connection.dismiss("the server is busy");
    }
  }

  void forget(ServerConnection connection) {
    pending.remove(connection.getID());
    if (connections.remove(connection)) {
      perAddress.computeIfPresent(connection.addressKey, (key, n) -> n == 1 ? null : n - 1);
    }
  }

  /** How the server reads. */
  private final class ServerFrames extends Frame.Codec {
    private ByteBuffer datagramBuffer;

    @Override
    long token(Connection connection) {
      return ((ServerConnection) connection).token;
    }

    @Override
    boolean server() {
      return true;
    }

    @Override
    @SuppressWarnings("ReferenceEquality") // it is the buffer's identity that tells UDP from TCP
    public Object read(Connection connection, ByteBuffer buffer) {
      try {
        if (connection == null) {
          datagramBuffer =
              buffer; // only datagrams come without a connection, and all in the same buffer
          return registration(buffer);
        }
        ServerConnection from = (ServerConnection) connection;
        return buffer == datagramBuffer ? from.readDatagram(buffer) : from.readFrame(buffer);
      } catch (Throwable x) {
        counters.error(x);
        return Frame.HANDLED;
      } finally {
        buffer.position(buffer.limit());
      }
    }

    private Object registration(ByteBuffer buffer) {
      if (buffer.remaining() == Frame.REGISTRATION_BYTES && buffer.get() == Frame.REGISTER_UDP) {
        ServerConnection newcomer = pending(buffer.getInt(), buffer.getLong());
        if (newcomer != null) {
          RegisterUDP register = new RegisterUDP();
          register.connectionID = newcomer.getID();
          return register;
        }
      }
      counters.strangeDatagrams.incrementAndGet();
      return Frame.HANDLED;
    }
  }
}
