package carom.net.snapshot;

import carom.net.snapshot.frame.EventOutbox;
import carom.net.snapshot.frame.FrameRing;
import carom.net.snapshot.frame.FrameState;

/**
 * Report on one client's last snapshot: what it took, what waits, and why an entity was sent or
 * not. For reading only; nothing here changes what is sent. Use it on the room's thread.
 */
public final class SnapshotReport {
  private final FrameRing ring;
  private final ClientKnowledge client;
  private final Selection selection;
  private final EventOutbox events;

  private int tick = -1;
  private boolean news;
  private int budgetBytes;
  private int aheadBytes;
  private int nearBytes;

  SnapshotReport(FrameRing ring, ClientKnowledge client, Selection selection, EventOutbox events) {
    this.ring = ring;
    this.client = client;
    this.selection = selection;
    this.events = events;
  }

  // ---- what the encoder notes

  /** Notes that a snapshot is begun. */
  void begin(int newTick, boolean hasNews, int budget) {
    tick = newTick;
    news = hasNews;
    budgetBytes = budget;
    aheadBytes = 0;
    nearBytes = 0;
  }

  /**
   * Notes what a datagram holds ahead of its records.
   *
   * @param near bytes of the near section with its rows, part of {@code ahead}
   */
  void wroteAhead(int ahead, int near) {
    aheadBytes += ahead;
    nearBytes += near;
  }

  // ---- the last snapshot

  /**
   * Returns whether the snapshot begun last holds anything that the client isn't known to have. If
   * so, the client is asked to ack soon.
   */
  public boolean hasNews() {
    return news;
  }

  /**
   * Returns the bytes of the last snapshot that weren't records: headers, own and near sections,
   * events.
   */
  public int aheadBytes() {
    return aheadBytes;
  }

  /** Returns the bytes of the last near section with its rows, part of {@link #aheadBytes}. */
  public int nearBytes() {
    return nearBytes;
  }

  /**
   * Returns how many changed entities are not sent yet in this tick. After the last {@link
   * SnapshotEncoder#next} these must wait.
   */
  public int waiting() {
    return selection.waiting();
  }

  /** Returns the number of events offered that are not acked yet. */
  public int eventsWaiting() {
    return events.waiting();
  }

  /** Returns the number of events that were dropped because too many waited. */
  public long eventsLost() {
    return events.lost();
  }

  // ---- one entity

  /** Returns the newest tick of the slot acked since it came into sight, or -1. */
  public int ackedTick(int slot) {
    return client.ackedTick(slot);
  }

  /** Returns the last tick at which a record of the slot was sent, or -1. */
  public int sentTick(int slot) {
    return client.sentTick(slot);
  }

  /**
   * Returns the priority that a slot has collected since it was sent; 0 if there is no such slot.
   */
  public float collectedPriority(int slot) {
    return selection.weight(slot);
  }

  /**
   * Returns what the slot's record would be coded against now, and why.
   *
   * @param slot 0..capacity - 1
   */
  public BaselineReason baseline(int slot) {
    FrameState newest = ring.newest();
    if (newest == null || slot >= newest.slotLimit()) {
      return BaselineReason.QUIESCENT;
    }
    client.update(newest);
    return client.baseline(newest, slot);
  }

  /**
   * Explains why the slot's entity was sent with the last snapshot, or was not. For operators and
   * tests; allocates.
   *
   * @param slot 0..capacity - 1
   */
  public Explanation explain(int slot) {
    BaselineReason baseline = baseline(slot);
    FrameState newest = ring.newest();
    return new Explanation(
        slot,
        reason(newest, slot, baseline),
        baseline,
        newest == null ? -1 : newest.tick(),
        ackedTick(slot),
        sentTick(slot),
        newest == null ? 0 : selection.priority(newest, slot),
        selection.weight(slot),
        selection.leastChosen(),
        waiting(),
        budgetBytes,
        aheadBytes,
        nearBytes);
  }

  private Explanation.Reason reason(FrameState newest, int slot, BaselineReason baseline) {
    if (sentTick(slot) >= 0 && sentTick(slot) == tick) {
      return Explanation.Reason.SENT;
    }
    if (baseline == BaselineReason.QUIESCENT) {
      if (newest == null || !newest.alive(slot)) {
        return Explanation.Reason.FREE;
      }
      return client.isInSight(slot)
          ? Explanation.Reason.UP_TO_DATE
          : Explanation.Reason.OUT_OF_SIGHT;
    }
    if (ring.changedTick(slot) > tick) {
      return Explanation.Reason.NOT_DUE;
    }
    return sentTick(slot) >= ring.changedTick(slot)
        ? Explanation.Reason.UNACKED
        : Explanation.Reason.OVER_BUDGET;
  }
}
