package carom.net.kryo;

import carom.net.transport.Link;
import carom.net.transport.ServerTransport;

/** Listens on a TCP and a UDP port. */
public final class KryoServerTransport implements ServerTransport {

  /** As {@link #KryoServerTransport(int, int, KryoLimits)} with {@link KryoLimits#DEFAULT}. */
  public KryoServerTransport(int tcpPort, int udpPort) {
    this(tcpPort, udpPort, KryoLimits.DEFAULT);
  }

  /**
   * Opens the ports and starts to listen.
   *
   * @param tcpPort 0..65,535; 0 takes a free one
   * @param udpPort 0..65,535; 0 takes a free one
   * @throws PortUnavailableException when a port is busy or forbidden; nothing stays open then
   * @throws IllegalArgumentException when a port is outside its range
   */
  public KryoServerTransport(int tcpPort, int udpPort, KryoLimits limits) {
    throw new UnsupportedOperationException("soon");
  }

  @Override
  public Link accept() {
    throw new UnsupportedOperationException("soon");
  }

  @Override
  public int tcpPort() {
    throw new UnsupportedOperationException("soon");
  }

  @Override
  public int udpPort() {
    throw new UnsupportedOperationException("soon");
  }

  @Override
  public void close() {
    throw new UnsupportedOperationException("soon");
  }
}
