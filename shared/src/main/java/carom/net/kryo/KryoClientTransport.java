package carom.net.kryo;

import carom.net.datagram.ClientDatagrams;
import carom.net.frame.Frame;
import carom.net.frame.Trust;
import carom.net.transport.ClientTransport;
import carom.net.transport.Link;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;

/**
 * Client transport over TCP and UDP. Each link has one daemon thread that waits in a selector, and
 * a second one while it connects; one more reads the datagrams of all links. Any thread may
 * connect; only the owner's thread may poll a link.
 */
public final class KryoClientTransport implements ClientTransport {
  private static final int CONNECT_MILLIS = 5_000;

  private final KryoMessageCodec codec = new KryoMessageCodec();
  private final ClientDatagrams datagrams = new ClientDatagrams(Frame.SERVER_BUFFER_BYTES);
  private final Set<ClientLink> links = ConcurrentHashMap.newKeySet();
  private final Trust trust;
  private final int connectMillis;
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
    this(trust, CONNECT_MILLIS);
  }

  /**
   * Creates a transport with another time limit for connecting. TCP's own part of it is always 5 s.
   */
  KryoClientTransport(Trust trust, int connectMillis) {
    this.trust = trust;
    this.connectMillis = connectMillis;
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
    ClientLink link =
        new ClientLink(
            codec, datagrams, trust, host, tcpPort, udpPort, connectMillis, links::remove);
    links.add(link);
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
    for (ClientLink link : links) {
      link.close("the game closed the connection");
    }
    boolean interrupted = false;
    long deadline = System.nanoTime() + 2_000_000_000L;
    for (ClientLink link : links) {
      interrupted |= link.await(deadline);
    }
    datagrams.close();
    if (interrupted) {
      Thread.currentThread().interrupt();
    }
  }
}
