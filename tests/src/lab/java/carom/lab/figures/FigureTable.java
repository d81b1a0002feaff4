package carom.lab.figures;

import carom.lab.measure.Figure;
import java.util.List;

/** Writes figures as Markdown tables: those of the product, then those of the laboratory. */
final class FigureTable {
  private FigureTable() {}

  static String of(List<Figure> figures) {
    List<Figure> product = figures.stream().filter(f -> !isLab(f)).toList();
    List<Figure> lab = figures.stream().filter(FigureTable::isLab).toList();
    String first = product.isEmpty() ? "" : table("what", product);
    String gap = product.isEmpty() || lab.isEmpty() ? "" : "\n";
    return first + gap + (lab.isEmpty() ? "" : table("laboratory: in no server or client", lab));
  }

  private static boolean isLab(Figure figure) {
    return figure.job().equals(FigureJob.LAB_CODEC);
  }

  private static String table(String title, List<Figure> figures) {
    StringBuilder table = new StringBuilder();
    table.append("| " + title + " | reach | measured | | note |\n");
    table.append("| --- | --- | --- | --- | --- |\n");
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
