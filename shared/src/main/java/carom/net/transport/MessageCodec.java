package carom.net.transport;

/**
 * Codec of the protocol's messages in both directions. Implementations are safe from any thread.
 */
public interface MessageCodec {

  /**
   * Returns the bytes of a message.
   *
   * @throws IllegalArgumentException when the message has an unknown type or breaks a limit; the
   *     text names field, value and limit
   */
  byte[] encode(Object message);

  /**
   * Reads a message. The content never makes it throw, and it allocates within a bound.
   *
   * @return the message, or null when the bytes are not exactly one message within the limits
   */
  Object decode(byte[] bytes, int offset, int length);
}
