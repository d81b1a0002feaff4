package carom.replay;

import carom.game.Games;
import carom.game.GuardedGame;
import carom.sim.Role;
import carom.sim.Simulation;
import carom.sim.level.Level;
import carom.sim.level.LevelException;
import java.util.Arrays;
import java.util.Objects;

/**
 * What a recording begins with: enough to build the simulation at tick 0.
 *
 * @param physicsDigest names the arithmetic of the build that recorded, see {@code
 *     carom.net.protocol.Protocol#physicsDigest}
 * @param game the game's name
 * @param levelName file name of the level, for messages
 * @param levelHash see {@link Level#contentHash}
 * @param level the level file; not copied, don't change it
 * @param seed start of the random numbers
 * @param tickRate ticks per second, 1..1000
 */
@SuppressWarnings("ArrayRecordComponent") // equals and hashCode look into it
public record RecordingHeader(
    long physicsDigest,
    String game,
    String levelName,
    long levelHash,
    byte[] level,
    long seed,
    int tickRate) {
  private static final int MAX_NAME_BYTES = 256;

  /** Of a simulation that stands at tick 0. */
  public static RecordingHeader of(Simulation s, long seed, long physicsDigest) {
    Level level = s.level();
    return new RecordingHeader(
        physicsDigest,
        s.game().name(),
        level.name(),
        level.contentHash(),
        level.source(),
        seed,
        s.tickRate());
  }

  /**
   * Builds the recorded game's simulation at tick 0. Failures of the game stop nothing, as on the
   * server that recorded.
   *
   * @throws RecordingException when this build has no such game, or the level can't be used
   */
  public Simulation start() throws RecordingException {
    try {
      Level parsed = Level.parse(levelName, level);
      GuardedGame rules = new GuardedGame(Games.create(game), (callback, s, failure) -> {});
      return new Simulation(rules, parsed, seed, tickRate, Role.AUTHORITY);
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
  }

  static RecordingHeader read(ByteSource in) throws RecordingException {
    long digest = in.i64();
    long seed = in.i64();
    int tickRate = in.varint("tickRate", 1, 1_000);
    String game = in.text("game", MAX_NAME_BYTES);
    String levelName = in.text("level name", MAX_NAME_BYTES);
    long levelHash = in.i64();
    byte[] level = in.bytes(in.varint("level size", 0, Level.MAX_BYTES));
    return new RecordingHeader(digest, game, levelName, levelHash, level, seed, tickRate);
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
        && tickRate == h.tickRate;
  }

  @Override
  public int hashCode() {
    return Objects.hash(physicsDigest, game, levelHash, seed, tickRate);
  }

  @Override
  public String toString() {
    return String.format(
        "game=%s level=%s hash=%016x seed=%d tickRate=%d physics=%016x",
        game, levelName, levelHash, seed, tickRate, physicsDigest);
  }
}
