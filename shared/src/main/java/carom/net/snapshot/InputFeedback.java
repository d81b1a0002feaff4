package carom.net.snapshot;

/**
 * Tells a client how its inputs arrive at the server, for round-trip time, clock and prediction: an
 * input of the snapshot's tick that no datagram up to this one had was replaced. Mutable, reused.
 */
public final class InputFeedback {

  /** True if the server got any input datagram; if not, the other fields mean nothing. */
  public boolean present;

  /** Sequence number of the newest input datagram received, 16 bits. */
  public int sequence;

  /**
   * Time from that datagram's arrival to the sending of this snapshot, ms, 0..255; 255 stands for
   * anything longer.
   */
  public int holdMs;

  /**
   * Number of ticks that the newest buffered input is ahead of the snapshot's tick, -32..31. If
   * negative, inputs come too late by that many ticks.
   */
  public int margin;

  /** Creates an absent feedback. */
  public InputFeedback() {}

  /** Copies another feedback into this one. */
  public void set(InputFeedback other) {
    present = other.present;
    sequence = other.sequence;
    holdMs = other.holdMs;
    margin = other.margin;
  }
}
