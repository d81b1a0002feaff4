package carom.client.prediction;

import carom.client.field.OwnWords;
import carom.client.interpolation.Pose;
import carom.net.snapshot.SnapshotDecoder;
import carom.net.snapshot.exact.OwnState;
import carom.sim.Role;
import carom.sim.SimulationHost;
import carom.sim.entity.Assembly;
import carom.sim.entity.HostEntity;
import carom.sim.entity.HostPlayer;
import carom.sim.level.Archetype;
import carom.sim.near.Neighbourhood;
import carom.sim.spawn.Origin;
import java.util.function.LongSupplier;

/**
 * Simulates the own body and the bodies near it ahead of the server, and reconciles them with the
 * server's states.
 *
 * <p>The server chooses the predicted set ({@code NearState}) and sends a hash of its exact state.
 * A body that enters the set comes once with its exact state. From then on both sides compute the
 * same bits from the same inputs: the own ones, and those of other players, which the server
 * relays. Until an input is relayed, the player's last one is repeated, fading tick by tick ({@code
 * Input.faded}).
 *
 * <p>What happens when the server's state after tick T arrives:
 *
 * <ol>
 *   <li>If an input of another player was mispredicted, a {@linkplain ReceivedRulings ruling} of
 *       the game came, or an {@linkplain carom.client.prediction.NearUpdate update} of exact states
 *       is complete, the simulation rolls back to the tick before. It applies the update and
 *       resimulates up to T with the real inputs and rulings.
 *   <li>If the hash of T is now the server's, T is right.
 *   <li>Otherwise the own body is corrected from the own section, and others from the quantised
 *       records where these disagree. The client reports that the hash differed, and the server
 *       sends an update of everything.
 *   <li>If anything changed, the ticks since T are resimulated. The jump of the picture becomes a
 *       {@code VisualError}, which fades; the state itself is never blended.
 * </ol>
 *
 * <pre>
 *  step ──► Timeline (simulation, saved ticks) ──► PredictedPoses ──► readPose
 *               ▲ rollback, exact state, resimulate
 *  reconcile ─► Reconciler ◄── PendingUpdates, Corrector ◄── SnapshotRecords ◄── decoder
 * </pre>
 *
 * <p>{@link ReplayBudget} bounds a replay in ticks and time. Ticks beyond the bound are left out,
 * the oldest first, and counted. One thread; a tick in which nothing is corrected allocates
 * nothing.
 */
public final class Prediction {
  /** States for which the exact state of a new own machine is waited for; its joints may break. */
  private static final int MOST_WAITED = 30;

  private final SimulationHost simulation;
  private final HostPlayer player;
  private final SnapshotRecords records;
  private final OwnWords words;
  private final MatchWords match;
  private final PlayerInputs inputs;
  private final PredictedPoses poses;
  private final Timeline timeline;
  private final Corrector corrector;
  private final ReplayBudget budget;
  private final PendingUpdates updates;
  private final SpawnSettler settler;
  private final ReceivedRulings rulings;
  private final Reconciler reconciler;
  private final Agreement agreement = new Agreement();
  private final Reconciliation result = new Reconciliation();
  private final OwnState server = new OwnState();
  private final SyncTester syncTester;
  private final boolean runsSyncTest;
  private boolean active;

  /** True if rulings and spawns may be known that the ticks computed so far don't contain. */
  private boolean hasNews;

  private int confirmedTick = -1;
  private int waited;

