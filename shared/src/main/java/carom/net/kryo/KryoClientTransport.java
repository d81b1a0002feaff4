package carom.net.kryo;

import carom.net.transport.ClientTransport;
import carom.net.transport.Link;

/** Connects to servers over TCP and UDP. */
public final class KryoClientTransport implements ClientTransport {

  /** Creates a transport without connections. */
  public KryoClientTransport() {}

  @Override
  public Link connect(String host, int tcpPort, int udpPort) {
    throw new UnsupportedOperationException("soon");
  }

  @Override
  public void close() {
    throw new UnsupportedOperationException("soon");
  }
}
