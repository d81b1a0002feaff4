package carom.net.snapshot;

import carom.net.codec.BitPass;
import carom.net.codec.Sequence;
import carom.net.protocol.DatagramMark;
import carom.net.snapshot.frame.FrameRing;

/**
 * The head of a snapshot datagram, described once for writing and reading. Mutable, reused; a
 * reader's values mean something only if the mark is right and all bits were there.
 */
final class DatagramHead {
  private static final int SEQUENCE_BITS = 16;
  private static final int TICK_BITS = 16;
  private static final int HOLD_BITS = 8;
  private static final int MAX_HOLD = (1 << HOLD_BITS) - 1;
  private static final int MARGIN_BITS = 6;
  private static final int MIN_MARGIN = -(1 << (MARGIN_BITS - 1));

  /** The datagram's epoch, and the sections that it carries. */
  int mark;

  /** Sequence number of the datagram, 16 bits. */
  int sequence;

  /** Tick whose state the datagram tells. */
  int tick;

  /** True if the client is asked to ack soon. */
  boolean news;

  /** The server's feedback about the client's inputs. */
  final InputFeedback feedback = new InputFeedback();

  /** True if an own section, inputs and a near section follow. */
  boolean hasOwn;

  /** Age of the baseline of the own section, ticks; 0 = none. */
  int ownAge;

  /**
   * Codes the head.
   *
   * @param nearTick a tick that is less than 32,768 away from the datagram's, for readers
   */
  void code(BitPass c, int nearTick) {
    mark = c.plain(mark, DatagramMark.BITS);
    sequence = c.plain(sequence, SEQUENCE_BITS);
    tick = Sequence.expand(c.plain(tick, TICK_BITS), c.isReading() ? nearTick : tick);
    news = c.flag(news);
    feedback(c);
    hasOwn = c.flag(hasOwn);
    ownAge = hasOwn ? c.plain(ownAge, FrameRing.AGE_BITS) : 0;
  }

  private void feedback(BitPass c) {
    InputFeedback f = feedback;
    f.present = c.flag(f.present);
    if (!f.present) {
      return;
    }
    f.sequence = c.plain(f.sequence, SEQUENCE_BITS);
    f.holdMs = c.plain(Math.max(0, Math.min(MAX_HOLD, f.holdMs)), HOLD_BITS);
    int margin = Math.max(MIN_MARGIN, Math.min(-1 - MIN_MARGIN, f.margin));
    int shift = Integer.SIZE - MARGIN_BITS;
    f.margin = c.plain(margin, MARGIN_BITS) << shift >> shift;
  }
}
