package carom.server.prediction;

import carom.net.snapshot.exact.NearState;

/**
 * Limits of one session's exact updates: how many entities may be near, and how often an update may
 * begin.
 *
 * <ul>
 *   <li><b>Line speed.</b> An update that doesn't get through in time halves the number of
 *       entities; each one that arrives adds {@value #REGAINED} again.
 *   <li><b>Length of the list.</b> A list of keys that takes too many bits loses a quarter of its
 *       entities and stays shorter.
 *   <li><b>Interference.</b> A game that pushes bodies all the time gets one update in {@value
 *       #TICKS_PER_INTERFERENCE} ticks on average. The client finds out about the rest by its hash.
 *   <li><b>Disagreement.</b> A client that disagrees again and again is told everything less and
 *       less often, because telling it doesn't help.
 * </ul>
 *
 * <p>One thread; no allocation.
 */
final class UpdateLimits {
  /** The number of entities never falls below this. */
  private static final int FEWEST = 4;

  /** Entities regained with each update that arrives. */
  private static final int REGAINED = 8;

  /** The list of keys takes at most this much, bits. */
  private static final int MAX_LIST_BITS = 3_000;

  /** Credit that an update for interference costs, and the ticks it takes to earn it. */
  private static final int TICKS_PER_INTERFERENCE = 5;

  /** Updates for interference that may begin in a row after a quiet time. */
  private static final int MAX_INTERFERENCES = 6;

  /** Shortest and longest time from one disagreement to telling everything again, ticks. */
  private static final int MIN_GAP = 4;

  private static final int MAX_GAP = 120;

  /** The most entities, as the length of the list allows. */
  private int mostListed = NearState.MAX_ENTITIES;

  /** The most entities, as the line allows, too. */
  private int most = NearState.MAX_ENTITIES;

  /** Ticks saved up for updates that interference causes. */
  private int credit = TICKS_PER_INTERFERENCE * MAX_INTERFERENCES;

  private int gap = MIN_GAP;
  private int lastFullTick = -1;

  /** Returns the most entities that may be near now. */
  int entities() {
    return most;
  }

  /** Notes that an update of some entities didn't get through in time. */
  void timedOut(int entities) {
    most = Math.max(FEWEST, entities / 2);
  }

  /** Notes that all of an update has arrived. */
  void arrived() {
    most = Math.min(mostListed, most + REGAINED);
  }

  /** Notes how many bits the list of some entities takes. */
  void listed(int bits, int entities) {
    if (bits > MAX_LIST_BITS) {
      mostListed = Math.max(FEWEST, entities * 3 / 4);
      most = Math.min(most, mostListed);
    }
  }

  /** Earns credit for the ticks that have passed. */
  void earn(int ticks) {
    credit = Math.min(TICKS_PER_INTERFERENCE * MAX_INTERFERENCES, credit + ticks);
  }

  /** Takes the credit for an update because of interference. Returns false if there is none. */
  boolean takeInterference() {
    if (credit < TICKS_PER_INTERFERENCE) {
      return false;
    }
    credit -= TICKS_PER_INTERFERENCE;
    return true;
  }

  /** Takes the right to tell everything at a tick. Returns false if that was done a moment ago. */
  boolean takeFullUpdate(int tick) {
    if (lastFullTick >= 0 && tick - lastFullTick > 2 * MAX_GAP) {
      gap = MIN_GAP;
    }
    if (lastFullTick >= 0 && tick - lastFullTick < gap) {
      return false;
    }
    gap = Math.min(MAX_GAP, 2 * gap);
    lastFullTick = tick;
    return true;
  }
}
