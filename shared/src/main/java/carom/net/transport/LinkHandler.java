package carom.net.transport;

/** Takes what a {@link Link} received, on the thread that polls. */
public interface LinkHandler {

  /** A message arrived; the handler owns it. */
  void message(Link link, Object message);

  /** A datagram arrived; the bytes from 0 on are the handler's only during the call. */
  void datagram(Link link, byte[] bytes, int length);

  /** The link is closed and nothing more will come; called once. */
  void closed(Link link, String reason);
}
