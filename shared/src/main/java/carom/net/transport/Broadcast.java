package carom.net.transport;

/**
 * A message for many links, which is encoded once. {@link Link#send} it to each link. Any thread
 * may use it; the wrapped message must not change.
 */
public final class Broadcast {
  private final Object message;
  private MessageCodec encodedBy;
  private byte[] bytes;

  /**
   * Wraps a message.
   *
   * @param message a message that the links' codec knows
   */
  public Broadcast(Object message) {
    this.message = message;
  }

  /**
   * Returns the bytes of a message, or of the message inside a broadcast. The caller must not
   * change them.
   */
  public static byte[] encode(MessageCodec codec, Object message) {
    return message instanceof Broadcast broadcast
        ? broadcast.encodedBy(codec)
        : codec.encode(message);
  }

  /** Returns a message, or the message inside a broadcast. */
  public static Object messageOf(Object message) {
    return message instanceof Broadcast broadcast ? broadcast.message : message;
  }

  @SuppressWarnings("ReferenceEquality") // another codec may write other bytes
  private synchronized byte[] encodedBy(MessageCodec codec) {
    if (encodedBy != codec) {
      bytes = codec.encode(message);
      encodedBy = codec;
    }
    return bytes;
  }

  @Override
  public String toString() {
    return "Broadcast[" + message + "]";
  }
}
