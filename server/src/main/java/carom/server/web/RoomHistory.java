package carom.server.web;

import carom.server.metrics.Counter;
import carom.server.metrics.Counters;
import carom.server.metrics.TurnStage;
import carom.server.room.Room;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/** Figures of a room, one row a second, for the last {@value #ROWS} seconds. One thread. */
final class RoomHistory {
  /** Rows that are kept. */
  static final int ROWS = 300;

  private static final double NS_PER_MS = 1e6;
  private static final double BITS_PER_KBIT = 125;
  private static final double BYTES_PER_MB = 1 << 20;
  private static final TurnStage[] STAGES = TurnStage.values();
  private static final Counter[] GAUGES = {
    Counter.PLAYERS,
    Counter.PLAYERS_IN_GRACE,
    Counter.SPECTATORS,
    Counter.LOAD_PERCENT,
    Counter.PACE_PERCENT
  };

  /** Counters whose growth in the second is shown. */
  private static final Counter[] COUNTED = {
    Counter.TICKS_LATE,
    Counter.TICKS_DROPPED,
    Counter.SNAPSHOTS_POSTPONED,
    Counter.INPUTS_DUE,
    Counter.INPUTS_MISSING,
    Counter.NEAR_DISAGREEMENTS,
    Counter.DIVERGENCES_UNEXPLAINED,
    Counter.GAME_FAILURES
  };

  /** Names of the values of a row. */
  private static final List<String> COLUMNS = columns();

  private final Room room;
  private final Counters.TickReader tickTimes;
  private final long[] before = new long[Counter.values().length];
  private final long[] stagesBefore = new long[STAGES.length];
  private final ArrayDeque<float[]> rows = new ArrayDeque<>();
  private long cpuNsBefore;

  RoomHistory(Room room, ProcessFigures begin) {
    this.room = room;
    cpuNsBefore = begin.cpuNs();
    tickTimes = room.counters().tickReader();
    for (Counter counter : Counter.values()) {
      before[counter.ordinal()] = room.counters().get(counter);
    }
    for (TurnStage stage : STAGES) {
      stagesBefore[stage.ordinal()] = room.stages().totalNs(stage);
    }
  }

  /** Returns the names of the values of a row. */
  static List<String> columns() {
    List<String> names =
        new ArrayList<>(
            List.of(
                "heapMb",
                "residentMb",
                "cpuPercent",
                "ticks",
                "p50",
                "p99",
                "max",
                "narrowPercent",
                "inKbit",
                "outKbit"));
    for (TurnStage stage : STAGES) {
      names.add(stage.name().toLowerCase(Locale.ROOT));
    }
    for (Counter gauge : GAUGES) {
      names.add(gauge.name().toLowerCase(Locale.ROOT));
    }
    for (Counter counter : COUNTED) {
      names.add(counter.name().toLowerCase(Locale.ROOT));
    }
    return names;
  }

  /**
   * Adds the row of the second that ends now.
   *
   * @param seconds its length
   * @param process the process at its end
   */
  void sample(double seconds, ProcessFigures process) {
    Counters counters = room.counters();
    Counters.TickTimes times = tickTimes.take();
    long ticks = Math.max(1, times.count());
    float[] row = new float[COLUMNS.size()];
    int at = 0;
    row[at++] = (float) (process.heapBytes() / BYTES_PER_MB);
    row[at++] = (float) (process.residentBytes() / BYTES_PER_MB);
    row[at++] = (float) ((process.cpuNs() - cpuNsBefore) / NS_PER_MS / 10 / seconds);
    cpuNsBefore = process.cpuNs();
    row[at++] = (float) (times.count() / seconds);
    row[at++] = (float) (times.p50Ns() / NS_PER_MS);
    row[at++] = (float) (times.p99Ns() / NS_PER_MS);
    row[at++] = (float) (times.maxNs() / NS_PER_MS);
    row[at++] = 100f * grown(counters, Counter.TICKS_NARROW) / ticks;
    row[at++] = (float) (grown(counters, Counter.BYTES_IN) / BITS_PER_KBIT / seconds);
    row[at++] = (float) (grown(counters, Counter.SNAPSHOT_BYTES) / BITS_PER_KBIT / seconds);
    for (TurnStage stage : STAGES) {
      long total = room.stages().totalNs(stage);
      row[at++] = (float) ((total - stagesBefore[stage.ordinal()]) / NS_PER_MS / ticks);
      stagesBefore[stage.ordinal()] = total;
    }
    for (Counter gauge : GAUGES) {
      row[at++] = counters.get(gauge);
    }
    for (Counter counter : COUNTED) {
      row[at++] = grown(counters, counter);
    }
    rows.add(row);
    if (rows.size() > ROWS) {
      rows.remove();
    }
  }

  private long grown(Counters counters, Counter counter) {
    long now = counters.get(counter);
    long grown = now - before[counter.ordinal()];
    before[counter.ordinal()] = now;
    return grown;
  }

  Room room() {
    return room;
  }

  /** Returns the last rows, so many at most, the oldest first. */
  List<float[]> latest(int most) {
    return rows.stream().skip(Math.max(0, rows.size() - most)).toList();
  }

  /** Returns the last row, or null before the first. */
  float[] last() {
    return rows.peekLast();
  }
}
