package carom.net.kryo.server;

import carom.net.admission.AddressGroup;
import carom.net.admission.Entrance;
import carom.net.admission.Hosts;
import carom.net.admission.TokenBucket;
import carom.net.admission.WorkProof;
import carom.net.frame.DatagramPort;
import carom.net.frame.Frame;
import carom.net.kryo.FrameCodec;
import carom.net.kryo.KryoMessageCodec;
import carom.net.kryo.Setup;
import carom.net.seal.DatagramOpener;
import carom.net.seal.StreamSeal;
import carom.net.transport.HandshakeLine;
import carom.net.transport.Impairment;
import carom.net.transport.Link;
import com.esotericsoftware.kryonet.Connection;
import com.esotericsoftware.kryonet.FrameworkMessage.RegisterTCP;
import com.esotericsoftware.kryonet.Server;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.security.SecureRandom;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.locks.LockSupport;
import java.util.function.Consumer;
import org.jctools.queues.atomic.SpscAtomicArrayQueue;

/**
 * The server's network. One thread drives KryoNet's server, which is never started by its own
 * means, for TCP and the handshake; the {@link DatagramPort} handles UDP; a third one computes
 * keys. The first two share the connections, which know their {@linkplain ServerConnection.Phase
 * phase}, and the table from a datagram to its connection. It survives and counts any error.
 */
final class ServerNetwork implements Runnable {
  private static final int SELECT_MILLIS =
      30; // above 25, or KryoNet also sleeps after 100 quiet selects

  /** Longest wait without a connection: a new one and the end of the server wake the thread. */
  private static final int IDLE_SELECT_MILLIS = 10_000;

  private static final long SWEEP_NANOS = 50_000_000L;
  private static final long KEY_IDLE_SECONDS = 10;

  private static final long SHUTDOWN_NANOS = 2 * SWEEP_NANOS + Frame.LINGER_NANOS;

  static {
    Setup.ensure();
  }

  volatile KryoLimits limits;
  final ServerIdentity identity;

  /** The simulated network below the handshake, or null. */
  final HandshakeLine line;

  final KryoMessageCodec codec = new KryoMessageCodec();
  final KryoServerCounters counters = new KryoServerCounters();
  private final Server server;
  private Acceptor acceptor;
  private DatagramPort datagrams;
  final SecureRandom random = new SecureRandom();
  private final SpscAtomicArrayQueue<Link> opened;
  private final ConcurrentLinkedQueue<ServerConnection> closing = new ConcurrentLinkedQueue<>();
  private volatile Thread thread;
  private volatile boolean stopping;
  private volatile Runnable wake = () -> {};

  // used by the network thread
  private final List<ServerConnection> connections = new ArrayList<>();
  private final Entrance<ServerConnection> entrance;

  // used by both threads
  private final LinkTable<ServerConnection> links; // the network thread adds and removes
  private final AtomicInteger open = new AtomicInteger();
  private final Map<InetSocketAddress, ServerConnection> byAddress = new ConcurrentHashMap<>();
  final Hosts hosts = new Hosts();

  // used by the port's thread
  /** Limit of all links together on datagrams from addresses that aren't theirs. */
  final TokenBucket addressChanges = AddressChangeLimit.total();

  private final byte[] received = new byte[Frame.SERVER_BUFFER_BYTES];
  private final ByteBuffer receivedView = ByteBuffer.wrap(received);
  private final WorkProof workProof = new WorkProof();

  private final WorkProof streamWorkProof = new WorkProof(); // used by the network thread

  private final ThreadPoolExecutor keyMaker;

  ServerNetwork(KryoLimits limits, ServerIdentity identity, Impairment impairment) {
    this.limits = limits;
    line = impairment.isNone() ? null : new HandshakeLine(impairment);
    this.identity = identity;
    int unproven = limits.maxPending();
    int proven = Math.max(1, unproven / 4);
    entrance = new Entrance<>(unproven, proven, this::evict);
    links =
        new LinkTable<>(
            KryoLimits.MAX_CONNECTIONS + unproven + 2 * proven, ServerConnection::number);
    keyMaker =
        new ThreadPoolExecutor(
            1,
            1,
            KEY_IDLE_SECONDS,
            TimeUnit.SECONDS,
            new ArrayBlockingQueue<>(2 * proven),
            work -> {
              Thread thread = new Thread(work, "carom-server-keys");
              thread.setDaemon(true);
              return thread;
            },
            (work, full) ->
                counters.refused.incrementAndGet()); // the handshake then takes too long
    keyMaker.allowCoreThreadTimeOut(true);
    opened = new SpscAtomicArrayQueue<>(Math.max(4, limits.maxConnections()));
    server =
        new Server(limits.unsentBytes(), Frame.SERVER_BUFFER_BYTES, new ServerFrames()) {
          @Override
          protected Connection newConnection() {
            return new ServerConnection(
                ServerNetwork.this, random.nextLong(), random.nextLong(), acceptor.client());
          }
        };
  }

