package carom.lab.bench;

import carom.lab.measure.BenchRow;
import carom.lab.measure.Scaling;
import carom.physics.profile.StepStage;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;

/**
 * Writes results as tables for people, for a terminal or in Markdown: the rows, with those of the
 * laboratory apart; the other engines' times as multiples of Carom's; the gain of threads; and the
 * stages of Carom's steps. A figure of a run that doesn't count has an exclamation mark.
 */
final class BenchTable {
  private static final List<String> HEADERS =
      List.of(
          "scene",
          "engine",
          "bodies",
          "median ms",
          "p99 ms",
          "ns/body",
          "x carom",
          "B/step",
          "energy J",
          "max mm",
          "deep",
          "gap mm",
          "hash",
          "fault");

  private static final String LAB_HEADER = "lab (not in the engine)";

  private BenchTable() {}

  /** Returns tables aligned by blanks. */
  static String plain(List<BenchRow> rows) {
    return tables(rows, "", "  ", "");
  }

  /** Returns tables in Markdown. */
  static String markdown(List<BenchRow> rows) {
    return tables(rows, "| ", " | ", " |");
  }

  private static String tables(List<BenchRow> rows, String left, String middle, String right) {
    StringBuilder text = new StringBuilder();
    for (List<List<String>> table :
        List.of(
            results(rows, false), results(rows, true), ratios(rows), scaling(rows), stages(rows))) {
      if (table.size() > 1 || text.length() == 0) {
        text.append(text.length() == 0 ? "" : "\n").append(render(table, left, middle, right));
      }
    }
    return text.toString();
  }

  private static String render(List<List<String>> lines, String left, String middle, String right) {
    List<String> headers = lines.get(0);
    int[] widths = new int[headers.size()];
    for (List<String> line : lines) {
      for (int i = 0; i < widths.length; i++) {
        widths[i] = Math.max(widths[i], line.get(i).length());
      }
    }
    StringBuilder text = new StringBuilder();
    for (List<String> line : lines) {
      StringBuilder row = new StringBuilder(left);
      for (int i = 0; i < widths.length; i++) {
        String pad = " ".repeat(widths[i] - line.get(i).length());
        row.append(i == 0 ? "" : middle);
        row.append(isText(headers.get(i)) ? line.get(i) + pad : pad + line.get(i));
      }
      text.append((row + right).stripTrailing()).append('\n');
      if (line == headers && !left.isEmpty()) {
        text.append('|');
        for (int i = 0; i < widths.length; i++) {
          text.append("-".repeat(widths[i] + 1)).append(isText(headers.get(i)) ? "-|" : ":|");
        }
        text.append('\n');
      }
    }
    return text.toString();
  }

  private static boolean isText(String header) {
    return List.of("scene", "engine", LAB_HEADER, "hash", "fault").contains(header);
  }

  /** Returns the rows; those of methods that no server or client uses form their own table. */
  private static List<List<String>> results(List<BenchRow> rows, boolean lab) {
    List<String> headers = new ArrayList<>(HEADERS);
    headers.set(1, lab ? LAB_HEADER : headers.get(1));
    List<List<String>> lines = new ArrayList<>();
    lines.add(headers);
    Map<String, BenchRow> firsts = firsts(rows);
    for (BenchRow row : rows) {
      if (row.entrant().isLab() != lab) {
        continue;
      }
      lines.add(row.isMeasured() ? cells(row, firsts.get(row.scene())) : empty(row));
    }
    return lines;
  }

  private static List<String> empty(BenchRow row) {
    List<String> cells = new ArrayList<>(List.of(row.scene(), row.entrant().toString()));
    while (cells.size() < HEADERS.size() - 1) {
      cells.add("");
    }
    cells.add(row.fault());
    return cells;
  }

