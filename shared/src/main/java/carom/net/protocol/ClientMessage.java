package carom.net.protocol;

import carom.physics.rows.BodyRow;
import java.util.Arrays;
import java.util.List;

/**
 * A message from a client to the server, sent reliably and in order. {@link ClientMessageCodec}
 * encodes it.
 */
public sealed interface ClientMessage {

  /**
   * Opens a session or resumes one. It is the first message of a client that plays.
   *
   * @param protocolVersion {@link Protocol#VERSION} of the client
   * @param physicsDigest {@link Protocol#physicsDigest()} of the client
   * @param name the player's name, see {@link PlayerName}
   * @param resumeSecret secret of an earlier session's {@link ServerMessage.Welcome}, or 0
   * @param room name of the room in which the player wants to play; empty for any
   * @param game name of the game that the player wants to play if the room is any; empty for any.
   *     It is a request: if no room that plays it has a place, the server chooses another
   * @param party name of the party whose members the player wants to be with if the room is any,
   *     see {@link RoomName#partyProblem}; empty for none
   * @param token join token of the operator's own backend, or what proves a key of the player's own
   *     (carom.net.seal.PlayerKey), at most {@link ProtocolLimits#MAX_TOKEN_BYTES} characters of
   *     ASCII; empty for none
   */
  record Hello(
      int protocolVersion,
      long physicsDigest,
      String name,
      long resumeSecret,
      String room,
      String game,
      String party,
      String token)
      implements ClientMessage {
    /** Leaves the token out, which lets its bearer in. */
    @Override
    public String toString() {
      return "Hello[name=" + name + ", room=" + room + ", game=" + game + "]";
    }

    /** Creates a message of a player who plays in any room. */
    public Hello(int protocolVersion, long physicsDigest, String name, long resumeSecret) {
      this(protocolVersion, physicsDigest, name, resumeSecret, "", "", "", "");
    }
  }

  /**
   * Shows the server's password, once, before {@link Hello} or {@link Watch}. A server without one
   * ignores it.
   *
   * @param text 1..{@link ProtocolLimits#MAX_PASSWORD_BYTES} bytes of UTF-8
   */
  record Password(String text) implements ClientMessage {
    /** Leaves the text out, which lets its bearer in. */
    @Override
    public String toString() {
      return "Password[]";
    }
  }

  /**
   * Asks which rooms there are, before {@link Hello} or while playing. {@link
   * ServerMessage.RoomList} answers.
   *
   * @param protocolVersion {@link Protocol#VERSION} of the client
   */
  record ListRooms(int protocolVersion) implements ClientMessage {}

  /**
   * Asks for the best of what the accounts of the room's game keep, while playing. {@link
   * ServerMessage.BestLists} answers.
   */
  record ListBest() implements ClientMessage {}

  /**
   * Asks to go on in another room, over the same link and in the same session. A {@link
   * ServerMessage.Welcome} answers, or a {@link ServerMessage.Notice} that says why the player
   * stays.
   *
   * @param room name of the room, 1..{@link ProtocolLimits#MAX_ROOM_NAME_BYTES} bytes
   */
  record ChangeRoom(String room) implements ClientMessage {}

  /**
   * Asks for the piece of the packed level at an offset. A client keeps several requests in flight,
   * so that the round trip doesn't limit the speed. After a reconnect it continues at its last
   * offset.
   *
   * @param epoch that of the {@link ServerMessage.Welcome} that named the level; the server ignores
   *     requests for the level before
   * @param offset 0..{@link ProtocolLimits#MAX_LEVEL_BYTES} - 1
   */
  record LevelRequest(int epoch, int offset) implements ClientMessage {}

  /**
   * Says that the client has loaded the level and asks for a body.
   *
   * @param epoch that of the {@link ServerMessage.Welcome} that named the level
   * @param declarationsDigest digest of the declarations of the client's game; the server refuses
   *     another than its own
   * @param gameDigest digest of the code of the client's game, or {@link #ANY_CODE}; unless the
   *     server takes any code, it refuses another than its own
   */
  record Ready(int epoch, long declarationsDigest, long gameDigest) implements ClientMessage {
    /** The game digest of a client that computes nothing with the game's code. */
    public static final long ANY_CODE = 0;

