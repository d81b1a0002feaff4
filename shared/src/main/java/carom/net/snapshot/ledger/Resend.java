package carom.net.snapshot.ledger;

/**
 * Says when a section sends again what hasn't arrived. What {@link DatagramLedger} acknowledges is
 * never sent again.
 *
 * @param copies number of snapshots in a row that hold something new, at least 1
 * @param lossyCopies the same on a line that {@linkplain DatagramLedger#isLossy loses datagrams}
 * @param again what is waited for after these
 */
public record Resend(int copies, int lossyCopies, Again again) {
  /** The reason for which something is sent again. */
  public enum Again {
    /** The section sends it in each snapshot. */
    EACH_SNAPSHOT,
    /** The section sends it when its acknowledgement is overdue; see {@link DatagramLedger}. */
    WHEN_OVERDUE,
    /** The section sends it when the ledger tells that all its copies are lost. */
    WHEN_LOST
  }
}
