package carom.server.thin;

import java.util.function.Function;

/** A message to thin clients, which is encoded once for all that are told it. Any thread. */
public final class ThinNews {
  private final ThinServerMessage message;
  private byte[] bytes;

  /** Wraps a message. */
  public ThinNews(ThinServerMessage message) {
    this.message = message;
  }

  /** Returns the message. */
  public ThinServerMessage message() {
    return message;
  }

  /**
   * Returns the bytes of the message.
   *
   * @param form makes them; the same one at each call
   */
  public synchronized byte[] bytes(Function<ThinServerMessage, byte[]> form) {
    if (bytes == null) {
      bytes = form.apply(message);
    }
    return bytes;
  }
}
