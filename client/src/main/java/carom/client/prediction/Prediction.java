package carom.client.prediction;

import carom.client.interpolation.HistoryStates;
import carom.client.interpolation.Pose;
import carom.client.interpolation.States;
import carom.net.codec.Quantizer;
import carom.net.snapshot.EntityHistory;
import carom.net.snapshot.NearState;
import carom.net.snapshot.OwnState;
import carom.net.snapshot.RelayedInputs;
import carom.net.snapshot.SnapshotDecoder;
import carom.physics.Body;
import carom.sim.Archetype;
import carom.sim.Entity;
import carom.sim.Input;
import carom.sim.Neighbourhood;
import carom.sim.Player;
import carom.sim.Role;
import carom.sim.SimState;
import carom.sim.Simulation;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
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
 *   <li>If another player's inputs up to T were not as foreseen, or an {@linkplain NearUpdate
 *       update} is complete, the simulation returns to the saved state before, takes over what was
 *       told, and runs to T again, with the true inputs.
 *   <li>If now the hash of T is the server's, all is well.
 *   <li>Else the own body is put right from the own section, and others where the quantised records
 *       disagree; the server is told that the hash differed, and sends an update of all.
 *   <li>If anything changed, the inputs since T are replayed. The jump of the picture is handed to
 *       {@link VisualError}; the state itself is never blended.
 * </ol>
 *
 * <p>Bounded: at most {@code maxRollbackTicks} are replayed, for at most {@code maxReplayNs}; what
 * is too much is left out, the oldest first, and counted. One thread; a tick in which nothing is
 * corrected allocates nothing.
 */
public final class Prediction {
  /** Saved ticks; a power of two. */
  static final int RING = 128;

  private static final int MASK = RING - 1;

  /** For how long a player's last known input is repeated, fading. */
  private static final int REPEAT_TICKS = 30;

  /** Longest time a neighbour's last known state is moved on in a straight line, ticks. */
  private static final int LONGEST_COAST = 9;

  private static final int BODY = 1;
  private static final int REST = 8;

  private static final float POSITION_TOLERANCE = 1.0f / Quantizer.POSITION_STEPS;
  private static final float VELOCITY_TOLERANCE = 1.0f / Quantizer.VELOCITY_STEPS;
  private static final float ANGLE_TOLERANCE = (float) (2 * Math.PI / Quantizer.ANGLE_STEPS);
  private static final float OMEGA_TOLERANCE = 1.0f / Quantizer.OMEGA_STEPS;

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
  private final long[] inputs = new long[RING];
  private final int[] inputTick = new int[RING];

  /** By player: the input each saved tick was computed with; null for who was never near. */
  private final long[][] used = new long[Simulation.MAX_PLAYERS][];

  private final OwnState server = new OwnState();
  private final OwnState predicted = new OwnState();
  private final Neighbourhood here = new Neighbourhood();
  private final Neighbourhood right = new Neighbourhood();
  private final int[] row = new int[Neighbourhood.ENTITY_INTS];
  private final int[] contact = new int[Neighbourhood.CONTACT_INTS];
  private final int[] placeOf = new int[NearState.MAX_ENTITIES];
  private final int[] newPlace = new int[NearState.MAX_ENTITIES + 1];
  private final NearUpdate update = new NearUpdate();
  private final Records records = new Records();
  private final HistoryStates states = new HistoryStates();
  private final Pose scratch = new Pose();
  private final Pose target = new Pose();
  private final List<Neighbour> others = new ArrayList<>();

  private Neighbour own;
  private boolean active;
  private int tick = -1;
  private int confirmed = -1;
  private int agreedTick = -1;
  private int disagreedTick = -1;
  private long lastInput;
  private int firstInput = Integer.MAX_VALUE;
  private int allowedTicks;

  private boolean compared;
  private boolean exact;
  private boolean agreed;
  private boolean corrected;
  private float correctionMetres;
  private int awakeBodies;
  private int exactBodies;
  private int replayed;
  private int rolledBack;
  private long replayNs;
  private long cutShort;

