package carom.server.match;

import carom.physics.archive.ArchiveException;
import carom.physics.archive.ArchiveReader;
import carom.physics.archive.ArchiveWriter;
import carom.server.config.DataFolder;
import carom.server.session.LoadedLevel;
import carom.sim.SimState;
import carom.sim.SimulationHost;
import carom.sim.level.Level;
import carom.sim.level.LevelException;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.EOFException;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.Locale;
import java.util.zip.CRC32;

/**
 * A match between two ticks, as a file holds it: the game's name, the whole level, and the state of
 * the simulation. A build whose states have the same layout can load it. Immutable.
 */
public final class SavedMatch {
  private static final long MAGIC = 0x4341524f4d534156L; // "CAROMSAV"
  private static final int FORMAT = 1;

  private final String game;
  private final LoadedLevel level;
  private final long seed;

  /** Bytes that {@link carom.sim.SimState#write} wrote; never changed. */
  private final byte[] state;

  private SavedMatch(String game, LoadedLevel level, long seed, byte[] state) {
    this.game = game;
    this.level = level;
    this.seed = seed;
    this.state = state;
  }

  /** Returns the name of the game. */
  public String game() {
    return game;
  }

  /** Returns the level. */
  public LoadedLevel level() {
    return level;
  }

  /** Returns the seed of the match's random numbers. */
  public long seed() {
    return seed;
  }

  /** Copies the state of a match. The room's thread. */
  public static SavedMatch of(MatchInfo match, SimulationHost simulation) {
    ArchiveWriter archive = new ArchiveWriter();
    simulation.save(null).write(archive);
    return new SavedMatch(match.game(), match.level(), match.seed(), archive.toBytes());
  }

  /**
   * Puts a fresh simulation of the same game and level into this state.
   *
   * @throws IllegalArgumentException if the state doesn't fit; the message says why
   */
  public void restore(SimulationHost simulation) {
    try {
      simulation.restore(simulation.read(new ArchiveReader(state)));
    } catch (ArchiveException e) {
      throw new IllegalArgumentException("the saved state doesn't fit: " + e.getMessage(), e);
    }
  }

  /** Writes a file in one step, see {@link DataFolder#replace}. */
  public void write(Path file) throws IOException {
    byte[] body = body();
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (DataOutputStream out = new DataOutputStream(bytes)) {
      out.writeLong(MAGIC);
      out.writeInt(FORMAT);
      out.writeInt(SimState.LAYOUT);
      out.writeLong(checksum(body));
      out.write(body);
    }
    DataFolder.replace(file, bytes.toByteArray());
  }

  private byte[] body() throws IOException {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (DataOutputStream out = new DataOutputStream(bytes)) {
      out.writeUTF(game);
      out.writeLong(seed);
      byte[] source = level.level().source();
      out.writeInt(source.length);
      out.write(source);
      out.write(state);
    }
    return bytes.toByteArray();
  }

  private static long checksum(byte[] body) {
    CRC32 sum = new CRC32();
    sum.update(body);
    return sum.getValue();
  }

  /**
   * Reads a file.
   *
   * @throws IOException if it can't be used; the message says why
   */
  public static SavedMatch read(Path file) throws IOException {
    byte[] bytes;
    try {
      bytes = Files.readAllBytes(file);
    } catch (NoSuchFileException e) {
      throw new IOException("there is no file " + file, e);
    }
    try (DataInputStream in = new DataInputStream(new ByteArrayInputStream(bytes))) {
      if (in.readLong() != MAGIC || in.readInt() != FORMAT) {
        throw new IOException(file + " is no saved match of this version");
      }
      int layout = in.readInt();
      if (layout != SimState.LAYOUT) {
        throw new IOException(
            String.format(
                Locale.ROOT,
                "%s has a state of layout=%d, this build reads %d",
                file,
                layout,
                SimState.LAYOUT));
      }
      long sum = in.readLong();
      byte[] body = in.readAllBytes();
      if (sum != checksum(body)) {
        throw new IOException(file + " is torn or damaged");
      }
      return parse(file, body);
    } catch (EOFException e) {
      throw new IOException(file + " is torn or damaged", e);
    }
  }

  private static SavedMatch parse(Path file, byte[] body) throws IOException {
    try (DataInputStream in = new DataInputStream(new ByteArrayInputStream(body))) {
      String game = in.readUTF();
      long seed = in.readLong();
      byte[] level = in.readNBytes(in.readInt());
      LoadedLevel loaded = new LoadedLevel(Level.parse(String.valueOf(file), level));
      return new SavedMatch(game, loaded, seed, in.readAllBytes());
    } catch (LevelException | IllegalArgumentException e) {
      throw new IOException(file + " has a level that can't be used: " + e.getMessage(), e);
    }
  }
}