    /** Creates the message of a client that computes nothing with the game's code. */
    public Ready(int epoch, long declarationsDigest) {
      this(epoch, declarationsDigest, ANY_CODE);
    }
  }

  /**
   * Tells the server what part of the world the client shows. The client sends it on every change.
   * The server limits the size and sends only entities in this rectangle.
   *
   * @param x centre of the view while the player has no body, metres
   * @param y centre of the view while the player has no body, metres
   * @param halfWidth half the width of the view, metres
   * @param halfHeight half the height of the view, metres
   * @param follows the player whose body is the centre of the view while the own player has no
   *     body, 0..1,023, or {@link #NOBODY}
   */
  record Look(float x, float y, float halfWidth, float halfHeight, int follows)
      implements ClientMessage {
    /** The place x, y is the centre of the view. */
    public static final int NOBODY = -1;
  }

  /**
   * Reports a misprediction that the client can't explain. Either it predicted its own body alone,
   * or the hash of the predicted set differs although the client knew every input and received no
   * other change after the last tick of equal hashes. The report is rare. The server judges whether
   * it proves a fault.
   *
   * @param tick first tick that differs
   * @param equalTick last tick before {@code tick} at which the prediction was equal in every bit
   * @param ofSet whether the report is about the predicted set rather than the own body alone
   * @param bodies the predicted state, {@value #BODY_INTS} ints for each body: slot and generation
   *     as {@code slot | generation << 16}, then the float bits of x, y, cos, sin, vx, vy and omega
   *     of the centre of mass. It holds either the own body alone, or the first bodies of the
   *     predicted set in world order, at most {@value #MAX_BODIES}
   * @param words the first words of the player's fields, at most {@value #MAX_WORDS}, if {@code
   *     bodies} is the own body alone; else empty
   */
  record Diverged(int tick, int equalTick, boolean ofSet, List<Integer> bodies, List<Integer> words)
      implements ClientMessage {
    /** Ints for each body in {@link #bodies}: the head of its row. */
    public static final int BODY_INTS = BodyRow.HEAD_INTS;

    /** Largest number of {@link #words}. */
    public static final int MAX_WORDS = 64;

    /** Largest number of bodies in a report, as many as a message has room for. */
    public static final int MAX_BODIES = 31;

    /** Copies both lists. */
    public Diverged {
      bodies = List.copyOf(bodies);
      words = List.copyOf(words);
    }

    /** Returns the number of ints in {@link #bodies} and {@link #words} together. */
    public int count() {
      return bodies.size() + words.size();
    }

    /** Returns an int of {@link #bodies} or, at higher indices, of {@link #words}. */
    public int number(int index) {
      return index < bodies.size() ? bodies.get(index) : words.get(index - bodies.size());
    }
  }

  /**
   * Asks to watch a room as a spectator, instead of {@link Hello}. A spectator sees the room's
   * recording with a delay.
   *
   * @param protocolVersion {@link Protocol#VERSION} of the client
   * @param physicsDigest {@link Protocol#physicsDigest()} of the client, which simulates the game
   *     from the recording
   * @param room number of the room, 1..255
   */
  record Watch(int protocolVersion, long physicsDigest, int room) implements ClientMessage {}

  /**
   * Asks for the piece of the recording at an offset. As with {@link LevelRequest}, several
   * requests may be in flight.
   *
   * @param offset not negative
   */
  record RecordingRequest(long offset) implements ClientMessage {}

  /**
   * Carries a reliable message of the game.
   *
   * @param number its place among those of the session, from 1 on, see {@link MessageStream}
   * @param bytes 1..{@link ProtocolLimits#MAX_GAME_MESSAGE_BYTES}, as {@code MessageKinds} codes
   *     them; owned by the message
   */
  @SuppressWarnings("ArrayRecordComponent") // The receiver reads the bytes at once.
  record GameMessage(int number, byte[] bytes) implements ClientMessage {
    @Override
    public boolean equals(Object other) {
      return other instanceof GameMessage m && m.number == number && Arrays.equals(m.bytes, bytes);
    }

