package carom.client.prediction;

import carom.client.field.OwnWords;
import carom.net.snapshot.exact.NearState;
import carom.net.snapshot.exact.OwnState;
import carom.sim.SimulationHost;
import carom.sim.near.Neighbourhood;

/**
 * Reconciles the timeline with one state of the server: rolls back, applies updates, compares,
 * corrects, and resimulates up to the present. {@link Prediction} describes the steps. One
 * prediction's; allocates nothing unless it corrects.
 *
 * <p>Nothing goes back behind the last tick at which all was as the server has it. The state of
 * that tick includes what is told late of earlier ones. The states saved before it may lack what
 * was put right since.
 */
final class Reconciler {
  private final SimulationHost simulation;
  private final PlayerInputs inputs;
  private final PredictedPoses poses;
  private final Timeline timeline;
  private final Corrector corrector;
  private final PendingUpdates updates;
  private final SpawnSettler settler;
  private final OwnWords words;
  private final ReceivedRulings rulings;
  private final ReplayBudget budget;
  private final Agreement agreement;
  private final Reconciliation result;
  private OwnState server;
  private int stateTick;

  Reconciler(
      SimulationHost simulation,
      PlayerInputs inputs,
      PredictedPoses poses,
      Timeline timeline,
      Corrector corrector,
      PendingUpdates updates,
      SpawnSettler settler,
      OwnWords words,
      ReceivedRulings rulings,
      ReplayBudget budget,
      Agreement agreement,
      Reconciliation result) {
    this.simulation = simulation;
    this.inputs = inputs;
    this.poses = poses;
    this.timeline = timeline;
    this.corrector = corrector;
    this.updates = updates;
    this.settler = settler;
    this.words = words;
    this.rulings = rulings;
    this.budget = budget;
    this.agreement = agreement;
    this.result = result;
  }

  /**
   * Starts the timeline at the first state of a body, and predicts from there up to the present.
   *
   * @param own the body's state after {@code tick}; used during the call only
   */
  void start(OwnState own, int tick) {
    begin(own, tick);
    timeline.skipTo(tick);
    correctTick(true);
    rewind(Integer.MAX_VALUE, inputs.newest());
    replay(inputs.newest());
    end();
  }

  /**
   * Reconciles the timeline with a state.
   *
   * @param own the own body's state after {@code tick}; used during the call only
   * @param lastTick tick of the last reconciliation
   * @param changedTick the first tick after which the match has other fields than was known, or
   *     {@link Integer#MAX_VALUE}
   */
  void reconcile(OwnState own, int tick, int lastTick, int changedTick) {
    begin(own, tick);
    poses.beginCorrection();
    int present = Math.max(timeline.tick(), tick);
    result.compared = timeline.isSaved(tick);
    result.exact = result.compared && timeline.own(tick).sameAs(own);
    if (result.compared) {
      result.predicted.set(timeline.own(tick));
      timeline.pin(tick);
    }
    int oldest = Math.max(lastTick, timeline.tick() - Timeline.RING + 1);
    int ruled = rulings.takeFirst(agreement.equalTick());
    int changed = simulation.hasRules() ? timeline.firstMisruled(oldest, tick) : changedTick;
    if (changed < timeline.tick()) {
      ruled = Math.min(ruled, Math.max(changed, oldest) + 1);
    }
    int otherInput = inputs.firstMispredicted(oldest, timeline.tick());
    result.ruled = ruled <= timeline.tick();
    result.otherInputs = otherInput <= timeline.tick();
    int mispredicted = Math.min(ruled, otherInput);
    int from = rewind(mispredicted, present);
    if (from < 0 && tick > timeline.tick()) {
      timeline.skipTo(tick); // the server is ahead: this tick was never predicted
      settler.settle(server.spawned());
      correctTick(false);
      from = tick;
    } else {
      from = compare(leave(settle(from)));
      if (ruled <= tick) {
        tell(tick);
      }
      if (from < 0 && isWorthRollback(mispredicted, present)) {
        from = mispredicted - 1;
        timeline.restore(from);
      }
    }
    if (from >= 0) {
      result.rolledBackTicks = present - from;
      replay(present);
      result.correctionMetres = poses.endCorrection();
    }
    result.corrected = result.compared && !result.exact && !result.told;
    end();
  }

  /**
   * Lets provisional entities of the state's tick become the server's, or go.
   *
   * @param from the tick of a rollback that has happened, or -1
   * @return the tick to replay from, or -1 if nothing has changed
   */
  private int settle(int from) {
    boolean isDue = false;
    int count = timeline.isSaved(stateTick) ? timeline.provisionalCount(stateTick) : 0;
    for (int i = 0; i < count; i++) {
      isDue |= settler.isDue(timeline.provisional(stateTick, i), server.spawned());
    }
    if (!isDue) {
      return from;
    }
    if (timeline.tick() != stateTick) {
      timeline.restore(stateTick);
    }
    settler.settle(server.spawned());
    timeline.saveCorrection();
    result.exact = result.compared && timeline.own(stateTick).sameAs(server); // means other ids
    return from < 0 ? stateTick : from;
  }

  /**
   * Removes the entities that have left the predicted set at the state's tick. The update that says
   * since when may be lost, and the list is in each snapshot: so the loss costs nothing, unless one
   * of them touched another in between. A list without the own body isn't an honest server's.
   *
   * @param from the tick of a rollback that has happened, or -1
   * @return the tick to replay from, or -1 if nothing has changed
   */
  private int leave(int from) {
    NearState near = server.near();
    boolean isHonest = near.present() && near.lists(ownKey());
    if (!isHonest || !timeline.isSaved(stateTick) || !timeline.hasMore(stateTick, near)) {
      return from;
    }
    if (timeline.tick() != stateTick) {
      timeline.restore(stateTick);
    }
    corrector.dropUnlisted(near);
    timeline.saveCorrection();
    return from < 0 ? stateTick : from;
  }

