package carom.tiled;

import carom.sim.level.LevelException;
import java.util.Map;
import java.util.TreeMap;

/** A set of tiles: their size, and what was said about single ones. */
final class Tileset {
  private static final int MAX_TILE = 1 << 24;

  final int firstGid;
  final int tileWidth;
  final int tileHeight;
  private final Map<Integer, TiledNode> tiles = new TreeMap<>();

  Tileset(int firstGid, TiledNode node) throws LevelException {
    this.firstGid = firstGid;
    tileWidth = node.whole("tilewidth", 0, 1, 4096);
    tileHeight = node.whole("tileheight", 0, 1, 4096);
    for (TiledNode tile : node.nodes("tiles")) {
      tiles.put(tile.whole("id", 0, 0, MAX_TILE), tile);
    }
  }

  /** Returns what is said about a tile, or null. */
  TiledNode tile(int gid) {
    return tiles.get(gid - firstGid);
  }

  /** Returns what is said about any of its tiles. */
  Iterable<TiledNode> tiles() {
    return tiles.values();
  }
}
