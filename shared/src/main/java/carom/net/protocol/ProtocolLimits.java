package carom.net.protocol;

/** Limits of the protocol. Decoders refuse values outside, and encoders never produce them. */
public final class ProtocolLimits {

  /**
   * Largest datagram in bytes, in either direction. With IP, UDP and tunnel headers it fits the MTU
   * of common paths.
   */
  public static final int MAX_DATAGRAM_BYTES = 1_200;

  /**
   * Bytes on the wire around a datagram's payload: 20 of IPv4, 8 of UDP, 27 of the frame (tag,
   * link, counter, proof). IPv6 takes 20 more.
   */
  public static final int DATAGRAM_OVERHEAD_BYTES = 20 + 8 + 27;

  /** Largest encoded message from a client, in bytes. */
  public static final int MAX_CLIENT_MESSAGE_BYTES = 1_024;

  /**
   * Largest encoded message from the server in bytes. A full {@link ServerMessage.Roster} is the
   * largest.
   */
  public static final int MAX_SERVER_MESSAGE_BYTES = 16 * 1_024;

  /** Largest message of a game, in bytes, in either direction. */
  public static final int MAX_GAME_MESSAGE_BYTES = 900;

  /** Longest account that a join token names, in characters. */
  public static final int MAX_ACCOUNT_CHARACTERS = 64;

  /** Longest player name in UTF-8 bytes, see {@link PlayerName}. The shortest has 1 byte. */
  public static final int MAX_NAME_BYTES = 32;

  /**
   * Longest text for a player ({@code Notice}, {@code Refused}, {@code Goodbye}), in UTF-8 bytes.
   */
  public static final int MAX_TEXT_BYTES = 512;

  /** Longest game name in UTF-8 bytes. */
  public static final int MAX_GAME_NAME_BYTES = 64;

  /** Longest join token in bytes of ASCII. */
  public static final int MAX_TOKEN_BYTES = 768;

  /** Largest size of a server's password in UTF-8. */
  public static final int MAX_PASSWORD_BYTES = 128;

  /** Longest address of a server in UTF-8 bytes: a host name of 253 and a port. */
  public static final int MAX_ADDRESS_BYTES = 261;

  /** Longest fingerprint of a server's key in bytes. */
  public static final int MAX_FINGERPRINT_BYTES = 43;

  /** Most servers of a fleet that a client is told. */
  public static final int MAX_FLEET_SERVERS = 16;

  /** Longest level name in UTF-8 bytes. */
  public static final int MAX_LEVEL_NAME_BYTES = 128;

  /** Largest number of bytes of the packed level file in one {@link ServerMessage.LevelChunk}. */
  public static final int MAX_LEVEL_CHUNK_BYTES = 4_096;

  /** Largest level file in bytes, packed or not. It holds some 40,000 bodies with a line each. */
  public static final int MAX_LEVEL_BYTES = 4 * 1_024 * 1_024;

  /** Largest state of a level's pools, in bytes. */
  public static final int MAX_POOL_STATE_BYTES = 256 * 1_024;

  /** Largest number of players in a room; ids are 0..1,023. */
  public static final int MAX_PLAYERS = 1_024;

  /** Largest number of entries in one {@link ServerMessage.Roster}. */
  public static final int MAX_ROSTER_ENTRIES = 256;

  /** Largest number of entity slots in a room; ids are 0..65,534. */
  public static final int MAX_ENTITIES = 65_535;

  /** Largest number of inputs in one input datagram. */
  public static final int MAX_INPUTS = 16;

  /** Slowest tick rate in Hz. */
  public static final int MIN_TICK_RATE = 10;

  /** Fastest tick rate in Hz. */
  public static final int MAX_TICK_RATE = 240;

  /**
   * Largest number of input datagrams that the server takes from one client per second, two a tick
   * at the fastest rate.
   */
  public static final int MAX_INPUT_DATAGRAMS_PER_SECOND = 2 * MAX_TICK_RATE;

  /**
   * Largest number of reliable messages that the server takes from one client per second, including
   * those that load the level.
   */
  public static final int MAX_CLIENT_MESSAGES_PER_SECOND = 2_000;

  /** Most declarations of fields and messages that {@code Welcome} tells. */
  public static final int MAX_DECLARATIONS = 128;

  /** Longest declaration that {@code Welcome} tells, bytes; the rest is cut. */
  public static final int MAX_DECLARATION_BYTES = 100;

  /** Longest name of a room. */
  public static final int MAX_ROOM_NAME_BYTES = 32;

  /** Longest name of a party. */
  public static final int MAX_PARTY_NAME_BYTES = 32;

  /** Largest number of rooms in one {@link ServerMessage.RoomList}. */
  public static final int MAX_LISTED_ROOMS = 16;

  /** Longest phase of a match in UTF-8 bytes, as lists of rooms show it. */
  public static final int MAX_PHASE_BYTES = 16;

  /** Most entries of a room's metadata. */
  public static final int MAX_ROOM_METADATA = 8;

  /** Longest key of a room's metadata. */
  public static final int MAX_METADATA_KEY_BYTES = 16;

  /** Longest value of a room's metadata. */
  public static final int MAX_METADATA_VALUE_BYTES = 48;

  /** Most lists of {@link ServerMessage.BestLists}. */
  public static final int MAX_BEST_LISTS = 16;

  /** Most entries of one of them. */
  public static final int MAX_BEST_ENTRIES = 10;

  /** Longest value of an entry. */
  public static final int MAX_BEST_VALUE_BYTES = 32;

  /** Longest name of a field. */
  public static final int MAX_FIELD_NAME_BYTES = 32;

  /** Largest level file of a player that a server takes, in bytes, packed or not. */
  public static final int MAX_OFFERED_BYTES = 256 * 1_024;

  /** Largest number of bytes of a packed level file in one {@link ClientMessage.LevelPiece}. */
  public static final int MAX_LEVEL_PIECE_BYTES = 1_000;

  /** Most pieces of a level that a client sends beyond those that have arrived. */
  public static final int MAX_PIECES_AHEAD = 16;

  /** Largest number of levels in one {@link ServerMessage.LevelList}. */
  public static final int MAX_LISTED_LEVELS = 64;

  private ProtocolLimits() {}
}
