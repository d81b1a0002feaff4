package carom.client.link;

import java.io.IOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.InterfaceAddress;
import java.net.NetworkInterface;
import java.net.SocketException;
import java.net.SocketTimeoutException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * Searches the local network for servers, on a daemon thread of its own. It broadcasts a status
 * query every {@value #ROUND_MS} ms over IPv4, asks this machine too, and forgets a server that
 * hasn't answered for {@value #KEEP_MS} ms. Servers that use another query port than the usual one
 * aren't found.
 *
 * <p>Anybody may answer. So at most {@value #MAX_SERVERS} servers are kept and {@value
 * #MAX_PER_ROUND} datagrams are looked at in a round, and an address is asked at most {@value
 * #MAX_PER_ADDRESS} times a round, which makes this useless for floods.
 */
public final class LanSearch implements AutoCloseable {
  /** Port at which servers answer unless told otherwise. */
  public static final int QUERY_PORT = 27_015;

  /** Most servers that are kept. */
  static final int MAX_SERVERS = 32;

  /** Most servers of one machine that are kept. */
  static final int MAX_PER_HOST = 8;

  private static final int ROUND_MS = 2_000;
  private static final int KEEP_MS = 7_000;
  private static final int MAX_PER_ROUND = 256;
  private static final int MAX_PER_ADDRESS = 2;
  private static final int MAX_INTERFACES = 16;
  private static final long NS_PER_MS = 1_000_000L;
  private static final int SINGLE = -1;
  private static final byte QUERY = 'T';
  private static final byte CHALLENGE = 'A';
  private static final int CHALLENGE_BYTES = 9;
  private static final byte[] PAYLOAD = "Source Engine Query\0".getBytes(StandardCharsets.US_ASCII);

  private final int queryPort;
  private final DatagramSocket socket;
  private final Thread thread;
  private volatile List<LanServer> servers = List.of();

  // used by the thread
  private final Map<ServerAddress, Heard> heard = new LinkedHashMap<>();
  private final Map<InetSocketAddress, Asked> asked = new LinkedHashMap<>();

  private record Heard(LanServer server, long timeNs) {}

  /** Number of times that an address was asked in this round, and the last time. */
  private record Asked(int times, long timeNs) {}

  /**
   * Begins to search.
   *
   * @throws IOException when the system gives no socket
   */
  public LanSearch() throws IOException {
    this(QUERY_PORT);
  }

  /** Begins to search for servers with another query port. */
  LanSearch(int queryPort) throws IOException {
    this.queryPort = queryPort;
    socket = new DatagramSocket();
    socket.setBroadcast(true);
    thread = new Thread(this::run, "carom-lan-search");
    thread.setDaemon(true);
    thread.start();
  }

  /**
   * Returns the servers that answer, in the order in which they first did. The list is another
   * object after each change, and never changes itself. Any thread may call it.
   */
  public List<LanServer> servers() {
    return servers;
  }

  private void run() {
    while (!socket.isClosed()) {
      try {
        round();
      } catch (IOException | RuntimeException broken) {
        pause(); // no network, or this search is closed
      }
    }
  }

  private void pause() {
    try {
      Thread.sleep(ROUND_MS / 10);
    } catch (InterruptedException x) {
      Thread.currentThread().interrupt();
      socket.close();
    }
  }

  private void round() throws IOException {
    asked.clear();
    byte[] question = query(SINGLE);
    for (InetAddress target : targets()) {
      try {
        socket.send(
            new DatagramPacket(
                question, question.length, new InetSocketAddress(target, queryPort)));
      } catch (IOException unreachable) {
        // another network may do
      }
    }
    long startNs = System.nanoTime();
    DatagramPacket in =
        new DatagramPacket(new byte[StatusAnswer.MAX_BYTES], StatusAnswer.MAX_BYTES);
    int looked = 0;
    while (true) {
      int leftMs = (int) (ROUND_MS - (System.nanoTime() - startNs) / NS_PER_MS);
      if (leftMs <= 0) {
        break;
      }
      socket.setSoTimeout(leftMs);
      try {
        in.setLength(StatusAnswer.MAX_BYTES);
        socket.receive(in);
      } catch (SocketTimeoutException quiet) {
        break;
      }
      if (++looked <= MAX_PER_ROUND) {
        receive(in, System.nanoTime());
      }
    }
    long nowNs = System.nanoTime();
    if (heard.values().removeIf(h -> nowNs - h.timeNs > KEEP_MS * NS_PER_MS)) {
      publish();
    }
  }

  private void receive(DatagramPacket packet, long nowNs) throws IOException {
    InetSocketAddress from = (InetSocketAddress) packet.getSocketAddress();
    ByteBuffer in = ByteBuffer.wrap(packet.getData(), 0, packet.getLength());
    in.order(ByteOrder.LITTLE_ENDIAN);
    Asked before = asked.get(from);
    if (in.remaining() == CHALLENGE_BYTES && in.getInt(0) == SINGLE && in.get(4) == CHALLENGE) {
      int times = before == null ? 0 : before.times;
      if (times < MAX_PER_ADDRESS) {
        asked.put(from, new Asked(times + 1, nowNs));
        byte[] again = query(in.getInt(5));
        socket.send(new DatagramPacket(again, again.length, from));
      }
      return;
    }
    StatusAnswer answer = before == null ? null : StatusAnswer.parse(in);
    if (answer == null) {
      return;
    }
    ServerAddress address =
        new ServerAddress(host(from.getAddress()), answer.tcpPort(), ServerAddress.TOLD_UDP_PORT);
    if (heard.containsKey(address) || hasPlaceFor(address)) {
      int pingMs = (int) Math.round((nowNs - before.timeNs) / (double) NS_PER_MS);
      heard.put(address, new Heard(new LanServer(address, answer, pingMs), nowNs));
      publish();
    }
  }

  private boolean hasPlaceFor(ServerAddress address) {
    long sameHost = heard.keySet().stream().filter(a -> a.host().equals(address.host())).count();
    return heard.size() < MAX_SERVERS && sameHost < MAX_PER_HOST;
  }

  private void publish() {
    servers = heard.values().stream().map(Heard::server).toList();
  }

  /** Returns one name for this machine, which answers under several addresses. */
  private static String host(InetAddress address) throws SocketException {
    boolean here =
        address.isLoopbackAddress() || NetworkInterface.getByInetAddress(address) != null;
    return here ? "localhost" : address.getHostAddress();
  }

  private static byte[] query(int challenge) {
    ByteBuffer out =
        ByteBuffer.allocate(Integer.BYTES + 1 + PAYLOAD.length + Integer.BYTES)
            .order(ByteOrder.LITTLE_ENDIAN)
            .putInt(SINGLE)
            .put(QUERY)
            .put(PAYLOAD);
    if (challenge != SINGLE) {
      out.putInt(challenge);
    }
    byte[] bytes = new byte[out.position()];
    out.flip().get(bytes);
    return bytes;
  }

  /** Returns this machine, and the broadcast addresses of its networks. */
  private static Set<InetAddress> targets() throws IOException {
    Set<InetAddress> targets = new LinkedHashSet<>();
    targets.add(InetAddress.getByAddress(new byte[] {127, 0, 0, 1}));
    targets.add(InetAddress.getByAddress(new byte[] {-1, -1, -1, -1}));
    List<NetworkInterface> all = NetworkInterface.networkInterfaces().toList();
    for (NetworkInterface one : all.subList(0, Math.min(MAX_INTERFACES, all.size()))) {
      if (one.isUp() && !one.isLoopback()) {
        for (InterfaceAddress address : one.getInterfaceAddresses()) {
          if (address.getBroadcast() != null) {
            targets.add(address.getBroadcast());
          }
        }
      }
    }
    return targets;
  }

  /** Ends the search. It waits for nothing. */
  @Override
  public void close() {
    socket.close();
    thread.interrupt();
  }
}
