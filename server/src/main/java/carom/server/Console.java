package carom.server;

import carom.server.command.Caller;
import carom.server.command.CommandRegistry;
import carom.text.Texts;
import java.io.BufferedInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.PrintStream;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Reads commands from standard input, on a daemon thread of its own. On a terminal there is a
 * prompt with history and completion, and log lines appear above it. On a pipe, each line is a
 * command and its answer goes to standard output. When the input ends, the console ends and the
 * server goes on.
 */
final class Console implements AutoCloseable {
  private static final Logger LOG = LoggerFactory.getLogger(Console.class);

  /** Most bytes of a line that may be one: a character has at most four. */
  private static final int MAX_LINE_BYTES = 4 * CommandRegistry.MAX_LINE;

  private final CommandRegistry commands;
  private final PrintStream out;

  /** The prompt, or null if standard input is no terminal. */
  private final TerminalPrompt prompt;

  private Console(CommandRegistry commands, PrintStream out, TerminalPrompt prompt) {
    this.commands = commands;
    this.out = out;
    this.prompt = prompt;
  }

  /**
   * Begins to read.
   *
   * @param history file that remembers lines over restarts
   */
  public static Console start(CommandRegistry commands, Path history) {
    TerminalPrompt prompt = TerminalPrompt.open(commands, history);
    Console console =
        new Console(commands, new PrintStream(System.out, false, StandardCharsets.UTF_8), prompt);
    Thread thread = new Thread(console::run, "carom-console");
    thread.setDaemon(true);
    thread.start();
    return console;
  }

  private void run() {
    try {
      if (prompt != null) {
        prompt.run();
      } else {
        read(commands, System.in, out);
      }
    } catch (IOException e) {
      LOG.debug("the console ends: {}", e.toString()); // standard input was closed
    }
  }

  /**
   * Carries out line after line until the input ends. Lines are UTF-8 in every locale. One that
   * isn't, or that is too long, is answered and has no effect.
   *
   * @param out receives the answers
   */
  static void read(CommandRegistry commands, InputStream input, PrintStream out)
      throws IOException {
    InputStream bytes = new BufferedInputStream(input);
    ByteArrayOutputStream line = new ByteArrayOutputStream();
    for (int b; (b = bytes.read()) >= 0; ) {
      if (b != '\n') {
        if (line.size() <= MAX_LINE_BYTES) {
          line.write(b);
        }
        continue;
      }
      answer(commands, line, out);
      line.reset();
    }
    answer(commands, line, out);
  }

  private static void answer(
      CommandRegistry commands, ByteArrayOutputStream line, PrintStream out) {
    String text =
        line.size() > MAX_LINE_BYTES
            ? line.toString(StandardCharsets.ISO_8859_1) // which the commands refuse by its length
            : Texts.ofUtf8(ByteBuffer.wrap(line.toByteArray()));
    if (text == null) {
      out.println("The line isn't UTF-8, so nothing was done. Set the terminal to UTF-8.");
      out.flush();
    } else {
      answer(commands, text, out);
    }
  }

  private static void answer(CommandRegistry commands, String line, PrintStream out) {
    CommandRegistry.Answer answer = commands.run(line, Caller.CONSOLE);
    if (!answer.text().isEmpty()) {
      out.println(answer.text());
      out.flush();
    }
  }

  /** Gives the terminal back as it was. */
  @Override
  public void close() {
    if (prompt != null) {
      prompt.close();
    }
  }
}
