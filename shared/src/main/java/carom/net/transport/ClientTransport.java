package carom.net.transport;

/** Client side of a transport. */
public interface ClientTransport extends AutoCloseable {

  /**
   * Starts to connect. It returns at once with a link in {@code CONNECTING}. A failure shows as
   * {@code CLOSED} with a reason that a player understands. Any thread may call it, also several at
   * once.
   *
   * @param host name or address of the server
   * @param tcpPort 1..65,535
   * @param udpPort 1..65,535, or 0 for the one that the server tells over TCP
   */
  Link connect(String host, int tcpPort, int udpPort);

  /**
   * Notes which key a server must show, as another server said, unless this client knows one
   * already. Transports without keys ignore it.
   *
   * @param server host and TCP port, {@code host:port}
   */
  default void expect(String server, String fingerprint) {}

  /** Closes all links and stops the transport's threads. A second call does nothing. */
  @Override
  void close();
}
