package carom.server.thin.plain;

import carom.net.admission.Entrance;
import carom.net.admission.Hosts;
import carom.net.frame.DatagramPort;
import carom.net.protocol.RefusalReason;
import carom.net.transport.AddressFamily;
import carom.net.transport.HandshakeLine;
import carom.net.transport.Impairment;
import carom.net.transport.Link;
import carom.net.transport.NetworkCounter;
import carom.net.transport.ServerTransport;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ProtocolFamily;
import java.net.StandardSocketOptions;
import java.nio.ByteBuffer;
import java.nio.channels.SelectionKey;
import java.nio.channels.Selector;
import java.nio.channels.ServerSocketChannel;
import java.nio.channels.SocketChannel;
import java.security.SecureRandom;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Queue;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.locks.LockSupport;

/**
 * The door for programs with stock KryoNet 2.22 and its Kryo 2.24: a TCP port and, if wanted, a UDP
 * port. It is weaker than the server's own ports, see SECURITY.md: nothing is encrypted, and a
 * client shows its UDP address by a number alone. So connections here have places of their own.
 *
 * <p>A daemon thread serves TCP, another one UDP. A link is {@linkplain #accept accepted} when its
 * client has asked to join.
 */
public final class PlainDoor implements ServerTransport, Runnable {
  private static final int BACKLOG = 256;
  private static final int MOST_ACCEPTED = 32;
  private static final int READ_BYTES = 16 * 1_024;

  /** Send buffer of the system for each connection; what is in it can't be replaced by newer. */
  private static final int SEND_BUFFER_BYTES = 32 * 1_024;

  private static final int MAX_DATAGRAM = 2_048;
  private static final int SELECT_MILLIS = 100;
  private static final int IDLE_MILLIS = 1_000;
  private static final long SWEEP_NANOS = 100_000_000L;
  private static final long SHUTDOWN_NANOS = 500_000_000L;
  private static final int MAX_LEAVING = 256;

  private final boolean open;
  private final SecureRandom random = new SecureRandom();
  private final PlainCounters counters = new PlainCounters();
  private final Selector selector;
  private final List<ServerSocketChannel> ports = new ArrayList<>();
  private final DatagramPort datagrams; // null without UDP
  private final int tcpPort;
  private final Thread thread = new Thread(this, "carom-plain");
  private volatile PlainLimits limits;
  private volatile int most;
  private volatile int mostPerAddress;
  private volatile HandshakeLine network;
  private volatile Runnable wake = () -> {};
  private volatile boolean stopping;

  private final Map<Integer, PlainConnection> byId = new ConcurrentHashMap<>();
  private final Map<InetSocketAddress, PlainConnection> byUdp = new ConcurrentHashMap<>();
  private final Queue<PlainLink> joined = new ConcurrentLinkedQueue<>();
  private final Queue<PlainConnection> closing = new ConcurrentLinkedQueue<>();

  // The door's thread only.
  private final Hosts hosts = new Hosts();
  private final Entrance<PlainConnection> entrance;
  private final ByteBuffer buffer = ByteBuffer.allocateDirect(READ_BYTES);
  private final PlainDecoder decoder = new PlainDecoder();
  private int inside;
  private int leaving;

  // The UDP port's thread only.
  private final PlainDecoder datagramDecoder = new PlainDecoder();
  private final byte[] received = new byte[MAX_DATAGRAM];

  /**
   * Opens the ports and starts to listen.
   *
   * @param addresses of this machine; empty for all
   * @param tcp 0..65,535; 0 takes a free one
   * @param udp 0..65,535; 0 takes a free one; -1 opens none, so that snapshots go by TCP
   * @param open whether clients from outside private networks may come
   * @throws IOException when a port can't be opened; nothing stays open then, and the message says
   *     which
   */
  public PlainDoor(List<InetAddress> addresses, int tcp, int udp, PlainLimits limits, boolean open)
      throws IOException {
    this.open = open;
    this.limits = limits;
    most = limits.maxConnections();
    mostPerAddress = limits.maxPerAddress();
    entrance = new Entrance<>(limits.maxWaiting(), 1, this::evict);
    List<InetAddress> all = addresses.isEmpty() ? Collections.singletonList(null) : addresses;
    selector = Selector.open();
    try {
      listen(all, tcp);
      tcpPort = ports.get(0).socket().getLocalPort();
      datagrams = udp < 0 ? null : listenToDatagrams(all, udp);
    } catch (IOException e) {
      closePorts();
      throw e;
    }
    thread.setDaemon(true);
    thread.start();
    if (datagrams != null) {
      datagrams.start();
    }
  }

  private void listen(List<InetAddress> addresses, int tcp) throws IOException {
    try {
      for (InetAddress address : addresses) {
        ProtocolFamily family = AddressFamily.of(address);
        ServerSocketChannel port =
            family == null ? ServerSocketChannel.open() : ServerSocketChannel.open(family);
        ports.add(port);
        int number = ports.size() == 1 ? tcp : ports.get(0).socket().getLocalPort();
        port.bind(new InetSocketAddress(address, number), BACKLOG);
        port.configureBlocking(false);
        port.register(selector, SelectionKey.OP_ACCEPT);
      }
    } catch (IOException e) {
      throw new IOException("TCP port " + tcp + " can't be opened: " + e.getMessage(), e);
    }
  }

