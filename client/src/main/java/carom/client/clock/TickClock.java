package carom.client.clock;

import java.util.Arrays;

/**
 * Decides when the client runs which tick: far enough ahead of the server that each input arrives
 * shortly before the server needs it, and no further, since every tick of lead is lag for others.
 *
 * <p>The server tells, with each snapshot, how many inputs of this client were waiting when it
 * consumed one: the <em>input margin</em>. The clock keeps the margin at {@link #targetMargin()},
 * which is two ticks plus allowances for jitter and loss.
 *
 * <p>How it steers. Let {@code offset(t) = position(t) - rate t} be how far the clock stands from
 * one that never changes speed. The margin measured for an input equals the offset at the moment
 * that input was made, plus a constant of the path (server phase minus travel time). So {@code
 * margin - offset(when made)} estimates that constant free of feedback delay: what was corrected
 * since then is already accounted for, and the loop can't oscillate however long the round trip.
 *
 * <ul>
 *   <li>Small errors bend the speed by at most {@value #MAX_BEND_PERCENT} %: nobody sees it.
 *   <li>Being far off (a first estimate gone wrong, a route change, a machine that was suspended)
 *       jumps. A jump back only pauses; a tick number is never handed out twice.
 *   <li>When the server has been silent for {@value #SILENCE_MS} ms, the clock waits: a server that
 *       stood still goes on where it stopped, and inputs for ticks far ahead are of no use to it.
 *       The first thing heard tells whether it stood still or only could not be heard; then the
 *       clock catches up.
 *   <li>A slow machine gets at most {@link #MAX_CATCH_UP} ticks per frame and loses the rest, so a
 *       frame that takes long cannot make the next one longer.
 * </ul>
 *
 * <p>Not thread-safe; allocates nothing after construction.
 */
public final class TickClock {
  /** Ticks handed out per {@link #advance} at most. */
  public static final int MAX_CATCH_UP = 8;

  /** Smallest margin aimed at, in ticks: one for the phase of both loops, one for a lost packet. */
  public static final double BASE_MARGIN = 2;

  /** After this the clock waits for the server, milliseconds. */
  static final int SILENCE_MS = 1_500;

  private static final long SILENCE_NS = SILENCE_MS * 1_000_000L;

  /** Chance to lose an input, with all its copies, that is small enough. */
  private static final double LOST = 1e-4;

  private static final double MAX_LOSS_MARGIN = 5;

  private static final int LOSS_SECONDS = 10;

  private static final int MAX_BEND_PERCENT = 3;
  private static final double MAX_BEND = MAX_BEND_PERCENT / 100.0;
  private static final double MAX_JITTER_MARGIN = 10;

  /** Seconds in which a small error shrinks to 1/e. */
  private static final double SETTLE_SECONDS = 0.5;

  /** Behind by more than this, inputs come too late: catch up at once. */
  private static final double JUMP_FORWARD_TICKS = 4;

  /** Ahead by more than this, waiting is better than half a minute of slow motion. */
  private static final double JUMP_BACK_TICKS = 12;

  private static final double SLOWEST_AVERAGE = 0.03;
  private static final int OUTLIERS_TO_RESTART = 8;

  /** So many suffice when none is further than this from their mean: no burst of jitter is so. */
  private static final int ALIKE_TO_RESTART = 4;

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

  /** Whether all outliers say about the same. */
  private boolean alike;

  private int newestReported;
  private double lastMargin;

  /** Whether anybody tells when the server is heard. */
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
   * Starts, or starts again from scratch.
   *
   * @param nowNs the present
   * @param serverTick newest tick known of the server
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
    lastMargin = 0;
    Arrays.fill(offsetTick, Integer.MIN_VALUE);
  }

  /** True after {@link #start}. */
  public boolean started() {
    return started;
  }

  /**
   * Moves to the present. Hand out the ticks that became due with {@link #next} while {@link #due}
   * is positive.
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

  /** Ticks due and not handed out yet. */
  public int due() {
    return started ? Math.max(0, (int) Math.floor(position) - last) : 0;
  }

  /** Hands out the next tick number; larger than every one before. */
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
   * Notes that the server was heard.
   *
   * @param serverTick newest tick known of it
   * @param nowNs the present, as for {@link #advance}
   */
  public void heard(int serverTick, long nowNs) {
    if (!started || serverTick < heardTick) {
      return;
    }
    listens = true;
    if (heldNs > 0) {
      // Of the time in which we waited, the server ran for so long.
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
   * Tells the clock how much is lost: each tick earlier is another copy of each input that may
   * arrive in time. What is lost within a second or two says little where losses come in bursts, so
   * the clock goes by the mean of about {@value #LOSS_SECONDS} seconds.
   *
   * @param fraction lost datagrams lately, 0..1
   */
  public void loss(double fraction) {
    double seconds = (nowNs - lossNs) * 1e-9;
    lossNs = nowNs;
    meanLoss += (fraction - meanLoss) * Math.min(1, seconds / LOSS_SECONDS);
    double copies = meanLoss <= LOST ? 1 : Math.log(LOST) / Math.log(Math.min(0.9, meanLoss));
    lossMargin = Math.max(0, Math.min(MAX_LOSS_MARGIN, copies - BASE_MARGIN));
  }

  /**
   * Takes in what the server reported.
   *
   * @param serverTick tick the server had just run
   * @param margin newest input tick it held at that moment minus {@code serverTick}; negative when
   *     inputs come too late
   */
  public void report(int serverTick, int margin) {
    lastMargin = margin;
    int newest = serverTick + margin;
    if (!started || newest <= newestReported) {
      return; // nothing new came in: says how long the line is dead, not how early we are
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
      path += outlierSum / outliers; // the path itself has changed
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
    double error = targetMargin() - path - offset(); // positive: we are behind
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

  /** Last tick handed out. */
  public int tick() {
    return last;
  }

  /** How much of the next tick has passed, 0..1; for drawing between two ticks. */
  public float fraction() {
    return (float) Math.max(0, Math.min(1, position - last));
  }

  /** Present speed: 1 = the server's nominal rate; 0.97..1.03. */
  public double speed() {
    return speed;
  }

  /** Margin the clock aims at, in ticks. */
  public double targetMargin() {
    double jitterMargin = Math.min(MAX_JITTER_MARGIN, Math.max(0, 2.5 * (deviation - 0.5)));
    return BASE_MARGIN + lossMargin + jitterMargin;
  }

  /** Margin last reported by the server, in ticks. */
  public double lastMargin() {
    return lastMargin;
  }

  /** Ticks lost because this machine was too slow, since construction. */
  public long dropped() {
    return dropped;
  }

  /** Jumps since construction. */
  public long jumps() {
    return jumps;
  }
}
