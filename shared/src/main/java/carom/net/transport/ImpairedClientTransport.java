package carom.net.transport;

import java.util.function.LongSupplier;

/**
 * Client transport that simulates a bad network. Each link gets its own seed, derived from the
 * configured one in the order of connecting. Equal seeds, order and traffic give each datagram the
 * same fate. If several threads connect at once, the order is up to chance.
 */
public final class ImpairedClientTransport implements ClientTransport {
  private final ClientTransport inner;
  private final LinkImpairer impairer;

  /**
   * Wraps a transport in a bad network.
   *
   * @param inner opens the real links; closing this transport closes it
   * @param impairment for both directions of each link
   * @param codec gives the size of a message, which counts on a line with limited bandwidth
   * @param nowNs clock in nanoseconds, the one the links are polled by
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
  public void expect(String server, String fingerprint) {
    inner.expect(server, fingerprint);
  }

  @Override
  public void close() {
    inner.close();
  }
}
