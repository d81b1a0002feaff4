package carom.net.transport;

/**
 * A network inside one process: links between its server and client side, bounded inboxes, real
 * bytes through a {@link MessageCodec}. Nothing is lost, nothing takes time; wrap links in {@link
 * ImpairedLink} for that. Safe with the two sides on two threads; needs none.
 */
public final class InProcessNetwork {

  /** Creates a network whose messages go through {@code codec}. */
  public InProcessNetwork(MessageCodec codec) {}

  /** The server's side; the same object at each call. Its ports are 0. */
  public ServerTransport server() {
    throw new UnsupportedOperationException("soon");
  }

  /**
   * The client's side; host and ports are ignored. Links are {@code OPEN} at once, or {@code
   * CLOSED} when the server side is closed.
   */
  public ClientTransport client() {
    throw new UnsupportedOperationException("soon");
  }
}
