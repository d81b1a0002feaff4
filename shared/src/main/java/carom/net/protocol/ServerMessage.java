package carom.net.protocol;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/**
 * A message from the server to a client, sent reliably and in order. It is plain data with sizes
 * bounded by {@link ProtocolLimits}.
 */
public sealed interface ServerMessage {

  /**
   * Admits a client and gives it what it needs to load the level and to predict. A client that
   * plays receives another one when its room goes on with another level or game, or when it changes
   * the room: it keeps its secret, and has to load again.
   *
   * @param sessionSecret proves the client's identity when it resumes the session; 0 for a bot of
   *     the server, which can't
   * @param epoch counts the link's Welcomes, modulo 8; in each datagram from now on
   * @param playerId 0..1,023
   * @param tickRate ticks per second, {@link ProtocolLimits#MIN_TICK_RATE}..{@link
   *     ProtocolLimits#MAX_TICK_RATE}
   * @param room name of the room; another than before if the player has changed the room
   * @param match counts the room's matches from 1 on; ticks begin at 0 in each
   * @param claim number by which the server owns the room within its fleet; a later owner has a
   *     higher one, and a client must not follow one with a lower. 0 without a fleet
   * @param incarnation stands for this run of the room; another than before if the room was resumed
   *     from a checkpoint, or is another server's
   * @param courseTick last tick that the match's present course shares with the one that this
   *     player has heard of, at most {@code tick}; meaningful if the incarnation is another one.
   *     Ticks after it happen again, otherwise
   * @param tick the server's tick when it sent this
   * @param seed seed of the simulation
   * @param game name of the game, for {@code Games.create}
   * @param levelName file name of the level, for texts only
   * @param levelHash content hash of the level file
   * @param levelSize size of the level file in bytes
   * @param packedSize size of the {@linkplain PackedLevel packed} level file in bytes; the chunks
   *     are pieces of it
   * @param declarationsDigest digest of the game's fields and kinds of messages
   * @param gameDigest digest of the game's code; {@link ClientMessage.Ready#ANY_CODE} if it has
   *     none
   * @param takesAnyCode whether a client whose code differs may play all the same
   * @param declarations the declarations, which name a difference: at most {@value
   *     ProtocolLimits#MAX_DECLARATIONS} texts of at most {@value
   *     ProtocolLimits#MAX_DECLARATION_BYTES} bytes
   */
  record Welcome(
      long sessionSecret,
      int epoch,
      int playerId,
      int tickRate,
      String room,
      int match,
      long claim,
      int incarnation,
      int courseTick,
      int tick,
      long seed,
      String game,
      String levelName,
      long levelHash,
      int levelSize,
      int packedSize,
      long declarationsDigest,
      long gameDigest,
      boolean takesAnyCode,
      List<String> declarations)
      implements ServerMessage {
    /** Copies the list. */
    public Welcome {
      declarations = List.copyOf(declarations);
    }

    /** Returns why a client that is ready is refused, in words for the player, or null. */
    public String refusal(ClientMessage.Ready ready) {
      if (ready.declarationsDigest() != declarationsDigest) {
        return "The fields of your game " + game + " differ.";
      }
      String difference = takesAnyCode ? null : codeDifference(ready.gameDigest());
      return difference == null ? null : difference + " Use the same build.";
    }

    /**
     * Returns how the code of a client's game differs from the server's.
     *
     * @param clientDigest as in {@link ClientMessage.Ready}
     * @return in words for the player, or null if it is the same or one side doesn't tell
     */
    public String codeDifference(long clientDigest) {
      boolean compared =
          gameDigest != ClientMessage.Ready.ANY_CODE
              && clientDigest != ClientMessage.Ready.ANY_CODE;
      return compared && clientDigest != gameDigest
          ? String.format(
              Locale.ROOT,
              "Game %s is another build here: server %016x, client %016x.",
              game,
              gameDigest,
              clientDigest)
          : null;
    }
  }

