package carom.server.console;

import carom.server.command.Caller;
import carom.server.command.CommandRegistry;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.PrintStream;
import java.io.Reader;
import java.nio.charset.Charset;
import java.nio.file.Path;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Reads commands from standard input, on a daemon thread of its own. On a terminal there is a
 * prompt with history and completion, and log lines appear above it. On a pipe, each line is a
 * command and its answer goes to standard output. When the input ends, the console ends and the
 * server goes on.
 */
public final class Console implements AutoCloseable {
  private static final Logger LOG = LoggerFactory.getLogger(Console.class);

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
    Console console = new Console(commands, System.out, prompt);
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
        Charset charset = Charset.defaultCharset();
        read(commands, new InputStreamReader(System.in, charset), out);
      }
    } catch (IOException e) {
      LOG.debug("the console ends: {}", e.toString()); // standard input was closed
    }
  }

  /**
   * Carries out line after line until the input ends. A line that is too long is answered, not
   * kept.
   *
   * @param out receives the answers
   */
  static void read(CommandRegistry commands, Reader input, PrintStream out) throws IOException {
    BufferedReader lines = new BufferedReader(input);
    StringBuilder line = new StringBuilder();
    for (int c; (c = lines.read()) >= 0; ) {
      if (c != '\n') {
        if (line.length() <= CommandRegistry.MAX_LINE) {
          line.append((char) c);
        }
        continue;
      }
      answer(commands, line.toString(), out);
      line.setLength(0);
    }
    answer(commands, line.toString(), out);
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
