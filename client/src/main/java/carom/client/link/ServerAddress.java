package carom.client.link;

/**
 * Address of a server.
 *
 * @param host name or address
 * @param tcpPort 1..65,535; 0 for an in-process transport, which has no ports
 * @param udpPort as the TCP port
 */
public record ServerAddress(String host, int tcpPort, int udpPort) {
  /** Returns the address for people: the host and, if there is one, the TCP port. */
  @Override
  public String toString() {
    return host + (tcpPort == 0 ? "" : ":" + tcpPort);
  }
}
