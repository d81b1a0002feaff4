package carom.tiled;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.tiled.TileOutlines.Loop;
import carom.tiled.TileOutlines.Point;
import carom.tiled.TileRectangles.Rectangle;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** Merged tiles cover exactly what the single ones do. */
final class TileOutlinesTest {
  private static final int SIDE = 16;

  /** Shapes within a tile: the whole, ramps, half a tile, a thin one. */
  private static final List<List<Point>> SHAPES =
      List.of(
          List.of(p(0, 0), p(SIDE, 0), p(SIDE, SIDE), p(0, SIDE)),
          List.of(p(0, SIDE), p(SIDE, 0), p(SIDE, SIDE)),
          List.of(p(0, 0), p(SIDE, SIDE), p(0, SIDE)),
          List.of(p(0, SIDE), p(SIDE, SIDE), p(SIDE, SIDE / 2)),
          List.of(p(0, SIDE / 2), p(SIDE, SIDE / 2), p(SIDE, SIDE), p(0, SIDE)),
          List.of(p(4, 4), p(12, 5), p(9, 12)),
          List.of(p(0, 0), p(SIDE, 0), p(SIDE, 5), p(5, 5), p(5, SIDE), p(0, SIDE)));

  private static Point p(int x, int y) {
    return new Point(x, y);
  }

  @Test
  void outlinesEncloseWhatTheTilesCover() {
    for (long seed = 1; seed <= 300; seed++) {
      Random random = new Random(seed);
      int width = 1 + random.nextInt(12);
      int height = 1 + random.nextInt(12);
      int kinds = seed % 2 == 0 ? 1 : SHAPES.size();
      TileOutlines outlines = new TileOutlines(SIDE, SIDE);
      List<List<Point>> tiles = new ArrayList<>();
      double full = random.nextDouble();
      for (int row = 0; row < height; row++) {
        for (int column = 0; column < width; column++) {
          if (random.nextDouble() < full) {
            List<Point> tile = new ArrayList<>();
            for (Point p : SHAPES.get(random.nextInt(kinds))) {
              tile.add(p(p.x() + (column - 5) * SIDE, p.y() + (row - 5) * SIDE));
            }
            tiles.add(tile);
            outlines.add(tile, random.nextInt(3));
          }
        }
      }
      List<Loop> loops = outlines.loops();
      long area = 0;
      for (List<Point> tile : tiles) {
        area += Math.abs(TileOutlines.doubleArea(tile));
      }
      long enclosed = 0;
      for (Loop loop : loops) {
        enclosed += TileOutlines.doubleArea(loop.points());
        assertEquals(loop.points().size(), new HashSet<>(loop.points()).size(), "seed " + seed);
        assertEquals(loop.points().size(), loop.materials().size());
      }
      assertEquals(area, enclosed, "seed " + seed);
      for (int i = 0; i < 100; i++) {
        double x = (random.nextDouble() * width - 5) * SIDE;
        double y = (random.nextDouble() * height - 5) * SIDE;
        boolean inTile = tiles.stream().anyMatch(tile -> crossings(tile, x, y) % 2 == 1);
        int crossed = loops.stream().mapToInt(loop -> crossings(loop.points(), x, y)).sum();
        assertEquals(inTile, crossed % 2 == 1, "seed " + seed + " at " + x + ", " + y);
      }
    }
  }

  /** Returns how many edges a ray to the right crosses. */
  private static int crossings(List<Point> corners, double x, double y) {
    int crossed = 0;
    for (int i = 0; i < corners.size(); i++) {
      Point a = corners.get(i);
      Point b = corners.get((i + 1) % corners.size());
      if (a.y() > y != b.y() > y
          && x < a.x() + (y - a.y()) * (b.x() - a.x()) / (double) (b.y() - a.y())) {
        crossed++;
      }
    }
    return crossed;
  }

  @Test
  void aFloorOfManyTilesIsOneLoopOfFourCorners() {
    TileOutlines outlines = new TileOutlines(SIDE, SIDE);
    for (int column = 0; column < 100; column++) {
      List<Point> tile = new ArrayList<>();
      for (Point p : SHAPES.get(0)) {
        tile.add(p(p.x() + column * SIDE, p.y()));
      }
      outlines.add(tile, 0);
    }
    List<Loop> loops = outlines.loops();
    assertEquals(1, loops.size());
    assertEquals(4, loops.get(0).points().size());
  }

  @Test
  void rectanglesCoverEachCellOnce() {
    for (long seed = 1; seed <= 200; seed++) {
      Random random = new Random(seed);
      int width = 1 + random.nextInt(20);
      int height = 1 + random.nextInt(20);
      int[] kinds = new int[width * height];
      for (int i = 0; i < kinds.length; i++) {
        kinds[i] = random.nextInt(4) - 1;
      }
      int[] covered = new int[width * height];
      List<Rectangle> all =
          TileRectangles.cover(3, -2, width, height, (x, y) -> kinds[(y + 2) * width + x - 3]);
      for (Rectangle r : all) {
        assertTrue(r.kind() > 0 || r.height() == 1, "seed " + seed);
        for (int y = r.row() + 2; y < r.row() + 2 + r.height(); y++) {
          for (int x = r.column() - 3; x < r.column() - 3 + r.width(); x++) {
            assertEquals(r.kind(), kinds[y * width + x], "seed " + seed);
            covered[y * width + x]++;
          }
        }
      }
      for (int i = 0; i < kinds.length; i++) {
        assertEquals(kinds[i] == 0 ? 0 : 1, covered[i], "seed " + seed);
      }
    }
  }
}
