package carom.net.snapshot;

/**
 * What the server tells a client about its inputs, for round-trip time and clock. Mutable, reused.
 */
public final class InputFeedback {

  /** Whether the rest means anything: false before the server got the first input datagram. */
  public boolean present;

  /** Sequence number of the newest input datagram received, 16 bits. */
  public int sequence;

  /**
   * How long the server held it before it sent this snapshot, milliseconds, 0..255 (255 = or
   * longer).
   */
  public int holdMs;

  /** Tick of the newest input that was consumed (a repeated one doesn't count). */
  public int consumedTick;

  /**
   * How many ticks the newest buffered input is ahead of the snapshot's tick, -32..31, clamped.
   * Negative: inputs come too late by that many ticks.
   */
  public int margin;

  /** Creates an absent feedback. */
  public InputFeedback() {}

  /** Copies another feedback into this one. */
  public void set(InputFeedback other) {
    present = other.present;
    sequence = other.sequence;
    holdMs = other.holdMs;
    consumedTick = other.consumedTick;
    margin = other.margin;
  }
}
