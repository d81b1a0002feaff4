package carom.server.prediction;

import carom.net.protocol.ClientMessage.Diverged;
import carom.net.snapshot.exact.OwnState;
import carom.physics.rows.Rows;
import carom.sim.near.Neighbourhood;
import java.util.Arrays;
import java.util.Locale;

/**
 * Remembers the exact states of the last {@value #TICKS} ticks of which a session's client was
 * told, and judges the client's reports that it predicted others.
 *
 * <p>A report is about the own body alone, or about the predicted set, of which the first {@value
 * Diverged#MAX_BODIES} bodies are remembered. Either way it names a tick at which client and server
 * were equal in every bit. If since then all inputs came in time and nothing else had an influence,
 * the state followed from what both sides knew. If it differs all the same, the client and the
 * server disagree although they used the same inputs: a bug. A report that has an ordinary reason
 * proves nothing.
 *
 * <p>The room's thread. Allocates for reports, which are rare, and to grow: for all ticks at once,
 * 64 KiB at most.
 */
public final class PredictionAudit {
  /** Ticks remembered. */
  static final int TICKS = 64;

  private static final int BODY_INTS = Diverged.BODY_INTS;
  private static final String[] NAMES = {"x", "y", "cos", "sin", "vx", "vy", "omega"};

  /** The result of an examined report: among reasons, a later one outweighs an earlier one. */
  public enum Finding {
    /** The report is too old, of another body, or of ticks that were not kept. */
    UNKNOWN,
    /** The server has what the client says it predicted, as far as the report goes. */
    EQUAL,
    /** Nothing explains the difference. */
    UNEXPLAINED,
    /** An input came too late or never. */
    INPUT_MISSING,
    /** Another player's input read a field of which the client isn't told. */
    FIELD_HIDDEN,
    /** The game, or a body outside the predicted set, had an influence. */
    INTERFERED,
    /** Something that moves touched the body, which the report says was alone. */
    TOUCHED
  }

  private final int[] ticks = new int[TICKS];
  private final boolean[] inputMissing = new boolean[TICKS];

  // Of the own body.
  private final int ownInts;
  private final int[] own;
  private final boolean[] touched = new boolean[TICKS];
  private final boolean[] interfered = new boolean[TICKS];

  // Of the predicted set.
  private final boolean[] hasSet = new boolean[TICKS];
  private final boolean[] hasOutsideCause = new boolean[TICKS];
  private final boolean[] hasHiddenCause = new boolean[TICKS];

  /** Bodies of which the state is kept; 0 when the client was told nothing of that tick. */
  private final int[] count = new int[TICKS];

  /** The number of bodies that there is room for in each tick. */
  private int room;

  private int[] bodies = new int[0];

  /**
   * Creates an audit that remembers nothing.
   *
   * @param words number of words of the player's fields in each state
   */
  public PredictionAudit(int words) {
    ownInts = BODY_INTS + Math.min(words, Diverged.MAX_WORDS);
    own = new int[TICKS * ownInts];
    clear();
  }

  /** Forgets everything: the session has another link, hence another client. */
  public void clear() {
    Arrays.fill(ticks, -1);
  }

  /**
   * Remembers a tick.
   *
   * @param state the state after it; body and words are copied
   * @param isInputMissing whether the player's input for it wasn't there in time; see {@link
   *     #confirmInput}
   * @param wasTouched whether anything that is not static touched the body in it
   * @param wasInterfered whether the game moved or pushed the body in it
   */
  public void keep(
      int tick, OwnState state, boolean isInputMissing, boolean wasTouched, boolean wasInterfered) {
    int slot = slot(tick);
    ticks[slot] = tick;
    int at = slot * ownInts;
    own[at] = state.slot() < 0 ? -1 : Neighbourhood.key(state.slot(), state.generation());
    for (int i = 1; i < ownInts; i++) {
      own[at + i] = state.bits(i - 1);
    }
    inputMissing[slot] = isInputMissing;
    touched[slot] = wasTouched;
    interfered[slot] = wasInterfered;
    hasSet[slot] = false;
    count[slot] = 0;
  }

  /**
   * Remembers that a tick, which was kept, has a predicted set.
   *
   * @param withOutsideCause whether its state has another cause than the state before and inputs
   * @param withHiddenCause whether another player's input read what the client isn't told
   */
  public void keepSet(int tick, boolean withOutsideCause, boolean withHiddenCause) {
    int slot = slot(tick);
    if (ticks[slot] == tick) {
      hasSet[slot] = true;
      hasOutsideCause[slot] = withOutsideCause;
      hasHiddenCause[slot] = withHiddenCause;
    }
  }

