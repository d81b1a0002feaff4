package carom.server;

import carom.server.command.Caller;
import carom.server.command.CommandRegistry;
import carom.server.command.Quoting;
import ch.qos.logback.classic.AsyncAppender;
import ch.qos.logback.classic.Logger;
import ch.qos.logback.classic.LoggerContext;
import ch.qos.logback.classic.encoder.PatternLayoutEncoder;
import ch.qos.logback.classic.spi.ILoggingEvent;
import ch.qos.logback.core.AppenderBase;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.jline.reader.Candidate;
import org.jline.reader.CompletingParsedLine;
import org.jline.reader.EndOfFileException;
import org.jline.reader.LineReader;
import org.jline.reader.LineReaderBuilder;
import org.jline.reader.ParsedLine;
import org.jline.reader.Parser;
import org.jline.reader.UserInterruptException;
import org.jline.terminal.Terminal;
import org.jline.terminal.TerminalBuilder;
import org.jline.terminal.spi.SystemStream;
import org.jline.terminal.spi.TerminalExt;
import org.slf4j.LoggerFactory;

/** A prompt on a terminal: editing, history, completion, and the log above it. */
final class TerminalPrompt implements AutoCloseable {
  private static final String PROMPT = "> ";
  private static final int MAX_HISTORY = 500;

  /** Exit code after Ctrl-C, as is usual in shells. */
  private static final int INTERRUPTED = 130;

  /** Name of the queue through which the log goes to standard error. */
  private static final String LOG_QUEUE = "QUEUE";

  private final CommandRegistry commands;
  private final Terminal terminal;
  private final LineReader reader;

  private TerminalPrompt(CommandRegistry commands, Terminal terminal, Path history) {
    this.commands = commands;
    this.terminal = terminal;
    this.reader =
        LineReaderBuilder.builder()
            .appName("carom")
            .terminal(terminal)
            .parser(TerminalPrompt::parse)
            .completer((ignored, line, candidates) -> complete(line, candidates))
            .variable(LineReader.HISTORY_FILE, history)
            .variable(LineReader.HISTORY_FILE_SIZE, MAX_HISTORY)
            .option(LineReader.Option.DISABLE_EVENT_EXPANSION, true) // "!" is a usual character
            .build();
  }

  /** Returns a prompt, or null if standard input or output is no terminal. */
  static TerminalPrompt open(CommandRegistry commands, Path history) {
    if (System.console() == null) {
      return null;
    }
    try {
      Terminal terminal =
          TerminalBuilder.builder()
              .system(true)
              .dumb(false)
              .encoding(StandardCharsets.UTF_8)
              .build();
      return new TerminalPrompt(commands, terminal, history);
    } catch (IOException | IllegalStateException e) {
      return null; // such as TERM=dumb
    }
  }

  /** Reads and carries out lines until the process ends. */
  void run() {
    showLogAbove();
    while (true) {
      try {
        CommandRegistry.Answer answer = commands.run(reader.readLine(PROMPT), Caller.CONSOLE);
        if (!answer.text().isEmpty()) {
          terminal.writer().println(answer.text());
          terminal.flush();
        }
      } catch (UserInterruptException e) {
        System.exit(INTERRUPTED);
      } catch (EndOfFileException e) {
        terminal.writer().println("'stop' stops the server.");
      }
    }
  }

  /** Takes a line apart as the registry does, for completion and to see when it is whole. */
  private static ParsedLine parse(String line, int cursor, Parser.ParseContext context) {
    List<Quoting.Word> words = new ArrayList<>(Quoting.begunWords(line.substring(0, cursor)));
    boolean begun =
        !words.isEmpty() && (words.get(words.size() - 1).isOpen() || !endsWithSpace(line, cursor));
    if (!begun) {
      words.add(new Quoting.Word("", false, cursor, false));
    }
    Quoting.Word last = words.get(words.size() - 1);
    List<String> texts = words.stream().map(Quoting.Word::text).toList();
    return new BegunLine(line, cursor, texts, cursor - last.begin());
  }

  private static boolean endsWithSpace(String line, int cursor) {
    return cursor == 0 || Character.isWhitespace(line.charAt(cursor - 1));
  }

  /** A line up to the cursor, whose last word is being written. */
  private record BegunLine(String line, int cursor, List<String> words, int rawWordCursor)
      implements CompletingParsedLine {
    @Override
    public String word() {
      return words.get(wordIndex());
    }

    @Override
    public int wordCursor() {
      return word().length();
    }

    @Override
    public int wordIndex() {
      return words.size() - 1;
    }

    @Override
    public int rawWordLength() {
      return rawWordCursor;
    }

    @Override
    public CharSequence escape(CharSequence candidate, boolean complete) {
      return Quoting.shown(candidate.toString());
    }
  }

  private void complete(ParsedLine line, List<Candidate> candidates) {
    List<String> before = line.words().subList(0, line.wordIndex());
    commands.complete(before, Caller.CONSOLE).forEach(word -> candidates.add(new Candidate(word)));
  }

  /** Prints log lines above the prompt instead of across it. */
  private void showLogAbove() {
    LoggerContext logging = (LoggerContext) LoggerFactory.getILoggerFactory();
    Logger root = logging.getLogger(Logger.ROOT_LOGGER_NAME);
    boolean onTerminal = ((TerminalExt) terminal).getProvider().isSystemStream(SystemStream.Error);
    if (!onTerminal || !(root.getAppender(LOG_QUEUE) instanceof AsyncAppender queue)) {
      return; // it goes to a file, or the operator has configured the log
    }
    PatternLayoutEncoder encoder = new PatternLayoutEncoder();
    encoder.setContext(logging);
    encoder.setCharset(StandardCharsets.UTF_8);
    encoder.setPattern(LogFiles.PATTERN);
    encoder.start();
    AppenderBase<ILoggingEvent> above =
        new AppenderBase<>() {
          @Override
          protected void append(ILoggingEvent event) {
            reader.printAbove(new String(encoder.encode(event), StandardCharsets.UTF_8));
          }
        };
    above.setContext(logging);
    above.setName("ABOVE-PROMPT");
    above.start();
    AsyncAppender prompted = new AsyncAppender();
    prompted.setContext(logging);
    prompted.setName(LOG_QUEUE);
    prompted.setNeverBlock(true);
    prompted.setDiscardingThreshold(0);
    prompted.setQueueSize(queue.getQueueSize());
    prompted.addAppender(above);
    prompted.start();
    root.detachAppender(queue);
    root.addAppender(prompted);
    queue.stop(); // writes the lines that are still queued
  }

  @Override
  public void close() {
    try {
      reader.getHistory().save();
      terminal.close();
    } catch (IOException e) {
      LoggerFactory.getLogger(TerminalPrompt.class).debug("the terminal: {}", e.toString());
    }
  }
}
