package carom.client.prediction;

import carom.client.interpolation.Pose;
import carom.client.interpolation.VisualError;
import carom.net.snapshot.SnapshotDecoder;
import carom.net.snapshot.exact.NearState;
import carom.net.snapshot.exact.OwnState;
import carom.physics.Body;
import carom.sim.Entity;
import carom.sim.Neighbourhood;
import carom.sim.Player;
import carom.sim.Role;
import carom.sim.SimState;
import carom.sim.Simulation;
import java.util.Arrays;
import java.util.function.LongSupplier;

/**
 * Runs the own body, and what is near it, ahead of the server, and corrects itself.
 *
 * <p>The server says who is near ({@link NearState}), with a hash of their exact state. Whoever
 * comes near is told exactly once; from then on both sides compute the same, bit by bit, from the
 * same inputs: the own ones, and those of other players, which the server relays. Until they are
 * known, a player is taken to do what it did last, and a little less each tick ({@link
 * Input#faded}).
 *
 * <p>What happens when the server's state after tick T arrives:
 *
 * <ol>
 *   <li>If another player's inputs were not as foreseen, those included that wait at the server for
 *       ticks after T, or an {@linkplain NearUpdate update} is complete, the simulation returns to
 *       the saved state before, takes over what was told, and runs to T again, with the true
 *       inputs.
 *   <li>If now the hash of T is the server's, all is well.
 *   <li>Else the own body is put right from the own section, and others where the quantised records
 *       disagree; the server is told that the hash differed, and sends an update of all.
 *   <li>If anything changed, the inputs since T are replayed. The jump of the picture is handed to
 *       {@link VisualError}; the state itself is never blended.
 * </ol>
 *
 * <p>Bounded: at most {@code maxRollbackTicks} are replayed, for at most {@code maxReplayNs}, or
 * {@value #UPDATE_WORTH} times that when an update is taken over; what is too much is left out, the
 * oldest first, and counted. How long it will take is known from the ticks before. One thread; a
 * tick in which nothing is corrected allocates nothing.
 */
public final class Prediction {
  /** Saved ticks; a power of two. */
  static final int RING = 128;

  private static final int MASK = RING - 1;

  /** Ticks that the synctest rolls back. */
  static final int SYNC_TICKS = 8;

  /** Exact states come rarely, and are worth a longer replay than what happens all the time. */
  private static final int UPDATE_WORTH = 3;

  private final Simulation simulation;
  private final Player player;
  private final int maxRollbackTicks;
  private final long maxReplayNs;
  private final LongSupplier stopwatch;
  private final boolean syncTest;
  private final SimState[] saved = new SimState[RING];
  private final int[] savedTick = new int[RING];
  private final int[] hash = new int[RING];
  private final Foreseen foreseen = new Foreseen(RING);
  private final OwnState[] ownAt = new OwnState[RING];
  private final Neighbourhood here = new Neighbourhood();
  private final OwnState server = new OwnState();
  private final OwnState predicted = new OwnState();
  private final Records records;
  private final PlayerInputs inputs;
  private final Mending mending;
  private final Pictures pictures;

  /**
   * The update that snapshots bring at present, and a complete one before it that waits for use.
   */
  private NearUpdate update = new NearUpdate();

  private NearUpdate earlier = new NearUpdate();

  private boolean active;
  private int tick = -1;
  private int confirmed = -1;
  private int agreedTick = -1;
  private int disagreedTick = -1;
  private int firstDisagreedTick = -1;
  private long disagreements;

  /** The newest tick at which the hash of what is near was the server's. */
  private int equalTick = -1;

  private boolean diverged;
  private final Neighbourhood divergedState = new Neighbourhood();

  /** What a tick takes to compute again, as measured; 0 when it doesn't count. */
  private double nsPerTick;

  private boolean compared;
  private boolean exact;
  private boolean agreed;
  private boolean corrected;
  private float correctionMetres;
  private int awakeBodies;
  private int exactBodies;
  private int replayed;
  private int rolledBack;
  private long worthNs;
  private long replayNs;
  private long cutShort;

  /** The newest tick whose state was put right by hand: no replay from before gives it. */
  private int changedTick;

  private boolean testing;
  private long syncErrors;

