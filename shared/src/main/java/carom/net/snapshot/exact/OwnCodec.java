package carom.net.snapshot.exact;

import carom.net.codec.BitPass;
import carom.net.codec.Bits;
import carom.net.snapshot.relay.RelayCodec;

/**
 * Codes the own section: the exact state of the player's own body and the set of relayed players,
 * as a difference from a baseline. One description serves writing and reading.
 */
public final class OwnCodec {
  private static final int SLOT_BITS = 16;
  private static final int GENERATION_BITS = 8;

  private OwnCodec() {}

  /**
   * Codes the section.
   *
   * @param baseline the state that both sides know, or a new state if there is none
   * @param own the section to write; a reader fills all of it except the near state
   */
  public static void code(BitPass c, OwnState baseline, OwnState own) {
    boolean changed = c.flag(!own.sameSection(baseline));
    if (c.isReading()) {
      own.set(baseline);
    }
    if (!changed) {
      return;
    }
    if (c.flag(own.slot != baseline.slot || own.generation != baseline.generation)) {
      boolean hasBody = c.flag(own.slot >= 0);
      own.slot = hasBody ? c.plain(own.slot, SLOT_BITS) : -1;
      own.generation = hasBody ? c.plain(own.generation, GENERATION_BITS) : 0;
    }
    for (int i = 0; i < own.values.length; i++) {
      int from = form(i, baseline.values[i]);
      own.values[i] = form(i, from + c.difference(form(i, own.values[i]) - from));
    }
    if (c.flag(!own.relayed.sameAs(baseline.relayed))) {
      RelayCodec.players(c, own.relayed);
    }
  }

  /**
   * Converts the bits of a float to ints in numeric order, and leaves memory ints as they are. The
   * function is its own inverse.
   */
  private static int form(int index, int value) {
    return index < OwnState.FLOATS ? Bits.orderedBits(value) : value;
  }
}
