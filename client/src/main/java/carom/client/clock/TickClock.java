package carom.client.clock;

import java.util.Arrays;

/**
 * Clock of the predicted ticks. It runs far enough ahead of the server that each input arrives
 * shortly before the server needs it, and no further: every tick of lead is lag for others.
 *
 * <p>With each snapshot the server reports the <em>input margin</em>: how many inputs of this
 * client were waiting when it consumed one. The clock keeps the margin at {@link #targetMargin()},
 * which is two ticks plus allowances for jitter and loss.
 *
 * <p>How it steers. Let {@code offset(t) = position(t) - rate t} be the distance to a clock that
 * never changes its speed. The margin of an input equals the offset at the moment the input was
 * sampled, plus a constant of the path (server phase minus travel time). So {@code margin -
 * offset(when sampled)} estimates that constant without feedback delay. Corrections since then are
 * accounted for, and the loop can't oscillate however long the round trip is.
 *
 * <ul>
 *   <li>A small error bends the speed by at most {@value #MAX_BEND_PERCENT} %, which is invisible.
 *   <li>A large error (a wrong first estimate, another route, a machine that was suspended) makes
 *       the clock jump. A jump back only pauses; a tick is never handed out twice.
 *   <li>After {@value #SILENCE_MS} ms without a snapshot the clock waits. A server that stood still
 *       goes on where it stopped, and has no use for inputs far ahead. The next snapshot tells
 *       whether it stood still or could only not be heard; then the clock catches up.
 *   <li>A slow machine gets at most {@link #MAX_CATCH_UP} ticks per frame and loses the rest, so a
 *       long frame can't make the next one longer.
 * </ul>
 *
 * <p>Not thread-safe; allocates nothing after construction.
 */
public final class TickClock {
  /** Most ticks handed out per {@link #advance}. */
  public static final int MAX_CATCH_UP = 8;

  /** Smallest margin aimed at, ticks: one for the phase of both loops, one for a lost packet. */
  public static final double BASE_MARGIN = 2;

  /** Silence after which the clock waits for the server, milliseconds. */
  static final int SILENCE_MS = 1_500;

  private static final long SILENCE_NS = SILENCE_MS * 1_000_000L;

  /** Acceptable probability of losing an input with all its copies. */
  private static final double LOST = 1e-4;

  private static final double MAX_LOSS_MARGIN = 5;

  private static final int LOSS_SECONDS = 10;

  private static final int MAX_BEND_PERCENT = 3;
  private static final double MAX_BEND = MAX_BEND_PERCENT / 100.0;
  private static final double MAX_JITTER_MARGIN = 10;

  /** Time in which a small error shrinks to 1/e. */
  private static final double SETTLE_SECONDS = 0.5;

  /** Lag beyond which the clock jumps forward, because inputs come too late. */
  private static final double JUMP_FORWARD_TICKS = 4;

  /** Lead beyond which the clock waits, which is better than half a minute of slow motion. */
  private static final double JUMP_BACK_TICKS = 12;

  private static final double SLOWEST_AVERAGE = 0.03;
  private static final int OUTLIERS_TO_RESTART = 8;

  /** Outliers that suffice to restart if they are alike, which no burst of jitter is. */
  private static final int ALIKE_TO_RESTART = 4;

  /** Largest distance of an outlier from the mean of those that are alike. */
  private static final double ALIKE_TICKS = 1.5;

  private static final int RING = 512;

  private final double ticksPerNs;
  private final int tickRate;
  private final double[] offsetOf = new double[RING];
  private final int[] offsetTick = new int[RING];

  private boolean started;
  private long originNs;
  private long nowNs;
  private double position;
  private double speed = 1;
  private int last;

  private int samples;
  private double path;
  private double deviation;
  private int outliers;
  private double outlierSum;

  /** True if all outliers are alike. */
  private boolean alike;

  private int newestReported;

  /** True once {@link #heard} was called. */
  private boolean listens;

