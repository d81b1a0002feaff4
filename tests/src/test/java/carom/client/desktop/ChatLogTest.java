package carom.client.desktop;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.sim.message.BuiltInKinds;
import org.junit.jupiter.api.Test;

/** Goal: a line is written as one expects. Method: keys without a window. */
final class ChatLogTest {
  private final ChatLog log = new ChatLog();

  private void type(String text) {
    text.chars().forEach(c -> log.type((char) c));
  }

  @Test
  void aLineIsWhatWasTypedWithoutControlCharacters() {
    log.open(true);
    type("he\u001b\n\b\u007fllo");
    assertEquals("hello", log.draft());
    assertTrue(log.isToTeam());
  }

  @Test
  void nothingIsTypedIntoAClosedLineAndANewOneIsEmpty() {
    type("lost");
    log.open(false);
    assertEquals("", log.draft());
    type("kept");
    log.close();
    assertFalse(log.isOpen());
    log.open(false);
    assertEquals("", log.draft());
  }

  @Test
  void erasingTakesWholeCharactersAndStopsAtTheBeginning() {
    log.open(false);
    type("a😀");
    log.erase();
    assertEquals("a", log.draft());
    log.erase();
    log.erase();
    assertEquals("", log.draft());
  }

  @Test
  void aLineIsNoLongerThanChatMayBe() {
    log.open(false);
    type("x".repeat(500));
    assertEquals(BuiltInKinds.MAX_CHAT, log.draft().length());
  }

  @Test
  void theOldestLinesGo() {
    for (int i = 0; i < 20; i++) {
      log.add(new ChatLog.Line("Ann", false, "line " + i, i));
    }
    assertEquals(ChatLog.MOST_LINES, log.lines().size());
    assertEquals("line 19", log.lines().get(ChatLog.MOST_LINES - 1).text());
  }
}
