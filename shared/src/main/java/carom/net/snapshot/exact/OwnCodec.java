package carom.net.snapshot.exact;

import carom.net.codec.BitPass;
import carom.net.codec.Bits;
import java.util.Arrays;

/**
 * Codes the own section as a difference from a baseline. The section holds the exact state of the
 * player's own body, the words of the player's fields, the set of relayed players and the list of
 * spawned entities. One description serves writing and reading.
 */
final class OwnCodec {
  private static final int SLOT_BITS = 16;
  private static final int GENERATION_BITS = 8;
  static final int ARCHETYPE_BITS = 12;

  /** Words that share a bit which says whether any of them differs. */
  private static final int GROUP = 8;

  private OwnCodec() {}

  /**
   * Codes the section.
   *
   * @param baseline the state that both sides know, or a new state of as many words if there is
   *     none
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
    if (c.flag(!own.sameIdentity(baseline))) {
      boolean hasBody = c.flag(own.slot >= 0);
      own.slot = hasBody ? c.plain(own.slot, SLOT_BITS) : -1;
      own.generation = hasBody ? c.plain(own.generation, GENERATION_BITS) : 0;
      own.archetype = hasBody ? c.plain(own.archetype, ARCHETYPE_BITS) : 0;
    }
    for (int i = 0; i < OwnState.FLOATS; i++) {
      int from = Bits.orderedBits(baseline.values[i]);
      int to = Bits.orderedBits(own.values[i]);
      own.values[i] = Bits.orderedBits(from + c.difference(to - from));
    }
    words(c, baseline.values, own.values);
    if (c.flag(!own.relayed.sameAs(baseline.relayed))) {
      RelayCodec.players(c, own.relayed);
    }
    if (c.flag(!own.spawned().sameAs(baseline.spawned()))) {
      SpawnList.code(c, baseline.spawned(), own.spawned());
    }
  }

  private static void words(BitPass c, int[] baseline, int[] own) {
    for (int from = OwnState.FLOATS; from < own.length; from += GROUP) {
      int to = Math.min(own.length, from + GROUP);
      if (c.flag(!Arrays.equals(own, from, to, baseline, from, to))) {
        for (int i = from; i < to; i++) {
          own[i] = baseline[i] + c.difference(own[i] - baseline[i]);
        }
      }
    }
  }
}
