package carom.net.protocol;

import carom.physics.rows.BodyRow;
import java.util.List;

/** What a client sends reliably and in order. Encoded by {@link ClientMessageCodec}. */
public sealed interface ClientMessage {

  /**
   * The first message: who is there.
   *
   * @param protocolVersion {@link Protocol#VERSION} of the client
   * @param physicsDigest {@link Protocol#physicsDigest()} of the client
   * @param name the player's name, see {@link PlayerName}
   * @param resumeSecret secret of an earlier session's {@link ServerMessage.Welcome}, or 0
   */
  record Hello(int protocolVersion, long physicsDigest, String name, long resumeSecret)
      implements ClientMessage {}

  /**
   * Asks for a piece of the packed level from an offset on. A client has several requests under
   * way, so that the round trip doesn't set the pace, and goes on where it was when it comes back.
   *
   * @param offset 0..{@link Limits#MAX_LEVEL_BYTES} - 1
   */
  record LevelRequest(int offset) implements ClientMessage {}

  /** The level is loaded: give me a body. */
  record Ready() implements ClientMessage {}

  /**
   * What the client shows, when it changes: the server tells about entities in there. It bounds the
   * size.
   *
   * @param x where it looks while the player has no body, metres
   * @param y where it looks while the player has no body, metres
   * @param halfWidth half of what it shows, metres
   * @param halfHeight half of what it shows, metres
   */
  record Look(float x, float y, float halfWidth, float halfHeight) implements ClientMessage {}

  /**
   * Reports a misprediction that nothing explains which the client knows of. Either the own body
   * was alone; or the hash of the predicted set differs, though the client knew every input and was
   * told of nothing else since the last tick of equal hashes. Rare; the server judges whether that
   * proves a fault.
   *
   * @param tick the first that differs
   * @param equalTick the last one whose prediction was equal in every bit, before {@code tick}
   * @param bodies what was predicted, {@value #BODY_INTS} numbers for each body: slot and
   *     generation as {@code slot | generation << 16}, and the float bits of x, y, cos, sin, vx,
   *     vy, omega of the centre of mass. Either the own body alone, or the predicted set in the
   *     order of the world, the first {@value #MAX_BODIES} at most
   * @param memory with the own body alone the player's {@value #MEMORY_INTS} memory ints, else
   *     empty
   */
  record Diverged(int tick, int equalTick, List<Integer> bodies, List<Integer> memory)
      implements ClientMessage {
    /** Numbers of a body: the head of its row. */
    public static final int BODY_INTS = BodyRow.HEAD_INTS;

    /** Numbers of the memory. */
    public static final int MEMORY_INTS = BodyRow.MEMORY_INTS;

    /** Most bodies told: as many as a message has room for. */
    public static final int MAX_BODIES = 31;

    /** Copies the lists. */
    public Diverged {
      bodies = List.copyOf(bodies);
      memory = List.copyOf(memory);
    }

    /** Returns whether this is about the predicted set, not about the own body alone. */
    public boolean isOfSet() {
      return memory.isEmpty();
    }

    /** Number of {@link #bodies}' and {@link #memory}'s numbers. */
    public int count() {
      return bodies.size() + memory.size();
    }

    /** Returns a number of the bodies or, after these, of the memory. */
    public int number(int index) {
      return index < bodies.size() ? bodies.get(index) : memory.get(index - bodies.size());
    }
  }

  /**
   * Instead of {@link Hello}: lets a spectator in, who is shown a room's recording some time later.
   *
   * @param protocolVersion {@link Protocol#VERSION} of the client
   * @param physicsDigest {@link Protocol#physicsDigest()} of the client, which computes the game
   * @param room its number, 1..255
   */
  record Watch(int protocolVersion, long physicsDigest, int room) implements ClientMessage {}

  /**
   * Asks for a piece of the recording from an offset on; as with {@link LevelRequest}, several may
   * be under way.
   *
   * @param offset not negative
   */
  record RecordingRequest(long offset) implements ClientMessage {}

  /** The player goes; no grace period. */
  record Leave() implements ClientMessage {}
}
