package carom.tiled;

import java.util.ArrayList;
import java.util.List;
import java.util.function.IntBinaryOperator;

/** Cells of one kind, merged to few rectangles. */
final class TileRectangles {
  /**
   * A rectangle of cells.
   *
   * @param kind of all its cells
   * @param column of the first cell
   * @param row of the first cell
   * @param width cells
   * @param height cells
   */
  record Rectangle(int kind, int column, int row, int width, int height) {}

  private TileRectangles() {}

  /**
   * Covers all cells but those of kind 0, each once. It goes row by row: a rectangle grows to the
   * right as far as it can, and then down.
   *
   * @param kinds returns the kind of a cell by column and row; 0 for none; negative for one that
   *     doesn't grow down
   */
  static List<Rectangle> cover(
      int firstColumn, int firstRow, int width, int height, IntBinaryOperator kinds) {
    List<Rectangle> found = new ArrayList<>();
    boolean[] taken = new boolean[width * height];
    for (int row = 0; row < height; row++) {
      for (int column = 0; column < width; column++) {
        int kind = kinds.applyAsInt(firstColumn + column, firstRow + row);
        if (kind == 0 || taken[row * width + column]) {
          continue;
        }
        int w = 1;
        while (column + w < width
            && !taken[row * width + column + w]
            && kinds.applyAsInt(firstColumn + column + w, firstRow + row) == kind) {
          w++;
        }
        int h = 1;
        while (kind > 0
            && row + h < height
            && isWhole(firstColumn + column, firstRow + row + h, w, kind, kinds)) {
          h++;
        }
        for (int y = row; y < row + h; y++) {
          for (int x = column; x < column + w; x++) {
            taken[y * width + x] = true;
          }
        }
        found.add(new Rectangle(kind, firstColumn + column, firstRow + row, w, h));
      }
    }
    return found;
  }

  private static boolean isWhole(
      int column, int row, int width, int kind, IntBinaryOperator kinds) {
    for (int x = column; x < column + width; x++) {
      if (kinds.applyAsInt(x, row) != kind) {
        return false;
      }
    }
    return true;
  }
}