  /**
   * Creates a prediction that waits for the server's first state.
   *
   * @param simulation of role PREDICTION, fresh; owned by this from now on
   * @param playerId the own player's id
   * @param name the own player's name
   * @param maxRollbackTicks longest replay, 1..120
   * @param maxReplayNs longest time a replay may take, nanoseconds; {@value
   *     ReplayBudget#UPDATE_FACTOR} times that when it applies an update
   * @param stopwatch measures it
   * @param runsSyncTest whether to roll back {@value SyncTester#TICKS} ticks in each tick and
   *     compare the hashes; for developers, takes ten times as long
   */
  public Prediction(
      SimulationHost simulation,
      int playerId,
      String name,
      int maxRollbackTicks,
      long maxReplayNs,
      LongSupplier stopwatch,
      boolean runsSyncTest) {
    if (simulation.role() != Role.PREDICTION) {
      throw new IllegalArgumentException("role=" + simulation.role() + " must be PREDICTION");
    }
    if (maxRollbackTicks < 1 || maxRollbackTicks > Timeline.RING - 8) {
      throw new IllegalArgumentException(
          "maxRollbackTicks=" + maxRollbackTicks + " is outside 1.." + (Timeline.RING - 8));
    }
    this.simulation = simulation;
    this.runsSyncTest = runsSyncTest;
    records = new SnapshotRecords(simulation, playerId);
    simulation.mirror().ownSpawns(records.spawns());
    settler = new SpawnSettler(simulation, records);
    player = simulation.mirror().join(playerId, name);
    rulings = new ReceivedRulings(simulation, playerId);
    words = new OwnWords(simulation.schema(), player);
    match = new MatchWords(simulation);
    inputs = new PlayerInputs(simulation, player, records, Timeline.RING);
    poses = new PredictedPoses(simulation, records);
    timeline = new Timeline(simulation, player, words, match, inputs, poses);
    corrector = new Corrector(simulation, player, records, words);
    budget = new ReplayBudget(maxRollbackTicks, maxReplayNs, stopwatch);
    simulation.mirror().rulings(rulings);
    updates = new PendingUpdates(records, timeline, budget, corrector);
    reconciler =
        new Reconciler(
            simulation,
            inputs,
            poses,
            timeline,
            corrector,
            updates,
            settler,
            words,
            rulings,
            budget,
            agreement,
            result);
    syncTester = new SyncTester(timeline, inputs, poses);
  }

  /** Returns the newest predicted tick. Valid while there is an own body to predict. */
  public int tick() {
    return timeline.tick();
  }

  // ---- forward

  /**
   * Predicts one tick. Ticks ascend; a tick that was left out counts as having this input.
   *
   * @param newTick the tick to predict
   * @param input the own player's packed input for it
   */
  public void step(int newTick, long input) {
    inputs.put(newTick, input);
    if (!active || newTick <= timeline.tick()) {
      return;
    }
    if (newTick - timeline.tick() > budget.maxTicks()) {
      timeline.skipTo(newTick - 1); // the clock jumped farther than a replay may reach
    }
    while (timeline.tick() < newTick) {
      if (timeline.tick() == newTick - 1) {
        poses.beginTick();
      }
      timeline.step(input, false);
      poses.follow(false);
    }
  }

  // ---- reconciliation

  /**
   * Takes in the own section of a snapshot. Call it for each snapshot, in order of arrival.
   *
   * @param own the section
   * @param stateTick the snapshot's tick
   */
  public void receive(OwnState own, int stateTick) {
    hasNews = true;
    updates.add(own.near(), stateTick);
    rulings.add(own.near(), stateTick);
    records.spawns().add(own);
  }

  /**
   * Notes that the own input of a tick hadn't arrived when the server took one for it, so that the
   * next tick goes on from what it took. Call it for each snapshot that tells so.
   *
   * @param tick the snapshot's tick
   * @param newest tick of the newest input that had arrived
   * @param held ticks for which that one was said to hold
   */
  public void missed(int tick, int newest, int held) {
    inputs.replace(tick, newest, held);
  }

  /**
   * Compares the server's newest state with the prediction of its tick, and corrects what differs.
   * Call it once per frame when a newer own state has arrived.
   *
   * @param newest the own state after {@code stateTick}; copied
   * @param stateTick its tick; nothing happens unless it is newer than the last one
   * @param decoder the histories of all entities, and the inputs of players
   */
  public void reconcile(OwnState newest, int stateTick, SnapshotDecoder decoder) {
    result.begin();
    agreement.begin();
    if (stateTick <= confirmedTick) {
      return;
    }
    hasNews = false;
    int before = confirmedTick;
    confirmedTick = stateTick;
    server.set(newest);
    records.readFrom(decoder);
    int changedTick = match.receive(decoder.tables(), stateTick);
    if (!followOwnBody()) {
      return;
    }
    if (active) {
      reconciler.reconcile(server, stateTick, before, changedTick);
    } else {
      reconciler.start(server, stateTick);
      active = true;
    }
  }

  /** Keeps the identity of the own body equal to the server's; false while there is no body. */
  private boolean followOwnBody() {
    if (server.slot() < 0) {
      deactivate();
      updates.clear();
      words.write(server);
      match.apply(confirmedTick);
      return false;
    }
    PredictedBody own = poses.own();
    if (own != null && own.id == server.slot() && own.generation == server.generation()) {
      return true;
    }
    deactivate();
    if (!records.isKnown(Neighbourhood.key(server.slot(), server.generation()))) {
      return false; // its record is still on the way
    }
    if (!isAssemblyKnown() && waited++ < MOST_WAITED) {
      return false; // without its joints it would fall apart, without its velocities jump
    }
    waited = 0;
    poses.begin(server.slot(), server.generation());
    return true;
  }

