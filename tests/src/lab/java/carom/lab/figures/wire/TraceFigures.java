package carom.lab.figures.wire;

import carom.lab.measure.Figure;
import carom.lab.trace.SceneTrace;
import carom.lab.trace.Trace;
import carom.lab.trace.TraceCodec;
import carom.lab.trace.TraceReport;
import java.util.List;

/**
 * Measures the size of recorded motion by the laboratory's codec, {@code carom-bots codec}, which
 * no server or client uses: baseline 100 ms old, poses only, payload. {@link SnapshotFigures}
 * measures the snapshots that servers send.
 */
public final class TraceFigures {
  private static final String LABEL = "lab: TraceCodec, poses alone, ";

  private TraceFigures() {}

  /** Measures the figures, roughly if {@code quick}. */
  public static List<Figure> measure(boolean quick) {
    Trace above = SceneTrace.of("plough_above", 20);
    Trace side = SceneTrace.of("plough", 20);
    Trace churn = SceneTrace.of("churn", 15);
    return List.of(
        codec("901 bodies ploughed through on a table, 60 Hz", above, 60, 6, 73).withNote("aim 40"),
        codec("901 bodies ploughed through on a table, 30 Hz", above, 30, 3, 37),
        plain("901 bodies ploughed through under gravity, 60 Hz", side, 60, 6),
        plain("901 bodies ploughed through under gravity, 30 Hz", side, 30, 3),
        codec("600 bodies in churning contact, 60 Hz", churn, 60, 6, 708)
            .withNote("naive Kryo objects: 7,750"));
  }

  private static Figure codec(String what, Trace trace, int rate, int lag, double reach) {
    return Figure.atMost(reach, LABEL + what, kbit(trace, rate, lag), "kbit/s");
  }

  private static Figure plain(String what, Trace trace, int rate, int lag) {
    return Figure.shown(LABEL + what, kbit(trace, rate, lag), "kbit/s");
  }

  private static double kbit(Trace trace, int rate, int lag) {
    TraceReport report = TraceReport.of(trace, rate, lag, TraceCodec.POSE);
    if (!report.exact()) {
      throw new IllegalStateException("the decoder gave back something else");
    }
    return report.kbitPerSecond();
  }
}
