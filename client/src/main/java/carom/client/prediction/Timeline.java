package carom.client.prediction;

import carom.client.field.OwnWords;
import carom.net.snapshot.exact.NearState;
import carom.net.snapshot.exact.OwnState;
import carom.physics.Body;
import carom.sim.SimState;
import carom.sim.SimulationHost;
import carom.sim.entity.HostEntity;
import carom.sim.entity.HostPlayer;
import carom.sim.near.Neighbourhood;
import carom.sim.spawn.Origin;
import java.util.Arrays;

/**
 * The predicted simulation with its saved past: steps forward, saves each tick, and rolls back. One
 * prediction's; a tick allocates nothing once the ring is filled.
 */
final class Timeline {
  /** Saved ticks; a power of two. */
  static final int RING = 128;

  private static final int MASK = RING - 1;

  private final SimulationHost simulation;
  private final OwnWords words;
  private final MatchWords match;
  private final PlayerInputs inputs;
  private final PredictedPoses poses;
  private final SimState[] saved = new SimState[RING];
  private final int[] savedTick = new int[RING];
  private final int[] hash = new int[RING];
  private final int[] provisionalCount = new int[RING];
  private final int[][] provisional = new int[RING][Origin.MOST_PER_PLAYER];
  private final OwnState[] own = new OwnState[RING];
  private final PredictedHashes hashes = new PredictedHashes(RING);
  private final Neighbourhood scratch;
  private int tick = -1;
  private int correctedTick;

  Timeline(
      SimulationHost simulation,
      HostPlayer player,
      OwnWords words,
      MatchWords match,
      PlayerInputs inputs,
      PredictedPoses poses) {
    this.simulation = simulation;
    this.words = words;
    this.match = match;
    scratch = new Neighbourhood(player.id());
    this.inputs = inputs;
    this.poses = poses;
    for (int i = 0; i < RING; i++) {
      own[i] = new OwnState(OwnWords.count(simulation.schema()));
    }
    forget();
  }

  /** Forgets all saved ticks. */
  void forget() {
    Arrays.fill(savedTick, -1);
  }

  /** Returns the tick that the simulation stands at. */
  int tick() {
    return tick;
  }

  /**
   * Simulates the next tick and saves it.
   *
   * @param input the own input
   * @param repeat whether all players repeat the inputs of the last time
   */
  void step(long input, boolean repeat) {
    inputs.apply(tick + 1, input, repeat);
    simulation.step();
    tick++;
    match.apply(tick);
    save();
  }

  /** Leaves ticks out: the present state counts as the one of another tick from now on. */
  void skipTo(int wanted) {
    for (int t = Math.max(tick + 1, wanted - RING); t <= wanted; t++) {
      savedTick[t & MASK] = -1;
    }
    simulation.mirror().tick(wanted);
    tick = wanted;
    match.apply(tick);
  }

  /** Rolls back (or forward) to a saved tick. */
  void restore(int wanted) {
    simulation.restore(saved[wanted & MASK]);
    tick = wanted;
    match.restored();
    match.apply(tick);
    poses.bind();
  }

  /** Saves the present tick again after a correction. */
  void saveCorrection() {
    correctedTick = Math.max(correctedTick, tick);
    poses.bind();
    inputs.correct(tick);
    if (simulation.hasRules()) {
      simulation.mirror().resume();
    }
    save();
  }

  private void save() {
    int slot = tick & MASK;
    saved[slot] = simulation.save(saved[slot]);
    savedTick[slot] = tick;
    provisionalCount[slot] = simulation.mirror().provisionalCount();
    for (int i = 0; i < provisionalCount[slot]; i++) {
      provisional[slot][i] = simulation.mirror().provisional(i).origin();
    }
    scratch.readAll(simulation);
    hash[slot] = NearState.fold(scratch.hash());
    hashes.store(slot, scratch);
    readOwn(own[slot]);
  }

  private void readOwn(OwnState out) {
    PredictedBody own = poses.own();
    Body<HostEntity> body = own.entity.body();
    out.setBody(
        own.id,
        own.generation,
        body.centerX(),
        body.centerY(),
        body.cos(),
        body.sin(),
        body.velocityX(),
        body.velocityY(),
        body.angularVelocity());
    out.setArchetype(own.entity.archetype().index());
    words.read(out);
  }

  /** Returns whether a tick is saved. */
  boolean isSaved(int wanted) {
    return wanted >= 0 && savedTick[wanted & MASK] == wanted;
  }

  /**
   * Returns the first saved tick after which rules predicted other words of the match than the
   * server has, or {@link Integer#MAX_VALUE} if there is none.
   *
   * @param after tick before the first one to look at
   * @param upTo last tick to look at
   */
  int firstMisruled(int after, int upTo) {
    for (int t = after + 1; simulation.hasRules() && t <= Math.min(upTo, tick); t++) {
      if (isSaved(t) && !match.agrees(saved[t & MASK])) {
        return t;
      }
    }
    return Integer.MAX_VALUE;
  }

  /** Returns the number of provisional entities after a saved tick. */
  int provisionalCount(int savedAt) {
    return provisionalCount[savedAt & MASK];
  }

  /** Returns the origin of a provisional entity after a saved tick. */
  int provisional(int savedAt, int index) {
    return provisional[savedAt & MASK][index];
  }

  /** Returns the hash of the predicted set after a saved tick. */
  int hash(int savedAt) {
    return hash[savedAt & MASK];
  }

  /** Returns whether the server lists some of the bodies of a saved tick and no others. */
  boolean hasMore(int savedAt, NearState near) {
    return hashes.hasMore(savedAt & MASK, near);
  }

  /** Returns the own body after a saved tick. */
  OwnState own(int savedAt) {
    return own[savedAt & MASK];
  }

  /** Pins the prediction of a saved tick for {@link #awakeBodies} and {@link #exactBodies}. */
  void pin(int savedAt) {
    hashes.pin(savedAt & MASK);
  }

  /** Returns how many bodies that are awake after a tick were in the pinned prediction. */
  int awakeBodies(int savedAt) {
    return hashes.awakeCount(savedAt & MASK);
  }

  /** Returns how many of {@link #awakeBodies} were predicted in every bit. */
  int exactBodies(int savedAt) {
    return hashes.exactCount(savedAt & MASK);
  }

  /** Returns the newest tick that was corrected by hand: no replay from before reproduces it. */
  int correctedTick() {
    return correctedTick;
  }
}
