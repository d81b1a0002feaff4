package carom.testkit;

import carom.net.transport.ClientTransport;
import carom.net.transport.Link;
import java.util.ArrayList;
import java.util.List;

/**
 * Opens links over a line that can be dead for some time, as in a tunnel. Nothing crosses a dead
 * line, in neither direction: datagrams are lost, reliable messages and the ends of links wait for
 * the line, and a link that is opened meanwhile connects only when the line is back. Neither side
 * hears of it. Wrap it in the simulation of a bad network, not the other way. One thread.
 */
public final class OutageTransport implements ClientTransport {
  private final ClientTransport inner;
  private final List<OutageLink> links = new ArrayList<>();
  private boolean dead;

  /**
   * Wraps a transport.
   *
   * @param inner opens the real links
   */
  public OutageTransport(ClientTransport inner) {
    this.inner = inner;
  }

  /** Ends the line's life for now, or brings it back; what waited then arrives at once. */
  public void dead(boolean now) {
    dead = now;
    links.removeIf(OutageLink::isOver);
    links.forEach(now ? OutageLink::lineEnds : OutageLink::lineReturns);
  }

  /** Returns whether the line is dead. */
  public boolean isDead() {
    return dead;
  }

  @Override
  public Link connect(String host, int tcpPort, int udpPort) {
    links.removeIf(OutageLink::isOver);
    OutageLink link = new OutageLink(() -> inner.connect(host, tcpPort, udpPort), dead);
    links.add(link);
    return link;
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
