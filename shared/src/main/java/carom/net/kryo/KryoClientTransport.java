package carom.net.kryo;

import carom.net.transport.ClientTransport;
import carom.net.transport.Link;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;

/**
 * Connects to servers over TCP and UDP. Each link has one daemon thread that waits in a selector; a
 * second one helps it while it connects. Any thread may connect; each link's {@code poll} belongs
 * to its owner's.
 */
public final class KryoClientTransport implements ClientTransport {
  private static final int CONNECT_MILLIS = 5_000;

  private final KryoMessageCodec codec = new KryoMessageCodec();
  private final Set<ClientLink> links = ConcurrentHashMap.newKeySet();
  private final int connectMillis;
  private volatile boolean closed;

  /** Creates a transport without connections. */
  public KryoClientTransport() {
    this(CONNECT_MILLIS);
  }

  /**
   * With another time until a server that doesn't answer is given up; TCP's own part of it is
   * always 5 s.
   */
  KryoClientTransport(int connectMillis) {
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
      throw new IllegalStateException("connect after close");
    }
    ClientLink link = new ClientLink(codec, host, tcpPort, udpPort, connectMillis, links::remove);
    links.add(link);
    link.start();
    return link;
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
    if (interrupted) {
      Thread.currentThread().interrupt();
    }
  }
}
