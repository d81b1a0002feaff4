package carom.net.transport;

/** The client's side of a transport. */
public interface ClientTransport extends AutoCloseable {

  /**
   * Begins to connect. Returns at once with a link in {@code CONNECTING}; a failure shows as {@code
   * CLOSED} with a reason that a player understands. Any thread, several at once.
   *
   * @param host name or address
   * @param tcpPort 1..65,535
   * @param udpPort 1..65,535
   */
  Link connect(String host, int tcpPort, int udpPort);

  /** Closes all links and frees threads. Closing twice does nothing. */
  @Override
  void close();
}
