package carom.net.snapshot;

import carom.net.codec.BitReader;
import carom.net.protocol.DatagramMark;
import carom.net.protocol.InputDatagram;

/**
 * Reads the heads of snapshots and nothing else, for clients that acknowledge snapshots without
 * decoding them. It acknowledges every new datagram, so it must only stand for clients that could
 * have decoded it: in a soak of the server.
 */
public final class SnapshotHeads {
  private final DatagramHead head = new DatagramHead();
  private final BitReader reader = new BitReader();
  private final Receipts receipts = new Receipts();
  private final int mark;
  private int newestTick;

  /**
   * Creates a reader that has heard nothing.
   *
   * @param epoch as in {@code Welcome}
   * @param tick the server's tick in {@code Welcome}
   */
  public SnapshotHeads(int epoch, int tick) {
    mark = DatagramMark.ofState(epoch);
    newestTick = tick;
  }

  /** Reads a head; returns false when the datagram is damaged, late, or had before. */
  public boolean take(byte[] bytes, int length) {
    reader.reset(bytes, 0, length);
    head.code(reader, newestTick);
    if (reader.failed() || head.mark != mark || receipts.status(head.sequence) != DecodeStatus.OK) {
      return false;
    }
    receipts.add(head.sequence);
    newestTick = Math.max(newestTick, head.tick);
    return true;
  }

  /** Returns the newest tick that a snapshot was of. */
  public int newestTick() {
    return newestTick;
  }

  /** Returns by how many ticks inputs come early, as the last head says; 0 if it doesn't. */
  public int margin() {
    return head.feedback.present ? head.feedback.margin : 0;
  }

  /** Writes the acknowledgements into an input datagram. */
  public void acknowledge(InputDatagram datagram) {
    datagram.hasAck = receipts.any();
    datagram.ackSequence = receipts.newest();
    datagram.ackBits = receipts.older();
  }
}
