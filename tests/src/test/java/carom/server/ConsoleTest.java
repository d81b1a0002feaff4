package carom.server;

import static org.junit.jupiter.api.Assertions.assertEquals;

import carom.server.command.Command;
import carom.server.command.CommandRegistry;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;

/** Goal: lines on a pipe are commands. Method: texts as standard input. */
final class ConsoleTest {
  private static String answers(String input) throws IOException {
    return answers(input.getBytes(StandardCharsets.UTF_8));
  }

  private static String answers(byte[] input) throws IOException {
    CommandRegistry commands = new CommandRegistry();
    commands.add(new Command("echo", "", "Echoes.", words -> words.rest(0), Command.NONE));
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    Console.read(commands, new ByteArrayInputStream(input), new PrintStream(out, true, "UTF-8"));
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

  @Test
  void linesAreUtf8OrRefused() throws IOException {
    assertEquals("Bj\u00f8rn \u2764\n", answers("echo Bj\u00f8rn \u2764"));
    byte[] latin = "echo Bj\u00f8rn\necho x\n".getBytes(StandardCharsets.ISO_8859_1);
    assertEquals(
        "The line isn't UTF-8, so nothing was done. Set the terminal to UTF-8.\nx\n",
        answers(latin));
  }
}
