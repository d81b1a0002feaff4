package carom.net.transport;

/**
 * One message for many links: {@link Link#send} it to each, and it is encoded once. Any thread; the
 * message must not change.
 */
public final class Broadcast {
  private final Object message;
  private MessageCodec encodedBy;
  private byte[] bytes;

  /**
   * Wraps a message.
   *
   * @param message one that the links' codec knows
   */
  public Broadcast(Object message) {
    this.message = message;
  }

  /** The bytes of a message or of a broadcast's message; not to be changed. */
  public static byte[] encode(MessageCodec codec, Object message) {
    return message instanceof Broadcast broadcast
        ? broadcast.encodedBy(codec)
        : codec.encode(message);
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
