package carom.replay;

import carom.game.Games;
import carom.game.GuardedGame;
import carom.sim.Role;
import carom.sim.SimulationHost;
import carom.sim.field.Schema;
import carom.sim.level.Level;
import carom.sim.level.LevelException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Objects;

/**
 * Header of a recording, which suffices to build the simulation at tick 0.
 *
 * @param physicsDigest identifies the arithmetic of the build that recorded, see {@code
 *     carom.net.protocol.Protocol#physicsDigest}
 * @param game name of the game
 * @param levelName file name of the level, for messages
 * @param levelHash content hash of the level, see {@link Level#contentHash}
 * @param level the level file; it is not copied, so don't change it
 * @param seed start of the random numbers
 * @param tickRate ticks per second, 1..1000
 * @param fields declarations of the game's fields, see {@link Schema#lines}
 */
@SuppressWarnings("ArrayRecordComponent") // equals and hashCode compare its content
public record RecordingHeader(
    long physicsDigest,
    String game,
    String levelName,
    long levelHash,
    byte[] level,
    long seed,
    int tickRate,
    List<String> fields) {
  private static final int MAX_NAME_BYTES = 256;
  private static final int MAX_LINE_BYTES = 1 << 16;

  /** Creates a header. The list is copied. */
  public RecordingHeader {
    fields = List.copyOf(fields);
  }

  /** Returns the header for a simulation. */
  public static RecordingHeader of(SimulationHost s, long seed, long physicsDigest) {
    Level level = s.level();
    return new RecordingHeader(
        physicsDigest,
        s.game().name(),
        level.name(),
        level.contentHash(),
        level.source(),
        seed,
        s.tickRate(),
        s.schema().lines());
  }

  /**
   * Builds the recorded game's simulation at tick 0. As on the server that recorded, a failure of
   * the game's code doesn't stop the simulation.
   *
   * @throws RecordingException when this build has no such game, the game has other fields here, or
   *     the level is invalid
   */
  public SimulationHost start() throws RecordingException {
    try {
      Level parsed = Level.parse(levelName, level);
      GuardedGame rules = new GuardedGame(Games.create(game), (callback, s, failure) -> {});
      String difference = SimulationHost.schemaOf(rules, parsed).difference(fields);
      if (difference != null) {
        throw new RecordingException(
            "game " + game + " has other fields than the recording: " + difference);
      }
      return new SimulationHost(rules, parsed, seed, tickRate, Role.AUTHORITY);
    } catch (LevelException | RuntimeException e) {
      throw new RecordingException("the recorded game can't be built: " + e.getMessage());
    }
  }

  void write(ByteSink out) {
    out.i64(physicsDigest);
    out.i64(seed);
    out.varint(tickRate);
    out.text(game);
    out.text(levelName);
    out.i64(levelHash);
    out.varint(level.length);
    out.bytes(level, level.length);
    out.varint(fields.size());
    for (String line : fields) {
      out.text(line);
    }
  }

  static RecordingHeader read(ByteSource in) throws RecordingException {
    long digest = in.i64();
    long seed = in.i64();
    int tickRate = in.varint("tickRate", 1, 1_000);
    String game = in.text("game", MAX_NAME_BYTES);
    String levelName = in.text("level name", MAX_NAME_BYTES);
    long levelHash = in.i64();
    byte[] level = in.bytes(in.varint("level size", 0, Level.MAX_BYTES));
    int count = in.varint("fields", 0, Schema.MAX_FIELDS);
    List<String> fields = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      fields.add(in.text("field", MAX_LINE_BYTES));
    }
    return new RecordingHeader(digest, game, levelName, levelHash, level, seed, tickRate, fields);
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof RecordingHeader h
        && physicsDigest == h.physicsDigest
        && game.equals(h.game)
        && levelName.equals(h.levelName)
        && levelHash == h.levelHash
        && Arrays.equals(level, h.level)
        && seed == h.seed
        && tickRate == h.tickRate
        && fields.equals(h.fields);
  }

  @Override
  public int hashCode() {
    return Objects.hash(physicsDigest, game, levelHash, seed, tickRate, fields);
  }

  @Override
  public String toString() {
    return String.format(
        Locale.ROOT,
        "game=%s level=%s hash=%016x seed=%d tickRate=%d physics=%016x",
        game,
        levelName,
        levelHash,
        seed,
        tickRate,
        physicsDigest);
  }
}
