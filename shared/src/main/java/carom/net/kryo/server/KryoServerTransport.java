package carom.net.kryo.server;

import carom.net.seal.Encryption;
import carom.net.transport.Impairment;
import carom.net.transport.Link;
import carom.net.transport.NetworkCounter;
import carom.net.transport.PortUnavailableException;
import carom.net.transport.ServerTransport;
import java.io.IOException;
import java.net.InetAddress;
import java.util.Collections;
import java.util.List;

/**
 * Server transport that listens on a TCP and a UDP port, each with its own daemon thread. Only the
 * owner's thread may call {@link #accept} and the links' {@code poll}; any thread may send. A link
 * opens when datagrams have passed in both directions.
 */
public final class KryoServerTransport implements ServerTransport {
  private static final int MAX_PORT = 65_535;

  private final ServerNetwork network;
  private final int tcpPort;
  private final int udpPort;

  /** Opens the ports with {@link KryoLimits#DEFAULT} and starts to listen. */
  public KryoServerTransport(int tcpPort, int udpPort) {
    this(tcpPort, udpPort, KryoLimits.DEFAULT);
  }

  /**
   * Opens the ports on all addresses of this machine, with a temporary identity, and starts to
   * listen.
   *
   * @param tcpPort 0..65,535; 0 takes a free one
   * @param udpPort 0..65,535; 0 takes a free one
   * @throws PortUnavailableException when a port is busy or forbidden; nothing stays open then
   * @throws IllegalArgumentException when a port is outside its range
   */
  public KryoServerTransport(int tcpPort, int udpPort, KryoLimits limits) {
    this(null, tcpPort, udpPort, limits, ServerIdentity.temporary(Encryption.ON));
  }

  /**
   * Opens the ports on one address of this machine and starts to listen.
   *
   * @param address an address of this machine, {@code 0.0.0.0} for those of IPv4, or null for all
   * @param tcpPort 0..65,535; 0 takes a free one
   * @param udpPort 0..65,535; 0 takes a free one
   * @param identity the key by which clients know this server
   * @throws PortUnavailableException when a port is busy or forbidden; nothing stays open then
   * @throws IllegalArgumentException when a port is outside its range
   */
  public KryoServerTransport(
      InetAddress address, int tcpPort, int udpPort, KryoLimits limits, ServerIdentity identity) {
    this(
        address == null ? List.of() : List.of(address),
        tcpPort,
        udpPort,
        limits,
        identity,
        Impairment.NONE,
        ProxyRule.NONE);
  }

  /**
   * Opens the ports as above, at one or more addresses, over a simulated network in the handshake
   * of the links. {@link carom.net.transport.ImpairedServerTransport} goes on where a link is open.
   *
   * @param addresses of this machine; empty for all
   * @param proxies which TCP connections come by proxies
   */
  public KryoServerTransport(
      List<InetAddress> addresses,
      int tcpPort,
      int udpPort,
      KryoLimits limits,
      ServerIdentity identity,
      Impairment impairment,
      ProxyRule proxies) {
    checkPort("tcpPort", tcpPort);
    checkPort("udpPort", udpPort);
    network = new ServerNetwork(limits, identity, impairment);
    try {
      List<InetAddress> all = addresses.isEmpty() ? Collections.singletonList(null) : addresses;
      network.bind(all, tcpPort, udpPort, proxies);
    } catch (IOException x) {
      network.dispose();
      throw PortUnavailableException.of(x, addresses, tcpPort, udpPort);
    }
    this.tcpPort = network.tcpPort();
    this.udpPort = network.udpPort();
    network.start();
  }

  private static void checkPort(String name, int port) {
    if (port < 0 || port > MAX_PORT) {
      throw new IllegalArgumentException(
          name + "=" + port + " must be from 0 (any free one) to " + MAX_PORT);
    }
  }

  @Override
  public String troubles() {
    return counters().troubles();
  }

  @Override
  public List<NetworkCounter> networkCounters() {
    return counters().all();
  }

  @Override
  public Throwable nextError() {
    return counters().errors.take();
  }

  @Override
  public Link accept() {
    return network.accept();
  }

  @Override
  public boolean onOpened(Runnable wake) {
    network.onOpened(wake);
    return true;
  }

  @Override
  public void limitLinks(int most, int mostPerAddress) {
    network.limits = network.limits.withConnections(most, mostPerAddress);
  }

  @Override
  public int tcpPort() {
    return tcpPort;
  }

  @Override
  public int udpPort() {
    return udpPort;
  }

  /** Returns the live counters of the whole transport. Each link has counters of its own. */
  public KryoServerCounters counters() {
    return network.counters;
  }

  /**
   * Tells all clients, closes all links and both ports, and waits for the network thread to end.
   * That takes half a second if a client doesn't answer. A second call does nothing.
   */
  @Override
  public void close() {
    network.stop();
  }
}
