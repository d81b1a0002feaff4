package carom.client.clock;

import java.util.Arrays;

/**
 * Clock of the interpolated picture: a moment of the server's past, late enough that the snapshots
 * around it have almost surely arrived, and no later.
 *
 * <p>Each snapshot of tick {@code T} that arrives at time {@code t} is one sample of the line
 * {@code T = rate t + offset}. The clock follows the mean of that line, minus a delay with these
 * parts:
 *
 * <ul>
 *   <li>Jitter: the lateness that 95 % of the snapshots stay below.
 *   <li>One send interval, to have two states to interpolate between.
 *   <li>One send interval for each consecutive loss to survive: one on a clean line, two above 1 %
 *       loss, three above 8 %. Above 8 %, where losses come in bursts, it is at least the typical
 *       length of a gap.
 * </ul>
 *
 * <p>Changes of the line or the delay bend the speed by at most a tenth, or by a quarter while the
 * picture is far off because the route has changed. Only a larger gap makes the clock jump. Not
 * thread-safe; allocates nothing after construction.
 */
public final class RenderClock {
  private static final int WINDOW = 64;
  private static final int LONGEST_INTERVAL = 15;
  private static final double MAX_BEND = 0.1;

  /** Largest bend while off by more than {@link #FAR_SECONDS}, which looks worse than haste. */
  private static final double MAX_FAR_BEND = 0.25;

  private static final double FAR_SECONDS = 0.05;

  /** Snapshots in a row, alike and unlike those before, that prove another route. */
  private static final int ANOTHER_ROUTE = 16;

  private static final double ALIKE_SECONDS = 0.02;
  private static final double UNLIKE_SECONDS = 0.05;
  private static final double SETTLE_SECONDS = 0.25;
  private static final double JUMP_SECONDS = 0.4;
  private static final double MAX_DELAY_SECONDS = 0.5;

  /** Longest gap that counts. A longer one is an outage, which no delay can hide. */
  private static final double LONGEST_GAP_SECONDS = 0.75;

  /** Time constant with which gaps are forgotten. */
  private static final double GAP_MEMORY_SECONDS = 10;

  /** Share of losses above which the delay covers typical gaps, 0..1. */
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

  /** Number of newest samples that are alike. */
  private int alike;

  /** The first of those samples. */
  private double alikeTo;

  private double loss;

  /** Ticks without a snapshot, fading. */
  private double missing;

  /** Sum of the squared lengths of gaps, fading. */
  private double missingSquares;

  private int interval = 1;
  private double leastDelaySeconds;
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

  /**
   * Notes the arrival of a snapshot: call once per tick, for its first datagram.
   *
   * @param tick server tick of the snapshot
   * @param arrivalNs when it arrived
   * @param quiet whether nothing moved in it: a server sends quiet snapshots less often, so they
   *     say nothing about the send interval
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
    noteRoute(offset);
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

  /** Starts a new line after an outage or a stall of the server. */
  private void restart(int tick, long arrivalNs) {
    originNs = arrivalNs;
    mean = tick;
    Arrays.fill(offsets, tick);
    samples = 1;
    newest = tick;
    alike = 0;
  }

  /** Detects another route: the lateness of the old one isn't jitter of the new one. */
  private void noteRoute(double offset) {
    if (alike == 0 || Math.abs(offset - alikeTo) > ALIKE_SECONDS * tickRate) {
      alike = 0;
      alikeTo = offset;
    }
    alike++;
    if (alike == ANOTHER_ROUTE && Math.abs(alikeTo - mean) > UNLIKE_SECONDS * tickRate) {
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

  /** Sets the delay that the player wants at least, seconds, 0..0.5. */
  public void leastDelay(double seconds) {
    leastDelaySeconds = seconds;
  }

  /**
   * Sets how much is lost.
   *
   * @param fraction lost datagrams, 0..1
   */
  public void loss(double fraction) {
    loss = fraction;
  }

  /**
   * Moves the clock to the present.
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

  /** Returns whether a snapshot has arrived. */
  public boolean started() {
    return started;
  }

  /** Returns the tick to draw, with its fraction. */
  public double tick() {
    return position;
  }

  /** Returns the most frequent number of ticks between snapshots. */
  public int intervalTicks() {
    return interval;
  }

  /** Returns the interpolation delay aimed at, ticks behind the mean arrival. */
  public double delayTicks() {
    double survive = interval * (loss > HEAVY_LOSS ? 3 : loss > 0.01 ? 2 : 1);
    if (loss > HEAVY_LOSS && missing > 0) {
      survive = Math.max(survive, missingSquares / missing);
    }
    double needed = Math.max(leastDelaySeconds * tickRate, interval + survive + lateness);
    return Math.min(MAX_DELAY_SECONDS * tickRate, needed);
  }

  /** Returns the lateness that 95 % of the snapshots stay below, milliseconds. */
  public double jitterMs() {
    return lateness / tickRate * 1000;
  }
}
