package carom.net.protocol;

import java.util.Arrays;
import java.util.List;

/**
 * What the server sends reliably and in order. Plain data; the sizes are bounded by {@link Limits}.
 */
public sealed interface ServerMessage {

  /**
   * The client is in: everything it needs to load and to predict.
   *
   * @param sessionSecret proves who the client is when it comes back; never 0
   * @param datagramKey first 32 bits of each input datagram, and the key of the snapshots' check
   * @param playerId 0..255
   * @param tickRate ticks per second, {@link Limits#MIN_TICK_RATE}..{@link Limits#MAX_TICK_RATE}
   * @param tick the server's tick when it sent this
   * @param seed of the simulation
   * @param game name of the game, for {@code Games.create}
   * @param levelName file name of the level, for messages
   * @param levelHash content hash of the level file
   * @param levelSize size of the level file in bytes
   * @param packedSize size of the {@linkplain PackedLevel packed} level file in bytes, which the
   *     chunks are of
   */
  record Welcome(
      long sessionSecret,
      int datagramKey,
      int playerId,
      int tickRate,
      int tick,
      long seed,
      String game,
      String levelName,
      long levelHash,
      int levelSize,
      int packedSize)
      implements ServerMessage {}

  /**
   * A piece of the packed level file, the answer to a {@link ClientMessage.LevelRequest}.
   *
   * @param offset of the first byte in the file
   * @param bytes 1..{@link Limits#MAX_LEVEL_CHUNK_BYTES}, owned by the message
   */
  @SuppressWarnings(
      "ArrayRecordComponent") // bulk data that is copied out at once; equality is by content
  record LevelChunk(int offset, byte[] bytes) implements ServerMessage {
    @Override
    public boolean equals(Object other) {
      return other instanceof LevelChunk chunk
          && chunk.offset == offset
          && Arrays.equals(chunk.bytes, bytes);
    }

    @Override
    public int hashCode() {
      return 31 * offset + Arrays.hashCode(bytes);
    }

    @Override
    public String toString() {
      return "LevelChunk[offset=" + offset + ", bytes=" + bytes.length + "]";
    }
  }

  /**
   * The client is not let in; the link closes.
   *
   * @param reason for the program
   * @param text for the player; details beyond {@link RefusalReason#playerText()}, may be empty
   */
  record Refused(RefusalReason reason, String text) implements ServerMessage {}

  /**
   * Who plays, sent when it changes.
   *
   * @param entries at most {@link Limits#MAX_PLAYERS}, by id; never modified
   */
  record Roster(List<RosterEntry> entries) implements ServerMessage {}

  /**
   * One player of a {@link Roster}.
   *
   * @param playerId 0..255
   * @param name see {@link PlayerName}
   * @param score as the game counts
   */
  record RosterEntry(int playerId, String name, int score) {}

  /**
   * A line for the player's screen.
   *
   * @param text at most {@link Limits#MAX_TEXT_BYTES} in UTF-8
   */
  record Notice(String text) implements ServerMessage {}

  /**
   * A spectator is in.
   *
   * @param delaySeconds how far behind the present it is kept, 1..65,535
   */
  record Watching(int delaySeconds) implements ServerMessage {}

  /**
   * A piece of a recording, the answer to a {@link ClientMessage.RecordingRequest}.
   *
   * @param offset of the first byte in the recording
   * @param bytes at most {@link Limits#MAX_LEVEL_CHUNK_BYTES}, owned by the message; none when
   *     there is nothing behind the offset yet
   */
  @SuppressWarnings("ArrayRecordComponent") // as LevelChunk
  record RecordingChunk(long offset, byte[] bytes) implements ServerMessage {
    @Override
    public boolean equals(Object other) {
      return other instanceof RecordingChunk chunk
          && chunk.offset == offset
          && Arrays.equals(chunk.bytes, bytes);
    }

    @Override
    public int hashCode() {
      return 31 * Long.hashCode(offset) + Arrays.hashCode(bytes);
    }

    @Override
    public String toString() {
      return "RecordingChunk[offset=" + offset + ", bytes=" + bytes.length + "]";
    }
  }

  /**
   * The session ends; the link closes.
   *
   * @param reason for the program
   * @param text for the player; details beyond {@link GoodbyeReason#playerText()}, may be empty
   */
  record Goodbye(GoodbyeReason reason, String text) implements ServerMessage {}
}
