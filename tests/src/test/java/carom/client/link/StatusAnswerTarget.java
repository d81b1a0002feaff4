package carom.client.link;

import carom.fuzz.FuzzTarget;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.List;

/** Answers to a search for servers, from a hostile one. What is kept can be shown and joined. */
public final class StatusAnswerTarget implements FuzzTarget {
  @Override
  public void take(byte[] data) {
    StatusAnswer answer = StatusAnswer.parse(ByteBuffer.wrap(data));
    if (answer == null) {
      return;
    }
    for (String text : List.of(answer.name(), answer.level(), answer.game())) {
      FuzzTarget.requirePrintable(text);
      if (text.codePointCount(0, text.length()) > StatusAnswer.MAX_TEXT) {
        throw new AssertionError("a text of " + text.length() + " characters was kept");
      }
    }
    if (answer.tcpPort() < 1 || answer.tcpPort() > 65_535 || answer.protocol() < 1) {
      throw new AssertionError(answer.toString());
    }
  }

  @Override
  public List<byte[]> seeds() {
    return List.of(
        answer(0x20, new byte[0]),
        answer(0xa0, new byte[2]),
        answer(0xf0, "123456789012tv\0".getBytes(StandardCharsets.US_ASCII)));
  }

  private static byte[] answer(int flags, byte[] optional) {
    ByteBuffer out = ByteBuffer.allocate(300).order(ByteOrder.LITTLE_ENDIAN).putInt(-1);
    out.put((byte) 'I').put((byte) 17).put(bytes("A server\0Corner Pocket\0carom\0arena\0"));
    out.putShort((short) 0).put(new byte[] {2, 64, 0, 'd', 'l', 0, 0}).put(bytes("1.2\0"));
    out.put((byte) flags).put(optional).put(bytes("carom,tcp=54555,udp=54777,protocol=9\0"));
    byte[] bytes = new byte[out.position()];
    out.flip().get(bytes);
    return bytes;
  }

  private static byte[] bytes(String text) {
    return text.getBytes(StandardCharsets.UTF_8);
  }
}
