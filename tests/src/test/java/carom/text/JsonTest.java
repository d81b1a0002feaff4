package carom.text;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** What a document of a hostile server can't do: use up memory, or write to a terminal. */
final class JsonTest {
  @Test
  void aDocumentAtTheLimitsIsRead() throws JsonException {
    assertEquals(
        Json.MAX_NODES - 1, parse("[" + "1,".repeat(Json.MAX_NODES - 2) + "1]").items.size());
    Json node = parse("[".repeat(Json.MAX_DEPTH) + "]".repeat(Json.MAX_DEPTH));
    int depth = 1;
    for (; !node.items.isEmpty(); depth++) {
      node = node.items.get(0);
    }
    assertEquals(Json.MAX_DEPTH, depth);
  }

  @Test
  void aValueBeyondTheLimitIsRefused() {
    JsonException e = refused("[" + "1,".repeat(Json.MAX_NODES - 1) + "1]");
    assertTrue(e.getMessage().contains("more than " + Json.MAX_NODES), e.getMessage());
  }

  @Test
  void aLevelOfNestingBeyondTheLimitIsRefused() {
    refused("[".repeat(Json.MAX_DEPTH + 1) + "]".repeat(Json.MAX_DEPTH + 1));
    refused("[".repeat(1_000_000));
  }

  @Test
  void longTextsNamesAndNumbersAreRefused() {
    refused("\"" + "a".repeat(5_000) + "\"");
    refused("{\"" + "a".repeat(5_000) + "\": 1}");
    refused("[" + "1".repeat(100) + "]");
  }

  @ParameterizedTest
  @ValueSource(strings = {"\\u001b[2J", "\\u202eevil", "\\u0007", "a\\nb", "\\ud800", "\\u200b"})
  void aTextThatATerminalWouldObeyIsRefusedWithoutShowingIt(String hostile) {
    for (String document :
        new String[] {
          "{\"bodies\": [{\"name\": \"" + hostile + "\"}]}", "{\"" + hostile + "\": 1}",
        }) {
      JsonException e = refused(document);
      String shown = e.path() + e.getMessage();
      assertTrue(shown.contains("invisible character"), shown);
      assertTrue(
          shown.chars().noneMatch(c -> c < ' ' || c >= 0x7f), "the error itself is printable");
    }
  }

  @Test
  void whatIsNoJsonIsQuotedWithoutWhatATerminalWouldObey() {
    for (String hostile : new String[] {"[\u001b[2J]", "tru\u202ee", "{\u0007: 1}", "[1,\u200b]"}) {
      String message = refused(hostile).getMessage();
      assertTrue(message.startsWith("not JSON: "), message);
      assertTrue(
          message.codePoints().noneMatch(c -> Character.getType(c) == Character.FORMAT || c < ' '),
          message);
    }
  }

  @Test
  void anErrorNamesThePlace() {
    JsonException e = refused("{\n  \"bodies\": [{\"name\": \"\\u0000\"}]}");
    assertEquals("2:23 bodies[0].name", e.line() + ":" + e.column() + " " + e.path());
  }

  @Test
  void lettersOfAllLanguagesAreText() throws JsonException {
    for (String text : new String[] {"Čaj", "茶", "чай", "🎱", "e\u0301"}) {
      assertEquals(text, parse("\"" + text + "\"").text);
    }
  }

  private static JsonException refused(String document) {
    return assertThrows(JsonException.class, () -> parse(document));
  }

  private static Json parse(String document) throws JsonException {
    return Json.parse(document.getBytes(UTF_8));
  }
}
