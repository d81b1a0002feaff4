package carom.net.transport;

/** Receiver of what arrives on a {@link Link}. It runs on the thread that polls. */
public interface LinkHandler {

  /** Takes a message, which the handler then owns. */
  void message(Link link, Object message);

  /** Takes a datagram. The first {@code length} bytes are valid only during the call. */
  void datagram(Link link, byte[] bytes, int length);

  /** Learns that the link has closed and nothing more will come. The link calls this once. */
  void closed(Link link, String reason);

  /** Returns a handler that tells this one what a link brings as if another link had brought it. */
  default LinkHandler as(Link other) {
    LinkHandler told = this;
    return new LinkHandler() {
      @Override
      public void message(Link link, Object message) {
        told.message(other, message);
      }

      @Override
      public void datagram(Link link, byte[] bytes, int length) {
        told.datagram(other, bytes, length);
      }

      @Override
      public void closed(Link link, String reason) {
        told.closed(other, reason);
      }
    };
  }
}
