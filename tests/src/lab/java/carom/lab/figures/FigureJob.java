package carom.lab.figures;

import carom.lab.figures.wire.BroadcastFigures;
import carom.lab.figures.wire.BudgetFigures;
import carom.lab.figures.wire.EncodeFigures;
import carom.lab.figures.wire.SnapshotFigures;
import carom.lab.figures.wire.TraceFigures;
import carom.lab.measure.Figure;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** A job that measures some figures in its own process. */
@FunctionalInterface
interface FigureJob {
  /** All jobs by name, in the order of the table. */
  Map<String, FigureJob> ALL = all();

  /**
   * The job that only runs on request, because its two processes use the whole machine for a
   * minute.
   */
  String CROWD = "crowd";

  /** The job that measures a codec of the laboratory, which no server or client uses. */
  String LAB_CODEC = "codec";

  /**
   * Measures the figures.
   *
   * @param quick whether a rough result in a few seconds is enough
   */
  List<Figure> measure(boolean quick) throws Exception;

  private static Map<String, FigureJob> all() {
    Map<String, FigureJob> jobs = new LinkedHashMap<>();
    jobs.put("snapshots", SnapshotFigures::measure);
    jobs.put("naive", BroadcastFigures::measure);
    jobs.put("budget", BudgetFigures::measure);
    jobs.put("perfect", PredictionFigures::perfect);
    jobs.put("alone", PredictionFigures::alone);
    jobs.put("push", PredictionFigures::push);
    jobs.put("forces", ForceFigures::measure);
    jobs.put("rocket", RocketFigures::measure);
    jobs.put("machines", MachineFigures::measure);
    jobs.put("feel", FeelFigures::measure);
    jobs.put("rollback", RollbackFigures::measure);
    jobs.put("encode", EncodeFigures::measure);
    jobs.put("rest", RestFigures::measure);
    jobs.put("entry", EntryFigures::measure);
    jobs.put("crowd", CrowdFigures::measure);
    jobs.put(LAB_CODEC, TraceFigures::measure);
    return jobs;
  }
}
