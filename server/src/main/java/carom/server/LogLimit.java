package carom.server;

import ch.qos.logback.classic.Level;
import ch.qos.logback.classic.Logger;
import ch.qos.logback.classic.LoggerContext;
import ch.qos.logback.classic.turbo.TurboFilter;
import ch.qos.logback.core.spi.FilterReply;
import java.util.HashMap;
import java.util.Map;
import java.util.function.LongSupplier;
import org.slf4j.Marker;
import org.slf4j.helpers.MessageFormatter;

/**
 * Bounds the lines that one cause writes to the log, no matter which client triggers it: {@value
 * #BURST} at once, then {@value #PER_SECOND} a second. A cause is the text of a log call before its
 * values are put in. What is held back is counted, and the count is logged with a later line that
 * shows the first of them. Any thread.
 */
final class LogLimit extends TurboFilter {
  static final int BURST = 100;
  static final int PER_SECOND = 2;

  private static final String HELD_BACK = "held back: {} more of: {}";
  private static final int MAX_CAUSES = 1_024;
  private static final long NS_PER_S = 1_000_000_000L;

  /** Time after its last line at which a cause's count is logged, ns. */
  private static final long REPORT_NS = NS_PER_S;

  /** The lines of one cause. */
  private static final class Cause {
    private double left = BURST;
    private long sinceNs;
    private long held;

    /** Text of the first line that is held back and not yet counted in the log. */
    private String example;

    private long lastReportNs;
  }

  private final Map<String, Cause> causes = new HashMap<>();
  private final LongSupplier clock;
  private boolean holds;

  /** Creates a limit that has counted nothing; {@code clock} is monotonic, in nanoseconds. */
  LogLimit(LongSupplier clock) {
    this.clock = clock;
  }

  /** Limits what a process logs from now on. */
  public static void begin(LoggerContext logging) {
    LogLimit limit = new LogLimit(System::nanoTime);
    limit.setContext(logging);
    limit.start();
    logging.addTurboFilter(limit);
  }

  @Override
  public FilterReply decide(
      Marker marker, Logger logger, Level level, String format, Object[] values, Throwable error) {
    if (format == null
        || format.equals(HELD_BACK)
        || !level.isGreaterOrEqual(logger.getEffectiveLevel())) {
      return FilterReply.NEUTRAL;
    }
    Map<String, Long> reports;
    boolean passes;
    synchronized (causes) {
      long now = clock.getAsLong();
      passes = take(format, values, now);
      reports = holds ? takeReports(now) : Map.of();
    }
    reports.forEach((example, held) -> logger.warn(HELD_BACK, held, example));
    return passes ? FilterReply.NEUTRAL : FilterReply.DENY;
  }

  private boolean take(String format, Object[] values, long now) {
    if (causes.size() >= MAX_CAUSES && !causes.containsKey(format)) {
      causes.values().removeIf(cause -> cause.held == 0);
      if (causes.size() >= MAX_CAUSES) {
        return true;
      }
    }
    Cause cause = causes.computeIfAbsent(format, text -> new Cause());
    double earned = (double) (now - cause.sinceNs) / NS_PER_S * PER_SECOND;
    cause.left = Math.min(BURST, cause.left + Math.max(0, earned));
    cause.sinceNs = now;
    if (cause.left >= 1) {
      cause.left--;
      return true;
    }
    if (cause.held == 0) {
      cause.lastReportNs = now;
      cause.example = MessageFormatter.arrayFormat(format, values).getMessage();
    }
    cause.held++;
    holds = true;
    return false;
  }

  private Map<String, Long> takeReports(long now) {
    Map<String, Long> reports = new HashMap<>();
    holds = false;
    for (Cause cause : causes.values()) {
      if (cause.held > 0 && now - cause.lastReportNs >= REPORT_NS) {
        reports.merge(cause.example, cause.held, Long::sum);
        cause.held = 0;
        cause.example = null;
      }
      holds |= cause.held > 0;
    }
    return reports;
  }
}