  private DatagramPort listenToDatagrams(List<InetAddress> addresses, int udp) throws IOException {
    try {
      return new DatagramPort(addresses, udp, MAX_DATAGRAM, this::datagram, counters.errors::add);
    } catch (IOException e) {
      throw new IOException("UDP port " + udp + " can't be opened: " + e.getMessage(), e);
    }
  }

  private void closePorts() throws IOException {
    for (ServerSocketChannel port : ports) {
      port.close();
    }
    selector.close();
  }

  // What connections need.

  PlainLimits limits() {
    return limits;
  }

  PlainCounters counters() {
    return counters;
  }

  /** Lets the door's thread look; any thread. */
  void wake() {
    selector.wakeup();
  }

  /** Returns the number of TCP connections in any state; any thread. */
  int connectionCount() {
    return byId.size();
  }

  boolean sendDatagram(InetSocketAddress to, byte[] bytes, int length) {
    return datagrams.send(to, bytes, length);
  }

  void requestClose(PlainConnection connection) {
    closing.add(connection);
    selector.wakeup();
  }

  /** Lets a link in whose client has asked to join; the door's thread. */
  void joined(PlainConnection connection, PlainLink link) {
    entrance.remove(connection);
    counters.joined.incrementAndGet();
    inside++;
    int ofAddress = hosts.add(connection.origin().host());
    boolean crowded = inside > most / 2 && ofAddress > mostPerAddress;
    if (inside > most || crowded) {
      counters.refused.incrementAndGet();
      link.gone("too many connections");
      connection.refuse(
          RefusalReason.TOO_MANY_CONNECTIONS,
          crowded
              ? "Too many players with stock KryoNet come from your address ("
                  + mostPerAddress
                  + ")."
              : "Too many players with stock KryoNet are here (" + most + ").");
      return;
    }
    joined.add(link);
    wake.run();
  }

  /** Notes that a connection says its last words; the door's thread. */
  void left(PlainConnection connection) {
    entrance.remove(connection);
    leaving++;
    if (leaving > MAX_LEAVING) {
      connection.close("");
    }
  }

  /** Forgets a connection that is closed; the door's thread. */
  void forget(PlainConnection connection, boolean hadJoined, boolean wasLeaving) {
    entrance.remove(connection);
    byId.remove(connection.id());
    InetSocketAddress udp = connection.udp();
    if (udp != null) {
      byUdp.remove(udp, connection);
    }
    if (hadJoined) {
      inside--;
      hosts.remove(connection.origin().host());
    }
    if (wasLeaving) {
      leaving--;
    }
  }

  private void evict(PlainConnection connection) {
    counters.evicted.incrementAndGet();
    connection.refuse(
        RefusalReason.TOO_MANY_CONNECTIONS, "Too many connect; try again in a moment.");
  }

  // The door's thread.

  @Override
  public void run() {
    long nextSweep = System.nanoTime();
    while (!stopping) {
      nextSweep = turn(byId.isEmpty() ? IDLE_MILLIS : SELECT_MILLIS, nextSweep);
    }
    long until = System.nanoTime() + SHUTDOWN_NANOS;
    byId.values().forEach(c -> c.leave("the server is shutting down", System.nanoTime()));
    while (!byId.isEmpty() && System.nanoTime() - until < 0) {
      nextSweep = turn(SELECT_MILLIS / 10, nextSweep);
    }
    byId.values().forEach(c -> c.close("the server is shutting down"));
    try {
      closePorts();
    } catch (IOException e) {
      counters.errors.add(e);
    }
  }

  private long turn(int millis, long nextSweep) {
    try {
      selector.select(this::ready, millis);
      for (PlainConnection c; (c = closing.poll()) != null; ) {
        c.leave("closed", System.nanoTime());
      }
      long now = System.nanoTime();
      if (now - nextSweep < 0) {
        return nextSweep;
      }
      for (PlainConnection connection : byId.values()) {
        sweep(connection, now);
      }
      return now + SWEEP_NANOS;
    } catch (IOException | RuntimeException | Error e) { // whatever it is, the others go on
      counters.errors.add(e);
      LockSupport.parkNanos(1_000_000L);
      return nextSweep;
    } finally {
      Thread.interrupted(); // an interrupted thread would never wait in select again
    }
  }

  private void sweep(PlainConnection connection, long now) {
    try {
      connection.sweep(now);
    } catch (RuntimeException e) {
      counters.errors.add(e);
      connection.close("server error");
    }
  }

  private void ready(SelectionKey key) {
    if (key.attachment() instanceof PlainConnection connection) {
      serve(connection, key);
    } else {
      accept((ServerSocketChannel) key.channel());
    }
  }

