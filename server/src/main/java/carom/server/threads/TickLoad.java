package carom.server.threads;

import java.util.Arrays;

/**
 * Measures how much of its time a room's ticks take: the 95th percentile of the last ten seconds,
 * and the pace at which the room can keep its ticks apart. One thread; no allocation.
 *
 * <p>The longest tick of each half second doesn't count for the pace, so that a callback that
 * waited once slows no player down. A room that is too slow sheds load in this order. First it
 * sends fewer snapshots ({@code SendTurns}). When snapshots wait in half of the ticks, views become
 * narrow: players are told only of what they show, not of the rest of the level. When ticks still
 * take longer than their period, time slows down: fewer ticks a second, each of the same length,
 * and all clients are told. Ticks that would come in a burst, and leave everybody without a
 * snapshot meanwhile, don't arise.
 */
public final class TickLoad {
  /** Slowest pace, percent of the tick rate. */
  public static final int SLOWEST_PERCENT = 5;

  private static final int SECONDS = 10;
  private static final int PERCENTILE = 95;

  /** Parts in which a period is counted; a tick of three periods or more counts as three. */
  private static final int PARTS = 50;

  private static final int MOST_PARTS = 3 * PARTS;

  /** Times in a second that the load chooses what to shed, and the pace in steps of percent. */
  private static final int CHOICES_PER_SECOND = 2;

  /** Fewest ticks of a choice. The longest doesn't count, and the others must tell how it is. */
  private static final int FEWEST_TICKS = 4;

  private static final int STEP_PERCENT = 5;

  /** Share of a tick's time at the present pace above which time slows down. */
  private static final double TOO_BUSY = 0.95;

  /** Share to which a slower pace brings it. */
  private static final double BUSY = 0.85;

  /** Share below which time goes faster again, by one step. */
  private static final double CALM = 0.75;

  /** A half second is calm when snapshots wait in less than one of so many of its ticks. */
  private static final int CALM_TICKS = 10;

  /**
   * Views widen after so many calm half seconds in a row. Nothing but trying shows whether that is
   * too early, so each time it takes twice as many, up to the most.
   */
  private static final int CHOICES_TO_WIDEN = 10 * CHOICES_PER_SECOND;

  private static final int MOST_CHOICES_TO_WIDEN = 32 * CHOICES_TO_WIDEN;

  private final long periodNs;
  private final byte[] parts;
  private final int[] counts = new int[MOST_PARTS + 1];
  private final int window;
  private long ticks;
  private long sumNs;
  private long longestNs;
  private int summed;
  private int lateTicks;
  private int pacePercent = 100;
  private boolean viewsNarrow;
  private int calmChoices;
  private int choicesToWiden = CHOICES_TO_WIDEN;

  /**
   * Creates the load of a room that has run no tick.
   *
   * @param rateHz ticks per second
   */
  public TickLoad(int rateHz) {
    periodNs = 1_000_000_000L / rateHz;
    parts = new byte[ticksUntilKnown(rateHz)];
    window = Math.max(FEWEST_TICKS, rateHz / CHOICES_PER_SECOND);
  }

  /**
   * Notes how long a tick took.
   *
   * @param late whether snapshots had to wait for the next tick
   * @return whether the pace has changed
   */
  public boolean tickTook(long tookNs, boolean late) {
    int place = (int) (ticks % parts.length);
    if (ticks >= parts.length) {
      counts[parts[place] & 0xff]--;
    }
    int part = (int) Math.min(MOST_PARTS, (tookNs * PARTS + periodNs - 1) / periodNs);
    parts[place] = (byte) part;
    counts[part]++;
    ticks++;
    sumNs += tookNs;
    longestNs = Math.max(longestNs, tookNs);
    summed++;
    lateTicks += late ? 1 : 0;
    return summed >= window && choose();
  }

  /** Notes that the room rests, as if its ticks of ten seconds had taken no time. */
  public void rest() {
    Arrays.fill(parts, (byte) 0);
    Arrays.fill(counts, 0);
    counts[0] = parts.length;
    ticks = parts.length;
    sumNs = 0;
    longestNs = 0;
    summed = 0;
    lateTicks = 0;
    viewsNarrow = false;
    calmChoices = 0;
    choicesToWiden = CHOICES_TO_WIDEN;
  }

  private boolean choose() {
    // One long tick is past when it is seen, however long it was: a slower pace would mend nothing.
    double needed = (double) (sumNs - longestNs) / (summed - 1) / periodNs;
    double share = needed * pacePercent / 100;
    boolean narrowed = chooseViews();
    sumNs = 0;
    longestNs = 0;
    summed = 0;
    lateTicks = 0;
    return !narrowed && choosePace(needed, share);
  }

  /** Returns whether views have just become narrow, which may be enough. */
  private boolean chooseViews() {
    if (!viewsNarrow) {
      viewsNarrow = 2 * lateTicks >= summed;
      return viewsNarrow;
    }
    boolean calm = CALM_TICKS * lateTicks < summed && pacePercent == 100;
    calmChoices = calm ? calmChoices + 1 : 0;
    if (calmChoices == choicesToWiden) {
      viewsNarrow = false;
      calmChoices = 0;
      choicesToWiden = Math.min(MOST_CHOICES_TO_WIDEN, 2 * choicesToWiden);
    }
    return false;
  }

  private boolean choosePace(double needed, double share) {
    int before = pacePercent;
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

  /** Returns whether players are told only of what they show. */
  public boolean viewsAreNarrow() {
    return viewsNarrow;
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
