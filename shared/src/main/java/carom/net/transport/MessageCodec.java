package carom.net.transport;

/**
 * Messages to bytes and back, both directions of the protocol. Implementations are safe from any
 * thread.
 */
public interface MessageCodec {

  /**
   * The bytes of a message.
   *
   * @throws IllegalArgumentException when the message is of no known type or breaks a limit; names
   *     field, value and limit
   */
  byte[] encode(Object message);

  /**
   * The message in some bytes. Never throws on the content and allocates within a bound.
   *
   * @return the message, or null when the bytes are not exactly one message within the limits
   */
  Object decode(byte[] bytes, int offset, int length);
}
