package carom.net.snapshot;

import carom.net.codec.BitCoder;
import carom.net.codec.BitTable;
import java.util.Arrays;

/**
 * The deltas of a room's newest frame, each worked out once for all sessions: how a body differs
 * from what is predicted out of an older frame, as steps for {@link
 * carom.net.codec.RangeEncoder#code(BitTable, char[], int, int)}. Most sessions have acked one of a
 * few ticks, so what one of them needs is mostly there already. Where room for all of them ends,
 * the rest is worked out each time.
 *
 * <p>One thread, no allocation in the steady state. Memory: 256 bytes per slot and up to 2 MiB.
 */
final class Deltas {

  private static final int MIN_SLOTS = 64;
  private static final int MIN_LENGTH = 1 << 12;
  private static final int MAX_LENGTH = 1 << 20;

  /** More than any delta takes. */
  private static final int MAX_DELTA = BitTable.MAX_MARKED;

  // Before the steps of a delta: its situation and way, and their number.
  private static final int WAY_BITS = 2;
  private static final int HEAD = 2;

  private final int tickRate;
  private final Predictor predictor;
  private final Recorder recorder = new Recorder();
  private final Motion old = new Motion();
  private final Motion actual = new Motion();
  private final Motion residual = new Motion();

  /** By age and slot: where in {@link #steps} the delta begins, plus 1; 0 when it isn't there. */
  private int[] known = {};

  private int slots;
  private long agesKnown;
  private char[] steps = new char[MIN_LENGTH + MAX_DELTA];
  private int written;
  private int tick = -1;

  Deltas(int tickRate, float gravityX, float gravityY) {
    this.tickRate = tickRate;
    predictor = new Predictor(tickRate);
    predictor.gravity(gravityX, gravityY);
  }

  int tickRate() {
    return tickRate;
  }

  /**
   * The delta of a slot between two frames.
   *
   * @param now the ring's newest frame
   * @param held an older one that holds the slot
   * @return for {@link #way} and the others, until the next call
   */
  int of(FrameState now, FrameState held, int slot) {
    if (now.tick() != tick) {
      forget(now);
    }
    int age = now.tick() - held.tick();
    int at = age * slots + slot;
    if (known[at] > 0) {
      return known[at] - 1;
    }
    int delta = written;
    int end = record(delta, now, held, slot, age);
    if (end <= MAX_LENGTH) {
      known[at] = delta + 1;
      agesKnown |= 1L << age;
      written = end;
    }
    return delta;
  }

  private void forget(FrameState now) {
    tick = now.tick();
    written = 0;
    if (now.slotLimit() > slots) {
      slots = Math.max(MIN_SLOTS, Math.max(now.slotLimit(), 2 * slots));
      known = new int[FrameRing.SIZE * slots];
    } else {
      for (long ages = agesKnown; ages != 0; ages &= ages - 1) {
        int from = Long.numberOfTrailingZeros(ages) * slots;
        Arrays.fill(known, from, from + slots, 0);
      }
    }
    agesKnown = 0;
  }

  private int record(int delta, FrameState now, FrameState held, int slot, int age) {
    if (delta + MAX_DELTA > steps.length) {
      steps = Arrays.copyOf(steps, Math.min(2 * delta, MAX_LENGTH) + MAX_DELTA);
    }
    held.motion(slot, old);
    now.motion(slot, actual);
    int way = predictor.way(old, actual, age);
    residual.setResidual(predictor, old, actual, way, age);
    int situation = RecordCodec.situation(old, age);
    recorder.at = delta + HEAD;
    recorder.residual(BitCoder.known(), situation, way, old, residual);
    steps[delta] = (char) (situation << WAY_BITS | way);
    steps[delta + 1] = (char) (recorder.at - delta - HEAD);
    return recorder.at;
  }

  /** How the delta's velocities are predicted. */
  int way(int delta) {
    return steps[delta] & (1 << WAY_BITS) - 1;
  }

  /** As {@link RecordCodec#situation}. */
  int situation(int delta) {
    return steps[delta] >>> WAY_BITS;
  }

  /** The steps of all deltas; another array after each {@link #of}. */
  char[] steps() {
    return steps;
  }

  /** Index of the delta's first step. */
  int from(int delta) {
    return delta + HEAD;
  }

  /** Index behind the delta's last step. */
  int to(int delta) {
    return delta + HEAD + steps[delta + 1];
  }

  /** Writes down the bits that a codec would code. */
  private final class Recorder extends RecordCodec {
    private int at;

    Recorder() {
      super(new char[0]); // it needs no table
    }

    @Override
    int bit(BitCoder c, int node, int bit) {
      steps[at++] = (char) (node << 1 | bit);
      return bit;
    }

    @Override
    int plain(BitCoder c, int value, int count) {
      for (int i = count - 1; i >= 0; i--) {
        bit(c, RecordCodec.NODES, value >>> i & 1);
      }
      return value & (1 << count) - 1;
    }
  }
}
