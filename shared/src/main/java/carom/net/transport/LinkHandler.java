package carom.net.transport;

/** Receiver of what arrives on a {@link Link}. It runs on the thread that polls. */
public interface LinkHandler {

  /** Takes a message, which the handler then owns. */
  void message(Link link, Object message);

  /** Takes a datagram. The first {@code length} bytes are valid only during the call. */
  void datagram(Link link, byte[] bytes, int length);

  /** Learns that the link has closed and nothing more will come. The link calls this once. */
  void closed(Link link, String reason);
}
