package carom.server.checkpoint;

import carom.net.protocol.Protocol;
import carom.net.protocol.ProtocolLimits;
import carom.physics.archive.Archive;
import carom.physics.archive.ArchiveException;
import carom.physics.archive.ArchiveReader;
import carom.physics.archive.ArchiveWriter;
import carom.server.account.AccountWrite;
import carom.server.config.RoomConfig;
import carom.sim.SimState;
import carom.sim.outbox.NextMatch;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.zip.CRC32;

/**
 * The part of a checkpoint that isn't the state of the match: which match of which rotation it is,
 * who plays, and what the players may not have heard of. Immutable.
 *
 * <p>Keys, baselines, input buffers and predicted sets aren't kept: the links of a resumed room are
 * new, and each begins with absolute states.
 *
 * @param physicsDigest identifies the arithmetic of the build
 * @param layout of the state, {@link SimState#LAYOUT}
 * @param config digest of the room's settings: what a room of other settings is refused by
 * @param roomSeed seed of the room's first match
 * @param match number of the match
 * @param rotation index of the level in the room's rotation
 * @param pending the match that the room was loading, or null
 * @param tick tick of the checkpoint
 * @param hash hash of its state
 * @param events what happened before the checkpoint
 * @param seats the players
 * @param accounts last writes of players who have left, which the store of accounts may lack
 */
record SavedRoom(
    long physicsDigest,
    int layout,
    String config,
    long roomSeed,
    int match,
    int rotation,
    NextMatch pending,
    int tick,
    long hash,
    SavedEvents events,
    List<SavedSeat> seats,
    List<AccountWrite> accounts) {
  private static final long MAGIC = 0x4341524f4d534541L; // "CAROMSEA"
  private static final int FORMAT = 7;
  private static final int HEAD_BYTES = 20;
  private static final int MAX_CONFIG = 1 << 16;
  private static final int MAX_NAME = 1 << 12;
  private static final int MAX_WRITES = 1 << 13;

  SavedRoom {
    seats = List.copyOf(seats);
    accounts = List.copyOf(accounts);
  }

  /** Returns the settings of a room that decide whether its checkpoints may be resumed. */
  static String config(RoomConfig room, int tickRateHz) {
    return String.format(
        Locale.ROOT,
        "room=%s game=%s levels=%s tickRate=%d",
        room.name(),
        room.game(),
        String.join(",", room.levels()),
        tickRateHz);
  }

  /** Returns the bytes of a file. */
  byte[] toBytes() {
    ArchiveWriter body = new ArchiveWriter();
    pass(body, this);
    ArchiveWriter file = new ArchiveWriter();
    file.bits("magic", MAGIC);
    file.integer("format", FORMAT, FORMAT, FORMAT);
    file.bits("checksum", checksum(body.array(), 0, body.length()));
    byte[] content = body.toBytes();
    file.bytes("body", content, content.length, Byte.MIN_VALUE, Byte.MAX_VALUE);
    return file.toBytes();
  }

  /**
   * Reads the bytes of a file.
   *
   * @throws SlotException if they can't be used; the message says why
   */
  static SavedRoom parse(byte[] bytes) throws SlotException {
    try {
      ArchiveReader head = new ArchiveReader(bytes);
      if (head.bits("magic", 0) != MAGIC) {
        throw new SlotException("its seats are no file of seats");
      }
      int format = head.integer("format", 0, Integer.MIN_VALUE, Integer.MAX_VALUE);
      if (format != FORMAT) {
        throw new SlotException("its seats have format=" + format + ", this build reads " + FORMAT);
      }
      long sum = head.bits("checksum", 0);
      int length = bytes.length - HEAD_BYTES;
      if (sum != checksum(bytes, HEAD_BYTES, length)) {
        throw new SlotException("its seats are torn or damaged");
      }
      byte[] body = new byte[length];
      head.bytes("body", body, length, Byte.MIN_VALUE, Byte.MAX_VALUE);
      return pass(new ArchiveReader(body), null);
    } catch (ArchiveException e) {
      throw new SlotException("its seats are damaged: " + e.getMessage());
    }
  }

  private static long checksum(byte[] bytes, int from, int length) {
    CRC32 sum = new CRC32();
    sum.update(bytes, from, length);
    return sum.getValue();
  }

  private static SavedRoom pass(Archive a, SavedRoom r) {
    boolean reads = a.reads();
    long physics = a.bits("physics", reads ? 0 : r.physicsDigest);
    int layout = a.integer("layout", reads ? 0 : r.layout, 0, Integer.MAX_VALUE);
    String config = a.text("settings", reads ? "" : r.config, MAX_CONFIG);
    long seed = a.bits("seed", reads ? 0 : r.roomSeed);
    int match = a.integer("match", reads ? 0 : r.match, 1, Integer.MAX_VALUE);
    int rotation = a.integer("rotation", reads ? 0 : r.rotation, 0, Integer.MAX_VALUE);
    NextMatch pending = reads ? null : r.pending;
    if (a.flag("pending", pending != null)) {
      String game = a.text("next game", reads ? "" : pending.game(), MAX_NAME);
      String level = a.text("next level", reads ? "" : pending.level(), MAX_NAME);
      boolean teams = a.flag("keeps teams", !reads && pending.keepsTeams());
      boolean scores = a.flag("keeps scores", !reads && pending.keepsScores());
      pending = new NextMatch(game, level, teams, scores);
    }
    int tick = a.integer("tick", reads ? 0 : r.tick, 0, Integer.MAX_VALUE);
    long hash = a.bits("hash", reads ? 0 : r.hash);
    SavedEvents events = SavedEvents.pass(a, reads ? null : r.events);
    int count =
        a.count("seats", reads ? 0 : r.seats.size(), ProtocolLimits.MAX_PLAYERS, SavedSeat.bytes());
    List<SavedSeat> seats = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      seats.add(SavedSeat.pass(a, reads ? null : r.seats.get(i), events.count()));
    }
    int writes =
        a.count("writes", reads ? 0 : r.accounts.size(), MAX_WRITES, AccountWrite.LEAST_BYTES);
    List<AccountWrite> accounts = new ArrayList<>();
    for (int i = 0; i < writes; i++) {
      accounts.add(AccountWrite.pass(a, reads ? null : r.accounts.get(i)));
    }
    return new SavedRoom(
        physics, layout, config, seed, match, rotation, pending, tick, hash, events, seats,
        accounts);
  }

  /**
   * Checks that this room may go on where the saved one was.
   *
   * @throws SlotException if not; the message says why
   */
  void requireFits(String presentConfig) throws SlotException {
    if (layout != SimState.LAYOUT) {
      throw new SlotException(
          String.format(
              Locale.ROOT,
              "its state has layout=%d, this build reads %d",
              layout,
              SimState.LAYOUT));
    }
    if (!config.equals(presentConfig)) {
      throw new SlotException(
          "it was kept by a room with other settings: \"%s\" is now \"%s\""
              .formatted(config, presentConfig));
    }
  }

  /** Returns whether this build computes as the one that kept the room. */
  boolean hasSamePhysics() {
    return physicsDigest == Protocol.physicsDigest();
  }
}
