package carom.net.frame;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;

/** Goal: the reason of the other side never reaches a terminal raw. */
class FrameTest {
  @Test
  void aReasonIsOneLineWithoutInvisibleCharacters() {
    String hostile = "bye\u001b[31m\u202egnorw\u2069\r\nadmin:\u200b in\u0085 \ue000";
    ByteBuffer bytes = ByteBuffer.wrap(hostile.getBytes(StandardCharsets.UTF_8));
    assertEquals("bye[31mgnorw  admin: in", Frame.byeText(bytes));
  }
}