  /**
   * Creates a prediction that waits for the server's first state.
   *
   * @param simulation of role PREDICTION, fresh; owned by this from now on
   * @param playerId the own player's id
   * @param name the own player's name
   * @param maxRollbackTicks longest replay, 1..120
   * @param maxReplayNs longest time a replay may take, nanoseconds
   * @param stopwatch measures it
   * @param syncTest whether to roll back {@value #SYNC_TICKS} ticks in each tick and compare the
   *     hashes; for developers, takes ten times as long
   */
  public Prediction(
      Simulation simulation,
      int playerId,
      String name,
      int maxRollbackTicks,
      long maxReplayNs,
      LongSupplier stopwatch,
      boolean syncTest) {
    if (simulation.role() != Role.PREDICTION) {
      throw new IllegalArgumentException("role=" + simulation.role() + " must be PREDICTION");
    }
    if (maxRollbackTicks < 1 || maxRollbackTicks > RING - 8) {
      throw new IllegalArgumentException(
          "maxRollbackTicks=" + maxRollbackTicks + " is outside 1.." + (RING - 8));
    }
    this.simulation = simulation;
    this.maxRollbackTicks = maxRollbackTicks;
    this.maxReplayNs = maxReplayNs;
    this.stopwatch = stopwatch;
    this.syncTest = syncTest;
    records = new Records(simulation);
    player = simulation.joinAs(playerId, name);
    inputs = new PlayerInputs(simulation, player, records, RING);
    mending = new Mending(simulation, records);
    pictures = new Pictures(simulation, records);
    Arrays.fill(savedTick, -1);
    for (int i = 0; i < RING; i++) {
      ownAt[i] = new OwnState();
    }
  }

  /** The predicted simulation, for debug drawing. Look, don't touch. */
  public Simulation simulation() {
    return simulation;
  }

  /** Whether there is an own body to predict. */
  public boolean active() {
    return active;
  }

  /** Newest tick predicted; meaningful while {@link #active}. */
  public int tick() {
    return tick;
  }

  /**
   * The newest tick at which the server had another state than could be put right exactly, or -1
   * when all was right since: the server should tell all of it.
   */
  public int disagreedTick() {
    return disagreedTick;
  }

  // ---- forward

  /**
   * Predicts one tick. Ticks ascend; ticks left out count as having the input of the last one.
   *
   * @param newTick the tick to predict
   * @param input the own player's packed input for it
   */
  public void step(int newTick, long input) {
    inputs.put(newTick, input);
    if (!active || newTick <= tick) {
      return;
    }
    if (newTick - tick > maxRollbackTicks) {
      skipTo(newTick - 1); // the clock jumped: what lies between can't be made up for
    }
    while (tick < newTick) {
      if (tick == newTick - 1) {
        pictures.stepping();
      }
      stepOnce(tick + 1, input);
    }
    if (syncTest) {
      testSync();
    }
  }

  /** Leaves ticks out: the state of the present counts as that of another tick. */
  private void skipTo(int wanted) {
    for (int t = Math.max(tick + 1, wanted - RING); t <= wanted; t++) {
      savedTick[t & MASK] = -1;
    }
    simulation.tick(wanted);
    tick = wanted;
  }

  private void stepOnce(int next, long input) {
    inputs.steer(next, input, testing);
    simulation.step();
    tick = next;
    keep();
  }

  private void keep() {
    int slot = tick & MASK;
    saved[slot] = simulation.save(saved[slot]);
    savedTick[slot] = tick;
    here.readAll(simulation);
    hash[slot] = NearState.fold(here.hash());
    foreseen.keep(slot, here);
    read(ownAt[slot]);
  }

  private void read(OwnState out) {
    Neighbour own = pictures.own();
    Body<Entity> body = own.entity.body();
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
    for (int i = 0; i < OwnState.MEMORY; i++) {
      out.setMemory(i, player.memory()[i]);
    }
  }

  private boolean isSaved(int wanted) {
    return wanted >= 0 && savedTick[wanted & MASK] == wanted;
  }

  private void restore(int wanted) {
    simulation.restore(saved[wanted & MASK]);
    tick = wanted;
    pictures.bind();
  }

  /** Goes back a few ticks and comes again: the hash must be the same. */
  private void testSync() {
    int present = tick;
    int from = present - SYNC_TICKS;
    for (int t = from; t <= present; t++) {
      if (t < changedTick || !isSaved(t) || !inputs.has(t)) {
        return;
      }
    }
    int expected = hash[present & MASK];
    restore(from);
    testing = true;
    while (tick < present) {
      stepOnce(tick + 1, inputs.at(tick + 1));
    }
    testing = false;
    if (hash[present & MASK] != expected) {
      syncErrors++;
    }
  }

