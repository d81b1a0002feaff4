package carom.client.link;

import carom.net.protocol.ClientMessage;
import carom.net.protocol.PackedLevel;
import carom.net.protocol.ProtocolLimits;
import carom.net.protocol.ServerMessage;
import carom.net.transport.Link;
import carom.sim.level.Level;
import carom.sim.level.LevelException;
import java.util.Iterator;
import java.util.LinkedHashMap;

/**
 * Downloads levels in pieces, and keeps the last ones. A level that is already here isn't loaded
 * again after a reconnect or when a room comes round to it, and a broken download goes on where it
 * stopped. One connection's; one thread.
 */
final class LevelDownload {
  /** Pieces that are requested and not yet received; several at once hide the round trip. */
  private static final int PIECES_IN_FLIGHT = 16;

  /** Levels that are kept, and their bytes together; the present one is kept at any size. */
  private static final int MAX_KEPT = 16;

  private static final int MAX_KEPT_BYTES = 16 << 20;

  /** State of the download after a piece. */
  enum Status {
    /** More pieces are needed. */
    LOADING,
    /** The level is complete. */
    DONE,
    /** The pieces don't fit or were damaged; another attempt may work. */
    DAMAGED,
    /** The level is of a kind that this client can't read. */
    UNREADABLE
  }

  private ServerMessage.Welcome welcome;
  private byte[] packed;
  private long packedHash;
  private int received;
  private int requested;
  private Level level;

  /** The levels that are kept, by their hash, the one that was used last at the end. */
  private final LinkedHashMap<Long, Level> kept = new LinkedHashMap<>(16, 0.75f, true);

  private String problem = "";

  /** Returns whether the sizes of a Welcome's level are ones that a client loads. */
  static boolean accepts(ServerMessage.Welcome welcome) {
    return welcome.levelSize() >= 1
        && welcome.levelSize() <= ProtocolLimits.MAX_LEVEL_BYTES
        && welcome.packedSize() >= 1
        && welcome.packedSize() <= ProtocolLimits.MAX_LEVEL_BYTES;
  }

  /**
   * Starts the download of a server's level.
   *
   * @return whether it is here already
   */
  boolean begin(ServerMessage.Welcome newWelcome) {
    welcome = newWelcome;
    level = kept.get(welcome.levelHash());
    if (level != null) {
      return true;
    }
    boolean continues =
        packed != null
            && packedHash == welcome.levelHash()
            && packed.length == welcome.packedSize();
    if (!continues) {
      packed = new byte[welcome.packedSize()];
      packedHash = welcome.levelHash();
      received = 0;
    }
    requested = received;
    return false;
  }

  /**
   * Requests the next pieces.
   *
   * @return whether there were any to request
   */
  boolean request(Link link) {
    int piece = ProtocolLimits.MAX_LEVEL_CHUNK_BYTES;
    boolean any = false;
    while (requested < packed.length && requested - received < PIECES_IN_FLIGHT * piece) {
      link.send(new ClientMessage.LevelRequest(welcome.epoch(), requested));
      requested += piece;
      any = true;
    }
    return any;
  }

  /** Takes in a piece; {@link #problem} explains a bad result. */
  Status add(ServerMessage.LevelChunk chunk) {
    int expected = Math.min(ProtocolLimits.MAX_LEVEL_CHUNK_BYTES, packed.length - received);
    if (chunk.offset() != received || chunk.bytes().length != expected) {
      return fail(
          Status.DAMAGED,
          "The level arrived in pieces that don't fit: offset="
              + chunk.offset()
              + " length="
              + chunk.bytes().length
              + ", expected offset="
              + received
              + " length="
              + expected);
    }
    System.arraycopy(chunk.bytes(), 0, packed, received, expected);
    received += expected;
    return received < packed.length ? Status.LOADING : unpack();
  }

  private Status unpack() {
    byte[] complete = PackedLevel.unpack(packed, welcome.levelSize());
    packed = null;
    if (complete == null) {
      return fail(Status.DAMAGED, "The level was damaged on its way. Try again.");
    }
    try {
      level = Level.parse(welcome.levelName(), complete);
    } catch (LevelException e) {
      return fail(Status.UNREADABLE, "The server's level can't be used: " + e.getMessage());
    }
    if (level.contentHash() != welcome.levelHash()) {
      level = null;
      return fail(Status.DAMAGED, "The level was damaged on its way. Try again.");
    }
    kept.put(welcome.levelHash(), level);
    forgetOldest();
    return Status.DONE;
  }

  private void forgetOldest() {
    long bytes = kept.values().stream().mapToLong(each -> each.source().length).sum();
    Iterator<Level> oldest = kept.values().iterator();
    while (kept.size() > 1 && (kept.size() > MAX_KEPT || bytes > MAX_KEPT_BYTES)) {
      bytes -= oldest.next().source().length;
      oldest.remove();
    }
  }

  private Status fail(Status progress, String why) {
    packed = null;
    problem = why;
    return progress;
  }

  /** Returns why the last piece was bad, in words for the player. */
  String problem() {
    return problem;
  }

  /** Returns the level, or null before it is here. */
  Level level() {
    return level;
  }

  /** Returns the share of the level that has arrived, 0..1; 0 while nothing is loaded. */
  double share() {
    return packed == null ? 0 : (double) received / packed.length;
  }
}
