package carom.net.transport;

/** The server's side of a transport. */
public interface ServerTransport extends AutoCloseable {

  /** The next link that has opened, or null when there is none now. Never blocks. */
  Link accept();

  /** The TCP port it listens on, 0 when there is none. */
  int tcpPort();

  /** The UDP port it listens on, 0 when there is none. */
  int udpPort();

  /** Stops listening and closes all links. Closing twice does nothing. */
  @Override
  void close();
}
