package carom.fuzz;

import carom.net.protocol.DatagramMark;
import carom.net.snapshot.SnapshotDecoder;
import carom.net.snapshot.SnapshotSeeds;
import carom.net.snapshot.table.TableInbox;
import java.util.List;

/** Snapshots of a hostile server, with the right mark: the pieces of an input are datagrams. */
final class SnapshotTarget implements FuzzTarget {
  private static final int MOST_DATAGRAMS = 32;
  private static final int MARK = DatagramMark.ofState(SnapshotSeeds.EPOCH);

  @Override
  public void take(byte[] data) {
    SnapshotDecoder decoder =
        new SnapshotDecoder(
            SnapshotSeeds.SLOTS,
            SnapshotSeeds.EPOCH,
            0,
            SnapshotSeeds.TICK_RATE,
            4,
            new TableInbox());
    Pieces pieces = new Pieces(data);
    int count = 0;
    for (byte[] piece = pieces.next();
        piece != null && count < MOST_DATAGRAMS;
        piece = pieces.next(), count++) {
      if (piece.length > 0) {
        piece[0] = (byte) (piece[0] & -1 << DatagramMark.BITS | MARK);
      }
      decoder.decode(piece, 0, piece.length);
      for (int i = 0; i < decoder.touchedCount(); i++) {
        int slot = decoder.touchedSlot(i);
        if (slot < 0 || slot >= SnapshotSeeds.SLOTS) {
          throw new AssertionError("touched slot=" + slot);
        }
      }
    }
  }

  @Override
  public List<byte[]> seeds() {
    return List.of(
        Pieces.of(SnapshotSeeds.datagrams(1, 3)),
        Pieces.of(SnapshotSeeds.datagrams(2, 12)),
        Pieces.of(SnapshotSeeds.datagrams(3, 30)));
  }
}