  /** Remembers the state of a kept tick's predicted set, whose hash the client is told; copied. */
  public void keepSetState(int tick, Neighbourhood state) {
    int slot = slot(tick);
    if (ticks[slot] != tick) {
      return;
    }
    int n = Math.min(state.count(), Diverged.MAX_BODIES);
    ensure(n);
    Rows from = state.rows().bodies();
    for (int i = 0; i < n; i++) {
      System.arraycopy(from.ints(), from.at(i), bodies, at(slot, i), BODY_INTS);
    }
    count[slot] = n;
  }

  /** Makes room in all ticks at once, so that not each of them allocates when its turn comes. */
  private void ensure(int n) {
    if (n <= room) {
      return;
    }
    int grown = Math.min(Diverged.MAX_BODIES, 2 * n);
    int[] roomy = new int[TICKS * grown * BODY_INTS];
    for (int slot = 0; slot < TICKS; slot++) {
      System.arraycopy(bodies, at(slot, 0), roomy, slot * grown * BODY_INTS, room * BODY_INTS);
    }
    bodies = roomy;
    room = grown;
  }

  private int at(int slot, int body) {
    return (slot * room + body) * BODY_INTS;
  }

  private static int slot(int tick) {
    return tick & (TICKS - 1);
  }

  /** Notes that the input for a tick, if that is kept, came late but was the one that was used. */
  public void confirmInput(int tick) {
    inputMissing[slot(tick)] &= ticks[slot(tick)] != tick;
  }

  /** Judges a report. Any numbers are allowed in it. */
  public Finding judge(Diverged report) {
    int last = slot(report.tick());
    if ((long) report.tick() - report.equalTick() >= TICKS
        || !isKept(report.tick(), report)
        || (report.ofSet() && count[last] == 0)) {
      return Finding.UNKNOWN;
    }
    int different = firstDifferent(report);
    if (different < 0) {
      return Finding.EQUAL;
    }
    if (different % BODY_INTS == 0 && different < report.bodies().size()) {
      return Finding.UNKNOWN; // of another body
    }
    Finding finding = Finding.UNEXPLAINED;
    int first = report.ofSet() ? report.equalTick() + 1 : report.equalTick();
    for (int tick = first; tick <= report.tick(); tick++) {
      if (!isKept(tick, report)) {
        return Finding.UNKNOWN;
      }
      Finding reason = reason(slot(tick), report.ofSet());
      finding = reason.compareTo(finding) > 0 ? reason : finding;
    }
    return finding;
  }

  private boolean isKept(int tick, Diverged report) {
    int slot = slot(tick);
    if (tick < 0 || ticks[slot] != tick) {
      return false;
    }
    return report.ofSet() ? hasSet[slot] : own[slot * ownInts] == report.bodies().get(0);
  }

  private Finding reason(int slot, boolean ofSet) {
    if (!ofSet && touched[slot]) {
      return Finding.TOUCHED;
    }
    if (ofSet ? hasOutsideCause[slot] : interfered[slot]) {
      return Finding.INTERFERED;
    }
    if (ofSet && hasHiddenCause[slot]) {
      return Finding.FIELD_HIDDEN;
    }
    return inputMissing[slot] ? Finding.INPUT_MISSING : Finding.UNEXPLAINED;
  }

  /**
   * Returns the place of the first number that differs, or -1; both lists are in the world's order.
   */
  private int firstDifferent(Diverged report) {
    int slot = slot(report.tick());
    int n = report.ofSet() ? count[slot] * BODY_INTS : ownInts;
    for (int i = 0; i < Math.min(n, report.count()); i++) {
      if (report.number(i) != kept(report, i)) {
        return i;
      }
    }
    return -1;
  }

  /** Returns what the server has for a number of a report. */
  private int kept(Diverged report, int index) {
    int slot = slot(report.tick());
    return report.ofSet() ? bodies[at(slot, 0) + index] : own[slot * ownInts + index];
  }

  /** Describes both states of the first body that differs, of a report judged to differ. */
  public String describe(Diverged report) {
    StringBuilder text = new StringBuilder();
    int body = 0;
    if (report.ofSet()) {
      body = firstDifferent(report) / BODY_INTS * BODY_INTS;
      int key = report.number(body);
      text.append(" entity=").append(Neighbourhood.id(key));
      text.append(" generation=").append(Neighbourhood.generation(key));
    }
    for (int i = 0; i < NAMES.length; i++) {
      float here = Float.intBitsToFloat(kept(report, body + 1 + i));
      float there = Float.intBitsToFloat(report.number(body + 1 + i));
      text.append(String.format(Locale.ROOT, " %s server=%s client=%s", NAMES[i], here, there));
    }
    for (int i = 0; i < report.words().size() && BODY_INTS + i < ownInts; i++) {
      int here = kept(report, BODY_INTS + i);
      int there = report.number(BODY_INTS + i);
      if (here != there) {
        text.append(String.format(Locale.ROOT, " word%d server=%d client=%d", i, here, there));
      }
    }
    return text.toString();
  }
}
