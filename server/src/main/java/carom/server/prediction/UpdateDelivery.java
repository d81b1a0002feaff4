package carom.server.prediction;

import carom.net.snapshot.SnapshotEncoder;
import carom.net.snapshot.exact.NearMeter;
import carom.net.snapshot.exact.NearState;
import carom.net.snapshot.exact.OwnState;
import java.util.Arrays;

/**
 * Brings the rows of one exact update to the client, spread over as many snapshots as it takes. A
 * row is due until a snapshot with it is sent, and again when that snapshot is lost.
 *
 * <p>The room's thread; allocates only to grow.
 */
final class UpdateDelivery {
  /** List and rows of one snapshot take at most this much, bits: less than a datagram. */
  private static final int PART_BITS = 5_500;

  /**
   * On a line that loses datagrams, an update of at most this many parts is sent twice: waiting for
   * a lost part costs a round trip.
   */
  private static final int TWICE_PARTS = 2;

  /** A snapshot counts as lost when one so many ticks younger has arrived. */
  private static final int OVERTAKEN_TICKS = 3;

  /** Most parts that are in flight. */
  private static final int PARTS = 64;

  private final NearMeter meter = new NearMeter();
  private boolean[] due = new boolean[16];
  private int dueRows;
  private int totalRows;

  /** True if a snapshot has said that there is an update; one without rows says nothing else. */
  private boolean announced;

  /** True if all of the update has been sent, though perhaps not all has arrived. */
  private boolean sentOnce;

  // The part in the snapshot that is being prepared.
  private boolean hasPart;
  private int firstRow;
  private int partRows;

  // Parts in flight.
  private final int[] sentTick = new int[PARTS];
  private final int[] sentFirst = new int[PARTS];
  private final int[] sentRows = new int[PARTS];
  private int sentParts;

  // Parts of earlier updates in flight whose rows no later update tells again.
  private final int[] earlierTick = new int[PARTS];
  private int earlierParts;
  private boolean isEarlierPartLost;

  /** Begins with an update of some rows, all of which are due. */
  void begin(int rows) {
    totalRows = rows;
    if (due.length < rows) {
      due = new boolean[Math.max(2 * due.length, rows)];
    }
    sentOnce = false;
    sentParts = 0;
    allDue();
  }

  private void allDue() {
    dueRows = totalRows;
    Arrays.fill(due, 0, totalRows, true);
    announced = false;
  }

  /** Returns whether something is left to send. */
  boolean isDue() {
    return dueRows > 0 || !announced;
  }

  int dueRows() {
    return dueRows;
  }

  boolean wasSentOnce() {
    return sentOnce;
  }

  /**
   * Goes on watching the parts that are in flight after another update has begun, which doesn't
   * tell their rows again. Call it before {@link #begin}.
   */
  void keepEarlier() {
    isEarlierPartLost |= earlierParts + sentParts > PARTS;
    int kept = Math.min(sentParts, PARTS - earlierParts);
    System.arraycopy(sentTick, 0, earlierTick, earlierParts, kept);
    earlierParts += kept;
  }

  /** Forgets the parts of earlier updates, because the client is told all. */
  void forgetEarlier() {
    earlierParts = 0;
    isEarlierPartLost = false;
  }

  /** Returns whether a part of an earlier update is lost, and no later update tells its rows. */
  boolean isEarlierPartLost() {
    return isEarlierPartLost;
  }

  /** Prepares a snapshot without a part. */
  void skip() {
    hasPart = false;
    partRows = 0;
  }

  /**
   * Prepares a snapshot with the next part; without one while there are rows but no room for them.
   *
   * @param age ticks since the base
   * @param rowBits what rows may take; a row that is longer goes alone
   */
  void write(UpdateRows rows, int age, int rowBits, OwnState out) {
    skip();
    if (dueRows > 0 && rowBits <= 0) {
      return;
    }
    hasPart = true;
    NearState near = out.near();
    firstRow = 0;
    while (firstRow < totalRows && !due[firstRow]) {
      firstRow++;
    }
    near.beginPart(age, rows.counts(), firstRow);
    for (int i = 0; i < rows.toldCount(); i++) {
      near.tell(rows.told(i));
    }
    int room = Math.min(rowBits, PART_BITS - near.listBits());
    meter.begin(out);
    for (int row = firstRow;
        row < totalRows && due[row] && partRows < NearState.MAX_PART;
        row++, partRows++) {
      meter.add(rows.kind(row), rows.source(row), rows.at(row));
      if (meter.bits() > room && partRows > 0) {
        break;
      }
      near.addRow(rows.source(row), rows.at(row));
    }
  }

  /**
   * Notes that the snapshot was sent.
   *
   * @param lossy whether the line loses datagrams
   * @return whether the last row that was due is out
   */
  boolean sent(int tick, boolean lossy) {
    if (!hasPart) {
      return false;
    }
    hasPart = false;
    announced = true;
    Arrays.fill(due, firstRow, firstRow + partRows, false);
    dueRows -= partRows;
    if (sentParts < PARTS) {
      sentTick[sentParts] = tick;
      sentFirst[sentParts] = firstRow;
      sentRows[sentParts] = partRows;
      sentParts++;
    }
    if (dueRows > 0) {
      return false;
    }
    if (lossy && !sentOnce && sentParts <= TWICE_PARTS) {
      allDue();
    }
    sentOnce = true;
    return true;
  }

  /**
   * Looks which parts have arrived, and which are lost and due again.
   *
   * @return whether all has arrived
   */
  boolean acknowledge(SnapshotEncoder encoder) {
    int open = 0;
    for (int i = 0; i < sentParts; i++) {
      if (encoder.hasAckedOwn(sentTick[i])) {
        continue;
      }
      if (encoder.ownAckedTick() - sentTick[i] >= OVERTAKEN_TICKS) {
        lose(i);
        continue;
      }
      sentTick[open] = sentTick[i];
      sentFirst[open] = sentFirst[i];
      sentRows[open] = sentRows[i];
      open++;
    }
    sentParts = open;
    return open == 0 && !isDue();
  }

  /** Takes all parts in flight for lost, unless some rows are due anyway. */
  void sendMissingAgain() {
    if (isDue()) {
      return;
    }
    for (int i = 0; i < sentParts; i++) {
      lose(i);
    }
    sentParts = 0;
  }

  private void lose(int part) {
    dueAgain(sentFirst[part], sentRows[part]);
    announced &= sentRows[part] > 0;
  }

  /** Looks which parts of earlier updates have arrived, and which are lost. */
  void acknowledgeEarlier(SnapshotEncoder encoder) {
    int open = 0;
    for (int i = 0; i < earlierParts; i++) {
      if (encoder.hasAckedOwn(earlierTick[i])) {
        continue;
      }
      if (encoder.ownAckedTick() - earlierTick[i] >= OVERTAKEN_TICKS) {
        isEarlierPartLost = true;
        continue;
      }
      earlierTick[open++] = earlierTick[i];
    }
    earlierParts = open;
  }

  /** Marks the rows of a lost part as due. The loss of another copy may have marked some before. */
  private void dueAgain(int first, int count) {
    for (int row = first; row < first + count; row++) {
      dueRows += due[row] ? 0 : 1;
      due[row] = true;
    }
  }
}