  /**
   * Returns whether the own body, if it is the root of an assembly, can be predicted exactly: all
   * joints of the assembly are known, and an update with its bodies is here.
   */
  private boolean isAssemblyKnown() {
    Assembly assembly = simulation.assemblies().of(records.archetype(server.slot()));
    int key = Neighbourhood.key(server.slot(), server.generation());
    return assembly == null
        || (corrector.assembly().isKnown(assembly, server.slot()) && updates.haveWhole(key));
  }

  private void deactivate() {
    poses.clear();
    active = false;
    agreement.reset();
    settler.clear();
    corrector.clear();
    timeline.forget();
  }

  // ---- the picture

  /** Lets time pass for what fades in the picture; the last call of a frame. */
  public void advance(float seconds) {
    if (runsSyncTest && active && !hasNews) {
      syncTester.run();
    }
    poses.advance(seconds, server.near());
  }

  /**
   * Reads the pose to draw of an entity.
   *
   * @param id its slot
   * @param generation its generation
   * @param fraction how much of the time between the last tick and {@link #tick} has passed, 0..1
   * @param out receives the predicted pose plus what is left of corrections; unchanged at 0
   * @return weight of the prediction in the picture, 0..1; 0 if the entity is not predicted
   */
  public float readPose(int id, int generation, float fraction, Pose out) {
    return active ? poses.readPose(id, generation, fraction, out) : 0;
  }

  /**
   * Returns whether what the server tells of an entity shouldn't be drawn: the own input has
   * despawned it, or it is drawn as a provisional one.
   */
  public boolean hides(int id, int generation) {
    if (!active || poses.isGone(id, generation, server.near())) {
      return active;
    }
    int key = Neighbourhood.key(id, generation);
    int origin = records.spawns().origin(key);
    if (origin == Origin.NONE || !records.spawns().wasPredicted(origin)) {
      return false;
    }
    HostEntity entity = simulation.entity(id);
    boolean isPredicted = entity != null && entity.generation() == generation;
    return !isPredicted && records.spawns().key(origin) != key;
  }

  /** Returns which entities of the server the own player's spawns are. */
  public SpawnMatches spawns() {
    return records.spawns();
  }

  /** Returns the number of pictures of predicted bodies besides the own one. */
  public int pictures() {
    return active ? poses.count() : 0;
  }

  /** Returns the id of the entity of a picture: a slot, or the origin of a provisional entity. */
  public int pictureId(int index) {
    return poses.get(index).id;
  }

  /** Returns the generation of the entity of a picture. */
  public int pictureGeneration(int index) {
    return poses.get(index).generation;
  }

  /**
   * Returns the archetype that an entity has in the prediction, where the own input and others may
   * have changed it already; null if it isn't predicted.
   */
  public Archetype archetype(int id, int generation) {
    return active ? poses.archetype(id, generation) : null;
  }

  /** Returns the archetype of the entity of a picture. */
  public Archetype pictureArchetype(int index) {
    return poses.get(index).archetype;
  }

  /** Reads the pose to draw of a picture; otherwise as the other {@code readPose}. */
  public float readPicture(int index, float fraction, Pose out) {
    return poses.readPose(poses.get(index), fraction, out);
  }

  /** Returns the own player, as predicted. Do not change it. */
  public HostPlayer player() {
    return player;
  }

  /** Returns what is left to fade of earlier corrections of the own body, metres. */
  public float visualErrorMetres() {
    return poses.own() == null ? 0 : poses.own().error.metres();
  }

  // ---- results

  /** Returns the result of the last {@link #reconcile}; the same object for ever. */
  public Reconciliation result() {
    return result;
  }

  /**
   * Returns whether the predicted set holds no other entity: only own inputs and statics matter.
   */
  public boolean isAlone() {
    return poses.isAlone();
  }

  /** Returns how many replays left out ticks because they were too long or took too long. */
  public long replaysCutShort() {
    return budget.cuts();
  }

  /** Returns how many sync tests failed; 0 unless the simulation has a fault. */
  public long syncErrors() {
    return syncTester.errors();
  }

  /** Returns what is known of the agreement with the server; the same object for ever. */
  public Agreement agreement() {
    return agreement;
  }
}