  // ---- correction

  /**
   * Takes what a snapshot tells of what is near; call it for each one, in order of arrival.
   *
   * @param near its near section
   * @param stateTick its tick
   */
  public void hear(NearState near, int stateTick) {
    if (update.isReady() && update.isFollowedBy(near, stateTick)) {
      NearUpdate done = update;
      update = earlier;
      earlier = done;
      update.clear();
    }
    update.hear(near, stateTick);
  }

  /**
   * Compares the server's newest state with what was predicted for its tick and corrects what
   * differs. Call it once per frame when a newer own state arrived.
   *
   * @param newest the own state after {@code stateTick}; copied
   * @param stateTick its tick; not newer than the last one: nothing happens
   * @param decoder the histories of all others, and the inputs of players
   */
  public void reconcile(OwnState newest, int stateTick, SnapshotDecoder decoder) {
    compared = false;
    agreed = false;
    diverged = false;
    corrected = false;
    replayed = 0;
    rolledBack = 0;
    awakeBodies = 0;
    exactBodies = 0;
    if (stateTick <= confirmed) {
      return;
    }
    int before = confirmed;
    confirmed = stateTick;
    server.set(newest);
    records.of(decoder);
    if (!sameBody()) {
      return;
    }
    long begin = stopwatch.getAsLong();
    worthNs = maxReplayNs;
    if (!active) {
      skipTo(stateTick);
      active = true;
      putRight(stateTick, true);
      rewind(stateTick, Integer.MAX_VALUE, inputs.newest());
      replay(inputs.newest(), begin);
    } else {
      pictures.correcting();
      int present = Math.max(tick, stateTick);
      compared = isSaved(stateTick);
      exact = compared && ownAt[stateTick & MASK].sameAs(server);
      if (compared) {
        predicted.set(ownAt[stateTick & MASK]);
        foreseen.remember(stateTick & MASK);
      }
      int wrong = inputs.firstWrong(Math.max(before, tick - RING + 1), tick);
      int from = rewind(stateTick, wrong, present);
      if (from < 0 && stateTick > tick) {
        skipTo(stateTick); // the server is ahead of us: nothing was predicted for this tick
        putRight(stateTick, false);
        from = stateTick;
      } else {
        from = compare(stateTick, from);
        if (from < 0 && isWorthReturning(wrong, present)) {
          from = wrong - 1;
          restore(from);
        }
      }
      if (from >= 0) {
        rolledBack = present - from;
        replay(present, begin);
        correctionMetres = pictures.corrected();
      }
      corrected = compared && !exact;
    }
    replayNs = stopwatch.getAsLong() - begin;
    if (replayed > 0) {
      nsPerTick += ((double) replayNs / replayed - nsPerTick) * (nsPerTick == 0 ? 1 : 0.25);
    }
  }

  /** How many ticks can be computed again in a time; as many as are allowed when it is unknown. */
  private int affordable(long ns) {
    return nsPerTick <= 0
        ? maxRollbackTicks
        : (int) Math.max(1, Math.min(maxRollbackTicks, ns / nsPerTick));
  }

  /**
   * Runs to a tick again when something before it was not as foreseen.
   *
   * @param wrong the first tick with another input than was foreseen
   * @return the tick it returned to, or -1 when all was as foreseen
   */
  private int rewind(int stateTick, int wrong, int present) {
    boolean past = wrong <= stateTick && isWorthReturning(wrong, present);
    int from = past ? wrong - 1 : Integer.MAX_VALUE;
    from = Math.min(from, Math.min(tellsFrom(earlier, present), tellsFrom(update, present)));
    if (from > stateTick) {
      dismiss(earlier);
      dismiss(update);
      return -1;
    }
    if (isSaved(from)) {
      restore(from);
    } else {
      skipTo(from); // the update that is taken over now leaves nothing as it was
    }
    while (true) {
      takeUpdate(earlier);
      takeUpdate(update);
      if (tick == stateTick) {
        dismiss(earlier);
        dismiss(update);
        return from;
      }
      again(tick + 1);
    }
  }

  /** Whether to compute a tick again in which somebody did something else than was foreseen. */
  private boolean isWorthReturning(int wrong, int present) {
    return isSaved(wrong - 1) && present - wrong < affordable(maxReplayNs);
  }

