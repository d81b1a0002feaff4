package carom.net.transport;

/** The server's side of a transport. */
public interface ServerTransport extends AutoCloseable {

  /** The next link that has opened, or null when there is none now. Never blocks. */
  Link accept();

  /** The TCP port it listens on, 0 when there is none. */
  int tcpPort();

  /** The UDP port it listens on, 0 when there is none. */
  int udpPort();

  /**
   * What it turned away, threw out and failed at since it was opened, in a few words for an
   * operator; empty when there was nothing. Any thread.
   */
  default String troubles() {
    return "";
  }

  /**
   * An unexpected error that the transport survived and that nobody was told of yet, or null: the
   * 1st, 10th, 100th and so on. Each is a bug. One thread.
   */
  default Throwable nextError() {
    return null;
  }

  /** Stops listening and closes all links. Closing twice does nothing. */
  @Override
  void close();
}
