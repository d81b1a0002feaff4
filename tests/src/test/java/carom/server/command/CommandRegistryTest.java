package carom.server.command;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;

/**
 * Goal: one line, one answer, whatever the line. Method: commands that tell what they were given.
 */
final class CommandRegistryTest {
  private final CommandRegistry registry = new CommandRegistry();

  CommandRegistryTest() {
    registry.add(
        new Command(
            "tell",
            "WORD...",
            "Tells its words.",
            words -> words.word(0, "WORD") + "|" + words.rest(1) + "|" + words.room(),
            place -> List.of("place" + place, "@duel")));
    registry.add(
        new Command(
            "bug",
            "",
            "Fails.",
            words -> {
              throw new IllegalStateException("oops");
            },
            Command.NONE));
  }

  private String ok(String line) {
    CommandRegistry.Answer answer = registry.run(line, Caller.CONSOLE);
    assertTrue(answer.ok(), answer.text());
    return answer.text();
  }

  private String fails(String line) {
    CommandRegistry.Answer answer = registry.run(line, Caller.CONSOLE);
    assertFalse(answer.ok(), answer.text());
    return answer.text();
  }

  @Test
  void quotesHoldWordsTogetherAndAtNamesTheRoomAnywhere() {
    assertEquals("a|b c|null", ok("  tell a b   c "));
    assertEquals("a b|c|duel", ok("TELL \"a b\" @duel c"));
    assertEquals("|x|null", ok("tell \"\" x"));
    assertEquals("@duel|a\"b|null", ok("tell \"@duel\" a\"b"));
    assertTrue(fails("tell \"a b @").startsWith("a quote is opened and never closed"));
    assertTrue(fails("tell a\ntell b").startsWith("this is more than one line"));
    assertEquals("", ok("") + ok("   ") + ok("# comment"));
  }

  @Test
  void unknownAndIncompleteLinesSayWhatToDo() {
    assertTrue(fails("tel").contains("did you mean \"tell\"?"));
    assertTrue(fails("xyzzy").contains("try help"));
    assertEquals("WORD is missing; usage: tell WORD...", fails("tell"));
    assertTrue(fails("help tel").contains("did you mean \"tell\"?"));
    assertTrue(fails("help a b").contains("\"b\" is one word too many"));
    assertTrue(fails("x".repeat(5_000)).contains("more than 4096"));
  }

  @Test
  void anExceptionIsAnAnswerToo() {
    assertTrue(fails("bug").contains("oops"));
  }

  @Test
  void helpNamesAllCommands() {
    assertTrue(ok("help").matches("(?s).*\ntell WORD\\.\\.\\. +Tells its words\\.\n.*"));
    assertEquals("tell WORD...\n  Tells its words.", ok("help tell"));
  }

  @Test
  void completionKnowsThePlaceWithoutTheRoom() {
    assertEquals(List.of("bug", "help", "tell"), registry.complete(List.of(), Caller.CONSOLE));
    assertEquals(List.of("place0", "@duel"), registry.complete(List.of("tell"), Caller.CONSOLE));
    assertEquals(
        List.of("place1"), registry.complete(List.of("tell", "@duel", "a"), Caller.CONSOLE));
    assertEquals(List.of(), registry.complete(List.of("xyzzy"), Caller.CONSOLE));
  }

  @Test
  void nothingThatSteersATerminalGetsThrough() {
    String hostile = "tell \u001b[2J\u009b1m\u202egnp\u2066\u0007\ue000\ud800";
    String answer = ok(hostile);
    assertTrue(answer.startsWith("U+001B[2JU+009B1mU+202EgnpU+2066U+0007U+E000U+D800"), answer);
    assertEquals("é ✓ 😀\nx", Printable.text("é ✓ 😀\nx"));
  }
}
