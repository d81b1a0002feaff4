package carom.net.kryo;

import carom.net.frame.Frame;
import carom.net.transport.Link;
import com.esotericsoftware.kryonet.Connection;
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
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.locks.LockSupport;
import java.util.function.Consumer;
import org.jctools.queues.atomic.SpscAtomicArrayQueue;

/**
 * The server's network. One thread drives KryoNet's server, which is never started by its own
 * means, for TCP and the handshake; the {@link DatagramPort} handles UDP. The two threads share the
 * connections, which know their {@linkplain ServerConnection.Phase phase}, and the maps from a
 * datagram to its connection. It survives and counts any error.
 */
final class ServerNetwork implements Runnable {
  private static final int SELECT_MILLIS =
      30; // above 25, or KryoNet also sleeps after 100 quiet selects
  private static final long SWEEP_NANOS = 50_000_000L;
  private static final long SHUTDOWN_NANOS = 2 * SWEEP_NANOS + Frame.LINGER_NANOS;

  static {
    Setup.ensure();
  }

  final KryoLimits limits;
  final KryoMessageCodec codec = new KryoMessageCodec();
  final KryoServerCounters counters = new KryoServerCounters();
  private final Server server;
  private DatagramPort datagrams;
  private final SecureRandom random = new SecureRandom();
  private final SpscAtomicArrayQueue<Link> opened;
  private final ConcurrentLinkedQueue<ServerConnection> closing = new ConcurrentLinkedQueue<>();
  private volatile Thread thread;
  private volatile boolean stopping;

  // used by the network thread
  private final List<ServerConnection> connections = new ArrayList<>();
  private final Map<Object, Integer> perAddress = new HashMap<>();

  // used by both threads
  private final Map<Integer, ServerConnection> pending = new ConcurrentHashMap<>();
  private final Map<InetSocketAddress, ServerConnection> byAddress = new ConcurrentHashMap<>();

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
  }

  /** Opens both ports or none. Call it before {@link #start}. */
  void bind(InetSocketAddress tcp, InetSocketAddress udp) throws IOException {
    server.bind(tcp, null);
    try {
      datagrams = new DatagramPort(udp, this::datagram, counters);
    } catch (IOException x) {
      server.close();
      throw x;
    }
  }

  /** Returns the number of the UDP port. Call it after {@link #bind}. */
  int udpPort() {
    return datagrams.number();
  }

  /** Releases what the constructor and {@link #bind} took. */
  void dispose() {
    if (datagrams != null) {
      datagrams.close();
    }
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
    datagrams.start();
  }

  /**
   * Closes everything and waits for the thread to end. Any thread but the network's may call it.
   */
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
      link = opened.poll(); // the link closed before it was accepted
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

  /** Runs one turn of the loop. Returns the time of the next sweep. */
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
    } catch (Throwable x) { // whatever the error, the other connections go on
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
    // It runs backwards, because an action may remove its connection.
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
   * Decides whether a new connection may stay. If not, the server tells the client why and closes.
   * Called on the network thread.
   */
  boolean admit(ServerConnection connection) {
    counters.accepted.incrementAndGet();
    connection.setTimeout(0); // sweep() does this, by frames and not by bytes
    connection.setKeepAliveTCP(Frame.KEEP_ALIVE_MILLIS);
    connection.setIdleThreshold(0); // no listener uses idle()
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

  /** Returns the key of one household: an IPv4 address, or an IPv6 /64 network. */
  private static Object addressKey(InetAddress address) {
    if (address instanceof Inet6Address) {
      return ByteBuffer.wrap(Arrays.copyOf(address.getAddress(), 8));
    }
    return address;
  }

  /** Takes a datagram that came in by UDP. Called on the port's thread. */
  private void datagram(InetSocketAddress from, ByteBuffer datagram, long nowNs) {
    ServerConnection sender = byAddress.get(from);
    if (sender != null) {
      sender.readDatagram(datagram, nowNs);
    } else if (!register(from, datagram, nowNs)) {
      counters.strangeDatagrams.incrementAndGet();
    }
  }

  /**
   * Registers the UDP address of a new connection. If an older connection has the address, its
   * client has crashed or left without a word, and the system gave its port to the new client. So
   * the older link ends, unless the new client's TCP comes from another machine; then the
   * datagram's source is forged. Called on the port's thread.
   *
   * @return false when the datagram is no registration that a connection waits for
   */
  boolean register(InetSocketAddress from, ByteBuffer datagram, long nowNs) {
    if (datagram.remaining() != Frame.REGISTRATION_BYTES || datagram.get() != Frame.REGISTER_UDP) {
      return false;
    }
    ServerConnection newcomer = pending.get(datagram.getInt());
    if (newcomer == null || newcomer.token != datagram.getLong()) {
      return false;
    }
    ServerConnection before = byAddress.get(from);
    if (before != null) {
      if (!newcomer.addressKey.equals(before.addressKey)) {
        return false;
      }
      before.supersede();
    }
    newcomer.addressKnown(from, nowNs);
    return true;
  }

  /** Maps the address to the connection, which then waits for no registration. */
  void registered(ServerConnection connection, InetSocketAddress address) {
    pending.remove(connection.getID());
    byAddress.put(address, connection);
  }

  /** Sends a datagram. Returns false when this end lost it. Any thread may call it. */
  boolean send(InetSocketAddress to, byte tag, byte[] bytes, int offset, int length) {
    return datagrams.send(to, tag, bytes, offset, length);
  }

  void opened(ServerConnection connection, Link link) {
    if (!connection.openLink()) {
      return;
    }
    counters.opened.incrementAndGet();
    if (!opened.offer(link)) {
      link.close("the server is busy");
    }
  }

  void forget(ServerConnection connection, InetSocketAddress address) {
    pending.remove(connection.getID());
    if (address != null) {
      byAddress.remove(address, connection);
    }
    if (connections.remove(connection)) {
      perAddress.computeIfPresent(connection.addressKey, (key, n) -> n == 1 ? null : n - 1);
    }
  }

  /** The codec through which the server reads TCP. */
  private final class ServerFrames extends FrameCodec {
    @Override
    long token(Connection connection) {
      return ((ServerConnection) connection).token;
    }

    @Override
    boolean server() {
      return true;
    }

    @Override
    public Object read(Connection connection, ByteBuffer buffer) {
      try {
        return ((ServerConnection) connection).readFrame(buffer);
      } catch (Throwable x) {
        counters.error(x);
        return FrameCodec.HANDLED;
      } finally {
        buffer.position(buffer.limit());
      }
    }
  }
}
