package carom.client.prediction;

import carom.net.snapshot.exact.NearState;
import carom.physics.rows.JointRow;
import carom.physics.rows.RowKind;

/**
 * Exact updates that wait to be applied: the one that snapshots bring at present, and a complete
 * one before it. One prediction's; allocates only to grow.
 */
final class PendingUpdates {
  /** Result of {@link #choose} if there is no update to apply. */
  static final int NONE = Integer.MAX_VALUE;

  private final SnapshotRecords records;
  private final Timeline timeline;
  private final ReplayBudget budget;
  private final Corrector corrector;
  private NearUpdate newest = new NearUpdate();
  private NearUpdate earlier = new NearUpdate();

  PendingUpdates(
      SnapshotRecords records, Timeline timeline, ReplayBudget budget, Corrector corrector) {
    this.records = records;
    this.timeline = timeline;
    this.budget = budget;
    this.corrector = corrector;
  }

  /** Adds the part of an update that a snapshot brings. */
  void add(NearState near, int stateTick) {
    if (newest.isReady() && newest.isFollowedBy(near, stateTick)) {
      NearUpdate complete = newest;
      newest = earlier;
      earlier = complete;
      newest.clear();
    }
    newest.add(near, stateTick);
  }

  /** Forgets everything. */
  void clear() {
    newest.clear();
    earlier.clear();
  }

  /** Returns whether the newest update is complete and not applied yet. */
  boolean isReady() {
    return newest.isReady();
  }

  /** Returns whether an update can be applied that has the exact state of all, the own body too. */
  boolean haveWhole(int ownKey) {
    return isWhole(earlier, ownKey) || isWhole(newest, ownKey);
  }

  private boolean isWhole(NearUpdate update, int ownKey) {
    return update.isReady() && update.isWhole() && update.contains(ownKey) && isUsable(update);
  }

  /** Drops complete updates that were made for an earlier body of the player. */
  void dropForeign(int ownKey) {
    dropForeign(earlier, ownKey);
    dropForeign(newest, ownKey);
  }

  private static void dropForeign(NearUpdate update, int ownKey) {
    if (update.isReady() && !update.contains(ownKey)) {
      update.use();
    }
  }

  /** Drops complete updates that begin before a tick at which all was as the server has it. */
  void dropOlder(int knownTick) {
    dropOlder(earlier, knownTick);
    dropOlder(newest, knownTick);
  }

  private static void dropOlder(NearUpdate update, int knownTick) {
    if (update.isReady() && update.baseTick() < knownTick) {
      update.use();
    }
  }

  /**
   * Chooses the updates to apply now. Drops an update whose replay would exceed the budget, and
   * extends the budget for one that remains.
   *
   * @param present newest predicted tick
   * @return the earliest tick to start from, or {@link #NONE}
   */
  int choose(int present) {
    return Math.min(choose(earlier, present), choose(newest, present));
  }

  private int choose(NearUpdate update, int present) {
    boolean reachable =
        update.isReady() && (timeline.isSaved(update.baseTick()) || update.isWhole());
    if (!reachable || !isUsable(update)) {
      return NONE;
    }
    if (present - update.baseTick() > budget.updateTicks()) {
      update.use();
      budget.countCut();
      return NONE;
    }
    budget.extendForUpdate();
    return update.baseTick();
  }

  /** Applies each update whose base tick is the present one of the timeline. */
  void apply(int ownKey) {
    apply(earlier, ownKey);
    apply(newest, ownKey);
  }

  private void apply(NearUpdate update, int ownKey) {
    if (update.isReady() && timeline.tick() == update.baseTick() && isUsable(update)) {
      if (corrector.apply(update, ownKey)) {
        timeline.saveCorrection();
      }
    }
  }

  /** Drops updates that could have been applied by now and were not. */
  void dropUsable() {
    dropUsable(earlier);
    dropUsable(newest);
  }

  private void dropUsable(NearUpdate update) {
    if (update.isReady() && isUsable(update)) {
      update.use();
    }
  }

  /**
   * Returns whether the identity of all listed entities and the definition of all told joints are
   * known.
   */
  private boolean isUsable(NearUpdate update) {
    for (int row = 0; row < update.rows().count(); row++) {
      if (update.kind(row) == RowKind.JOINT
          && !records.isJointKnown(update.rows().get(row, JointRow.KEY))) {
        return false;
      }
    }
    for (int i = 0; i < update.count(); i++) {
      if (!records.isKnown(update.key(i))) {
        return false;
      }
    }
    return true;
  }
}