  private long heardNs;
  private int heardTick;
  private long heldNs;
  private long lossNs;
  private double meanLoss;
  private double lossMargin;
  private long dropped;
  private long jumps;

  /**
   * Creates a stopped clock.
   *
   * @param tickRate the server's ticks per second, at least 1
   */
  public TickClock(int tickRate) {
    if (tickRate < 1) {
      throw new IllegalArgumentException("tickRate=" + tickRate + " must be at least 1");
    }
    this.tickRate = tickRate;
    this.ticksPerNs = tickRate / 1e9;
  }

  /**
   * Starts the clock, or starts it again from scratch.
   *
   * @param nowNs the present
   * @param serverTick newest known tick of the server
   * @param roundTripNs time a message takes there and back; 0 if unknown
   */
  public void start(long nowNs, int serverTick, long roundTripNs) {
    started = true;
    originNs = nowNs;
    this.nowNs = nowNs;
    heardNs = nowNs;
    heardTick = serverTick;
    heldNs = 0;
    lossNs = nowNs;
    meanLoss = 0;
    listens = false;
    position = serverTick + Math.max(0, roundTripNs) * ticksPerNs + BASE_MARGIN + 1;
    last = (int) Math.floor(position) - 1;
    speed = 1;
    samples = 0;
    deviation = 0.5;
    outliers = 0;
    newestReported = Integer.MIN_VALUE;
    Arrays.fill(offsetTick, Integer.MIN_VALUE);
  }

  /** Returns whether the clock was started. */
  public boolean started() {
    return started;
  }

  /**
   * Moves the clock to the present. Call {@link #next} while {@link #due} is positive.
   *
   * @param nowNs the present; earlier than before counts as no time passed
   * @return ticks due, 0..{@link #MAX_CATCH_UP}
   */
  public int advance(long nowNs) {
    if (!started) {
      return 0;
    }
    long elapsed = Math.max(0, nowNs - this.nowNs);
    this.nowNs = Math.max(nowNs, this.nowNs);
    long silent = listens ? Math.max(0, this.nowNs - heardNs - SILENCE_NS) : 0;
    long held = Math.min(elapsed, silent);
    heldNs += held;
    originNs += held;
    steer();
    position += (elapsed - held) * ticksPerNs * speed;
    int due = due();
    if (due > MAX_CATCH_UP) {
      dropped += due - MAX_CATCH_UP;
      position -= due - MAX_CATCH_UP;
      due = MAX_CATCH_UP;
    }
    return due;
  }

  /** Returns how many ticks are due and not handed out yet. */
  public int due() {
    return started ? Math.max(0, (int) Math.floor(position) - last) : 0;
  }

  /** Hands out the next tick, which is larger than every one before. */
  public int next() {
    if (due() == 0) {
      throw new IllegalStateException("no tick is due: last=" + last + " position=" + position);
    }
    last++;
    int slot = last & (RING - 1);
    offsetTick[slot] = last;
    offsetOf[slot] = offset();
    return last;
  }

  /**
   * Notes that a snapshot arrived.
   *
   * @param serverTick newest known tick of the server
   * @param nowNs the present, as for {@link #advance}
   */
  public void heard(int serverTick, long nowNs) {
    if (!started || serverTick < heardTick) {
      return;
    }
    listens = true;
    if (heldNs > 0) {
      // The server ran for this part of the time in which the clock waited.
      double ran = (serverTick - heardTick) / ticksPerNs - (nowNs - heardNs - heldNs);
      long missed = (long) Math.max(0, Math.min(heldNs, ran));
      originNs -= missed;
      position += missed * ticksPerNs;
      if (due() > MAX_CATCH_UP) {
        last = (int) Math.floor(position) - 1;
      }
      heldNs = 0;
    }
    heardNs = nowNs;
    heardTick = serverTick;
  }

