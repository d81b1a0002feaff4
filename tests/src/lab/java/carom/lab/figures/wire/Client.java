package carom.lab.figures.wire;

import carom.net.snapshot.DecodeStatus;
import carom.net.snapshot.Deltas;
import carom.net.snapshot.InputFeedback;
import carom.net.snapshot.Interest;
import carom.net.snapshot.SnapshotDecoder;
import carom.net.snapshot.SnapshotEncoder;
import carom.net.snapshot.exact.OwnState;
import carom.net.snapshot.table.Tables;

/**
 * The snapshots of one client without a network. Each snapshot arrives, and its ack is back after a
 * fixed number of sends.
 */
final class Client {
  private static final int EPOCH = 1;

  private final SnapshotEncoder encoder;
  private final SnapshotDecoder decoder;
  private final InputFeedback feedback = new InputFeedback();
  private final OwnState own = new OwnState();
  private final byte[] buffer = new byte[SnapshotEncoder.MAX_DATAGRAM_BYTES];
  private final int[] ackSequence;
  private final long[] ackBits;
  private final int budget;
  private int sends;

  /**
   * Creates a client that knows nothing.
   *
   * @param deltas those of the room, which all its clients share
   * @param decodes whether the client decodes; if not, it acks all the same
   * @param lag number of sends until an ack is back, at least 1
   * @param budgetBytes budget of each send, bytes
   */
  Client(Deltas deltas, int tickRate, boolean decodes, int lag, int budgetBytes) {
    encoder = new SnapshotEncoder(deltas, EPOCH, Interest.EVERYTHING, Tables.NONE, null);
    int capacity = deltas.ring().capacity();
    decoder = decodes ? new SnapshotDecoder(capacity, EPOCH, 0, tickRate) : null;
    ackSequence = new int[lag];
    ackBits = new long[lag];
    budget = budgetBytes;
  }

  /** Sends the newest frame and returns the payload bytes of all its datagrams. */
  int send() {
    int at = sends % ackSequence.length;
    if (sends >= ackSequence.length) {
      encoder.receiveAck(ackSequence[at], ackBits[at]);
    }
    sends++;
    int bytes = 0;
    if (!encoder.nothingNew(own)) {
      encoder.begin(feedback, own, budget);
      for (int n; (n = encoder.next(buffer)) > 0; ) {
        bytes += n;
        if (decoder != null && decoder.decode(buffer, 0, n) != DecodeStatus.OK) {
          throw new IllegalStateException("a datagram could not be decoded");
        }
      }
    }
    ackSequence[at] = encoder.sequence() & 0xffff;
    ackBits[at] = -1;
    return bytes;
  }
}
