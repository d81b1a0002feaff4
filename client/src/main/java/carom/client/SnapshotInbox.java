package carom.client;

import carom.client.stats.NetStatsRecorder;
import carom.net.snapshot.DecodeStatus;
import carom.net.snapshot.SnapshotDecoder;
import carom.net.snapshot.exact.OwnState;
import java.util.Arrays;

/**
 * Decodes snapshot datagrams, and keeps the newest own state until the client reconciles with it.
 * One stay's; one thread; allocates nothing per datagram.
 */
final class SnapshotInbox {
  private static final int RING = 256;

  private final SnapshotDecoder decoder;
  private final NetStatsRecorder stats;
  private final int[] seenTick = new int[RING];
  private final OwnState own = new OwnState();
  private int newestTick = -1;
  private int ownTick = -1;
  private boolean newest;

  SnapshotInbox(SnapshotDecoder decoder, NetStatsRecorder stats) {
    this.decoder = decoder;
    this.stats = stats;
    own.clearBody();
    Arrays.fill(seenTick, -1);
  }

  /**
   * Decodes a datagram.
   *
   * @return whether it brought something; false if it is damaged, foreign or known
   */
  boolean decode(byte[] bytes, int length, long arrivedNs) {
    DecodeStatus status = decoder.decode(bytes, 0, length);
    if (status != DecodeStatus.OK) {
      if (status == DecodeStatus.DAMAGED) {
        stats.malformed();
      }
      return false;
    }
    stats.datagram(length, decoder.ackSequence(), decoder.ackBits());
    int tick = decoder.tick();
    if (seenTick[tick & (RING - 1)] != tick) {
      seenTick[tick & (RING - 1)] = tick;
      stats.snapshot(arrivedNs);
    }
    newest = tick > newestTick;
    newestTick = Math.max(newestTick, tick);
    return true;
  }

  /** Returns whether the last datagram was the first one of the newest tick. */
  boolean isNewest() {
    return newest;
  }

  /**
   * Keeps the own state of the last datagram if it is newer than the one kept.
   *
   * @return whether it is
   */
  boolean keepOwn() {
    if (!decoder.hasOwn() || decoder.tick() <= ownTick) {
      return false;
    }
    own.set(decoder.own());
    ownTick = decoder.tick();
    return true;
  }

  /** Returns the newest own state; its body is empty before one arrives. */
  OwnState own() {
    return own;
  }

  /** Returns the tick of an own state that waits for reconciliation, or -1; it is taken. */
  int takeOwnTick() {
    int tick = ownTick;
    ownTick = -1;
    return tick;
  }
}
