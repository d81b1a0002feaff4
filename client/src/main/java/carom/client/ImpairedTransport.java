package carom.client;

import carom.net.transport.ClientTransport;
import carom.net.transport.ImpairedLink;
import carom.net.transport.Impairment;
import carom.net.transport.Link;
import java.util.function.LongSupplier;

/** A bad network in front of any transport: each link gets its own seed, derived from the first. */
public final class ImpairedTransport implements ClientTransport {
  private final ClientTransport inner;
  private final Impairment impairment;
  private final LongSupplier nowNs;
  private long links;

  /**
   * Wraps a transport.
   *
   * @param inner opens the real links; closed with this
   * @param impairment for both directions of each link
   * @param nowNs the clock the links are polled by
   */
  public ImpairedTransport(ClientTransport inner, Impairment impairment, LongSupplier nowNs) {
    this.inner = inner;
    this.impairment = impairment;
    this.nowNs = nowNs;
  }

  @Override
  public Link connect(String host, int tcpPort, int udpPort) {
    long seed = impairment.seed() + 2 * links++;
    return new ImpairedLink(
        inner.connect(host, tcpPort, udpPort),
        impairment.withSeed(seed),
        impairment.withSeed(seed + 1),
        nowNs);
  }

  @Override
  public void close() {
    inner.close();
  }
}
