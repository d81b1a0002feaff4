package carom.net.transport;

import java.nio.charset.StandardCharsets;

/** Strings as messages; one that begins with "?" can't be decoded. */
final class TextCodec implements MessageCodec {

  @Override
  public byte[] encode(Object message) {
    if (!(message instanceof String text)) {
      throw new IllegalArgumentException("message type=" + message.getClass());
    }
    return text.getBytes(StandardCharsets.UTF_8);
  }

  @Override
  public Object decode(byte[] bytes, int offset, int length) {
    String text = new String(bytes, offset, length, StandardCharsets.UTF_8);
    return text.startsWith("?") ? null : text;
  }
}
