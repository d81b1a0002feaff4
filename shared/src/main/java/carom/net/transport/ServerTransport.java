package carom.net.transport;

import java.util.List;

/** Server side of a transport. */
public interface ServerTransport extends AutoCloseable {

  /** Returns the next link that has opened, or null if there is none. It never blocks. */
  Link accept();

  /**
   * Sets the callback that tells the server that {@link #accept} has a link, so that it needn't
   * poll.
   *
   * @param wake runs on any thread and returns at once
   * @return false if the transport doesn't tell, so that the server must look
   */
  default boolean onOpened(Runnable wake) {
    return false;
  }

  /**
   * Sets how many links may be open from now on. Any thread; a transport without limits ignores it.
   *
   * @param most links in all
   * @param mostPerAddress links from one address
   */
  default void limitLinks(int most, int mostPerAddress) {}

  /** Returns the TCP port that the transport listens on, or 0 if there is none. */
  int tcpPort();

  /** Returns the UDP port that the transport listens on, or 0 if there is none. */
  int udpPort();

  /**
   * Returns a short summary for the operator of refused and closed connections and of failures
   * since the transport opened. It is empty if there were none. Any thread may call it.
   */
  default String troubles() {
    return "";
  }

  /** Returns what the transport counts. Any thread may call it. */
  default List<NetworkCounter> networkCounters() {
    return List.of();
  }

  /**
   * Returns an unexpected error that the transport survived and has not reported, or null. It
   * reports the 1st, 10th, 100th and so on; each is a bug. One thread may call it.
   */
  default Throwable nextError() {
    return null;
  }

  /** Stops listening and closes all links. A second call does nothing. */
  @Override
  void close();
}
