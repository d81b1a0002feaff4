package carom.server.session;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.net.protocol.ServerMessage;
import carom.net.transport.Broadcast;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Goal: a long answer reaches a client on a slow line, and a short one comes at once. */
class PacedMessagesTest {
  private static final long MS = 1_000_000;
  private final PacedMessages messages = new PacedMessages();

  private static List<Broadcast> answer(int count) {
    List<Broadcast> all = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      all.add(new Broadcast(new ServerMessage.Notice("" + i)));
    }
    return all;
  }

  @Test
  void aShortAnswerGoesAtOnce() {
    List<Broadcast> answer = answer(4);
    messages.begin(answer);
    for (Broadcast part : answer) {
      assertFalse(messages.isSent());
      assertSame(part, messages.take(7));
    }
    assertTrue(messages.isSent());
    assertNull(messages.take(8));
  }

  @Test
  void theRestOfALongAnswerComesOneByOneInOrder() {
    List<Broadcast> answer = answer(32);
    messages.begin(answer);
    List<Broadcast> taken = new ArrayList<>();
    int most = 0;
    for (int ms = 0; ms < 2_000; ms += 5) {
      int before = taken.size();
      for (Broadcast part; (part = messages.take(ms * MS)) != null; ) {
        taken.add(part);
      }
      most = ms == 0 ? 0 : Math.max(most, taken.size() - before);
      assertTrue(taken.size() <= 4 + ms / 50, taken.size() + " after " + ms + " ms");
    }
    assertEquals(1, most);
    assertEquals(answer, taken);
    assertTrue(messages.isSent());
  }
}
