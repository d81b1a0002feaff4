package carom.options;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.util.List;
import org.junit.jupiter.api.Test;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;

/** Goal: who doesn't know a flag's name is told it. Method: flags of server and bots. */
final class FlagSuggestionTest {
  private static final List<String> SERVER =
      List.of("--tcp-port", "--udp-port", "--web-port", "--max-players", "--max-load", "--level");
  private static final List<String> BOTS = List.of("--host", "--count", "--seconds", "--name");

  /** A program with a flag for all to see and one that is hidden. */
  @Command(name = "program")
  static final class Program {
    @Option(names = "--tcp-port")
    int port;

    @Option(names = "--port-of-tests", hidden = true)
    int hidden;
  }

  @Test
  void aMisspeltFlagIsTheFirstSuggestion() {
    assertEquals("--tcp-port", FlagSuggestion.of("--tcp-prot", SERVER).get(0));
    assertEquals("--max-players", FlagSuggestion.of("--maxplayers", SERVER).get(0));
    assertEquals("--seconds", FlagSuggestion.of("-second=5", BOTS).get(0));
  }

  @Test
  void aPartOfTheNameIsEnough() {
    assertEquals(
        List.of("--tcp-port", "--udp-port", "--web-port"), FlagSuggestion.of("--port", SERVER));
    assertEquals(
        List.of("--max-players", "--max-load"), FlagSuggestion.of("--max-visitors", SERVER));
  }

  @Test
  void wordsOfOtherProgramsAreUnderstood() {
    assertEquals("--count", FlagSuggestion.of("--bots", BOTS).get(0));
    assertEquals("--host", FlagSuggestion.of("--server", BOTS).get(0));
    assertEquals("--host", FlagSuggestion.of("--port=30", BOTS).get(0));
    assertEquals(List.of("--level"), FlagSuggestion.of("--map", SERVER));
  }

  @Test
  void nothingIsSuggestedForNonsense() {
    assertEquals(List.of(), FlagSuggestion.of("--xyzzy", SERVER));
    assertEquals(List.of(), FlagSuggestion.of("-", BOTS));
  }

  @Test
  void aProgramNamesTheFlagAloneAndShowsNoHiddenOnes() {
    StringWriter err = new StringWriter();
    CommandLine program = BadFlag.explainedBy(new CommandLine(new Program()));
    assertEquals(2, program.setErr(new PrintWriter(err, true)).execute("--port", "30"));
    assertTrue(err.toString().startsWith("program: unknown flag '--port'"), err.toString());
    assertTrue(err.toString().contains("Possible solutions: --tcp-port"), err.toString());
    assertFalse(err.toString().contains("tests"), err.toString());
  }

  @Test
  void theHelpBeginsWithALineAndListsEachFlagOnce() {
    StringWriter out = new StringWriter();
    CommandLine program = BadFlag.explainedBy(new CommandLine(new Program()));
    program.usage(new PrintWriter(out, true));
    String usage = out.toString();
    assertTrue(usage.startsWith("Usage: program [OPTIONS]" + System.lineSeparator()), usage);
    assertEquals(usage.indexOf("--tcp-port"), usage.lastIndexOf("--tcp-port"), usage);
  }
}