  private void serve(PlainConnection connection, SelectionKey key) {
    try {
      if (key.isValid() && key.isWritable()) {
        connection.writable();
      }
      if (key.isValid() && key.isReadable()) {
        int count = connection.channel().read(buffer.clear());
        if (count < 0) {
          connection.close("the client closed the connection");
        } else {
          connection.read(buffer.flip(), decoder, System.nanoTime());
        }
      }
    } catch (IOException e) {
      connection.close("the connection broke");
    } catch (RuntimeException | Error e) {
      counters.errors.add(e);
      connection.close("server error");
    }
  }

  private void accept(ServerSocketChannel port) {
    for (int i = 0; i < MOST_ACCEPTED; i++) {
      try {
        SocketChannel channel = port.accept();
        if (channel == null) {
          return;
        }
        counters.accepted.incrementAndGet();
        admit(channel);
      } catch (IOException e) { // too many open files: connections must close before the next comes
        counters.errors.add(e);
        LockSupport.parkNanos(1_000_000L);
        return;
      }
    }
  }

  private void admit(SocketChannel channel) throws IOException {
    InetSocketAddress from;
    SelectionKey key;
    try {
      from = (InetSocketAddress) channel.getRemoteAddress();
      if (from == null || (!open && !PrivateNetworks.contains(from.getAddress()))) {
        counters.foreign.incrementAndGet();
        channel.close();
        return;
      }
      channel.configureBlocking(false);
      channel.setOption(StandardSocketOptions.TCP_NODELAY, true);
      channel.setOption(StandardSocketOptions.SO_SNDBUF, SEND_BUFFER_BYTES);
      key = channel.register(selector, SelectionKey.OP_READ);
    } catch (IOException e) { // it is gone already
      channel.close();
      return;
    }
    int id;
    do {
      id = random.nextInt() & Integer.MAX_VALUE;
    } while (id == 0 || byId.containsKey(id));
    PlainConnection connection = new PlainConnection(this, channel, from, id, System.nanoTime());
    key.attach(connection);
    byId.put(id, connection);
    connection.begin(key);
    entrance.add(connection);
  }

  // The UDP port's thread.

  private void datagram(InetSocketAddress from, ByteBuffer datagram, long nowNs) {
    int length = datagram.remaining();
    datagram.get(received, 0, length);
    PlainConnection connection = byUdp.get(from);
    if (connection != null) {
      connection.datagram(datagramDecoder, received, length, nowNs);
    } else if (!register(from, length)) {
      counters.strangeDatagrams.incrementAndGet();
    }
  }

  private boolean register(InetSocketAddress from, int length) {
    if (length > 6
        || !(datagramDecoder.decode(received, 0, length, null)
            instanceof PlainControl.RegisterUdp registration)) {
      return false;
    }
    PlainConnection connection = byId.get(registration.id());
    if (connection == null || !connection.bind(from)) {
      return false;
    }
    byUdp.put(from, connection);
    if (!byId.containsKey(registration.id())) {
      byUdp.remove(from, connection); // it closed meanwhile
    }
    connection.confirmUdp();
    return true;
  }

  // A transport, as the server sees it.

  @Override
  public Link accept() {
    PlainLink link = joined.poll();
    while (link != null && link.state() == Link.State.CLOSED) {
      link = joined.poll(); // it closed before it was accepted
    }
    return link;
  }

  @Override
  public boolean onOpened(Runnable newWake) {
    wake = newWake;
    return true;
  }

  /** Lowers the door's own limits, never raises them. */
  @Override
  public void limitLinks(int newMost, int newMostPerAddress) {
    most = Math.min(limits.maxConnections(), newMost);
    mostPerAddress = Math.min(limits.maxPerAddress(), newMostPerAddress);
  }

  /**
   * Makes the network bad on purpose, for connections from now on: latency, jitter and loss.
   * Handshake and pings of KryoNet itself are as they are.
   */
  public void simulate(Impairment impairment) {
    network = new HandshakeLine(impairment);
  }

  /** Returns the simulated network, or null. */
  HandshakeLine network() {
    return network;
  }

  @Override
  public int tcpPort() {
    return tcpPort;
  }

  @Override
  public int udpPort() {
    return datagrams == null ? 0 : datagrams.number();
  }

  /** Returns the ports as the operator writes them, {@code TCP} or {@code TCP:UDP}. */
  public String ports() {
    return datagrams == null ? String.valueOf(tcpPort) : tcpPort + ":" + datagrams.number();
  }

  @Override
  public String troubles() {
    return counters.troubles();
  }

  @Override
  public List<NetworkCounter> networkCounters() {
    return counters.all();
  }

  @Override
  public Throwable nextError() {
    return counters.errors.take();
  }

  /**
   * Closes all connections and both ports, and waits for the threads. A second call does nothing.
   */
  @Override
  public void close() {
    HandshakeLine simulated = network;
    if (simulated != null) {
      simulated.close();
    }
    stopping = true;
    selector.wakeup();
    boolean interrupted = false;
    long deadline = System.nanoTime() + 5_000_000_000L;
    while (thread.isAlive() && System.nanoTime() - deadline < 0) {
      try {
        thread.join(1_000);
      } catch (InterruptedException e) {
        interrupted = true;
      }
    }
    if (datagrams != null) {
      datagrams.close();
    }
    if (interrupted) {
      Thread.currentThread().interrupt();
    }
  }
}
