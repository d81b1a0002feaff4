package carom.server.session;

import carom.net.protocol.PackedLevel;
import carom.sim.level.Level;

/**
 * A level and its file as clients download it. Immutable; any thread. Rooms of the same level share
 * one.
 */
public final class LoadedLevel {
  private final Level level;
  private final int size;
  private final long contentHash;
  private final byte[] packed;

  /** Packs a level's file. */
  public LoadedLevel(Level level) {
    this.level = level;
    byte[] source = level.source();
    size = source.length;
    contentHash = level.contentHash();
    packed = PackedLevel.pack(source);
  }

  /** Returns the level. */
  public Level level() {
    return level;
  }

  /** Returns the size of the level's file, bytes. */
  public int size() {
    return size;
  }

  /** Returns the hash of the level's file. */
  public long contentHash() {
    return contentHash;
  }

  /** Returns the level's file {@linkplain PackedLevel packed}. The live array, never changed. */
  byte[] packed() {
    return packed;
  }

  /** Returns the size of the packed file, bytes. */
  public int packedSize() {
    return packed.length;
  }
}
