package carom.server.session;

import carom.net.protocol.ClientMessage;
import carom.net.protocol.ProtocolLimits;
import carom.net.protocol.ServerMessage;
import carom.net.transport.Link;
import java.util.Arrays;

/**
 * Sends one client the level that its last Welcome named, in the pieces it requests. The bytes that
 * a client can make the server send are bounded. One thread.
 */
public final class LevelUpload {
  /** Number of times that one link may request the whole level. */
  private static final int MAX_PULLS = 3;

  private final LoadedLevel level;
  private final int epoch;
  private long sentBytes;

  /**
   * Creates an upload that has sent nothing.
   *
   * @param epoch that of the Welcome; requests of another are for an earlier level
   */
  public LevelUpload(LoadedLevel level, int epoch) {
    this.level = level;
    this.epoch = epoch;
  }

  /**
   * Answers a request. A request for an earlier level is ignored.
   *
   * @return null, or what is wrong with the request, in words for the player
   */
  public String answer(ClientMessage.LevelRequest request, Link link) {
    if (request.epoch() != epoch) {
      return null;
    }
    byte[] packed = level.packed();
    int offset = request.offset();
    if (offset < 0 || offset >= packed.length) {
      return "LevelRequest.offset=" + offset + " is outside 0.." + (packed.length - 1) + ".";
    }
    int end = Math.min(packed.length, offset + ProtocolLimits.MAX_LEVEL_CHUNK_BYTES);
    sentBytes += end - offset;
    if (sentBytes > (long) MAX_PULLS * packed.length) {
      return "The level was requested again and again.";
    }
    link.send(new ServerMessage.LevelChunk(offset, Arrays.copyOfRange(packed, offset, end)));
    return null;
  }

  /** Returns whether the client has loaded this level, rather than an earlier one. */
  public boolean isFinishedBy(ClientMessage.Ready ready) {
    return ready.epoch() == epoch;
  }
}
