package carom.server.session;

import carom.net.protocol.ClientMessage.DivergedNear;
import carom.sim.Neighbourhood;
import java.util.Arrays;
import java.util.Locale;

/**
 * Remembers the exact states of which a session's client was told the hash, and judges its report
 * that it computed another one: as {@link PredictionAudit}, of what is near the player's body. Of a
 * long list it knows the first {@value DivergedNear#MAX_BODIES} bodies.
 *
 * <p>The room's thread; allocates only to grow, for all ticks at once: 64 KiB at most, for long
 * lists.
 */
final class NearAudit {
  private static final int TICKS = PredictionAudit.TICKS;
  private static final int INTS = DivergedNear.BODY_INTS;
  private static final String[] NAMES = {"x", "y", "cos", "sin", "vx", "vy", "omega"};

  private final int[] ticks = new int[TICKS];
  private final boolean[] surprising = new boolean[TICKS];

  /** Bodies of which the state is kept; 0 when nothing was told of that tick. */
  private final int[] count = new int[TICKS];

  /** How many bodies of a tick there is room for. */
  private int room;

  private int[] bodies = new int[0];

  NearAudit() {
    clear();
  }

  /** Forgets everything: another link, another client. */
  void clear() {
    Arrays.fill(ticks, -1);
  }

  /**
   * Remembers a tick.
   *
   * @param wasSurprising whether its state follows from more than the one before and the inputs
   */
  void keep(int tick, boolean wasSurprising) {
    int slot = tick & (TICKS - 1);
    ticks[slot] = tick;
    surprising[slot] = wasSurprising;
    count[slot] = 0;
  }

  /** Remembers the state of a tick that was kept, as its hash is told to the client; copied. */
  void keepState(int tick, Neighbourhood state) {
    int slot = tick & (TICKS - 1);
    if (ticks[slot] != tick) {
      return;
    }
    int n = Math.min(state.count(), DivergedNear.MAX_BODIES);
    ensure(n);
    for (int i = 0; i < n; i++) {
      System.arraycopy(state.entities(), i * Neighbourhood.ENTITY_INTS, bodies, at(slot, i), INTS);
    }
    count[slot] = n;
  }

  /** Makes room in each tick, so that not each of them allocates when its turn comes. */
  private void ensure(int n) {
    if (n <= room) {
      return;
    }
    int grown = Math.min(DivergedNear.MAX_BODIES, 2 * n);
    int[] roomy = new int[TICKS * grown * INTS];
    for (int slot = 0; slot < TICKS; slot++) {
      System.arraycopy(bodies, at(slot, 0), roomy, slot * grown * INTS, room * INTS);
    }
    bodies = roomy;
    room = grown;
  }

  private int at(int slot, int body) {
    return (slot * room + body) * INTS;
  }

  /**
   * Judges a report; any numbers are allowed in it. Says nothing of the player's own inputs.
   *
   * @return {@code EQUAL} too when what differs is in none of the bodies told
   */
  PredictionAudit.Verdict judge(DivergedNear report) {
    long span = (long) report.tick() - report.equalTick();
    if (span >= TICKS || !isKept(report.tick()) || count[report.tick() & (TICKS - 1)] == 0) {
      return PredictionAudit.Verdict.UNKNOWN;
    }
    for (int tick = report.equalTick() + 1; tick <= report.tick(); tick++) {
      if (!isKept(tick)) {
        return PredictionAudit.Verdict.UNKNOWN;
      }
      if (surprising[tick & (TICKS - 1)]) {
        return PredictionAudit.Verdict.RULED;
      }
    }
    int first = firstDifferent(report);
    if (first < 0) {
      return PredictionAudit.Verdict.EQUAL;
    }
    return first % INTS == 0
        ? PredictionAudit.Verdict.UNKNOWN // of another body: the lists aren't the same
        : PredictionAudit.Verdict.UNEXPLAINED;
  }

  private boolean isKept(int tick) {
    return tick >= 0 && ticks[tick & (TICKS - 1)] == tick;
  }

  /** The first number that differs, or -1; both lists are in the order of the world. */
  private int firstDifferent(DivergedNear report) {
    int slot = report.tick() & (TICKS - 1);
    int n = Math.min(report.bodies().size(), count[slot] * INTS);
    for (int i = 0; i < n; i++) {
      if (report.bodies().get(i) != bodies[at(slot, 0) + i]) {
        return i;
      }
    }
    return -1;
  }

  /** Both states of the first body that differs, of a report judged to differ, for the log. */
  String describe(DivergedNear report) {
    int at = firstDifferent(report) / INTS * INTS;
    int own = at(report.tick() & (TICKS - 1), 0) + at;
    StringBuilder text =
        new StringBuilder()
            .append(" entity=")
            .append(Neighbourhood.id(bodies[own]))
            .append(" generation=")
            .append(Neighbourhood.generation(bodies[own]));
    for (int i = 0; i < NAMES.length; i++) {
      text.append(
          String.format(
              Locale.ROOT,
              " %s server=%s client=%s",
              NAMES[i],
              Float.intBitsToFloat(bodies[own + 1 + i]),
              Float.intBitsToFloat(report.bodies().get(at + 1 + i))));
    }
    return text.toString();
  }
}