  /**
   * Opens both ports or none. Call it before {@link #start}.
   *
   * @param addresses of this machine; null stands for all
   * @param proxies which connections come by proxies
   */
  void bind(List<InetAddress> addresses, int tcp, int udp, ProxyRule proxies) throws IOException {
    acceptor = new Acceptor(server, addresses, tcp, proxies);
    try {
      datagrams =
          new DatagramPort(
              addresses, udp, Frame.SERVER_BUFFER_BYTES, this::datagram, counters.errors::add);
    } catch (IOException x) {
      acceptor.close();
      throw x;
    }
  }

  /** Returns the number of the TCP port. Call it after {@link #bind}. */
  int tcpPort() {
    return acceptor.port();
  }

  /** Returns the number of the UDP port. Call it after {@link #bind}. */
  int udpPort() {
    return datagrams.number();
  }

  /** Returns what a client is told first. */
  byte[] greeting(int link, long token, int workBits) {
    return Frame.greeting(
        link, token, udpPort(), identity.encryption(), workBits, identity.key().publicKey());
  }

  /** Runs work on the thread for keys, or counts a refusal if too much waits. */
  void computeKeys(Runnable work) {
    keyMaker.execute(
        () -> {
          try {
            work.run();
          } catch (RuntimeException | Error x) {
            counters.errors.add(x);
          }
        });
  }

