package carom.server.session;

import carom.net.protocol.ClientMessage;
import carom.net.snapshot.exact.OwnState;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;

/**
 * Remembers what a session's body did in the last ticks, and judges a client's report that its
 * prediction came out otherwise.
 *
 * <p>What is proved: from the tick at which client and server were last equal in every bit, the
 * body was alone among statics and its player's inputs were all consumed, so its state followed
 * from what both sides knew. If it differs all the same, one of them computes wrongly, or something
 * moved the body that neither is physics nor belongs to the game's rules. A report that has an
 * ordinary reason proves nothing.
 *
 * <p>The room's thread; no allocation but by reports, which are rare.
 */
final class PredictionAudit {
  /** Ticks remembered. */
  static final int TICKS = 64;

  /** What a report turned out to be. */
  enum Verdict {
    /** Too old, of another body, or of ticks that were not kept. */
    UNKNOWN,
    /** The server has what the client says it predicted. */
    EQUAL,
    /** An input came too late or never. */
    INPUT_MISSING,
    /** Something that moves touched the body. */
    TOUCHED,
    /** The game moved or pushed the body by rules that clients don't run. */
    RULED,
    /** Nothing explains it. */
    UNEXPLAINED
  }

  private final OwnState[] states = new OwnState[TICKS];
  private final int[] ticks = new int[TICKS];
  private final boolean[] missing = new boolean[TICKS];
  private final boolean[] touched = new boolean[TICKS];
  private final boolean[] ruled = new boolean[TICKS];

  PredictionAudit() {
    for (int i = 0; i < TICKS; i++) {
      states[i] = new OwnState();
    }
    clear();
  }

  /** Forgets everything: another link, another client. */
  void clear() {
    Arrays.fill(ticks, -1);
  }

  /**
   * Remembers a tick.
   *
   * @param own the state after it; body and memory are copied
   * @param inputMissing whether the player's input for it wasn't there in time; see {@link
   *     #confirmInput}
   * @param wasTouched whether anything that is not static touched the body in it
   * @param wasRuled whether the game moved or pushed the body, see {@code Player.ruledTick}
   */
  void keep(int tick, OwnState own, boolean inputMissing, boolean wasTouched, boolean wasRuled) {
    int slot = tick & (TICKS - 1);
    ticks[slot] = tick;
    states[slot].setBody(own);
    missing[slot] = inputMissing;
    touched[slot] = wasTouched;
    ruled[slot] = wasRuled;
  }

  /** The player's input for a tick, if that is remembered, came after it and was what it used. */
  void confirmInput(int tick) {
    int slot = tick & (TICKS - 1);
    missing[slot] &= ticks[slot] != tick;
  }

  /** Whether the player's inputs for some ticks were there in time, as far as is remembered. */
  boolean isCertain(int after, int upTo) {
    for (int tick = after + 1; tick <= upTo; tick++) {
      if (at(tick) == null || missing[tick & (TICKS - 1)]) {
        return false;
      }
    }
    return true;
  }

  /** Judges a report; any numbers are allowed in it. */
  Verdict judge(ClientMessage.Diverged report) {
    long span = (long) report.tick() - report.equalTick();
    OwnState state = at(report.tick());
    if (state == null
        || span >= TICKS
        || state.slot() != report.slot()
        || state.generation() != report.generation()) {
      return Verdict.UNKNOWN;
    }
    boolean equal = true;
    for (int i = 0; i < ClientMessage.Diverged.BITS; i++) {
      equal &= state.bits(i) == report.bits().get(i);
    }
    if (equal) {
      return Verdict.EQUAL;
    }
    Verdict verdict = Verdict.UNEXPLAINED;
    for (int tick = report.equalTick(); tick <= report.tick(); tick++) {
      OwnState then = at(tick);
      if (then == null
          || then.slot() != report.slot()
          || then.generation() != report.generation()) {
        return Verdict.UNKNOWN;
      }
      int slot = tick & (TICKS - 1);
      if (touched[slot]) {
        verdict = Verdict.TOUCHED;
      } else if (ruled[slot] && verdict != Verdict.TOUCHED) {
        verdict = Verdict.RULED;
      } else if (missing[slot] && verdict == Verdict.UNEXPLAINED) {
        verdict = Verdict.INPUT_MISSING;
      }
    }
    return verdict;
  }

  private OwnState at(int tick) {
    int slot = tick & (TICKS - 1);
    return tick >= 0 && ticks[slot] == tick ? states[slot] : null;
  }

  /** Both states of a report that was judged to differ, for the log. */
  String describe(ClientMessage.Diverged report) {
    OwnState state = at(report.tick());
    StringBuilder text = new StringBuilder();
    List<String> names =
        List.of("x", "y", "cos", "sin", "vx", "vy", "omega", "m0", "m1", "m2", "m3");
    for (int i = 0; i < ClientMessage.Diverged.BITS; i++) {
      int here = state.bits(i);
      int there = report.bits().get(i);
      if (i < OwnState.FLOATS) {
        text.append(
            String.format(
                Locale.ROOT,
                " %s server=%s client=%s",
                names.get(i),
                Float.intBitsToFloat(here),
                Float.intBitsToFloat(there)));
      } else if (here != there) {
        text.append(
            String.format(Locale.ROOT, " %s server=%d client=%d", names.get(i), here, there));
      }
    }
    return text.toString();
  }
}
