package carom.net.transport;

import java.util.function.LongSupplier;

/**
 * A bad network in front of a server's transport: what clients experience without any flag of their
 * own. Each link gets a seed of its own, derived from the first, in the order of arrival.
 */
public final class ImpairedServerTransport implements ServerTransport {
  private final ServerTransport inner;
  private final LinkImpairer impairer;

  /**
   * Wraps a transport.
   *
   * @param inner accepts the real links; closed with this
   * @param impairment for both directions of each link
   * @param codec tells how many bytes a message takes on a line with a bandwidth
   * @param nowNs the clock the links are polled by
   */
  public ImpairedServerTransport(
      ServerTransport inner, Impairment impairment, MessageCodec codec, LongSupplier nowNs) {
    this.inner = inner;
    impairer = new LinkImpairer(impairment, codec, nowNs);
  }

  @Override
  public Link accept() {
    Link link = inner.accept();
    return link == null ? null : impairer.impair(link);
  }

  @Override
  public int tcpPort() {
    return inner.tcpPort();
  }

  @Override
  public int udpPort() {
    return inner.udpPort();
  }

  @Override
  public String troubles() {
    return inner.troubles();
  }

  @Override
  public Throwable nextError() {
    return inner.nextError();
  }

  @Override
  public void close() {
    inner.close();
  }
}