  /** Releases what the constructor and {@link #bind} took. */
  void dispose() {
    keyMaker.shutdownNow();
    if (line != null) {
      line.close();
    }
    if (datagrams != null) {
      datagrams.close();
    }
    try {
      if (acceptor != null) {
        acceptor.close();
      }
      server.dispose();
    } catch (IOException x) {
      counters.errors.add(x);
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
    acceptor.wake();
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

  /** Sets what runs when a link has opened. */
  void onOpened(Runnable newWake) {
    wake = newWake;
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
      nextSweep = step(connections.isEmpty() ? IDLE_SELECT_MILLIS : SELECT_MILLIS, nextSweep);
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
      counters.errors.add(x);
    }
    dispose();
  }

  /** Runs one turn of the loop. Returns the time of the next sweep. */
  private long step(int selectMillis, long nextSweep) {
    try {
      server.update(selectMillis);
      acceptWaiting();
      drainCloseRequests();
      long now = System.nanoTime();
      if (now - nextSweep < 0) {
        return nextSweep;
      }
      each(connection -> connection.sweep(now));
      entrance.sort();
      return now + SWEEP_NANOS;
    } catch (Throwable x) { // whatever the error, the other connections go on
      counters.errors.add(x);
      LockSupport.parkNanos(1_000_000L);
      return nextSweep;
    } finally {
      Thread.interrupted(); // an interrupted thread would never wait in select again
    }
  }

  private void acceptWaiting() {
    try {
      acceptor.acceptWaiting();
    } catch (IOException x) { // too many open files: connections must close before the next comes
      counters.errors.add(x);
      LockSupport.parkNanos(1_000_000L);
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
        counters.errors.add(x);
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
    InetSocketAddress remote = connection.clientAddress();
    if (remote == null || remote.getAddress() == null) {
      connection.closeNow("connection lost");
      return false;
    }
    connection.remote(AddressGroup.remote(remote.getAddress(), remote.getPort()));
    connection.origin(AddressGroup.of(remote.getAddress()));
    String host = connection.origin().host();
    if (open.get() >= limits.maxConnections() * 3 / 4) {
      each(ServerConnection::leave); // who was told to go holds no place that others need
    }
    int inside = open.get();
    connections.add(connection);
    int sameHost = hosts.add(host);
    boolean isCrowded = inside >= limits.maxConnections() / 2;
    String refusal = null;
    if (stopping) {
      refusal = "the server is shutting down";
    } else if (inside >= limits.maxConnections()) {
      refusal = full();
    } else if (hosts.isRefused(host, System.nanoTime())) {
      refusal =
          "your address sent far too many datagrams; try again in "
              + Hosts.REFUSAL_SECONDS
              + " seconds";
    } else if (isCrowded && sameHost > limits.maxPerAddress()) {
      refusal = "too many connections from your address (" + limits.maxPerAddress() + ")";
    }
    if (refusal != null) {
      counters.refused.incrementAndGet();
      connection.dismiss(refusal);
      return false;
    }
    int workBits = entrance.workBits();
    entrance.add(connection);
    connection.admitted(links.add(connection), workBits);
    return true;
  }

  private String full() {
    return "the server is full (" + limits.maxConnections() + " connections)";
  }

  private void evict(ServerConnection connection) {
    counters.evicted.incrementAndGet();
    connection.dismiss("too many are connecting to this server; try again in a moment");
  }

  /** Takes a datagram that came in by UDP. Called on the port's thread. */
  private void datagram(InetSocketAddress from, ByteBuffer datagram, long nowNs) {
    int length = datagram.remaining();
    if (line != null && line.isDeaf()) {
      return;
    }
    datagram.get(received, 0, length);
    ServerConnection connection = links.get(DatagramOpener.link(received, length));
    if (connection != null && received[0] != Frame.REGISTER_UDP) {
      connection.readDatagram(from, received, length, receivedView, nowNs);
    } else if (!register(from, length, nowNs)) {
      counters.strangeDatagrams.incrementAndGet();
    }
  }

  /**
   * Tells a new connection its UDP address.
   *
   * @return false when the datagram is no registration that a connection waits for
   */
  private boolean register(InetSocketAddress from, int length, long nowNs) {
    if (length != Frame.REGISTRATION_BYTES || received[0] != Frame.REGISTER_UDP) {
      return false;
    }
    receivedView.limit(length).position(1);
    ServerConnection newcomer = links.get(receivedView.getInt());
    long token = receivedView.getLong();
    if (newcomer == null
        || !newcomer.hasToken(token)
        || !workProof.isSolved(
            newcomer.number(), token, newcomer.workBits(), receivedView.getLong())) {
      return false;
    }
    newcomer.addressKnown(from, nowNs);
    return true;
  }

  /** Returns whether a client has worked. Called on the network thread. */
  boolean hasWorked(ServerConnection connection, int bits, long solution) {
    return streamWorkProof.isSolved(connection.number(), connection.token(), bits, solution);
  }

  /**
   * Returns how long a client may take for a step of the handshake: as long as the slowest line
   * needs while most places are free, so that nobody pays for it. When newcomers have to work for a
   * place, nobody holds one for longer than a usual line needs.
   */
  long handshakeNanos() {
    long factor = entrance.workBits() == 0 ? KryoLimits.CALM_FACTOR : 1;
    return factor * limits.handshakeMillis() * 1_000_000L;
  }

  /** Sends a datagram. Returns false when this end lost it. Any thread may call it. */
  boolean send(InetSocketAddress to, byte[] bytes, int length) {
    return datagrams.send(to, bytes, length);
  }

  /**
   * Opens a link whose client has proven its address. If an older connection has the address, its
   * client has crashed or left without a word, and the system gave its port to the new client. So
   * the older link ends. Called on the port's thread, or for a link without UDP, whose address is
   * null, on the network thread.
   */
  synchronized void opened(ServerConnection connection, InetSocketAddress address, Link link) {
    if (!connection.openLink()) {
      return;
    }
    if (address != null) {
      claim(address, connection);
    }
    counters.opened.incrementAndGet();
    if (open.incrementAndGet() > limits.maxConnections()) {
      link.close(full());
    } else if (!opened.offer(link)) {
      link.close("the server is busy");
    } else {
      wake.run();
    }
  }

  /** Notes that a client has proven another address. Called on the port's thread. */
  void moved(ServerConnection connection, InetSocketAddress from, InetSocketAddress to) {
    counters.movedLinks.incrementAndGet();
    if (from != null) {
      byAddress.remove(from, connection);
    }
    claim(to, connection);
  }

  private void claim(InetSocketAddress address, ServerConnection connection) {
    ServerConnection before = byAddress.put(address, connection);
    if (before != null && before != connection) {
      before.supersede();
    }
    if (connection.phase() == ServerConnection.Phase.CLOSED) {
      byAddress.remove(address, connection); // it closed meanwhile
    }
  }

  /**
   * Forgets a connection that is closed.
   *
   * @param wasOpen whether its link had opened
   */
  void forget(ServerConnection connection, InetSocketAddress address, boolean wasOpen) {
    if (wasOpen) {
      open.decrementAndGet();
    }
    links.remove(connection);
    if (address != null) {
      byAddress.remove(address, connection);
    }
    if (connections.remove(connection)) {
      hosts.remove(connection.origin().host());
      entrance.remove(connection);
    }
  }

  /** The codec through which the server reads TCP. */
  private final class ServerFrames extends FrameCodec {
    @Override
    protected void writeRegistration(
        Connection connection, ByteBuffer buffer, Object registration) {
      if (registration instanceof RegisterTCP) {
        buffer.put(((ServerConnection) connection).greeting());
      }
    }

    @Override
    protected StreamSeal streamSeal(Connection connection) {
      return ((ServerConnection) connection).streamSeal();
    }

    @Override
    protected void written(Connection connection, byte tag) {
      if (tag == Frame.KEY_ANSWER) {
        ((ServerConnection) connection).sealStream();
      }
    }

    @Override
    public Object read(Connection connection, ByteBuffer buffer) {
      try {
        return ((ServerConnection) connection).readFrame(buffer);
      } catch (Throwable x) {
        counters.errors.add(x);
        return FrameCodec.HANDLED;
      } finally {
        buffer.position(buffer.limit());
      }
    }
  }
}
