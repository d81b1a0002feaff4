package carom.net.transport;

import java.util.function.LongSupplier;

/**
 * A bad network in front of a client's transport. Each link gets a seed of its own, derived from
 * the first, in the order of connecting: equal seeds, order and traffic give each datagram the same
 * fate. Among threads that connect at once the order is up to chance.
 */
public final class ImpairedClientTransport implements ClientTransport {
  private final ClientTransport inner;
  private final LinkImpairer impairer;

  /**
   * Wraps a transport.
   *
   * @param inner opens the real links; closed with this
   * @param impairment for both directions of each link
   * @param codec tells how many bytes a message takes on a line with a bandwidth
   * @param nowNs the clock the links are polled by
   */
  public ImpairedClientTransport(
      ClientTransport inner, Impairment impairment, MessageCodec codec, LongSupplier nowNs) {
    this.inner = inner;
    impairer = new LinkImpairer(impairment, codec, nowNs);
  }

  @Override
  public ImpairedLink connect(String host, int tcpPort, int udpPort) {
    return impairer.impair(inner.connect(host, tcpPort, udpPort));
  }

  @Override
  public void close() {
    inner.close();
  }
}