  /**
   * Carries a piece of the packed level file in answer to a {@link ClientMessage.LevelRequest}.
   *
   * @param offset offset of the first byte in the packed file
   * @param bytes 1..{@link ProtocolLimits#MAX_LEVEL_CHUNK_BYTES}, owned by the message
   */
  @SuppressWarnings(
      "ArrayRecordComponent") // The receiver copies the bytes at once, and equality is by content.
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
   * Refuses a client. The link closes after it.
   *
   * @param reason reason for the program
   * @param text details for the player beyond {@link RefusalReason#playerText()}, may be empty
   */
  record Refused(RefusalReason reason, String text) implements ServerMessage {
    /** Returns why the client is refused, for the player's screen: the reason and its details. */
    public String playerText() {
      return withDetails(reason.playerText(), text);
    }
  }

  /**
   * Lists the changes of the players. The first roster on a link lists all players; each later one
   * has what changed after the one before.
   *
   * @param entries at most {@link ProtocolLimits#MAX_ROSTER_ENTRIES}, ordered by id; never modified
   */
  record Roster(List<RosterEntry> entries) implements ServerMessage {
    /**
     * Applies the changes to a list of players.
     *
     * @param players the current players, ordered by id; this method updates the list
     */
    public void applyTo(List<RosterEntry> players) {
      for (RosterEntry entry : entries) {
        int at = placeOf(entry.playerId(), players);
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

    /**
     * Returns the index of the first player whose id isn't below an id, or the list's size.
     *
     * @param players ordered by id
     */
    public static int placeOf(int id, List<RosterEntry> players) {
      int at = 0;
      int end = players.size();
      while (at < end) {
        int middle = (at + end) >>> 1;
        if (players.get(middle).playerId() < id) {
          at = middle + 1;
        } else {
          end = middle;
        }
      }
      return at;
    }
  }

  /**
   * One participant of a {@link Roster}: a player or a spectator.
   *
   * @param playerId 0..1,023
   * @param name see {@link PlayerName}; empty when the participant has gone, and the rest has no
   *     meaning
   * @param team number with a meaning of the game's own; -1 for spectators
   * @param score the player's score, as the game counts it
   * @param spectator whether it watches and has no body
   * @param ready whether the player has said that it is ready
   * @param alive whether the player has a body
   * @param pingMs round trip as the server measures it, 0..{@value #MAX_PING_MS} ms, roughly; 0
   *     while it isn't known or there is no link
   * @param colour number of the colour that the player has chosen, 0..{@value #MAX_COLOUR}; 0 for
   *     none
   */
  record RosterEntry(
      int playerId,
      String name,
      int team,
      int score,
      boolean spectator,
      boolean ready,
      boolean alive,
      int pingMs,
      int colour) {
    /** Longest round trip that is told. */
    public static final int MAX_PING_MS = 9_999;

    /** Largest number of a colour, as many as a message has room for. */
    public static final int MAX_COLOUR = 31;

    /** Returns the entry of a participant that has gone. */
    public static RosterEntry gone(int playerId) {
      return new RosterEntry(playerId, "", 0, 0, false, false, false, 0, 0);
    }

    /** Returns whether the player has gone and the id is free. */
    public boolean hasGone() {
      return name.isEmpty();
    }
  }

  /**
   * Lists rooms, in answer to {@link ClientMessage.ListRooms}. A long list takes several messages.
   *
   * @param left number of rooms that follow in further messages
   * @param rooms at most {@link ProtocolLimits#MAX_LISTED_ROOMS}
   */
  record RoomList(int left, List<RoomEntry> rooms) implements ServerMessage {
    /** Copies the list. */
    public RoomList {
      rooms = List.copyOf(rooms);
    }
  }

  /**
   * One room of a {@link RoomList}.
   *
   * @param name see {@link RoomName}
   * @param game name of the game that it plays
   * @param level name of the level, for people
   * @param phase what the match is at, for people; empty if the game doesn't say
   * @param players number of places that are taken
   * @param places number of places
   * @param spectators number of spectators
   * @param metadata what players can choose the room by, see {@link RoomName#metadataProblem}
   */
  record RoomEntry(
      String name,
      String game,
      String level,
      String phase,
      int players,
      int places,
      int spectators,
      Map<String, String> metadata) {}

  /**
   * Lists the best of what the accounts of the room's game keep, in answer to {@link
   * ClientMessage.ListBest}.
   *
   * @param lists at most {@link ProtocolLimits#MAX_BEST_LISTS}, one for each field that has any
   */
  record BestLists(List<BestList> lists) implements ServerMessage {
    /** Copies the list. */
    public BestLists {
      lists = List.copyOf(lists);
    }
  }

  /**
   * One list of {@link BestLists}.
   *
   * @param field name of the field
   * @param own index of the player's own entry, or -1
   * @param entries at most {@link ProtocolLimits#MAX_BEST_ENTRIES}, the best first
   */
  record BestList(String field, int own, List<BestEntry> entries) {
    /** Copies the list. */
    public BestList {
      entries = List.copyOf(entries);
    }
  }

  /**
   * One entry of a {@link BestList}.
   *
   * @param name under which the account's player played last
   * @param value for people, at most {@link ProtocolLimits#MAX_BEST_VALUE_BYTES}
   */
  record BestEntry(String name, String value) {}

  /**
   * Says how far the server has a level that is offered, and what comes of it.
   *
   * @param received bytes of the packed file that have arrived; the client sends at most {@link
   *     ProtocolLimits#MAX_PIECES_AHEAD} pieces beyond them
   * @param outcome what has come of it
   * @param text for the player: why it isn't taken, or under which name it is; at most {@link
   *     ProtocolLimits#MAX_TEXT_BYTES}
   */
  record LevelAnswer(int received, LevelOutcome outcome, String text) implements ServerMessage {}

  /** The state of a level that is offered. The order is part of the protocol. */
  enum LevelOutcome {
    /** The level arrives, or is checked. */
    UNDER_WAY,
    /** The server has it. The link closes after it. */
    TAKEN,
    /** The server doesn't take it. The link closes after it. */
    NOT_TAKEN
  }

  /**
   * Lists levels of players, in answer to {@link ClientMessage.ListLevels}. A long list takes
   * several messages.
   *
   * @param left number of levels that follow in further messages
   * @param mayChoose whether the players of the room choose what it plays
   * @param levels at most {@link ProtocolLimits#MAX_LISTED_LEVELS}, sorted by name
   */
  record LevelList(int left, boolean mayChoose, List<LevelEntry> levels) implements ServerMessage {
    /** Copies the list. */
    public LevelList {
      levels = List.copyOf(levels);
    }
  }

  /**
   * One level of a {@link LevelList}.
   *
   * @param name by which it is chosen
   * @param game name of the game that it is made for
   * @param author name of the player who sent it, as it was then
   * @param votes number of players here who want the room to play it
   * @param chosen whether the player is one of them
   */
  record LevelEntry(String name, String game, String author, int votes, boolean chosen) {}

  /**
   * Shows a line on the player's screen.
   *
   * @param text at most {@link ProtocolLimits#MAX_TEXT_BYTES} in UTF-8
   */
  record Notice(String text) implements ServerMessage {}

  /**
   * Tells at which pace time passes, and whether views are narrow. A server that is too slow tells
   * players only of what they show, and then runs fewer ticks a second, each of the same length.
   *
   * @param percent ticks a second in percent of the tick rate, 1..100; 100 until told otherwise
   * @param viewsNarrow whether the client is told only of what it shows; false until told otherwise
   */
  record Pace(int percent, boolean viewsNarrow) implements ServerMessage {
    /** That of a server with time enough, which clients assume. */
    public static final Pace FULL = new Pace(100, false);
  }

  /**
   * Tells where the server's page is on which browsers play. A server without a page sends none.
   *
   * @param port 1..65,535, at the address by which the client came
   * @param encrypted whether it is reached by https
   */
  record PlayPage(int port, boolean encrypted) implements ServerMessage {}

  /**
   * Admits a spectator.
   *
   * @param delaySeconds delay of the spectator behind the present, 1..65,535 s
   */
  record Watching(int delaySeconds) implements ServerMessage {}

  /**
   * Carries a piece of a recording in answer to a {@link ClientMessage.RecordingRequest}.
   *
   * @param offset offset of the first byte in the recording
   * @param bytes at most {@link ProtocolLimits#MAX_LEVEL_CHUNK_BYTES}, owned by the message; empty
   *     when the recording has nothing past the offset yet
   */
  @SuppressWarnings("ArrayRecordComponent") // see LevelChunk
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
   * Carries a reliable message of the game.
   *
   * @param number its place among those of the session, from 1 on, see {@link MessageStream}
   * @param bytes 1..{@link ProtocolLimits#MAX_GAME_MESSAGE_BYTES}, as {@code MessageKinds} codes
   *     them; owned by the message
   */
  @SuppressWarnings("ArrayRecordComponent") // see LevelChunk
  record GameMessage(int number, byte[] bytes) implements ServerMessage {
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
   * Carries a piece of the state of the level's pools in answer to a {@link
   * ClientMessage.PoolRequest}.
   *
   * @param size of the whole state in bytes, 1..{@link ProtocolLimits#MAX_POOL_STATE_BYTES}
   * @param offset offset of the first byte in the state
   * @param bytes 1..{@link ProtocolLimits#MAX_LEVEL_CHUNK_BYTES}, owned by the message
   */
  @SuppressWarnings("ArrayRecordComponent") // see LevelChunk
  record PoolChunk(int size, int offset, byte[] bytes) implements ServerMessage {
    @Override
    public boolean equals(Object other) {
      return other instanceof PoolChunk chunk
          && chunk.size == size
          && chunk.offset == offset
          && Arrays.equals(chunk.bytes, bytes);
    }

    @Override
    public int hashCode() {
      return 31 * (31 * size + offset) + Arrays.hashCode(bytes);
    }

    @Override
    public String toString() {
      return "PoolChunk[size=" + size + ", offset=" + offset + ", bytes=" + bytes.length + "]";
    }
  }

  /**
   * Begins the messages of the game on a new link: says which of the client's the server has heard.
   * The client answers with {@link ClientMessage.Heard}.
   *
   * @param number the last one's, 0 for none
   */
  record Heard(int number) implements ServerMessage {}

  /**
   * Ends the session. The link closes after it.
   *
   * @param reason reason for the program
   * @param text details for the player beyond {@link GoodbyeReason#playerText()}, may be empty
   */
  record Goodbye(GoodbyeReason reason, String text) implements ServerMessage {
    /** Returns why the session ends, for the player's screen: the reason and its details. */
    public String playerText() {
      return withDetails(reason.playerText(), text);
    }
  }

  private static String withDetails(String sentence, String details) {
    return details.isEmpty() || details.equals(sentence) ? sentence : sentence + " " + details;
  }

  /**
   * Sends the client to another server. Nothing of the session goes along: it joins there as a
   * newcomer. The client decides whether it follows.
   *
   * @param server host and TCP port, {@code host:port}, at most {@link
   *     ProtocolLimits#MAX_ADDRESS_BYTES}
   * @param fingerprint of the key that the other server must show, or empty if this one doesn't
   *     know
   * @param room to ask for there, or empty for any
   * @param token join token for the other server, or empty
   */
  record Redirect(String server, String fingerprint, String room, String token)
      implements ServerMessage {
    /** Leaves the token out, which lets its bearer in. */
    @Override
    public String toString() {
      return "Redirect[server=" + server + ", room=" + room + "]";
    }
  }

  /**
   * Sends the client to another server of the same fleet, which owns the room. The session goes
   * along: the client says Hello there with its secret and the ticket.
   *
   * @param server as in {@link Redirect}
   * @param fingerprint of the fleet's key, which this server has shown, too
   * @param room name of the room there
   * @param ticket stands in for the join token there, once and for ten seconds; empty where the
   *     secret is enough, because the session is there by then
   */
  record Move(String server, String fingerprint, String room, String ticket)
      implements ServerMessage {
    /** Leaves the ticket out, which lets its bearer in. */
    @Override
    public String toString() {
      return "Move[server=" + server + ", room=" + room + "]";
    }
  }

  /**
   * Tells the other servers of the fleet, where a client goes that has lost this one. Each message
   * replaces the one before.
   *
   * @param servers addresses {@code host:port}, at most {@link ProtocolLimits#MAX_FLEET_SERVERS}
   * @param standby the one of them that follows the client's room and goes on with it if this
   *     server dies; the client keeps a link to it, see {@link ClientMessage.Standby}. Empty for
   *     none
   */
  record Fleet(List<String> servers, String standby) implements ServerMessage {
    /** Copies the list. */
    public Fleet {
      servers = List.copyOf(servers);
    }
  }
}
