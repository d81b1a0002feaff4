package carom.server.schedule;

import java.util.Arrays;

/**
 * Measures how much of its time a room's ticks take: the 95th percentile of the last ten seconds,
 * and the pace at which the room can keep its ticks apart. One thread; no allocation.
 *
 * <p>A room that is too slow sheds load in this order. First it sends fewer snapshots ({@link
 * SendTurns}). When a tick without most of its snapshots still takes longer than its period, time
 * slows down: fewer ticks a second, each of the same length, and all clients are told. Ticks that
 * would come in a burst, and leave everybody without a snapshot meanwhile, don't arise.
 */
public final class TickLoad {
  /** Slowest pace, percent of the tick rate. */
  public static final int SLOWEST_PERCENT = 5;

  private static final int SECONDS = 10;
  private static final int PERCENTILE = 95;

  /** Parts in which a period is counted; a tick of three periods or more counts as three. */
  private static final int PARTS = 50;

  private static final int MOST_PARTS = 3 * PARTS;

  /** A pace is chosen twice a second, in steps of so many percent. */
  private static final int CHOICES_PER_SECOND = 2;

  private static final int STEP_PERCENT = 5;

  /** Share of a tick's time at the present pace above which time slows down. */
  private static final double TOO_BUSY = 0.95;

  /** Share to which a slower pace brings it. */
  private static final double BUSY = 0.85;

  /** Share below which time goes faster again, by one step. */
  private static final double CALM = 0.75;

  private final long periodNs;
  private final byte[] parts;
  private final int[] counts = new int[MOST_PARTS + 1];
  private final int window;
  private long ticks;
  private long sumNs;
  private int summed;
  private int pacePercent = 100;

  /**
   * Creates the load of a room that has run no tick.
   *
   * @param rateHz ticks per second
   */
  public TickLoad(int rateHz) {
    periodNs = 1_000_000_000L / rateHz;
    parts = new byte[ticksUntilKnown(rateHz)];
    window = Math.max(1, rateHz / CHOICES_PER_SECOND);
  }

  /**
   * Notes how long a tick took.
   *
   * @return whether the pace has changed
   */
  public boolean tickTook(long tookNs) {
    int place = (int) (ticks % parts.length);
    if (ticks >= parts.length) {
      counts[parts[place] & 0xff]--;
    }
    int part = (int) Math.min(MOST_PARTS, (tookNs * PARTS + periodNs - 1) / periodNs);
    parts[place] = (byte) part;
    counts[part]++;
    ticks++;
    sumNs += tookNs;
    summed++;
    return summed >= window && choosePace();
  }

  /** Notes that the room rests, as if its ticks of ten seconds had taken no time. */
  public void rest() {
    Arrays.fill(parts, (byte) 0);
    Arrays.fill(counts, 0);
    counts[0] = parts.length;
    ticks = parts.length;
    sumNs = 0;
    summed = 0;
  }

  private boolean choosePace() {
    double needed = (double) sumNs / summed / periodNs;
    sumNs = 0;
    summed = 0;
    int before = pacePercent;
    double share = needed * pacePercent / 100;
    if (share > TOO_BUSY) {
      int fitting = (int) (100 * BUSY / needed) / STEP_PERCENT * STEP_PERCENT;
      pacePercent = Math.max(SLOWEST_PERCENT, Math.min(pacePercent, fitting));
    } else if (share < CALM) {
      pacePercent = Math.min(100, pacePercent + STEP_PERCENT);
    }
    return pacePercent != before;
  }

  /** Returns the pace, percent of the tick rate, {@value #SLOWEST_PERCENT}..100. */
  public int pacePercent() {
    return pacePercent;
  }

  /**
   * Returns after how many ticks the load decides about newcomers: the first ones run cold code.
   *
   * @param rateHz ticks per second
   */
  public static int ticksUntilKnown(int rateHz) {
    return SECONDS * rateHz;
  }

  /**
   * Returns the time that 95 of 100 ticks of the last {@value #SECONDS} s took at most, percent of
   * their period at full pace, 0..300. It is that of the ticks since the start while they are
   * fewer, and 0 before the first.
   */
  public int percent() {
    int left = (int) (Math.min(ticks, parts.length) * PERCENTILE + 99) / 100;
    int part = 0;
    while (left > counts[part]) {
      left -= counts[part];
      part++;
    }
    return part * 100 / PARTS;
  }
}
