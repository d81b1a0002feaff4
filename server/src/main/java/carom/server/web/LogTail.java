package carom.server.web;

import ch.qos.logback.classic.Logger;
import ch.qos.logback.classic.LoggerContext;
import ch.qos.logback.classic.spi.ILoggingEvent;
import ch.qos.logback.classic.spi.IThrowableProxy;
import ch.qos.logback.core.AppenderBase;
import java.time.Instant;
import java.time.LocalTime;
import java.time.ZoneId;
import java.time.format.DateTimeFormatter;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/** The last {@value #LINES} lines of the log, for people who watch the server. Any thread. */
public final class LogTail extends AppenderBase<ILoggingEvent> {
  /** Most lines that are kept. */
  public static final int LINES = 500;

  private static final int MAX_LENGTH = 1_000;
  private static final DateTimeFormatter TIME =
      DateTimeFormatter.ofPattern("HH:mm:ss", Locale.ROOT);

  private final ArrayDeque<Line> lines = new ArrayDeque<>();
  private long next = 1;

  /**
   * A line of the log.
   *
   * @param number larger by one than that of the line before
   * @param time local time, hh:mm:ss
   * @param level such as {@code WARN}
   * @param text what it says; may hold anything that players wrote
   */
  public record Line(long number, String time, String level, String text) {}

  private LogTail() {}

  /** Begins to keep what is logged. */
  public static LogTail begin(LoggerContext logging) {
    LogTail tail = new LogTail();
    tail.setContext(logging);
    tail.setName("TAIL");
    tail.start();
    logging.getLogger(Logger.ROOT_LOGGER_NAME).addAppender(tail);
    return tail;
  }

  @Override
  protected void append(ILoggingEvent event) {
    IThrowableProxy error = event.getThrowableProxy();
    String text = event.getFormattedMessage();
    if (error != null) {
      text += " (" + error.getClassName() + ": " + error.getMessage() + ")";
    }
    String time =
        LocalTime.ofInstant(Instant.ofEpochMilli(event.getTimeStamp()), ZoneId.systemDefault())
            .format(TIME);
    String shown = text.length() <= MAX_LENGTH ? text : text.substring(0, MAX_LENGTH) + " ...";
    synchronized (lines) {
      lines.add(new Line(next++, time, event.getLevel().toString(), shown));
      if (lines.size() > LINES) {
        lines.remove();
      }
    }
  }

  /** Returns the lines with a number above one, 0 for all, oldest first. */
  public List<Line> after(long number) {
    synchronized (lines) {
      if (number >= next - 1) {
        return List.of();
      }
      List<Line> newer = new ArrayList<>();
      lines.forEach(
          line -> {
            if (line.number() > number) {
              newer.add(line);
            }
          });
      return newer;
    }
  }
}
