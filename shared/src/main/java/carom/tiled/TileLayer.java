package carom.tiled;

import carom.sim.level.LevelException;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Base64;
import java.util.List;
import java.util.zip.GZIPInputStream;
import java.util.zip.InflaterInputStream;

/** The cells of a tile layer: global ids of tiles with their flips, as Tiled stores them. */
final class TileLayer {
  /** Most cells of a layer, those between the chunks of an infinite map included. */
  static final int MAX_CELLS = 4_194_304;

  private static final int MAX_SIDE = 1 << 20;

  final int column;
  final int row;
  final int width;
  final int height;
  private final int[] cells;

  private TileLayer(int column, int row, int width, int height) {
    this.column = column;
    this.row = row;
    this.width = width;
    this.height = height;
    cells = new int[width * height];
  }

  /** Reads the data of a layer, in one piece or in chunks. */
  static TileLayer of(TiledNode layer) throws LevelException {
    List<TiledNode> chunks = layer.nodes("chunks");
    if (chunks.isEmpty()) {
      chunks = List.of(layer);
    }
    int minX = Integer.MAX_VALUE;
    int minY = Integer.MAX_VALUE;
    int maxX = Integer.MIN_VALUE;
    int maxY = Integer.MIN_VALUE;
    for (TiledNode chunk : chunks) {
      int x = chunk.whole("x", 0, -MAX_SIDE, MAX_SIDE);
      int y = chunk.whole("y", 0, -MAX_SIDE, MAX_SIDE);
      minX = Math.min(minX, x);
      minY = Math.min(minY, y);
      maxX = Math.max(maxX, x + chunk.whole("width", 0, 0, MAX_SIDE));
      maxY = Math.max(maxY, y + chunk.whole("height", 0, 0, MAX_SIDE));
    }
    if ((long) (maxX - minX) * (maxY - minY) > MAX_CELLS) {
      throw layer.wrong(
          "has " + (maxX - minX) + " x " + (maxY - minY) + " cells, the limit is " + MAX_CELLS);
    }
    TileLayer made = new TileLayer(minX, minY, maxX - minX, maxY - minY);
    for (TiledNode chunk : chunks) {
      made.read(chunk, layer);
    }
    return made;
  }

  /** Returns what is in a cell, 0 for nothing and outside. */
  int at(int x, int y) {
    boolean inside = x >= column && y >= row && x - column < width && y - row < height;
    return inside ? cells[(y - row) * width + x - column] : 0;
  }

  private void read(TiledNode chunk, TiledNode layer) throws LevelException {
    int x = chunk.whole("x", 0, -MAX_SIDE, MAX_SIDE) - column;
    int y = chunk.whole("y", 0, -MAX_SIDE, MAX_SIDE) - row;
    int w = chunk.whole("width", 0, 0, MAX_SIDE);
    int h = chunk.whole("height", 0, 0, MAX_SIDE);
    int[] gids = gids(chunk, layer, w * h);
    for (int i = 0; i < h; i++) {
      System.arraycopy(gids, i * w, cells, (y + i) * width + x, w);
    }
  }

  private static int[] gids(TiledNode chunk, TiledNode layer, int count) throws LevelException {
    String encoding = layer.text("encoding", "csv");
    Object data = chunk.fields.get("data");
    if (count == 0) {
      return new int[0];
    }
    if (encoding.equals("base64")) {
      return base64(chunk, chunk.text("data", ""), layer.text("compression", ""), count);
    }
    if (!encoding.equals("csv")) {
      throw layer.wrong("encoding=" + encoding + " isn't read; csv and base64 are");
    }
    int[] gids = new int[count];
    int found = 0;
    if (data instanceof List<?> items) {
      for (Object item : items) {
        gids[found < count ? found : 0] = gid(chunk, String.valueOf(item));
        found++;
      }
    } else {
      String text = chunk.text("data", "").strip();
      for (String item : text.isEmpty() ? new String[0] : text.split(",", -1)) {
        gids[found < count ? found : 0] = gid(chunk, item.strip());
        found++;
      }
    }
    requireCount(chunk, found, count);
    return gids;
  }

  private static void requireCount(TiledNode chunk, long found, int count) throws LevelException {
    if (found != count) {
      throw chunk.wrong("has " + found + " tiles, must have width x height = " + count);
    }
  }

  private static int gid(TiledNode chunk, String text) throws LevelException {
    try {
      double value = Double.parseDouble(text);
      if (value >= 0 && value <= 0xffffffffL && value == Math.rint(value)) {
        return (int) (long) value;
      }
    } catch (NumberFormatException e) {
      // said below
    }
    throw chunk.wrong("a tile isn't a whole number from 0 to 4294967295");
  }

  private static int[] base64(TiledNode chunk, String text, String compression, int count)
      throws LevelException {
    byte[] bytes = new byte[4 * count];
    try {
      byte[] packed = Base64.getMimeDecoder().decode(text.strip());
      try (InputStream in = unpacked(chunk, compression, packed)) {
        int read = in.readNBytes(bytes, 0, bytes.length);
        requireCount(chunk, in.read() < 0 ? read / 4 : count + 1L, count);
      }
    } catch (IOException | IllegalArgumentException e) {
      throw chunk.wrong("its base64 or " + compression + " data is damaged");
    }
    int[] gids = new int[count];
    ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN).asIntBuffer().get(gids);
    return gids;
  }

  private static InputStream unpacked(TiledNode chunk, String compression, byte[] packed)
      throws IOException, LevelException {
    InputStream in = new ByteArrayInputStream(packed);
    return switch (compression) {
      case "" -> in;
      case "zlib" -> new InflaterInputStream(in);
      case "gzip" -> new GZIPInputStream(in);
      default ->
          throw chunk.wrong(
              "compression="
                  + compression
                  + " isn't read; set the map's Tile Layer Format to CSV, zlib or gzip");
    };
  }
}