  /** The tick whose state an update tells, or a huge one when it is of no use now. */
  private int tellsFrom(NearUpdate told, int present) {
    boolean possible = told.isReady() && (isSaved(told.baseTick()) || told.tellsAll());
    if (!possible || !isUsable(told)) {
      return Integer.MAX_VALUE;
    }
    if (present - told.baseTick() > affordable(UPDATE_WORTH * maxReplayNs)) {
      told.use();
      cutShort++;
      return Integer.MAX_VALUE;
    }
    worthNs = UPDATE_WORTH * maxReplayNs;
    return told.baseTick();
  }

  /** An update that could not be taken over by now is of no use. */
  private void dismiss(NearUpdate told) {
    if (told.isReady() && isUsable(told)) {
      told.use();
    }
  }

  private void takeUpdate(NearUpdate told) {
    if (!told.isReady() || tick != told.baseTick() || !isUsable(told)) {
      return;
    }
    if (mending.take(told, ownKey())) {
      changed();
    }
  }

  private int ownKey() {
    return Neighbourhood.key(pictures.own().id, pictures.own().generation);
  }

  private void putRight(int stateTick, boolean fresh) {
    mending.putRight(server, stateTick, fresh);
    changed();
  }

  /** The state of this tick is another now. */
  private void changed() {
    changedTick = Math.max(changedTick, tick);
    pictures.bind();
    keep();
  }

  /** Whether it is known who all those are that the update lists, the own body among them. */
  private boolean isUsable(NearUpdate told) {
    if (!told.lists(ownKey())) {
      told.use(); // it is of an earlier body's
      return false;
    }
    for (int i = 0; i < told.count(); i++) {
      if (!records.know(told.key(i))) {
        return false;
      }
    }
    return true;
  }

  /** Compares; answers the tick to replay from, or -1 when nothing has changed. */
  private int compare(int stateTick, int from) {
    boolean same = isSaved(stateTick) && ownAt[stateTick & MASK].sameAs(server);
    NearState near = server.near();
    if (same && (!near.present() || hash[stateTick & MASK] == near.hash())) {
      agreed = compared && from < 0;
      agreedTick = stateTick;
      equalTick = near.present() ? stateTick : -1;
      disagreedTick = -1;
      if (compared) {
        awakeBodies = foreseen.awake(stateTick & MASK);
        exactBodies = foreseen.right(stateTick & MASK);
      }
      return from;
    }
    boolean waits = near.updating() || (update.isReady() && near.present());
    if (same && waits) {
      return from; // what is near is about to be told
    }
    if (!waits) {
      if (disagreedTick < 0) {
        firstDisagreedTick = stateTick;
        disagreements++;
        diverged = near.present() && isForeseeable(stateTick);
      }
      disagreedTick = stateTick;
    }
    awakeBodies = compared ? foreseen.awake(stateTick & MASK) : 0;
    if (tick != stateTick && isSaved(stateTick)) {
      restore(stateTick);
    } else {
      skipTo(stateTick);
    }
    if (diverged) {
      divergedState.readAll(simulation);
    }
    putRight(stateTick, false);
    return from < 0 ? stateTick : from;
  }

  /**
   * Whether the state of a tick follows from one that was the server's and true inputs alone: none
   * was foreseen, no tick left out, nothing put right in between.
   */
  private boolean isForeseeable(int stateTick) {
    if (equalTick < 0 || changedTick > equalTick || stateTick - equalTick >= RING) {
      return false;
    }
    for (int t = equalTick + 1; t <= stateTick; t++) {
      if (!isSaved(t) || !inputs.areTrue(t)) {
        return false;
      }
    }
    return true;
  }

  /** Keeps the own body's identity in step with the server; false when there is none. */
  private boolean sameBody() {
    if (server.slot() < 0) {
      stop();
      update.clear();
      earlier.clear();
      takeMemory();
      return false;
    }
    Neighbour own = pictures.own();
    if (own != null && own.id == server.slot() && own.generation == server.generation()) {
      return true;
    }
    stop();
    if (!records.know(Neighbourhood.key(server.slot(), server.generation()))) {
      return false; // its record is still on the way
    }
    pictures.begin(server.slot(), server.generation());
    return true;
  }

  private void takeMemory() {
    for (int i = 0; i < OwnState.MEMORY; i++) {
      player.memory()[i] = server.memory(i);
    }
  }

