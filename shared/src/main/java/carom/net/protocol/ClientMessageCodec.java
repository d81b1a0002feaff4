package carom.net.protocol;

/**
 * Fixed layout of what clients send: a tag byte, then the fields, big-endian, exact length. No
 * object graph, no reflection; safe on any bytes. Stateless, any thread.
 */
public final class ClientMessageCodec {

  private ClientMessageCodec() {}

  /**
   * Writes a message.
   *
   * @param message within {@link Limits}
   * @param out at least {@link Limits#MAX_CLIENT_MESSAGE_BYTES} from {@code offset} on
   * @return number of bytes written
   * @throws IllegalArgumentException when a field is outside its limit; names field, value and
   *     limit
   */
  public static int encode(ClientMessage message, byte[] out, int offset) {
    throw new UnsupportedOperationException("soon");
  }

  /** As {@link #encode(ClientMessage, byte[], int)}, into an array of exactly the right length. */
  public static byte[] encode(ClientMessage message) {
    throw new UnsupportedOperationException("soon");
  }

  /**
   * Reads a message. Never throws on the content, allocates at most the message and a name of
   * {@link Limits#MAX_NAME_BYTES}.
   *
   * @return the message, or null when the bytes are not exactly one message within the limits
   */
  public static ClientMessage decode(byte[] bytes, int offset, int length) {
    throw new UnsupportedOperationException("soon");
  }
}