  /** Counts what was predicted otherwise, and is right with a ruling that came, as told. */
  private void tell(int tick) {
    boolean right = timeline.isSaved(tick) && timeline.own(tick).sameAs(server);
    result.told |= result.compared && !result.exact && right;
    if (right && agreement.agreedTick() == tick) {
      result.toldBodies = result.awakeBodies - result.exactBodies;
      result.awakeBodies = result.exactBodies;
    }
  }

  private void begin(OwnState own, int tick) {
    server = own;
    stateTick = tick;
    updates.dropForeign(ownKey());
    updates.dropOlder(agreement.equalTick());
    budget.begin();
  }

  private void end() {
    result.replayNs = budget.end(result.replayedTicks);
  }

  /**
   * Rolls back and resimulates up to the state's tick, if an input before it was mispredicted or an
   * update can be applied.
   *
   * @param mispredicted the first tick that was simulated with a mispredicted input
   * @return the tick of the rollback, or -1 if there was none
   */
  private int rewind(int mispredicted, int present) {
    boolean past = mispredicted <= stateTick && isWorthRollback(mispredicted, present);
    int from = past ? mispredicted - 1 : Integer.MAX_VALUE;
    from = Math.min(from, updates.choose(present));
    if (from > stateTick) {
      updates.dropUsable();
      return -1;
    }
    if (timeline.isSaved(from)) {
      timeline.restore(from);
    } else {
      timeline.skipTo(from); // the update replaces everything
    }
    while (true) {
      updates.apply(ownKey());
      if (timeline.tick() == stateTick) {
        updates.dropUsable();
        return from;
      }
      resimulate();
    }
  }

  private boolean isWorthRollback(int mispredicted, int present) {
    return timeline.isSaved(mispredicted - 1) && present - mispredicted < budget.usualTicks();
  }

  private int ownKey() {
    return Neighbourhood.key(poses.own().id, poses.own().generation);
  }

  /**
   * Compares the state's tick with the server and, if they differ, corrects it.
   *
   * @param from the tick of a rollback that has happened, or -1
   * @return the tick to replay from, or -1 if nothing has changed
   */
  private int compare(int from) {
    NearState near = server.near();
    boolean ownEqual = timeline.isSaved(stateTick) && timeline.own(stateTick).sameAs(server);
    if (ownEqual && (!near.present() || timeline.hash(stateTick) == near.hash())) {
      agreement.agree(stateTick, near.present());
      if (result.compared) {
        result.awakeBodies = timeline.awakeBodies(stateTick);
        result.exactBodies = timeline.exactBodies(stateTick);
      }
      return from;
    }
    boolean sameSet = !near.present() || timeline.hash(stateTick) == near.hash();
    if (sameSet && timeline.isSaved(stateTick) && timeline.own(stateTick).sameBody(server)) {
      return takeWords(from);
    }
    boolean updateComes = near.updating() || (updates.isReady() && near.present());
    if (ownEqual && updateComes) {
      return from;
    }
    if (!updateComes
        && agreement.disagree(stateTick)
        && near.present()
        && isReproducible(agreement.equalTick())) {
      agreement.diverge();
    }
    result.awakeBodies = result.compared ? timeline.awakeBodies(stateTick) : 0;
    if (timeline.tick() != stateTick && timeline.isSaved(stateTick)) {
      timeline.restore(stateTick);
    } else {
      timeline.skipTo(stateTick);
    }
    if (agreement.hasDiverged()) {
      agreement.divergedState().readAll(simulation);
    }
    correctTick(false);
    return from < 0 ? stateTick : from;
  }

  /**
   * Takes the server's words of the own player's fields: its rules wrote them, so the server sends
   * them, and it counts as no misprediction. All bodies are equal and stay as they are.
   *
   * @param from the tick of a rollback that has happened, or -1
   */
  private int takeWords(int from) {
    if (timeline.tick() != stateTick) {
      timeline.restore(stateTick);
    }
    words.write(server);
    timeline.saveCorrection();
    result.told = result.compared;
    agreement.agree(stateTick, server.near().present());
    return from < 0 ? stateTick : from;
  }

  /**
   * Returns whether the state's tick follows from an equal one and real inputs alone: no input and
   * no effect of one was guessed, no tick left out, and nothing corrected in between.
   */
  private boolean isReproducible(int equalTick) {
    if (equalTick < 0
        || !inputs.areKnown(equalTick)
        || timeline.correctedTick() > equalTick
        || stateTick - equalTick >= Timeline.RING) {
      return false;
    }
    for (int t = equalTick + 1; t <= stateTick; t++) {
      if (!timeline.isSaved(t) || !inputs.areConfirmed(t) || rulings.isGuessed(t)) {
        return false;
      }
    }
    return true;
  }

  private void correctTick(boolean ownOnly) {
    corrector.correct(server, stateTick, ownOnly);
    timeline.saveCorrection();
  }

  /** Resimulates up to a tick. Leaves out the oldest ticks beyond the budget. */
  private void replay(int present) {
    int most = budget.ticks();
    if (present - timeline.tick() > most) {
      budget.countCut();
      timeline.skipTo(present - most);
    }
    while (timeline.tick() < present) {
      if (budget.isSpent() && timeline.tick() < present - 1) {
        budget.countCut();
        timeline.skipTo(present - 1);
      }
      if (timeline.tick() == present - 1) {
        poses.follow(true);
        poses.beginTick();
      }
      resimulate();
    }
    poses.follow(true);
  }

  private void resimulate() {
    timeline.step(inputs.at(timeline.tick() + 1), false);
    result.replayedTicks++;
  }
}
