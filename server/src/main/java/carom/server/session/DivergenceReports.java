package carom.server.session;

import carom.net.protocol.ClientMessage.Diverged;
import carom.server.metrics.Counter;
import carom.server.metrics.Counters;
import carom.server.metrics.LogInterval;
import carom.server.prediction.PredictionAudit.Finding;
import carom.server.replication.SessionReplication;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Judges what one client reports of its mispredictions: counts the reports, and logs now and then
 * one that nothing explains.
 *
 * <p>A report and the inputs before it travel on their own. An input that a client said would go on
 * counts as missing until it has arrived, so a report that came first would be blamed on it. That
 * is why a report waits for the inputs of its tick. One waits at a time; another one ends the wait.
 *
 * <p>The room's thread.
 */
final class DivergenceReports {
  /** Ticks that a report waits for inputs at most; what the audit remembers is longer. */
  private static final int MOST_TICKS = 20;

  private static final Logger LOG = LoggerFactory.getLogger(DivergenceReports.class);

  private final Session session;
  private final Counters counters;
  private final LogInterval lines = new LogInterval();
  private Diverged waiting;
  private int waitedTicks;
  private String firstUnexplained;

  DivergenceReports(Session session, Counters counters) {
    this.session = session;
    this.counters = counters;
  }

  /** Counts a report, which is judged later. */
  void receive(Diverged report, SessionReplication replication, long nowNs) {
    counters.add(Counter.DIVERGENCES_REPORTED, 1);
    if (waiting != null) {
      judge(replication, nowNs);
    }
    waiting = report;
    waitedTicks = 0;
  }

  /**
   * Judges the report that waits, if it has waited enough; call once per tick.
   *
   * @param newestInputTick the last tick whose input has arrived
   */
  void tick(int newestInputTick, SessionReplication replication, long nowNs) {
    if (waiting != null && (newestInputTick - waiting.tick() >= 0 || ++waitedTicks == MOST_TICKS)) {
      judge(replication, nowNs);
    }
  }

  /** Returns the first report that nothing explained, in words, or null. */
  String firstUnexplained() {
    return firstUnexplained;
  }

  private void judge(SessionReplication replication, long nowNs) {
    Diverged report = waiting;
    waiting = null;
    if (replication.judge(report) != Finding.UNEXPLAINED) {
      return;
    }
    counters.add(Counter.DIVERGENCES_UNEXPLAINED, 1);
    if (firstUnexplained == null) {
      firstUnexplained = "tick " + report.tick() + ":" + replication.describe(report);
    }
    if (lines.tryBegin(nowNs)) {
      LOG.warn(
          report.ofSet()
              ? "diverged: {} predicted tick {} of what is near otherwise, though equal at tick"
                  + " {}:{}"
              : "diverged: {} predicted tick {} otherwise, though equal at tick {} and alone"
                  + " since:{}",
          session,
          report.tick(),
          report.equalTick(),
          replication.describe(report));
    }
  }
}
