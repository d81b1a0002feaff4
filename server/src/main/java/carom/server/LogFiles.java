package carom.server;

import static java.nio.file.StandardOpenOption.APPEND;
import static java.nio.file.StandardOpenOption.CREATE;

import carom.text.FileErrors;
import ch.qos.logback.classic.AsyncAppender;
import ch.qos.logback.classic.Logger;
import ch.qos.logback.classic.LoggerContext;
import ch.qos.logback.classic.encoder.PatternLayoutEncoder;
import ch.qos.logback.classic.spi.ILoggingEvent;
import ch.qos.logback.core.rolling.FixedWindowRollingPolicy;
import ch.qos.logback.core.rolling.RollingFileAppender;
import ch.qos.logback.core.rolling.SizeBasedTriggeringPolicy;
import ch.qos.logback.core.util.FileSize;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;

/**
 * The log in files: {@code carom.log}, and older ones as {@code carom.1.log} and so on, the newest
 * first. Lines pass through a queue, so no tick waits for the disk; when it is full they are
 * dropped.
 */
public final class LogFiles {
  /** Layout of a line. Control characters, which could come from a client, are left out. */
  static final String PATTERN =
      "%d{yyyy-MM-dd HH:mm:ss.SSS} %-5level %replace(%msg){'[\\p{Cc}\\p{Cf}]', '?'}%n%ex{full}";

  private static final FileSize SIZE = FileSize.valueOf("10MB");
  private static final int QUEUE_LINES = 2_048;

  private LogFiles() {}

  /**
   * Begins to log to a folder, and creates it. Does nothing if no file shall be kept.
   *
   * @param keep number of older files beside the present one; 0 = no file at all
   * @throws IOException if the folder can't be written to; the message says what to do
   */
  public static void begin(LoggerContext logging, Path folder, int keep) throws IOException {
    if (keep == 0) {
      return;
    }
    Path file = folder.resolve("carom.log");
    try {
      Files.createDirectories(folder);
      Files.newOutputStream(file, CREATE, APPEND).close();
    } catch (IOException e) {
      throw new IOException(
          "the log %s can't be written (%s); make it writable, or set --log-keep=0"
              .formatted(file, FileErrors.reason(e)),
          e);
    }
    AsyncAppender queue = new AsyncAppender();
    queue.setContext(logging);
    queue.setName("FILE-QUEUE");
    queue.setQueueSize(QUEUE_LINES);
    queue.setDiscardingThreshold(0);
    queue.setNeverBlock(true);
    queue.addAppender(files(logging, folder, file, keep));
    queue.start();
    logging.getLogger(Logger.ROOT_LOGGER_NAME).addAppender(queue);
  }

  private static RollingFileAppender<ILoggingEvent> files(
      LoggerContext logging, Path folder, Path file, int keep) {
    PatternLayoutEncoder encoder = new PatternLayoutEncoder();
    encoder.setContext(logging);
    encoder.setCharset(StandardCharsets.UTF_8);
    encoder.setPattern(PATTERN);
    encoder.start();
    RollingFileAppender<ILoggingEvent> files = new RollingFileAppender<>();
    files.setFile(file.toString()); // before the policy, which asks for it
    FixedWindowRollingPolicy names = new FixedWindowRollingPolicy();
    names.setContext(logging);
    names.setParent(files);
    names.setFileNamePattern(folder.resolve("carom.%i.log").toString());
    names.setMinIndex(1);
    names.setMaxIndex(keep);
    names.start();
    SizeBasedTriggeringPolicy<ILoggingEvent> limit = new SizeBasedTriggeringPolicy<>();
    limit.setContext(logging);
    limit.setMaxFileSize(SIZE);
    limit.start();
    files.setContext(logging);
    files.setName("FILE");
    files.setEncoder(encoder);
    files.setRollingPolicy(names);
    files.setTriggeringPolicy(limit);
    files.start();
    return files;
  }
}
