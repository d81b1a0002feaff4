package carom.launcher;

import carom.net.kryo.KryoMessageCodec;
import carom.net.transport.ClientTransport;
import carom.net.transport.InProcessNetwork;
import carom.net.transport.Link;
import carom.net.transport.ServerTransport;

/**
 * A server's transport whose links come from this process and, if others may join, from sockets.
 */
final class JoinedTransport implements ServerTransport {
  private final InProcessNetwork inside = new InProcessNetwork(new KryoMessageCodec());
  private final ServerTransport sockets;

  /**
   * Joins the two.
   *
   * @param sockets closed with this; null if no other client may join
   */
  JoinedTransport(ServerTransport sockets) {
    this.sockets = sockets;
  }

  /** Returns the clients' side in this process. */
  ClientTransport client() {
    return inside.client();
  }

  @Override
  public Link accept() {
    Link link = inside.server().accept();
    return link == null && sockets != null ? sockets.accept() : link;
  }

  /** Returns the sockets' port; 0 without sockets. */
  @Override
  public int tcpPort() {
    return sockets == null ? 0 : sockets.tcpPort();
  }

  /** Returns the sockets' port; 0 without sockets. */
  @Override
  public int udpPort() {
    return sockets == null ? 0 : sockets.udpPort();
  }

  @Override
  public void close() {
    inside.server().close();
    if (sockets != null) {
      sockets.close();
    }
  }
}
