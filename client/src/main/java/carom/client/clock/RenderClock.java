package carom.client.clock;

import java.util.Arrays;

/**
 * The moment of the server's past that is drawn: late enough that the snapshots around it have
 * almost surely arrived, and no later.
 *
 * <p>Each snapshot of tick {@code T} that arrives at time {@code t} is one sample of the line
 * {@code T = rate t + offset}. The clock follows the mean of that line, minus a delay made of
 *
 * <ul>
 *   <li>the lateness that 95 % of the snapshots stay below (measured jitter),
 *   <li>one send interval to have two states to draw between,
 *   <li>one more for each consecutive loss worth surviving at the measured loss rate (one when the
 *       line is clean, two above 1 %, three above 8 %); above 8 % as long as the gap is in which a
 *       lost snapshot typically lies, where losses come in bursts.
 * </ul>
 *
 * Changes of the line or the delay bend the speed by at most a tenth, by a quarter while the
 * picture is far off because the line has become another; only a gap too large for that jumps. Not
 * thread-safe; allocates nothing after construction.
 */
public final class RenderClock {
  private static final int WINDOW = 64;
  private static final int LONGEST_INTERVAL = 15;
  private static final double MAX_BEND = 0.1;

  /** Being off by more than {@link #FAR_SECONDS} looks worse than moving too fast for a second. */
  private static final double MAX_FAR_BEND = 0.25;

  private static final double FAR_SECONDS = 0.05;

  /** So many snapshots in a row that are alike, and unlike those before, came another way. */
  private static final int ANOTHER_WAY = 16;

  private static final double ALIKE_SECONDS = 0.02;
  private static final double UNLIKE_SECONDS = 0.05;
  private static final double SETTLE_SECONDS = 0.25;
  private static final double JUMP_SECONDS = 0.4;
  private static final double MAX_DELAY_SECONDS = 0.5;

  /** A longer gap is an outage, which no delay can hide. */
  private static final double LONGEST_GAP_SECONDS = 0.75;

  /** Gaps count for about so long. */
  private static final double GAP_MEMORY_SECONDS = 10;

  /** Losses beyond are worth waiting for, 0..1. */
  private static final double HEAVY_LOSS = 0.08;

  private final double ticksPerNs;
  private final int tickRate;
  private final double[] offsets = new double[WINDOW];
  private final double[] sorted = new double[WINDOW];
  private final float[] intervalWeight = new float[LONGEST_INTERVAL + 1];

  private boolean started;
  private long originNs;
  private long nowNs;
  private int newest;
  private boolean lastQuiet;
  private int samples;
  private double mean;
  private double lateness;

  /** Samples alike, the newest included, and what the first of them was. */
  private int alike;

  private double alikeTo;
  private double loss;

  /** Ticks without a snapshot, and the sum of each gap's square; fading. */
  private double missing;

  private double missingSquares;
  private int interval = 1;
  private double position;

  /**
   * Creates a stopped clock; the first snapshot starts it.
   *
   * @param tickRate the server's ticks per second, at least 1
   */
  public RenderClock(int tickRate) {
    if (tickRate < 1) {
      throw new IllegalArgumentException("tickRate=" + tickRate + " must be at least 1");
    }
    this.tickRate = tickRate;
    this.ticksPerNs = tickRate / 1e9;
  }

  /** Forgets everything; the next snapshot starts it again. */
  public void reset() {
    started = false;
    samples = 0;
    interval = 1;
    lateness = 0;
    loss = 0;
    missing = 0;
    missingSquares = 0;
    Arrays.fill(intervalWeight, 0);
    alike = 0;
  }

  /**
   * Notes the arrival of a snapshot: call once per tick, for its first datagram.
   *
   * @param tick server tick of the snapshot
   * @param arrivalNs when it came
   * @param quiet whether nothing moved in it: a server that has nothing to tell sends less often,
   *     and that says nothing about how often it sends when something moves
   */
  public void snapshot(int tick, long arrivalNs, boolean quiet) {
    if (!started) {
      started = true;
      originNs = arrivalNs;
      nowNs = arrivalNs;
      newest = tick;
      mean = tick;
      offsets[0] = tick;
      samples = 1;
      position = tick - delayTicks();
      return;
    }
    double offset = tick - (arrivalNs - originNs) * ticksPerNs;
    if (Math.abs(offset - mean) > JUMP_SECONDS * tickRate && tick > newest) {
      restart(tick, arrivalNs);
      return;
    }
    noteWay(offset);
    offsets[samples % WINDOW] = offset;
    samples++;
    mean += Math.max(0.04, 1.0 / samples) * (offset - mean);
    if (samples % 8 == 0 || samples < 8) {
      int count = Math.min(samples, WINDOW);
      System.arraycopy(offsets, 0, sorted, 0, count);
      Arrays.sort(sorted, 0, count);
      lateness = Math.max(0, mean - sorted[(int) (count * 0.05)]);
    }
    if (tick > newest) {
      if (!quiet && !lastQuiet) {
        noteInterval(tick - newest);
        noteGap(tick - newest);
      }
      newest = tick;
      lastQuiet = quiet;
    }
  }

