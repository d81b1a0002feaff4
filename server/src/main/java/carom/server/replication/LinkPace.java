package carom.server.replication;

import carom.net.protocol.ProtocolLimits;

/**
 * Estimates from the acks how fast one client's line takes snapshots.
 *
 * <p>A line that is slower than the budget lets datagrams queue up in front of it, and a datagram
 * that waited there is old when it arrives. So when even the quickest ack of an interval took
 * longer than on the empty line, the pace falls below what has been delivered, and the queue
 * drains. Otherwise the pace rises again. Loss alone says nothing about the speed of a line.
 * Neither does jitter, which leaves some datagrams quick: where they are few, an interval that
 * seems slow goes on until enough were acked to tell.
 *
 * <p>A delay that doesn't fall although no more is sent than arrives isn't a queue of ours. The
 * line has become longer, such as by another route, and its delay counts as that of the empty line
 * from then on.
 *
 * <p>Counts what is on the wire, headers included. The room's thread, no allocation.
 */
final class LinkPace {
  private static final int INTERVALS_PER_SECOND = 3;

  /**
   * The quickest ack of the last one or two spans, 5 to 10 s, shows how long the empty line takes.
   */
  private static final int EMPTY_INTERVALS = 5 * INTERVALS_PER_SECOND;

  /** A queue shorter than this is left alone, ms. */
  private static final int QUEUE_MS = 35;

  /**
   * Number of acks of which at least one is quick on nearly every line without a queue, even with
   * jitter: with 40 ms to either side, evenly spread, all six take 35 ms longer than the quickest
   * in 3 % of cases.
   */
  private static final int ENOUGH_ACKS = 6;

  /** An interval lasts at most so many times its length. */
  private static final int LONGEST_INTERVAL = 3;

  /** A queue of ours that isn't fed is shorter by {@link #QUEUE_MS} after so many intervals. */
  private static final int UNFED_INTERVALS = 2;

  /** Part of what was acked beyond which the bytes that were sent may feed a queue. */
  private static final float FEEDING = 1.25f;

  /** New pace as a part of what was delivered: below 1, so that a queue drains. */
  private static final float DRAIN = 0.8f;

  private static final float RISE = 1.25f;

  /** After a silence the pace returns to what it was by doubling, as TCP's slow start does. */
  private static final float RETURN = 2;

  private static final float SILENCE = 0.5f;
  private static final int LEAST_BYTES_PER_SECOND = 3_000;

  /** Length of a burst at the present pace, seconds. */
  private static final float BURST_SECONDS = 0.1f;

  private static final int NEVER = Integer.MAX_VALUE;

  private final int tickRate;
  private int most;
  private final int intervalTicks;
  private final int queueTicks;
  private float rate; // bytes per second
  private float rateBefore; // a silence, or a delay that was no queue
  private float rateBeforeSlow;
  private int unfedTicks; // of slow intervals in a row that fed no queue
  private int measuredTicks; // of them, since the delay below
  private int quickestUnfed;
  private float tokens; // bytes
  private int ticks;
  private int quickest = NEVER;
  private int acks;
  private int emptyNow = NEVER;
  private int emptyBefore = NEVER;
  private int intervals;
  private long ackedBefore;
  private long sent;

  /**
   * Starts at full speed.
   *
   * @param mostBytesPerSecond the pace of a line that is fast enough
   */
  LinkPace(int tickRate, int mostBytesPerSecond) {
    this.tickRate = tickRate;
    most = Math.max(LEAST_BYTES_PER_SECOND, mostBytesPerSecond);
    intervalTicks = Math.max(2, tickRate / INTERVALS_PER_SECOND);
    queueTicks = Math.max(2, QUEUE_MS * tickRate / 1_000);
    rate = most;
    tokens = most * BURST_SECONDS;
  }

  /** Sets the pace of a line that is fast enough, bytes per second. */
  void limit(int mostBytesPerSecond) {
    boolean full = rate >= most;
    most = Math.max(LEAST_BYTES_PER_SECOND, mostBytesPerSecond);
    rate = full ? most : Math.min(rate, most);
  }