    @Override
    public int hashCode() {
      return 31 * number + Arrays.hashCode(bytes);
    }

    @Override
    public String toString() {
      return "GameMessage[number=" + number + ", bytes=" + bytes.length + "]";
    }
  }

  /**
   * Asks for the piece of the state of the level's pools at an offset. Offset 0 asks for a new
   * state, to which the later pieces belong.
   *
   * @param offset 0..{@link ProtocolLimits#MAX_POOL_STATE_BYTES} - 1
   */
  record PoolRequest(int offset) implements ClientMessage {}

  /**
   * Answers {@link ServerMessage.Heard} on each new link: says which of the server's messages of
   * the game the client has heard.
   *
   * @param number the last one's, 0 for none
   */
  record Heard(int number) implements ClientMessage {}

  /**
   * Waits at a server that follows the client's room, instead of {@link Hello}. Nothing happens
   * until that server owns the room; then {@link ServerMessage.Welcome} comes.
   *
   * @param protocolVersion {@link Protocol#VERSION} of the client
   * @param physicsDigest {@link Protocol#physicsDigest()} of the client
   * @param secret of the session
   * @param room name of the room
   */
  record Standby(int protocolVersion, long physicsDigest, long secret, String room)
      implements ClientMessage {
    /** Leaves the secret out, which is the player's. */
    @Override
    public String toString() {
      return "Standby[room=" + room + "]";
    }
  }

  /**
   * Offers a level of the player's to a server that takes levels, instead of {@link Hello}. {@link
   * ServerMessage.LevelAnswer} says whether and how far the server takes it.
   *
   * @param protocolVersion {@link Protocol#VERSION} of the client
   * @param levelSize size of the level file in bytes, 1..{@link ProtocolLimits#MAX_OFFERED_BYTES}
   * @param packedSize size of the {@linkplain PackedLevel packed} file, of which {@link LevelPiece}
   *     carries pieces, 1..{@link ProtocolLimits#MAX_OFFERED_BYTES}
   * @param name the player's name, as in {@link Hello}
   * @param token as in {@link Hello}; not empty, because a level belongs to an account
   */
  record OfferLevel(int protocolVersion, int levelSize, int packedSize, String name, String token)
      implements ClientMessage {
    /** Leaves the token out, which lets its bearer in. */
    @Override
    public String toString() {
      return "OfferLevel[name=" + name + ", levelSize=" + levelSize + "]";
    }
  }

  /**
   * Carries the next piece of a level that is offered.
   *
   * @param offset of the first byte in the packed file; the pieces come in order, without gaps
   * @param bytes 1..{@link ProtocolLimits#MAX_LEVEL_PIECE_BYTES}, owned by the message
   */
  @SuppressWarnings("ArrayRecordComponent") // The receiver reads the bytes at once.
  record LevelPiece(int offset, byte[] bytes) implements ClientMessage {
    @Override
    public boolean equals(Object other) {
      return other instanceof LevelPiece m && m.offset == offset && Arrays.equals(m.bytes, bytes);
    }

    @Override
    public int hashCode() {
      return 31 * offset + Arrays.hashCode(bytes);
    }

    @Override
    public String toString() {
      return "LevelPiece[offset=" + offset + ", bytes=" + bytes.length + "]";
    }
  }

  /**
   * Asks which levels of players there are, while playing. {@link ServerMessage.LevelList} answers.
   */
  record ListLevels() implements ClientMessage {}

  /**
   * Says which level of a player the player wants the room to play, if its players may choose.
   *
   * @param name of the level; empty for none
   */
  record ChooseLevel(String name) implements ClientMessage {}

  /** Says that the player leaves. The server keeps no place for a player who left. */
  record Leave() implements ClientMessage {}
}