  private static List<String> cells(BenchRow row, BenchRow first) {
    return List.of(
        row.scene(),
        row.entrant().toString(),
        Integer.toString(row.bodies()),
        number("%.3f", row.medianMs()) + mark(row),
        number("%.3f", row.times().p99Ms()) + mark(row),
        number("%.0f", row.medianMs() * 1e6 / row.bodies()) + mark(row),
        number("%.2f", row.medianMs() / first.medianMs()) + mark(row),
        number("%.0f", row.times().allocatedBytes()),
        number("%.1f", row.kineticEnergy()),
        number("%.1f", row.maxPenetration() * 1e3),
        number("%.0f", row.deepPairs()),
        row.joints() == 0 ? "" : number("%.1f", row.jointGap() * 1e3),
        row.hash(),
        row.fault());
  }

  private static String mark(BenchRow row) {
    return row.counts() ? "" : "!";
  }

  /** Returns a line per scene: the first row's time, and the other rows beside it. */
  private static List<List<String>> ratios(List<BenchRow> rows) {
    Map<String, BenchRow> firsts = firsts(rows);
    Set<String> others = new LinkedHashSet<>();
    for (BenchRow row : rows) {
      if (row.joints() > 0 || !Double.isNaN(row.kineticEnergy())) {
        others.add(row.entrant().toString());
      }
    }
    firsts.values().stream().limit(1).forEach(first -> others.remove(first.entrant().toString()));
    List<String> header = new ArrayList<>(List.of("scene", "ms"));
    header.addAll(others);
    List<List<String>> lines = new ArrayList<>(List.of(header));
    for (BenchRow first : firsts.values()) {
      if (Double.isNaN(first.kineticEnergy())) {
        continue;
      }
      List<String> line = new ArrayList<>();
      line.add(first.scene());
      line.add(number("%.3f", first.medianMs()) + mark(first));
      for (String other : others) {
        String cell = "";
        for (BenchRow row : rows) {
          if (row.scene().equals(first.scene()) && row.entrant().toString().equals(other)) {
            cell = number("%.2f", row.medianMs() / first.medianMs()) + mark(row);
          }
        }
        line.add(cell);
      }
      lines.add(line);
    }
    return others.isEmpty() ? List.of(header) : lines;
  }

  /** Returns, for each scene, the row that others are compared with: the first with figures. */
  private static Map<String, BenchRow> firsts(List<BenchRow> rows) {
    Map<String, BenchRow> firsts = new LinkedHashMap<>();
    for (BenchRow row : rows) {
      if (row.isMeasured()) {
        firsts.putIfAbsent(row.scene(), row);
      }
    }
    return firsts;
  }

  /** Returns the gain of several threads beside its ceiling, for rows that have both. */
  private static List<List<String>> scaling(List<BenchRow> rows) {
    List<List<String>> lines = new ArrayList<>();
    lines.add(List.of("scene", "engine", "speed-up", "ceiling", "share"));
    for (BenchRow row : rows) {
      Scaling scaling = row.scaling();
      if (scaling.isMeasured()) {
        lines.add(
            List.of(
                row.scene(),
                row.entrant().toString(),
                number("%.2f", scaling.speedUp()) + mark(row),
                number("%.2f", scaling.ceiling()) + mark(row),
                number("%.2f", scaling.share()) + mark(row)));
      }
    }
    return lines;
  }

  /** Returns the time of each stage, ms, for rows that have it. */
  private static List<List<String>> stages(List<BenchRow> rows) {
    List<String> header = new ArrayList<>(List.of("scene", "engine"));
    for (StepStage stage : StepStage.values()) {
      if (rows.stream().anyMatch(row -> row.stages().containsKey(stage.toString()))) {
        header.add(stage.toString());
      }
    }
    List<List<String>> lines = new ArrayList<>(List.of(header));
    for (BenchRow row : rows) {
      if (row.stages().isEmpty()) {
        continue;
      }
      List<String> line = new ArrayList<>(List.of(row.scene(), row.entrant().toString()));
      for (String stage : header.subList(2, header.size())) {
        line.add(number("%.3f", row.stages().getOrDefault(stage, Double.NaN)));
      }
      lines.add(line);
    }
    return lines;
  }

  private static String number(String format, double value) {
    return Double.isNaN(value) ? "" : String.format(Locale.ROOT, format, value);
  }
}
