package carom.net.snapshot.exact;

import carom.net.snapshot.ledger.DatagramLedger;
import carom.net.snapshot.ledger.Resend;
import carom.physics.rows.RowCounts;
import java.util.Arrays;

/**
 * Brings the rows of one exact update to the client, spread over as many snapshots as it takes. A
 * row is due until a snapshot with it is sent, and again when that snapshot is lost and no other
 * with it has arrived.
 *
 * <p>One thread; allocates only to grow.
 */
public final class UpdateDelivery implements DatagramLedger.Section {
  /** The rows of an update, and the entities of the list that it tells. */
  public interface Content {
    /** Returns the number of rows by kind. The counts are live. */
    RowCounts counts();

    /** Returns the number of told entities. Their rows come first. */
    int toldCount();

    /** Returns the place in the list of a told entity. */
    int told(int index);

    /** Returns the array that holds a row, from {@link #at} on. */
    int[] source(int row);

    /** Returns where a row begins in {@link #source}. */
    int at(int row);
  }

  /**
   * On a line that loses datagrams a short update is sent twice: a lost part costs a round trip.
   */
  private static final Resend RESEND = new Resend(1, 2, Resend.Again.WHEN_LOST);

  /** Most parts of an update that is short. */
  private static final int SHORT_PARTS = 2;

  /** List and rows of one snapshot take at most this much, bits: less than a datagram. */
  private static final int PART_BITS = 5_500;

  private static final int MASK = DatagramLedger.SIZE - 1;

  private final DatagramLedger ledger;
  private final NearMeter meter = new NearMeter();

  // By row. Of an update without rows, row 0 stands for saying that there is one.
  private boolean[] due = new boolean[16];
  private boolean[] arrived = new boolean[16];
  private int totalRows;
  private int dueRows;
  private int missingRows;

  /** True if all of the update has been sent, though perhaps not all has arrived. */
  private boolean sentOnce;

  /** Tick of the snapshot that had the last row that was due, of any update; -1 before. */
  private int sentTick = -1;

  // The part in the snapshot that is being prepared.
  private boolean hasPart;
  private int firstRow;
  private int partRows;

  /** Number of the update that is sent. It goes up when parts of it are no longer waited for. */
  private int number;

  /** Parts that were sent under that number. */
  private int sentParts;

  /** By the lowest bits of a number: whether rows of it that are lost are told by none since. */
  private final boolean[] watched = new boolean[DatagramLedger.SIZE];

  private boolean isEarlierPartLost;

  /**
   * Creates a delivery of nothing.
   *
   * @param ledger of the datagrams that own sections are written into
   */
  public UpdateDelivery(DatagramLedger ledger) {
    this.ledger = ledger;
  }

  /** Begins with an update of some rows, all of which are due. */
  public void begin(int rows) {
    totalRows = rows;
    missingRows = Math.max(1, rows);
    if (due.length < rows) {
      due = new boolean[Math.max(2 * due.length, rows)];
      arrived = new boolean[due.length];
    }
    Arrays.fill(arrived, 0, missingRows, false);
    sentOnce = false;
    nextNumber();
    allDue();
  }

  private void nextNumber() {
    if (sentParts > 0) {
      number++; // so there are no more numbers than datagrams on their way
      sentParts = 0;
    }
    watched[number & MASK] = false;
  }

  /** Makes all rows due that have not arrived. */
  private void allDue() {
    dueRows = missingRows;
    for (int row = 0; row < Math.max(1, totalRows); row++) {
      due[row] = !arrived[row];
    }
  }

  /** Returns whether something is left to send. */
  public boolean isDue() {
    return dueRows > 0;
  }

  /** Returns the number of rows that are left to send. */
  public int dueRows() {
    return Math.min(dueRows, totalRows);
  }

  /** Returns whether all of the update has been sent, though perhaps not all has arrived. */
  public boolean wasSentOnce() {
    return sentOnce;
  }

  /** Returns the tick of the snapshot with the last row that was due, of any update; -1 before. */
  public int sentTick() {
    return sentTick;
  }

  /** Returns whether all of the update has arrived. */
  public boolean hasArrived() {
    return missingRows == 0;
  }

  /**
   * Goes on watching the parts that are in flight after another update has begun, which doesn't
   * tell their rows again. Call it before {@link #begin}.
   */
  public void keepEarlier() {
    if (sentParts > 0) {
      watched[number++ & MASK] = true;
      sentParts = 0;
    }
  }

  /** Forgets the parts of earlier updates, because the client is told all. */
  public void forgetEarlier() {
    Arrays.fill(watched, false);
    isEarlierPartLost = false;
  }

  /** Returns whether a part of an earlier update is lost, and no later update tells its rows. */
  public boolean isEarlierPartLost() {
    return isEarlierPartLost;
  }

  /** Forgets the update and all before it. */
  public void clear() {
    skip();
    nextNumber();
    forgetEarlier();
  }

  /** Prepares a snapshot without a part. */
  public void skip() {
    hasPart = false;
    partRows = 0;
  }

  /**
   * Prepares a snapshot with the next part; without one while there are rows but no room for them.
   *
   * @param age ticks since the base
   * @param rowBits what rows may take; a row that is longer goes alone
   */
  public void write(Content rows, int age, int rowBits, OwnState out) {
    skip();
    if (totalRows > 0 && rowBits <= 0) {
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
      meter.add(rows.counts().kind(row), rows.source(row), rows.at(row));
      if (meter.bits() > room && partRows > 0) {
        break;
      }
      near.addRow(rows.source(row), rows.at(row));
    }
  }

  /**
   * Notes that the datagram begun last holds the part prepared last.
   *
   * @param tick of the datagram
   */
  public void wrote(int tick) {
    if (!hasPart) {
      return;
    }
    hasPart = false;
    sentParts++;
    int rows = Math.max(1, partRows);
    ledger.append(this, number, (long) firstRow << Integer.SIZE | rows);
    for (int row = firstRow; row < firstRow + rows; row++) {
      dueRows -= due[row] ? 1 : 0;
      due[row] = false;
    }
    if (dueRows > 0) {
      return;
    }
    if (!sentOnce && sentParts <= SHORT_PARTS && ledger.copies(RESEND, tick) > 1) {
      allDue();
    }
    sentOnce = true;
    sentTick = tick;
  }

  @Override
  public void acknowledged(int tick, int update, long rows) {
    if (update != number) {
      return;
    }
    int first = (int) (rows >> Integer.SIZE);
    for (int row = first; row < first + (int) rows; row++) {
      missingRows -= arrived[row] ? 0 : 1;
      dueRows -= due[row] ? 1 : 0;
      arrived[row] = true;
      due[row] = false;
    }
  }

  @Override
  public void lost(int tick, int update, long rows) {
    if (update != number) {
      isEarlierPartLost |= watched[update & MASK];
      return;
    }
    int first = (int) (rows >> Integer.SIZE);
    for (int row = first; row < first + (int) rows; row++) {
      dueRows += due[row] || arrived[row] ? 0 : 1;
      due[row] = !arrived[row];
    }
  }

  /** Takes all parts in flight for lost, unless some rows are due anyway. */
  public void sendMissingAgain() {
    if (!isDue()) {
      nextNumber();
      allDue();
    }
  }
}
