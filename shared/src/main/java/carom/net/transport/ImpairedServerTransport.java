package carom.net.transport;

import java.util.List;
import java.util.function.LongSupplier;

/**
 * Server transport that simulates a bad network, so that clients experience it without a flag of
 * their own. Each link gets its own seed, derived from the configured one in the order of arrival.
 */
public final class ImpairedServerTransport implements ServerTransport {
  private final ServerTransport inner;
  private final LinkImpairer impairer;

  /**
   * Wraps a transport in a bad network.
   *
   * @param inner accepts the real links; closing this transport closes it
   * @param impairment for both directions of each link
   * @param codec gives the size of a message, which counts on a line with limited bandwidth
   * @param nowNs clock in nanoseconds, the one the links are polled by
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
  public boolean onOpened(Runnable wake) {
    return inner.onOpened(wake);
  }

  @Override
  public void limitLinks(int most, int mostPerAddress) {
    inner.limitLinks(most, mostPerAddress);
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
  public List<NetworkCounter> networkCounters() {
    return inner.networkCounters();
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
