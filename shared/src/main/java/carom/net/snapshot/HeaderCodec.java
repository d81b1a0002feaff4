package carom.net.snapshot;

import carom.net.codec.BitReader;
import carom.net.codec.BitWriter;
import carom.net.codec.Bits;
import carom.net.snapshot.exact.OwnState;
import carom.net.snapshot.relay.RelayCodec;

/**
 * Feedback and own section: what only a tick's first datagram carries. Pairs of write and read that
 * mirror each other.
 */
final class HeaderCodec {

  private static final int MARGIN_BITS = 6;
  private static final int MIN_MARGIN = -(1 << (MARGIN_BITS - 1));

  private HeaderCodec() {}

  static void writeFeedback(BitWriter w, InputFeedback feedback, int tick) {
    w.write(feedback.present);
    if (!feedback.present) {
      return;
    }
    w.write(feedback.sequence, 16);
    w.write(Math.max(0, Math.min(255, feedback.holdMs)), 8);
    boolean current = feedback.consumedTick == tick;
    w.write(current);
    if (!current) {
      w.write(feedback.consumedTick, 32);
    }
    w.write(Math.max(MIN_MARGIN, Math.min(-1 - MIN_MARGIN, feedback.margin)), MARGIN_BITS);
  }

  static void readFeedback(BitReader r, InputFeedback feedback, int tick) {
    feedback.present = r.readBit();
    if (!feedback.present) {
      return;
    }
    feedback.sequence = r.read(16);
    feedback.holdMs = r.read(8);
    feedback.consumedTick = r.readBit() ? tick : r.read(32);
    int shift = 32 - MARGIN_BITS;
    feedback.margin = r.read(MARGIN_BITS) << shift >> shift;
  }

  /** Own state against a baseline; the all-zero state is the baseline of the first. */
  static void writeOwn(BitWriter w, OwnState baseline, OwnState own) {
    boolean changed = !own.sameSection(baseline);
    w.write(changed);
    if (!changed) {
      return;
    }
    boolean other = own.slot != baseline.slot || own.generation != baseline.generation;
    w.write(other);
    if (other) {
      w.write(own.slot >= 0);
      if (own.slot >= 0) {
        w.write(own.slot, 16);
        w.write(own.generation, 8);
      }
    }
    for (int i = 0; i < own.values.length; i++) {
      Bits.writeDifference(w, form(i, own.values[i]) - form(i, baseline.values[i]));
    }
    boolean others = !own.relayed.sameAs(baseline.relayed);
    w.write(others);
    if (others) {
      RelayCodec.writePlayers(w, own.relayed);
    }
  }

  static void readOwn(BitReader r, OwnState baseline, OwnState own) {
    own.set(baseline);
    if (!r.readBit()) {
      return;
    }
    if (r.readBit()) {
      boolean body = r.readBit();
      own.slot = body ? r.read(16) : -1;
      own.generation = body ? r.read(8) : 0;
    }
    for (int i = 0; i < own.values.length; i++) {
      own.values[i] = form(i, form(i, baseline.values[i]) + Bits.readDifference(r));
    }
    if (r.readBit()) {
      RelayCodec.readPlayers(r, own.relayed);
    }
  }

  /**
   * Floats are compared in the order of numbers, memory as it is; the same function there and back.
   */
  private static int form(int index, int value) {
    return index < OwnState.FLOATS ? Bits.orderedBits(value) : value;
  }
}
