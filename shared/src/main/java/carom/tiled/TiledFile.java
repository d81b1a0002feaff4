package carom.tiled;

import carom.sim.level.LevelException;
import carom.text.FileErrors;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.TreeMap;

/** A map with its tilesets, read from files. */
final class TiledFile {
  /** Largest map or tileset, in bytes. */
  static final int MAX_BYTES = 1 << 24;

  private static final int MAX_TILESETS = 256;
  private static final int LOWEST_BITS = 0x0fffffff;

  final String name;
  final TiledNode map;
  private final TreeMap<Integer, Tileset> tilesets = new TreeMap<>();

  TiledFile(Path file) throws LevelException {
    name = String.valueOf(file.getFileName());
    map = read(name, file);
    if (!map.text("orientation", "").equals("orthogonal")) {
      throw map.wrong(
          "orientation="
              + map.text("orientation", "(none)")
              + " isn't read; the map must be one of Tiled with orientation orthogonal");
    }
    List<TiledNode> all = map.nodes("tilesets");
    if (all.size() > MAX_TILESETS) {
      throw map.wrong("has " + all.size() + " tilesets, the limit is " + MAX_TILESETS);
    }
    for (TiledNode node : all) {
      int first = node.whole("firstgid", 0, 1, LOWEST_BITS);
      String source = node.text("source", "");
      tilesets.put(first, new Tileset(first, source.isEmpty() ? node : external(file, source)));
    }
  }

  private TiledNode external(Path file, String source) throws LevelException {
    String ending = source.toLowerCase(Locale.ROOT);
    if (!ending.matches("(?s).*\\.(tsx|tsj|json|xml)")) {
      throw map.wrong("tileset source=" + source + " must be a .tsx or .tsj file");
    }
    try {
      return read(source, file.toAbsolutePath().resolveSibling(source));
    } catch (InvalidPathException e) {
      throw map.wrong("tileset source=" + source + " can't be the name of a file");
    }
  }

  private static TiledNode read(String name, Path file) throws LevelException {
    byte[] bytes;
    try {
      if (!Files.isRegularFile(file)) {
        throw new LevelException(name, 0, 0, "", "there is no such file");
      }
      try (InputStream in = Files.newInputStream(file)) {
        bytes = in.readNBytes(MAX_BYTES + 1);
      }
    } catch (IOException e) {
      throw new LevelException(name, 0, 0, "", "can't read it: " + FileErrors.reason(e));
    }
    if (bytes.length > MAX_BYTES) {
      throw new LevelException(name, 0, 0, "", "it has more than " + MAX_BYTES + " bytes");
    }
    return isXml(bytes) ? XmlTree.read(name, bytes) : JsonTree.read(name, bytes);
  }

  private static boolean isXml(byte[] bytes) {
    int i = 0;
    while (i < bytes.length && (bytes[i] < 0 || Character.isWhitespace(bytes[i]))) {
      i++; // behind a byte order mark
    }
    return i < bytes.length && bytes[i] == '<';
  }

  /** Returns the set that a tile is of, or null; the id is without flips. */
  Tileset tileset(int gid) {
    return tilesets.isEmpty() || tilesets.floorEntry(gid) == null
        ? null
        : tilesets.floorEntry(gid).getValue();
  }

  /** Returns all tilesets. */
  List<Tileset> tilesets() {
    return new ArrayList<>(tilesets.values());
  }
}
