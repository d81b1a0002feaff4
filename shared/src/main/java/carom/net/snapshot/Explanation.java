package carom.net.snapshot;

import java.util.Locale;

/**
 * Answers "why was this entity not sent?": see {@link SnapshotReport#explain}.
 *
 * @param slot the entity asked about
 * @param reason what became of it in the last snapshot
 * @param baseline what its record was, or would be, coded against
 * @param tick tick of the room's newest frame
 * @param ackedTick newest tick of the slot that the client has acked since it came into sight, or
 *     -1
 * @param sentTick last tick at which a record of the slot was sent, or -1
 * @param priority what it collects per tick now
 * @param collected priority collected since it was sent
 * @param needed least that anything sent had collected in the last snapshot that could not hold
 *     everything; 0 when everything fitted
 * @param waiting entities that wait, this one included if it does
 * @param budgetBytes what the last snapshot was allowed to take, all told
 * @param aheadBytes what of it was taken ahead of all entities: by headers, the own body, exact
 *     state of what is near, and events
 * @param nearBytes what of that told what is near
 */
public record Explanation(
    int slot,
    Reason reason,
    BaselineReason baseline,
    int tick,
    int ackedTick,
    int sentTick,
    float priority,
    float collected,
    float needed,
    int waiting,
    int budgetBytes,
    int aheadBytes,
    int nearBytes) {

  /** Says what became of an entity in the last snapshot. */
  public enum Reason {
    /** There is no such entity, and the client doesn't show one. */
    FREE,
    /** The entity is outside of the client's view, or the game hides it. */
    OUT_OF_SIGHT,
    /** The client has the present state and has acked it. */
    UP_TO_DATE,
    /** A record went out with the newest frame. */
    SENT,
    /** A record is on its way; it is sent again with the next snapshot until acked. */
    UNACKED,
    /** Others had collected more priority, and the budget was used up. */
    OVER_BUDGET,
    /** The entity changed after the last snapshot; the next one will tell. */
    NOT_DUE
  }

  /** Returns one line for an operator. */
  @Override
  public String toString() {
    return String.format(
        Locale.ROOT,
        "entity=%d reason=%s baseline=%s tick=%d acked=%d sent=%d priority=%.3f collected=%.3f"
            + " needed=%.3f waiting=%d budget=%d ahead=%d near=%d",
        slot,
        reason,
        baseline,
        tick,
        ackedTick,
        sentTick,
        priority,
        collected,
        needed,
        waiting,
        budgetBytes,
        aheadBytes,
        nearBytes);
  }
}
