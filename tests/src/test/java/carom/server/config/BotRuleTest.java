package carom.server.config;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Goal: {@code --bots} says what an operator means. Method: values, and those with mistakes. */
class BotRuleTest {
  private static List<BotRule> rules(String... texts) {
    return Stream.of(texts).map(BotRule::parse).toList();
  }

  @Test
  void aRoomsOwnRuleComesBeforeThatForAllAndTheLastCounts() {
    List<BotRule> rules = rules("cup=6:strong", "4", "3:weak", "quiet=0");
    assertEquals(new BotRule("cup", 6, "strong"), BotRule.of(rules, "cup"));
    assertEquals(new BotRule("", 3, "weak"), BotRule.of(rules, "other"));
    assertEquals(0, BotRule.of(rules, "quiet").players());
    assertSame(BotRule.NONE, BotRule.of(rules("cup=6"), "other"));
  }

  @ParameterizedTest
  @ValueSource(strings = {"4", "0", "cup=6:strong", "1=2", "1024:weak"})
  void aRuleIsWrittenAsItIsRead(String text) {
    assertEquals(text, BotRule.parse(text).toString());
  }

  @ParameterizedTest
  @ValueSource(strings = {"", "four", "-1", "4:hard", "cup=", "=4", "cup:4", "12345"})
  void aMistakeIsToldWithTheForm(String text) {
    String told =
        assertThrows(IllegalArgumentException.class, () -> BotRule.parse(text)).getMessage();
    assertTrue(told.contains("[ROOM=]N[:STRENGTH]"), told);
  }

  @Test
  void theMostIsARoomsLargestNumberOfPlaces() {
    String told =
        assertThrows(IllegalArgumentException.class, () -> BotRule.parse("1025")).getMessage();
    assertTrue(told.contains("1025") && told.contains("0..1024"), told);
    ServerConfig read =
        new ServerConfig().with(ServerConfig.BOTS, ServerConfig.BOTS.parse(List.of("4", "a=2")));
    assertEquals(
        "4, a=2",
        String.join(", ", read.get(ServerConfig.BOTS).stream().map(String::valueOf).toList()));
  }
}