  /**
   * Sets how much is lost. Each tick of margin is another copy of each input that may arrive in
   * time. Losses come in bursts, so the clock uses the mean of about {@value #LOSS_SECONDS}
   * seconds.
   *
   * @param fraction recently lost datagrams, 0..1
   */
  public void loss(double fraction) {
    double seconds = (nowNs - lossNs) * 1e-9;
    lossNs = nowNs;
    meanLoss += (fraction - meanLoss) * Math.min(1, seconds / LOSS_SECONDS);
    double copies = meanLoss <= LOST ? 1 : Math.log(LOST) / Math.log(Math.min(0.9, meanLoss));
    lossMargin = Math.max(0, Math.min(MAX_LOSS_MARGIN, copies - BASE_MARGIN));
  }

  /**
   * Takes in a reported input margin.
   *
   * @param serverTick the tick that the server had just run
   * @param margin newest input tick it held at that moment minus {@code serverTick}; negative when
   *     inputs come too late
   */
  public void report(int serverTick, int margin) {
    int newest = serverTick + margin;
    if (!started || newest <= newestReported) {
      return; // no new input had arrived: the margin tells how long the line has been dead
    }
    newestReported = newest;
    int slot = newest & (RING - 1);
    if (offsetTick[slot] != newest) {
      return;
    }
    double sample = margin - offsetOf[slot];
    double error = sample - path;
    if (samples > 0 && Math.abs(error) > Math.max(3, 4 * deviation)) {
      boolean first = outliers == 0 || outlierSum * error < 0;
      alike = first || (alike && Math.abs(error - outlierSum / outliers) <= ALIKE_TICKS);
      outlierSum = first ? error : outlierSum + error;
      outliers = first ? 1 : outliers + 1;
      if (outliers < (alike ? ALIKE_TO_RESTART : OUTLIERS_TO_RESTART)) {
        return;
      }
      path += outlierSum / outliers; // another route
      samples = OUTLIERS_TO_RESTART;
      outliers = 0;
      outlierSum = 0;
      return;
    }
    outliers = 0;
    outlierSum = 0;
    samples++;
    double weight = Math.max(SLOWEST_AVERAGE, 1.0 / samples);
    path += weight * error;
    if (samples > 1) {
      deviation += Math.max(SLOWEST_AVERAGE, 1.0 / samples) * (Math.abs(error) - deviation);
    }
  }

  private void steer() {
    if (samples < 4) {
      speed = 1;
      return;
    }
    double error = targetMargin() - path - offset(); // positive: the clock is behind
    if (error > JUMP_FORWARD_TICKS || error < -JUMP_BACK_TICKS) {
      position += error;
      jumps++;
      if (due() > MAX_CATCH_UP) {
        last = (int) Math.floor(position) - 1;
      }
      speed = 1;
      return;
    }
    double bend = error / (SETTLE_SECONDS * tickRate);
    speed = 1 + Math.max(-MAX_BEND, Math.min(MAX_BEND, bend));
  }

  private double offset() {
    return position - (nowNs - originNs) * ticksPerNs;
  }

  /** Returns the last tick handed out. */
  public int tick() {
    return last;
  }

  /** Returns how much of the next tick has passed, 0..1; for drawing between two ticks. */
  public float fraction() {
    return (float) Math.max(0, Math.min(1, position - last));
  }

  /** Returns the speed, 0.97..1.03; 1 = the server's nominal rate. */
  public double speed() {
    return speed;
  }

  /** Returns the margin the clock aims at, ticks. */
  public double targetMargin() {
    double jitterMargin = Math.min(MAX_JITTER_MARGIN, Math.max(0, 2.5 * (deviation - 0.5)));
    return BASE_MARGIN + lossMargin + jitterMargin;
  }

  /** Returns how many ticks were lost because this machine was too slow, since construction. */
  public long dropped() {
    return dropped;
  }

  /** Returns how often the clock jumped since construction. */
  public long jumps() {
    return jumps;
  }
}