  /** After a blackout or a stall of the server the old line is worth nothing. */
  private void restart(int tick, long arrivalNs) {
    originNs = arrivalNs;
    mean = tick;
    Arrays.fill(offsets, tick);
    samples = 1;
    newest = tick;
    alike = 0;
  }

  /** What is known of the way that snapshots took before is no jitter of the one they take now. */
  private void noteWay(double offset) {
    if (alike == 0 || Math.abs(offset - alikeTo) > ALIKE_SECONDS * tickRate) {
      alike = 0;
      alikeTo = offset;
    }
    alike++;
    if (alike == ANOTHER_WAY && Math.abs(alikeTo - mean) > UNLIKE_SECONDS * tickRate) {
      mean = alikeTo;
      Arrays.fill(offsets, alikeTo);
      lateness = 0;
    }
  }

  private void noteInterval(int gap) {
    if (gap > LONGEST_INTERVAL) {
      return;
    }
    int best = 1;
    for (int i = 1; i <= LONGEST_INTERVAL; i++) {
      intervalWeight[i] = intervalWeight[i] * 0.95f + (i == gap ? 1 : 0);
      if (intervalWeight[i] > intervalWeight[best]) {
        best = i;
      }
    }
    interval = best;
  }

  private void noteGap(int ticks) {
    double fade = Math.exp(-ticks / (GAP_MEMORY_SECONDS * tickRate));
    missing *= fade;
    missingSquares *= fade;
    int gap = ticks - interval;
    if (gap > 0 && ticks <= LONGEST_GAP_SECONDS * tickRate) {
      missing += gap;
      missingSquares += (double) gap * gap;
    }
  }

  /**
   * Tells the clock how much is lost.
   *
   * @param fraction lost datagrams, 0..1
   */
  public void loss(double fraction) {
    loss = fraction;
  }

  /**
   * Moves to the present.
   *
   * @param nowNs the present; earlier than before counts as no time passed
   */
  public void advance(long nowNs) {
    if (!started) {
      return;
    }
    long elapsed = Math.max(0, nowNs - this.nowNs);
    this.nowNs = Math.max(nowNs, this.nowNs);
    double goal = (this.nowNs - originNs) * ticksPerNs + mean - delayTicks();
    double step = elapsed * ticksPerNs;
    double error = goal - (position + step);
    if (Math.abs(error) > JUMP_SECONDS * tickRate) {
      position = goal;
      return;
    }
    double bend = error / (SETTLE_SECONDS * tickRate);
    double most = Math.abs(error) > FAR_SECONDS * tickRate ? MAX_FAR_BEND : MAX_BEND;
    position += step * (1 + Math.max(-most, Math.min(most, bend)));
  }

  /** True once a snapshot came. */
  public boolean started() {
    return started;
  }

  /** The tick to draw, with its fraction. */
  public double tick() {
    return position;
  }

  /** Newest tick a snapshot was noted for. */
  public int newestTick() {
    return newest;
  }

  /** Ticks between the server's snapshots, as observed most often. */
  public int intervalTicks() {
    return interval;
  }

  /** Interpolation delay aimed at, in ticks behind the mean arrival. */
  public double delayTicks() {
    double survive = interval * (loss > HEAVY_LOSS ? 3 : loss > 0.01 ? 2 : 1);
    if (loss > HEAVY_LOSS && missing > 0) {
      survive = Math.max(survive, missingSquares / missing);
    }
    return Math.min(MAX_DELAY_SECONDS * tickRate, interval + survive + lateness);
  }

  /** Lateness that 95 % of the snapshots stay below, in milliseconds. */
  public double jitterMs() {
    return lateness / tickRate * 1000;
  }
}
