package carom.lab.figures;

import java.util.List;

/** Figures as a table in Markdown. */
final class FigureTable {
  private FigureTable() {}

  static String of(List<Figure> figures) {
    StringBuilder table = new StringBuilder();
    table.append("| what | reach | measured | | note |\n| --- | --- | --- | --- | --- |\n");
    for (Figure f : figures) {
      String unit = f.unit().isEmpty() ? "" : " " + f.unit();
      String limit = f.limit().isEmpty() ? "" : f.limit() + unit;
      String measured = Double.isNaN(f.value()) ? "" : Figure.number(f.value()) + unit;
      table.append(
          "| %s | %s | %s | %s | %s |\n"
              .formatted(f.what(), limit, measured, f.verdict(), f.note()));
    }
    return table.toString();
  }
}