  private void stop() {
    pictures.clear();
    active = false;
    disagreedTick = -1;
    equalTick = -1;
    mending.empty();
    Arrays.fill(savedTick, -1);
  }

  /** Replays the inputs up to a tick; what takes too long is left out, the oldest first. */
  private void replay(int present, long begin) {
    int most = affordable(worthNs);
    if (present - tick > most) {
      cutShort++;
      skipTo(present - most);
    }
    while (tick < present) {
      if (stopwatch.getAsLong() - begin > worthNs && tick < present - 1) {
        cutShort++;
        skipTo(present - 1);
      }
      if (tick == present - 1) {
        pictures.stepping();
      }
      again(tick + 1);
    }
  }

  private void again(int next) {
    stepOnce(next, inputs.at(next));
    replayed++;
  }

  // ---- the picture

  /** Lets time pass for what fades. */
  public void advance(float seconds) {
    pictures.advance(seconds);
  }

  /**
   * Share of the prediction in what is drawn of an entity, 0..1; 0 when it is not predicted.
   *
   * @param id its slot
   * @param generation its generation
   * @param fraction how much of the tick after {@link #tick}'s predecessor has passed, 0..1
   * @param out receives the predicted pose with what is left of corrections; unchanged at 0
   */
  public float drawn(int id, int generation, float fraction, Pose out) {
    return active ? pictures.drawn(id, generation, fraction, out) : 0;
  }

  /** One of the own player's memory ints, as predicted. */
  public int memory(int index) {
    return player.memory()[index];
  }

  // ---- what the last reconcile did

  /** Whether nobody else was near, so that nothing but the own inputs and statics count. */
  public boolean alone() {
    return pictures.alone();
  }

  /** What was predicted for the tick that was compared last; valid while {@link #compared}. */
  public OwnState predicted() {
    return predicted;
  }

  /** Whether a prediction was there to compare with. */
  public boolean compared() {
    return compared;
  }

  /** Whether the own body was right in every bit. */
  public boolean exact() {
    return compared && exact;
  }

  /** Whether all that is near was right in every bit. */
  public boolean agreed() {
    return compared && agreed;
  }

  /** Bodies near and awake, whose prediction was compared. */
  public int awakeBodies() {
    return awakeBodies;
  }

  /** How many of {@link #awakeBodies} were right in every bit. */
  public int exactBodies() {
    return exactBodies;
  }

  /** Whether the own body was corrected. */
  public boolean corrected() {
    return corrected;
  }

  /** How far the correction moved the own body in the present, metres. */
  public float correctionMetres() {
    return corrected ? correctionMetres : 0;
  }

  /** Ticks simulated again. */
  public int replayed() {
    return replayed;
  }

  /** How many ticks before the present the simulation returned to; 0 when it didn't. */
  public int rolledBack() {
    return rolledBack;
  }

  /** Time the last reconcile took, nanoseconds. */
  public long replayNs() {
    return replayNs;
  }

  /** Replays that were too long, or took too long, so that ticks were left out. */
  public long cutShort() {
    return cutShort;
  }

  /** Ticks in which the synctest found another hash; 0 unless the simulation has a fault. */
  public long syncErrors() {
    return syncErrors;
  }

  /**
   * The tick since which the server has another state, in ticks that were compared; -1 while there
   * is none: where to look for what went another way.
   */
  public int firstDisagreedTick() {
    return disagreedTick < 0 ? -1 : firstDisagreedTick;
  }

  /**
   * Whether the server's state of what is near began to differ at the tick compared last, and
   * nothing explains it: at {@link #equalTick} it was equal, and since then all inputs were known
   * and nothing was put right.
   */
  public boolean diverged() {
    return diverged;
  }

  /** The newest tick at which the hash of what is near was the server's, or -1. */
  public int equalTick() {
    return equalTick;
  }

  /** What was computed for the tick compared last, while {@link #diverged}. Look, don't touch. */
  public Neighbourhood divergedState() {
    return divergedState;
  }

  /** How often, after having been right, the server's state of what is near was another. */
  public long disagreements() {
    return disagreements;
  }

  /** The newest tick whose state is known to be the server's in every bit, or -1. */
  public int agreedTick() {
    return agreedTick;
  }

  /** Offset still shown of earlier corrections of the own body, metres. */
  public float visualErrorMetres() {
    return pictures.own() == null ? 0 : pictures.own().error.metres();
  }
}