  /** Notes that a datagram was acknowledged, and how many ticks after it was sent. */
  void acked(int delayTicks) {
    quickest = Math.min(quickest, delayTicks);
    acks++;
  }

  /**
   * Notes that a datagram is sent.
   *
   * @param acked whether the client acks it soon, see {@link #acked}
   */
  void sent(int payloadBytes, boolean acked) {
    tokens -= payloadBytes + ProtocolLimits.DATAGRAM_OVERHEAD_BYTES;
    sent += acked ? payloadBytes + ProtocolLimits.DATAGRAM_OVERHEAD_BYTES : 0;
  }

  /**
   * Earns the right to send for a tick, and adapts the pace now and then.
   *
   * @param ackedBytes bytes on the wire that were ever acked
   */
  void tick(long ackedBytes) {
    tokens = Math.min(rate * BURST_SECONDS, tokens + rate / tickRate);
    if (++ticks < intervalTicks || (isSlow() && mayBeChance())) {
      return;
    }
    float seconds = (float) ticks / tickRate;
    float delivered = (ackedBytes - ackedBefore) / seconds;
    if (quickest == NEVER) {
      rateBefore = Math.max(rateBefore, rate);
      rate = sent > 0 ? rate * SILENCE : rate;
    } else {
      emptyNow = Math.min(emptyNow, quickest);
      if (!isSlow()) {
        unfedTicks = 0;
      }
      if (isSlow() && !isLonger(delivered * seconds)) {
        // Few acks in a short interval may be chance: half at most at a time.
        rate = Math.max(rate * SILENCE, Math.min(rate, delivered * DRAIN));
        rateBefore = 0;
      } else if (rate * RETURN <= rateBefore) {
        rate *= RETURN;
      } else {
        rate *= RISE;
        rateBefore = 0;
      }
    }
    rate = Math.max(LEAST_BYTES_PER_SECOND, Math.min(most, rate));
    if (++intervals == EMPTY_INTERVALS) {
      intervals = 0;
      emptyBefore = emptyNow;
      emptyNow = NEVER;
    }
    ackedBefore = ackedBytes;
    quickest = NEVER;
    acks = 0;
    ticks = 0;
    sent = 0;
  }

  /**
   * Takes note of a slow interval. Returns true, and takes its delay for that of the empty line, if
   * the line has become longer.
   */
  private boolean isLonger(float ackedBytes) {
    if (sent > FEEDING * ackedBytes) {
      unfedTicks = 0;
      return false;
    }
    if (unfedTicks == 0) {
      rateBeforeSlow = rate;
      measuredTicks = 0;
    }
    if (unfedTicks < quickest) { // these were sent before, and may tell of a queue that still grew
      unfedTicks += ticks;
      return false;
    }
    unfedTicks += ticks;
    if (measuredTicks == 0) {
      quickestUnfed = quickest;
    }
    measuredTicks += ticks;
    if (measuredTicks <= UNFED_INTERVALS * intervalTicks
        || quickestUnfed - quickest >= queueTicks) {
      return false;
    }
    unfedTicks = 0;
    emptyNow = quickest;
    emptyBefore = NEVER;
    rateBefore = rateBeforeSlow;
    return true;
  }

  /** Returns whether even the quickest ack of the interval seems to have waited in a queue. */
  private boolean isSlow() {
    return quickest != NEVER && quickest - Math.min(emptyNow, emptyBefore) > queueTicks;
  }

  private boolean mayBeChance() {
    return acks < ENOUGH_ACKS && ticks < LONGEST_INTERVAL * intervalTicks;
  }

  /** Returns the bytes of payload that may leave now. Not positive when the line needs a rest. */
  int allowance() {
    return payload(tokens);
  }

  /** Returns what {@link #allowance} comes to when nothing is sent for long. */
  int mostAllowance() {
    return payload(rate * BURST_SECONDS);
  }

  private static int payload(float bytes) {
    return (int) Math.min(Integer.MAX_VALUE, bytes - ProtocolLimits.DATAGRAM_OVERHEAD_BYTES);
  }

  /** Returns the present pace, bytes on the wire per second. */
  int bytesPerSecond() {
    return (int) rate;
  }
}
