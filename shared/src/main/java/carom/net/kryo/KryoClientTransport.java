package carom.net.kryo;

import carom.net.frame.Frame;
import carom.net.frame.Trust;
import carom.net.transport.ClientTransport;
import carom.net.transport.HandshakeLine;
import carom.net.transport.Impairment;
import carom.net.transport.Link;
import java.net.InetAddress;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;

/**
 * Client transport over TCP and UDP. Each link has one daemon thread that waits in a selector, and
 * a second one while it connects; one more reads the datagrams of all links. Any thread may
 * connect; only the owner's thread may poll a link.
 */
public final class KryoClientTransport implements ClientTransport {
  private static final int STEP_MILLIS = 10_000;

  private final KryoMessageCodec codec = new KryoMessageCodec();
  private final ClientDatagrams datagrams = new ClientDatagrams(Frame.SERVER_BUFFER_BYTES);
  private final Set<AddressRace> links = ConcurrentHashMap.newKeySet();
  private final Trust trust;
  private final AddressRace.Names names;
  private HandshakeLine line; // null without a simulated network
  private final int stepMillis;
  private volatile boolean closed;

  /**
   * Creates a transport without connections. It encrypts, and remembers servers until the process
   * ends.
   */
  public KryoClientTransport() {
    this(Trust.firstUse());
  }

  /**
   * Creates a transport without connections.
   *
   * @param trust what a server must be like
   */
  public KryoClientTransport(Trust trust) {
    this(trust, STEP_MILLIS);
  }

  /**
   * Creates a transport over a simulated network, in the handshake of its links. {@link
   * carom.net.transport.ImpairedClientTransport} goes on where a link is open.
   */
  public KryoClientTransport(Trust trust, Impairment impairment) {
    this(trust, STEP_MILLIS);
    line = impairment.isNone() ? null : new HandshakeLine(impairment);
  }

  /**
   * Creates a transport with another time limit for each step of connecting, ms. TCP's own part is
   * always 5 s.
   */
  KryoClientTransport(Trust trust, int stepMillis) {
    this(trust, stepMillis, InetAddress::getAllByName);
  }

  /** Creates a transport that finds addresses in another way than by the system. */
  KryoClientTransport(Trust trust, int stepMillis, AddressRace.Names names) {
    this.trust = trust;
    this.names = names;
    this.stepMillis = stepMillis;
  }

  /**
   * {@inheritDoc}
   *
   * @throws IllegalArgumentException when a port is outside its range
   * @throws IllegalStateException when this transport is closed
   */
  @Override
  public Link connect(String host, int tcpPort, int udpPort) {
    if (closed) {
      throw new IllegalStateException("the transport is closed; create another one to connect");
    }
    checkPort("tcpPort", tcpPort, 1);
    checkPort("udpPort", udpPort, 0);
    links.removeIf(AddressRace::isOver);
    AddressRace race =
        new AddressRace(host, tcpPort, names, address -> open(host, tcpPort, udpPort, address));
    links.add(race);
    race.start();
    return race;
  }

  private static void checkPort(String name, int port, int least) {
    if (port < least || port > 65_535) {
      throw new IllegalArgumentException(
          name + "=" + port + " must be from " + least + " to 65535");
    }
  }

  private ClientLink open(String host, int tcpPort, int udpPort, InetAddress address) {
    ClientLink link =
        new ClientLink(codec, datagrams, trust, host, tcpPort, udpPort, stepMillis, line, address);
    link.start();
    return link;
  }

  @Override
  public void expect(String server, String fingerprint) {
    trust.servers().hear(server, fingerprint);
  }

  @Override
  public void close() {
    closed = true;
    for (AddressRace link : links) {
      link.close("the game closed the connection");
    }
    boolean interrupted = false;
    long deadline = System.nanoTime() + 2_000_000_000L;
    for (AddressRace link : links) {
      interrupted |= link.await(deadline);
    }
    datagrams.close();
    if (line != null) {
      line.close();
    }
    if (interrupted) {
      Thread.currentThread().interrupt();
    }
  }
}
