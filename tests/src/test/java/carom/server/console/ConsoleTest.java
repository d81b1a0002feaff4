package carom.server.console;

import static org.junit.jupiter.api.Assertions.assertEquals;

import carom.server.command.Command;
import carom.server.command.CommandRegistry;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.io.StringReader;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;

/** Goal: lines on a pipe are commands. Method: texts as standard input. */
final class ConsoleTest {
  private static String answers(String input) throws IOException {
    CommandRegistry commands = new CommandRegistry();
    commands.add(new Command("echo", "", "Echoes.", words -> words.rest(0), Command.NONE));
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    Console.read(commands, new StringReader(input), new PrintStream(out, true, "UTF-8"));
    return out.toString(StandardCharsets.UTF_8).replace(System.lineSeparator(), "\n");
  }

  @Test
  void eachLineIsAnsweredAlsoTheLastWithoutItsEnd() throws IOException {
    assertEquals("a b\nc\n", answers("echo a b\r\n\n# nothing\necho c"));
    assertEquals("", answers(""));
  }

  @Test
  void aLineWithoutAnEndCostsNoMemory() throws IOException {
    assertEquals(
        "the line has more than 4096 characters\nx\n",
        answers("echo " + "y".repeat(1_000_000) + "\necho x\n"));
  }
}
