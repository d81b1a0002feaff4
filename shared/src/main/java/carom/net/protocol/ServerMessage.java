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
   * @param playerId 0..1,023
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
   * Who plays: what has changed since the one before on the same link, the first one everybody.
   *
   * @param entries at most {@link Limits#MAX_ROSTER_ENTRIES}, by id; never modified
   */
  record Roster(List<RosterEntry> entries) implements ServerMessage {
    /**
     * Takes the changes over.
     *
     * @param players who plays, by id
     */
    public void applyTo(List<RosterEntry> players) {
      for (RosterEntry entry : entries) {
        int at = 0;
        int end = players.size();
        while (at < end) {
          int middle = (at + end) >>> 1;
          if (players.get(middle).playerId() < entry.playerId()) {
            at = middle + 1;
          } else {
            end = middle;
          }
        }
        boolean known = at < players.size() && players.get(at).playerId() == entry.playerId();
        if (entry.hasGone()) {
          players.subList(at, known ? at + 1 : at).clear();
        } else if (known) {
          players.set(at, entry);
        } else {
          players.add(at, entry);
        }
      }
    }
  }

  /**
   * One player of a {@link Roster}.
   *
   * @param playerId 0..1,023
   * @param name see {@link PlayerName}; empty when the player has gone
   * @param score as the game counts
   */
  record RosterEntry(int playerId, String name, int score) {
    /** Whether the place is free now. */
    public boolean hasGone() {
      return name.isEmpty();
    }
  }

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
