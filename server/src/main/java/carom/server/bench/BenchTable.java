package carom.server.bench;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.Predicate;

/** Results for people: the same columns on a terminal and in Markdown. */
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
  private static final int FIRST_NUMBER = 2;
  private static final int AFTER_NUMBERS = HEADERS.indexOf("hash");

  private BenchTable() {}

  /** Aligned by blanks. */
  static String plain(List<BenchRow> rows) {
    return render(rows, "", "  ", "");
  }

  /** A table as GitHub shows it. */
  static String markdown(List<BenchRow> rows) {
    return render(rows, "| ", " | ", " |");
  }

  private static String render(List<BenchRow> rows, String left, String middle, String right) {
    List<List<String>> lines = new ArrayList<>();
    lines.add(HEADERS);
    for (BenchRow row : rows) {
      lines.add(cells(row, rows));
    }
    int[] widths = new int[HEADERS.size()];
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
        row.append(isNumber(i) ? pad + line.get(i) : line.get(i) + pad);
      }
      text.append((row + right).stripTrailing()).append('\n');
      if (line == HEADERS && !left.isEmpty()) {
        text.append('|');
        for (int i = 0; i < widths.length; i++) {
          text.append("-".repeat(widths[i] + 1)).append(isNumber(i) ? ":|" : "-|");
        }
        text.append('\n');
      }
    }
    return text.toString();
  }

  private static boolean isNumber(int column) {
    return column >= FIRST_NUMBER && column < AFTER_NUMBERS;
  }

  private static List<String> cells(BenchRow row, List<BenchRow> all) {
    if (!row.isMeasured()) {
      List<String> cells = new ArrayList<>(List.of(row.scene(), row.who()));
      while (cells.size() < HEADERS.size() - 1) {
        cells.add("");
      }
      cells.add(row.fault());
      return cells;
    }
    return List.of(
        row.scene(),
        row.who(),
        Integer.toString(row.bodies()),
        number("%.3f", row.medianMs()),
        number("%.3f", row.p99Ms()),
        number("%.0f", row.medianMs() * 1e6 / row.bodies()),
        number("%.2f", row.medianMs() / reference(row, all)),
        number("%.0f", row.allocatedBytesPerStep()),
        number("%.1f", row.kineticEnergy()),
        number("%.1f", row.maxPenetration() * 1e3),
        Double.isNaN(row.maxPenetration()) ? "" : Integer.toString(row.deepPairs()),
        row.joints() == 0 ? "" : number("%.1f", row.jointGap() * 1e3),
        row.hash(),
        row.fault());
  }

  /** Carom's time for the scene, with vectors if it was measured so. */
  private static double reference(BenchRow row, List<BenchRow> all) {
    Predicate<BenchRow> carom =
        r -> r.scene().equals(row.scene()) && r.engine().equals(CaromEngine.NAME);
    return all.stream()
        .filter(carom.and(BenchRow::isMeasured))
        .findFirst()
        .map(BenchRow::medianMs)
        .orElse(Double.NaN);
  }

  private static String number(String format, double value) {
    return Double.isNaN(value) ? "" : String.format(Locale.ROOT, format, value);
  }
}
