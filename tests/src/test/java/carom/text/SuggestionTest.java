package carom.text;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;

import java.util.List;
import org.junit.jupiter.api.Test;

class SuggestionTest {
  private static final List<String> COMMANDS = List.of("say", "save", "status", "stop", "record");

  @Test
  void theOnlyWordThatBeginsSoIsMeant() {
    assertEquals("status", Suggestion.nearest("stat", COMMANDS));
    assertEquals("record", Suggestion.nearest("Rec", COMMANDS));
  }

  @Test
  void aFewWrongLettersAreForgiven() {
    assertEquals("status", Suggestion.nearest("stauts", COMMANDS));
    assertEquals("save", Suggestion.nearest("sav", COMMANDS));
    assertEquals("say", Suggestion.nearest("sya", COMMANDS));
    assertNull(Suggestion.nearest("teleport", COMMANDS));
    assertNull(Suggestion.nearest("x".repeat(65), COMMANDS));
  }
}