  /** The newest tick whose state was put right by hand: no replay from before gives it. */
  private int changedTick;

  private boolean testing;
  private long syncErrors;

  /** Who is who, from what has arrived. */
  private static final class Records implements Neighbourhood.Identity {
    private SnapshotDecoder decoder;
    private Simulation simulation;

    @Override
    public Archetype archetype(int id) {
      return simulation.archetypes().get(decoder.history(id).archetype(0));
    }

    @Override
    public int owner(int id) {
      return decoder.history(id).owner(0);
    }

    /** Whether the newest record of a slot is of this entity, and its kind is known. */
    boolean know(int key) {
      EntityHistory history = decoder.history(Neighbourhood.id(key));
      return history != null
          && history.alive()
          && history.generation(0) == Neighbourhood.generation(key)
          && archetype(Neighbourhood.id(key)) != null;
    }
  }

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
    allowedTicks = maxRollbackTicks;
    records.simulation = simulation;
    player = simulation.joinAs(playerId, name);
    for (int i = 0; i < RING; i++) {
      savedTick[i] = -1;
      inputTick[i] = -1;
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
    int slot = newTick & MASK;
    inputs[slot] = input;
    inputTick[slot] = newTick;
    lastInput = input;
    firstInput = Math.min(firstInput, newTick);
    if (!active || newTick <= tick) {
      return;
    }
    if (newTick - tick > maxRollbackTicks) {
      skipTo(newTick - 1); // the clock jumped: what lies between can't be made up for
    }
    while (tick < newTick) {
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
    own.pose(own.previous);
    for (int i = 0; i < others.size(); i++) {
      Neighbour n = others.get(i);
      if (n.entity != null) {
        n.pose(n.previous);
      }
    }
    player.input().unpack(input);
    steerOthers(next);
    simulation.step();
    tick = next;
    keep();
  }

  /** Gives the other players the inputs they had, or probably have. */
  private void steerOthers(int next) {
    for (int id = 0; id < simulation.playerCapacity(); id++) {
      Player other = simulation.player(id);
      if (other == null || other == player) {
        continue;
      }
      long input = testing && used[id] != null ? used[id][next & MASK] : inputOf(id, next);
      other.input().unpack(input);
      if (used[id] == null) {
        used[id] = new long[RING];
      }
      used[id][next & MASK] = input;
    }
  }

  private long inputOf(int id, int wanted) {
    RelayedInputs relayed = records.decoder.inputs();
    if (relayed.knows(id, wanted)) {
      return relayed.at(id, wanted);
    }
    int known = relayed.newestBefore(id, wanted);
    return known < 0 ? 0 : Input.faded(relayed.at(id, known), wanted - known, REPEAT_TICKS);
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
    bind();
  }

  /** Goes back a few ticks and comes again: the hash must be the same. */
  private void testSync() {
    int present = tick;
    int from = present - SYNC_TICKS;
    for (int t = from; t <= present; t++) {
      if (t < changedTick || !isSaved(t) || inputTick[t & MASK] != t) {
        return;
      }
    }
    int expected = hash[present & MASK];
    Pose previous = new Pose();
    previous.set(own.previous);
    restore(from);
    testing = true;
    while (tick < present) {
      stepOnce(tick + 1, inputs[tick + 1 & MASK]);
    }
    testing = false;
    own.previous.set(previous);
    if (hash[present & MASK] != expected) {
      syncErrors++;
    }
  }

  /** Ticks that the synctest rolls back. */
  static final int SYNC_TICKS = 8;

  // ---- correction

  /**
   * Takes what a snapshot tells of what is near; call it for each one, in order of arrival.
   *
   * @param near its near section
   * @param stateTick its tick
   */
  public void hear(NearState near, int stateTick) {
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
    records.decoder = decoder;
    if (!sameBody()) {
      return;
    }
    long begin = stopwatch.getAsLong();
    if (!active) {
      skipTo(stateTick);
      active = true;
      here.clear();
      putRight(stateTick);
      replay(newestInput(), begin);
    } else {
      rememberPoses();
      int present = Math.max(tick, stateTick);
      compared = isSaved(stateTick);
      exact = compared && ownAt[stateTick & MASK].sameAs(server);
      if (compared) {
        predicted.set(ownAt[stateTick & MASK]);
        foreseen.remember(stateTick & MASK);
      }
      int from = rewind(stateTick, before);
      if (from < 0 && stateTick > tick) {
        skipTo(stateTick); // the server is ahead of us: nothing was predicted for this tick
        here.readAll(simulation);
        putRight(stateTick);
        from = stateTick;
      } else {
        from = compare(stateTick, from);
      }
      if (from >= 0) {
        rolledBack = present - from;
        replay(present, begin);
        glide();
      }
      corrected = compared && !exact;
    }
    replayNs = stopwatch.getAsLong() - begin;
  }

  /**
   * Runs to a tick again when something before it was not as foreseen.
   *
   * @return the tick it returned to, or -1 when all was as foreseen
   */
  private int rewind(int stateTick, int before) {
    int wrong = firstWrongInput(Math.max(before, tick - RING + 1), Math.min(stateTick, tick));
    int from = isSaved(wrong - 1) ? wrong - 1 : Integer.MAX_VALUE;
    boolean told = update.isReady() && isSaved(update.baseTick()) && isUsable();
    if (told) {
      from = Math.min(from, update.baseTick());
    }
    if (from > stateTick) {
      return -1;
    }
    restore(from);
    while (true) {
      if (told && tick == update.baseTick()) {
        takeUpdate();
      }
      if (tick == stateTick) {
        return from;
      }
      again(tick + 1);
    }
  }

  /** Whether it is known who all those are that the update lists. */
  private boolean isUsable() {
    for (int i = 0; i < update.count(); i++) {
      if (!records.know(update.key(i))) {
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
    disagreedTick = waits ? disagreedTick : stateTick;
    awakeBodies = compared ? foreseen.awake(stateTick & MASK) : 0;
    if (tick != stateTick && isSaved(stateTick)) {
      restore(stateTick);
    } else {
      skipTo(stateTick);
    }
    here.readAll(simulation);
    putRight(stateTick);
    return from < 0 ? stateTick : from;
  }

  private void rememberPoses() {
    own.pose(own.before);
    for (int i = 0; i < others.size(); i++) {
      others.get(i).pose(others.get(i).before);
    }
  }

  /** The first tick in which a player did something else than was foreseen. */
  private int firstWrongInput(int after, int upTo) {
    RelayedInputs relayed = records.decoder.inputs();
    for (int t = after + 1; t <= upTo; t++) {
      for (int id = 0; id < simulation.playerCapacity(); id++) {
        if (simulation.player(id) != null
            && simulation.player(id) != player
            && used[id] != null
            && relayed.knows(id, t)
            && relayed.at(id, t) != used[id][t & MASK]) {
          return t;
        }
      }
    }
    return Integer.MAX_VALUE;
  }

  /** Keeps the own body's identity in step with the server; false when there is none. */
  private boolean sameBody() {
    if (server.slot() < 0) {
      stop();
      takeMemory();
      return false;
    }
    if (own != null && own.id == server.slot() && own.generation == server.generation()) {
      return true;
    }
    stop();
    if (!records.know(Neighbourhood.key(server.slot(), server.generation()))) {
      return false; // its record is still on the way
    }
    own = new Neighbour(server.slot(), server.generation(), 1);
    return true;
  }

  private void takeMemory() {
    for (int i = 0; i < OwnState.MEMORY; i++) {
      player.memory()[i] = server.memory(i);
    }
  }

  private void stop() {
    others.clear();
    update.clear();
    own = null;
    active = false;
    disagreedTick = -1;
    here.clear();
    here.write(simulation, records);
    Arrays.fill(savedTick, -1);
  }

  private int newestInput() {
    int newest = -1;
    for (int t : inputTick) {
      newest = Math.max(newest, t);
    }
    return newest;
  }

  // ---- putting right

  /** Takes an update over, at its base tick. */
  private void takeUpdate() {
    update.use();
    here.readAll(simulation);
    right.clear();
    for (int i = 0; i < update.count(); i++) {
      int key = update.key(i);
      int mine = here.find(key);
      placeOf[i] = -1;
      boolean told = update.isTold(i) && isFinite(update.rows(), update.entityAt(i));
      if (right.find(key) >= 0 || (!told && mine < 0)) {
        continue;
      }
      placeOf[i] = right.count();
      right.add(
          told ? update.rows() : here.entities(), told ? update.entityAt(i) : mine * row.length);
    }
    if (right.find(Neighbourhood.key(own.id, own.generation)) < 0) {
      return; // it is of another body's
    }
    for (int i = 0; i < update.contacts(); i++) {
      System.arraycopy(update.rows(), update.contactAt(i), contact, 0, contact.length);
      contact[0] = translate(contact[0]);
      contact[1] = translate(contact[1]);
      addContact();
    }
    for (int i = 0; i < here.contactCount(); i++) {
      System.arraycopy(here.contacts(), i * contact.length, contact, 0, contact.length);
      contact[0] = kept(contact[0]);
      contact[1] = kept(contact[1]);
      addContact();
    }
    right.write(simulation, records);
    changedTick = Math.max(changedTick, tick);
    bind();
    keep();
  }

  private void addContact() {
    if (contact[0] != Integer.MAX_VALUE && contact[1] != Integer.MAX_VALUE) {
      right.addContact(contact, 0);
    }
  }

  /** A place in the server's list, in ours. */
  private int translate(int end) {
    if (end < 0) {
      return end;
    }
    return end < update.count() && placeOf[end] >= 0 ? placeOf[end] : Integer.MAX_VALUE;
  }

  /** A place in what was here, in what is to be; none when it goes, or its contacts are told. */
  private int kept(int end) {
    if (end < 0) {
      return end;
    }
    int key = here.entities()[end * row.length];
    for (int i = 0; i < update.count(); i++) {
      if (update.key(i) == key) {
        return update.isTold(i) || placeOf[i] < 0 ? Integer.MAX_VALUE : placeOf[i];
      }
    }
    return Integer.MAX_VALUE;
  }

  /**
   * Without an update: the own body becomes what the server had after a tick, and others go where
   * their records have them, if those disagree. {@link #here} is what the simulation has.
   */
  private void putRight(int stateTick) {
    int ownKey = Neighbourhood.key(own.id, own.generation);
    right.clear();
    boolean ownListed = false;
    for (int i = 0; i < here.count(); i++) {
      int at = i * row.length;
      int key = here.entities()[at];
      newPlace[i] = Integer.MAX_VALUE;
      if (key == ownKey) {
        ownRow();
        ownListed = true;
      } else if (records.know(key)) {
        System.arraycopy(here.entities(), at, row, 0, row.length);
        if (!agrees(key, stateTick)) {
          moveRow();
        }
      } else {
        continue; // it is gone
      }
      newPlace[i] = right.count();
      right.add(row, 0);
    }
    if (!ownListed) {
      right.clear();
      ownRow();
      right.add(row, 0);
    } else {
      for (int i = 0; i < here.contactCount(); i++) {
        System.arraycopy(here.contacts(), i * contact.length, contact, 0, contact.length);
        contact[0] = contact[0] < 0 ? contact[0] : newPlace[contact[0]];
        contact[1] = contact[1] < 0 ? contact[1] : newPlace[contact[1]];
        addContact();
      }
    }
    right.write(simulation, records);
    changedTick = Math.max(changedTick, tick);
    bind();
    keep();
  }

  private void ownRow() {
    row[0] = Neighbourhood.key(own.id, own.generation);
    row[BODY] = Float.floatToRawIntBits(server.x());
    row[BODY + 1] = Float.floatToRawIntBits(server.y());
    row[BODY + 2] = Float.floatToRawIntBits(server.cos());
    row[BODY + 3] = Float.floatToRawIntBits(server.sin());
    row[BODY + 4] = Float.floatToRawIntBits(server.vx());
    row[BODY + 5] = Float.floatToRawIntBits(server.vy());
    row[BODY + 6] = Float.floatToRawIntBits(server.omega());
    row[REST] = 0; // players' bodies never rest
    for (int i = 0; i < OwnState.MEMORY; i++) {
      row[REST + 1 + i] = server.memory(i);
    }
  }

  /** What comes from the network must not poison the simulation. */
  private static boolean isFinite(int[] rows, int at) {
    for (int i = 0; i < 7; i++) {
      float value = Float.intBitsToFloat(rows[at + BODY + i]);
      if (!(Math.abs(value) < 1e9f)) {
        return false;
      }
    }
    float cos = Float.intBitsToFloat(rows[at + BODY + 2]);
    float sin = Float.intBitsToFloat(rows[at + BODY + 3]);
    return Math.abs(cos * cos + sin * sin - 1) < 1e-3f;
  }

  /** Whether an entity of {@link #row} is where its record has it, as far as that tells. */
  private boolean agrees(int key, int stateTick) {
    if (!fromRecord(key, stateTick)) {
      return true;
    }
    Entity e = simulation.entity(Neighbourhood.id(key));
    Body<Entity> body = e.body();
    return Math.abs(body.x() - target.x) <= POSITION_TOLERANCE
        && Math.abs(body.y() - target.y) <= POSITION_TOLERANCE
        && Math.abs(body.velocityX() - target.vx) <= VELOCITY_TOLERANCE
        && Math.abs(body.velocityY() - target.vy) <= VELOCITY_TOLERANCE
        && Math.abs(body.angularVelocity() - target.omega) <= OMEGA_TOLERANCE
        && Math.abs(Pose.wrap(body.angle() - target.angle)) <= ANGLE_TOLERANCE;
  }

  /** Reads an entity's state after a tick into {@link #target}, from what has arrived. */
  private boolean fromRecord(int key, int stateTick) {
    int generation = Neighbourhood.generation(key);
    EntityHistory history = records.decoder.history(Neighbourhood.id(key));
    int index = history.indexAt(stateTick);
    if (index < 0 || !history.alive(index) || history.generation(index) != generation) {
      index = 0; // it is younger than the tick
    }
    if (!history.alive(index) || history.generation(index) != generation) {
      return false;
    }
    States s = states.of(history);
    int age = Math.max(0, Math.min(LONGEST_COAST, stateTick - s.tick(index)));
    float seconds = age * simulation.tickSeconds();
    target.set(
        s.x(index) + s.vx(index) * seconds,
        s.y(index) + s.vy(index) * seconds,
        s.angle(index) + s.omega(index) * seconds,
        s.vx(index),
        s.vy(index),
        s.omega(index));
    return true;
  }

  /** Puts {@link #row} where {@link #target} is. */
  private void moveRow() {
    float cos = (float) Math.cos(target.angle);
    float sin = (float) Math.sin(target.angle);
    Entity e = simulation.entity(Neighbourhood.id(row[0]));
    float localX = e == null ? 0 : e.body().localCenterX();
    float localY = e == null ? 0 : e.body().localCenterY();
    row[BODY] = Float.floatToRawIntBits(target.x + cos * localX - sin * localY);
    row[BODY + 1] = Float.floatToRawIntBits(target.y + sin * localX + cos * localY);
    row[BODY + 2] = Float.floatToRawIntBits(cos);
    row[BODY + 3] = Float.floatToRawIntBits(sin);
    row[BODY + 4] = Float.floatToRawIntBits(target.vx);
    row[BODY + 5] = Float.floatToRawIntBits(target.vy);
    row[BODY + 6] = Float.floatToRawIntBits(target.omega);
    row[REST] = 0;
  }

  /** Finds each picture's entity, after the simulation's entities changed. */
  private void bind() {
    own.entity = simulation.entity(own.id);
    for (int i = others.size() - 1; i >= 0; i--) {
      Neighbour n = others.get(i);
      Entity e = simulation.entity(n.id);
      if (e == null || e.generation() != n.generation) {
        n.leave();
      } else {
        n.entity = e;
      }
    }
    for (int id = 0; id < simulation.entityCapacity(); id++) {
      Entity e = simulation.entity(id);
      if (e != null && id != own.id && find(id, e.generation()) == null) {
        Neighbour n = new Neighbour(id, e.generation(), 0);
        n.entity = e;
        n.pose(n.previous);
        n.pose(n.before);
        others.add(n);
      }
    }
  }

  private Neighbour find(int id, int generation) {
    for (int i = 0; i < others.size(); i++) {
      Neighbour n = others.get(i);
      if (n.id == id && n.generation == generation) {
        return n;
      }
    }
    return null;
  }

  /** Replays the inputs up to a tick; what takes too long is left out, the oldest first. */
  private void replay(int present, long begin) {
    int most = Math.min(maxRollbackTicks, allowedTicks);
    if (present - tick > most) {
      cutShort++;
      skipTo(present - most);
    }
    int from = tick;
    while (tick < present) {
      if (stopwatch.getAsLong() - begin > maxReplayNs && tick < present - 1) {
        allowedTicks = Math.max(1, tick - from);
        cutShort++;
        skipTo(present - 1);
      }
      again(tick + 1);
    }
    if (allowedTicks < maxRollbackTicks && stopwatch.getAsLong() - begin < maxReplayNs / 2) {
      allowedTicks = Math.min(maxRollbackTicks, 2 * allowedTicks);
    }
  }

  private void again(int next) {
    int slot = next & MASK;
    stepOnce(next, inputTick[slot] == next ? inputs[slot] : next < firstInput ? 0 : lastInput);
    replayed++;
  }

  /** What the corrections moved is still shown, and fades. */
  private void glide() {
    correctionMetres = glide(own);
    for (int i = 0; i < others.size(); i++) {
      glide(others.get(i));
    }
  }

  private float glide(Neighbour n) {
    n.pose(scratch);
    float dx = n.before.x - scratch.x;
    float dy = n.before.y - scratch.y;
    n.error.add(dx, dy, Pose.wrap(n.before.angle - scratch.angle));
    return (float) Math.sqrt(dx * dx + dy * dy);
  }

  // ---- the picture

  /** Lets time pass for what fades. */
  public void advance(float seconds) {
    if (own != null) {
      own.advance(seconds);
    }
    for (int i = others.size() - 1; i >= 0; i--) {
      others.get(i).advance(seconds);
      if (others.get(i).faded()) {
        others.remove(i);
      }
    }
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
    if (!active) {
      return 0;
    }
    boolean isOwn = own.id == id && own.generation == generation;
    Neighbour n = isOwn ? own : find(id, generation);
    if (n == null || n.share() == 0) {
      return 0;
    }
    n.pose(scratch);
    out.set(n.previous);
    out.blend(scratch, fraction);
    n.error.addTo(out);
    return n.share();
  }

  /** One of the own player's memory ints, as predicted. */
  public int memory(int index) {
    return player.memory()[index];
  }

  // ---- what the last reconcile did

  /** Whether nobody else was near, so that nothing but the own inputs and statics count. */
  public boolean alone() {
    return others.isEmpty();
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

  /** The newest tick whose state is known to be the server's in every bit, or -1. */
  public int agreedTick() {
    return agreedTick;
  }

  /** Offset still shown of earlier corrections of the own body, metres. */
  public float visualErrorMetres() {
    return own == null ? 0 : own.error.metres();
  }
}
