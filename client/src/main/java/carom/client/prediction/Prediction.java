package carom.client.prediction;

import carom.client.interpolation.HistoryStates;
import carom.client.interpolation.Pose;
import carom.client.interpolation.States;
import carom.net.codec.Quantizer;
import carom.net.snapshot.EntityHistory;
import carom.net.snapshot.OwnState;
import carom.net.snapshot.RelayedInputs;
import carom.net.snapshot.SnapshotDecoder;
import carom.physics.Body;
import carom.physics.BodyType;
import carom.physics.geometry.Shape;
import carom.physics.math.Aabb;
import carom.physics.math.Transform;
import carom.sim.Archetype;
import carom.sim.Entity;
import carom.sim.Input;
import carom.sim.Player;
import carom.sim.Role;
import carom.sim.SimState;
import carom.sim.Simulation;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;

/**
 * Runs the own body ahead of the server, with the inputs the server will get, and corrects itself.
 *
 * <p>The predicted simulation holds the level's statics, the own body from the server's exact bits,
 * and the bodies near it from their decoded states. Alone among statics the prediction is what the
 * server will compute, bit by bit. Among others it is a good guess: their players do what the
 * server last relayed, until the next snapshot says otherwise.
 *
 * <p>When the server's state after tick T arrives, it is compared with what was predicted for T. If
 * the own body is the same in every bit and the neighbours are within what quantisation hides,
 * nothing happens. Else the simulation returns to its saved state of T (contacts with their
 * impulses included), takes over the server's state there, and replays the inputs since. The jump
 * of the picture is handed to {@link VisualError}; the state itself is never blended.
 *
 * <p>Bounded: at most {@code maxRollbackTicks} are replayed, at most {@code maxNearBodies} are
 * mirrored. One thread; allocates only when a body enters the predicted set.
 */
public final class Prediction {
  /** Saved ticks; a power of two. */
  static final int RING = 128;

  /** Leaving the set takes a larger distance than entering it. */
  private static final float HYSTERESIS = 1.25f;

  /** Bodies count as touching up to this gap between the circles around them, metres. */
  private static final float TOUCH = 0.05f;

  /** Longest time a neighbour's last known state is moved on in a straight line, ticks. */
  private static final int LONGEST_COAST = 9;

  /** For how long a player's last known input is repeated, fading. */
  private static final int REPEAT_TICKS = 30;

  private static final float POSITION_TOLERANCE = 1.0f / Quantizer.POSITION_STEPS;
  private static final float VELOCITY_TOLERANCE = 1.0f / Quantizer.VELOCITY_STEPS;
  private static final float ANGLE_TOLERANCE = (float) (2 * Math.PI / Quantizer.ANGLE_STEPS);
  private static final float OMEGA_TOLERANCE = 1.0f / Quantizer.OMEGA_STEPS;

  private final Simulation simulation;
  private final Player player;
  private final float nearMetres;
  private final int maxNearBodies;
  private final int maxRollbackTicks;
  private final SimState[] saved = new SimState[RING];
  private final int[] savedTick = new int[RING];
  private final OwnState[] ownAt = new OwnState[RING];
  private final long[] inputs = new long[RING];
  private final int[] inputTick = new int[RING];
  private final float[] reachOf;
  private final OwnState server = new OwnState();
  private final OwnState predicted = new OwnState();
  private RelayedInputs relayed;
  private final HistoryStates states = new HistoryStates();
  private final Pose scratch = new Pose();
  private final Pose target = new Pose();
  private final List<Neighbour> others = new ArrayList<>();
  private int[] candidateId = new int[64];
  private float[] candidateDistance = new float[64];
  private int candidates;
  private final BitSet chosen = new BitSet();
  private boolean tooMany;

  private Neighbour own;
  private boolean active;
  private int tick = -1;
  private int confirmed = -1;
  private long lastInput;

  private boolean compared;
  private boolean exact;
  private boolean corrected;
  private float correctionMetres;
  private int replayed;

  /**
   * Creates a prediction that waits for the server's first state.
   *
   * @param simulation of role PREDICTION, fresh; owned by this from now on
   * @param playerId the own player's id
   * @param name the own player's name
   * @param nearMetres bodies within this distance are predicted too
   * @param maxNearBodies most of them
   * @param maxRollbackTicks longest replay, 1..120
   */
  public Prediction(
      Simulation simulation,
      int playerId,
      String name,
      float nearMetres,
      int maxNearBodies,
      int maxRollbackTicks) {
    if (simulation.role() != Role.PREDICTION) {
      throw new IllegalArgumentException("role=" + simulation.role() + " must be PREDICTION");
    }
    if (maxRollbackTicks < 1 || maxRollbackTicks > RING - 8) {
      throw new IllegalArgumentException(
          "maxRollbackTicks=" + maxRollbackTicks + " is outside 1.." + (RING - 8));
    }
    this.simulation = simulation;
    this.nearMetres = nearMetres;
    this.maxNearBodies = maxNearBodies;
    this.maxRollbackTicks = maxRollbackTicks;
    player = simulation.joinAs(playerId, name);
    reachOf = new float[simulation.archetypes().size()];
    Transform identity = new Transform();
    Aabb box = new Aabb();
    for (int i = 0; i < reachOf.length; i++) {
      for (Shape shape : simulation.archetypes().get(i).shapes()) {
        shape.aabb(identity, box);
        float w = Math.max(Math.abs(box.minX), Math.abs(box.maxX));
        float h = Math.max(Math.abs(box.minY), Math.abs(box.maxY));
        reachOf[i] = Math.max(reachOf[i], (float) Math.sqrt(w * w + h * h));
      }
    }
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

  // ---- forward

  /**
   * Predicts one tick. Ticks ascend; ticks left out count as having the input of the last one.
   *
   * @param newTick the tick to predict
   * @param input the own player's packed input for it
   */
  public void step(int newTick, long input) {
    int slot = newTick & (RING - 1);
    inputs[slot] = input;
    inputTick[slot] = newTick;
    lastInput = input;
    if (!active || newTick <= tick) {
      return;
    }
    if (newTick - tick > maxRollbackTicks) {
      simulation.tick(newTick - 1); // the clock jumped: what lies between can't be made up for
      tick = newTick - 1;
    }
    while (tick < newTick) {
      stepOnce(tick + 1, input);
    }
  }

  private void stepOnce(int next, long input) {
    own.pose(own.previous);
    for (int i = 0; i < others.size(); i++) {
      Neighbour n = others.get(i);
      n.pose(n.previous);
    }
    player.input().unpack(input);
    steerOthers(next);
    simulation.step();
    for (int i = 0; i < others.size(); i++) {
      others.get(i).holdCourse(simulation.tickSeconds());
    }
    tick = next;
    keep();
  }

  /** Gives the other players the inputs they had, or probably have. */
  private void steerOthers(int next) {
    for (int i = 0; i < others.size(); i++) {
      Neighbour n = others.get(i);
      Player owner = simulation.player(n.ownerId);
      if (owner == null || relayed == null) {
        continue;
      }
      int known = Math.min(next, relayed.newestTick(n.ownerId));
      if (known < 0) {
        owner.input().clear();
      } else {
        long last = relayed.at(n.ownerId, known);
        owner.input().unpack(Input.faded(last, next - known, REPEAT_TICKS));
      }
    }
  }

  /** Whether a player turned out to do something else than was foreseen. */
  private boolean inputsAgree() {
    boolean agree = true;
    for (int i = 0; i < others.size(); i++) {
      Neighbour n = others.get(i);
      int newest = n.ownerId < 0 ? -1 : relayed.newestTick(n.ownerId);
      if (newest > n.inputTick) {
        long guess = Input.faded(n.input, newest - n.inputTick, REPEAT_TICKS);
        agree &= n.inputTick >= 0 && guess == relayed.at(n.ownerId, newest);
        n.inputTick = newest;
        n.input = relayed.at(n.ownerId, newest);
      }
    }
    return agree;
  }

  private void keep() {
    int slot = tick & (RING - 1);
    saved[slot] = simulation.save(saved[slot]);
    savedTick[slot] = tick;
    read(ownAt[slot]);
    for (int i = 0; i < others.size(); i++) {
      others.get(i).keep(tick);
    }
  }

  private void read(OwnState out) {
    Body<Entity> body = own.body();
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

  // ---- correction

  /**
   * Compares the server's newest state with what was predicted for its tick and corrects what
   * differs. Call it once per frame when a newer own state arrived.
   *
   * @param newest the own state after {@code stateTick}; copied
   * @param stateTick its tick; not newer than the last one: nothing happens
   * @param decoder the histories of all others
   */
  public void reconcile(OwnState newest, int stateTick, SnapshotDecoder decoder) {
    compared = false;
    corrected = false;
    replayed = 0;
    if (stateTick <= confirmed) {
      return;
    }
    confirmed = stateTick;
    server.set(newest);
    relayed = decoder.inputs();
    if (!sameBody(decoder)) {
      return;
    }
    if (!active) {
      begin(stateTick);
      compared = false;
      return;
    }
    if (stateTick > tick) {
      // The server is ahead of us: nothing was predicted for this tick.
      choose(decoder, stateTick);
      setRight(stateTick, decoder, false);
      return;
    }
    boolean known = savedTick[stateTick & (RING - 1)] == stateTick;
    exact = known && ownAt[stateTick & (RING - 1)].sameAs(server);
    compared = known;
    if (known && !exact) {
      predicted.set(ownAt[stateTick & (RING - 1)]);
    }
    boolean same = choose(decoder, stateTick);
    boolean foreseen = inputsAgree();
    if (exact && same && foreseen && neighboursAgree(stateTick, decoder)) {
      return;
    }
    setRight(stateTick, decoder, known);
  }

  /** Keeps the own body's identity in step with the server; false when there is none. */
  private boolean sameBody(SnapshotDecoder decoder) {
    if (server.slot() < 0) {
      stop();
      takeMemory();
      return false;
    }
    if (own != null && own.id == server.slot() && own.generation == server.generation()) {
      return true;
    }
    stop();
    EntityHistory history = decoder.history(server.slot());
    if (history == null
        || !history.alive()
        || history.generation(0) != server.generation()
        || simulation.archetypes().get(history.archetype(0)) == null) {
      return false; // its record is still on the way
    }
    own =
        new Neighbour(
            server.slot(),
            server.generation(),
            simulation.archetypes().get(history.archetype(0)),
            player.id(),
            1);
    return true;
  }

  private void stop() {
    for (int i = 0; i < others.size(); i++) {
      remove(others.get(i));
    }
    others.clear();
    if (own != null) {
      remove(own);
      own = null;
    }
    active = false;
    Arrays.fill(savedTick, -1);
  }

  private void remove(Neighbour n) {
    Entity there = simulation.entity(n.id);
    if (there != null && there.generation() == n.generation) {
      simulation.despawn(there);
    }
  }

  private void begin(int stateTick) {
    simulation.tick(stateTick);
    settle(own, server.x(), server.y(), 0);
    setOwn();
    active = true;
    tick = stateTick;
    own.pose(own.previous);
    keep();
    replay(newestInput());
  }

  private int newestInput() {
    int newest = -1;
    for (int t : inputTick) {
      newest = Math.max(newest, t);
    }
    return newest;
  }

  private void setRight(int stateTick, SnapshotDecoder decoder, boolean known) {
    int present = Math.max(tick, stateTick);
    own.pose(own.before);
    for (int i = 0; i < others.size(); i++) {
      Neighbour n = others.get(i);
      if (n.placed) {
        n.pose(n.before);
      }
    }
    if (known) {
      simulation.restore(saved[stateTick & (RING - 1)]);
    }
    simulation.tick(stateTick);
    tick = stateTick;
    sweep();
    settle(own, server.x(), server.y(), 0);
    setOwn();
    for (int i = 0; i < others.size(); i++) {
      place(others.get(i), stateTick, decoder);
    }
    own.pose(own.previous);
    for (int i = 0; i < others.size(); i++) {
      others.get(i).pose(others.get(i).previous);
    }
    keep();
    replay(present);
    glide();
    if (compared && !exact) {
      corrected = true;
    }
  }

  /** Replays the inputs up to a tick; if that is too far, the oldest are left out. */
  private void replay(int present) {
    if (present - tick > maxRollbackTicks) {
      tick = present - maxRollbackTicks;
      simulation.tick(tick);
    }
    while (tick < present) {
      int next = tick + 1;
      int slot = next & (RING - 1);
      stepOnce(next, inputTick[slot] == next ? inputs[slot] : lastInput);
      replayed++;
    }
  }

  /** What the corrections moved is still shown, and fades. */
  private void glide() {
    own.pose(scratch);
    float dx = own.before.x - scratch.x;
    float dy = own.before.y - scratch.y;
    correctionMetres = (float) Math.sqrt(dx * dx + dy * dy);
    own.error.add(dx, dy, Pose.wrap(own.before.angle - scratch.angle));
    for (int i = 0; i < others.size(); i++) {
      Neighbour n = others.get(i);
      if (n.placed) {
        n.pose(scratch);
        n.error.add(
            n.before.x - scratch.x,
            n.before.y - scratch.y,
            Pose.wrap(n.before.angle - scratch.angle));
      }
      n.placed = true;
    }
  }

  /** After a restore: destroys what is not, or no longer, predicted. */
  private void sweep() {
    for (int id = 0; id < simulation.entityCapacity(); id++) {
      Entity e = simulation.entity(id);
      if (e != null && !isPredicted(e)) {
        simulation.despawn(e);
      }
    }
  }

  private boolean isPredicted(Entity e) {
    if (own.id == e.id()) {
      return own.generation == e.generation();
    }
    Neighbour n = find(e.id());
    return n != null && n.generation == e.generation() && n.archetype == e.archetype();
  }

  private Neighbour find(int id) {
    for (int i = 0; i < others.size(); i++) {
      if (others.get(i).id == id) {
        return others.get(i);
      }
    }
    return null;
  }

  /** Makes sure the body exists; returns whether it did already. */
  private boolean settle(Neighbour n, float x, float y, float angle) {
    n.entity = simulation.entity(n.id);
    if (n.entity != null) {
      return true;
    }
    if (n.ownerId >= 0 && simulation.player(n.ownerId) == null) {
      simulation.joinAs(n.ownerId, "");
    }
    n.entity = simulation.spawnAs(n.id, n.generation, n.archetype, x, y, angle, n.ownerId);
    return false;
  }

  private void setOwn() {
    Body<Entity> body = own.body();
    body.setCenterPose(server.x(), server.y(), server.cos(), server.sin());
    body.setVelocity(server.vx(), server.vy());
    body.setAngularVelocity(server.omega());
    takeMemory();
  }

  private void takeMemory() {
    for (int i = 0; i < OwnState.MEMORY; i++) {
      player.memory()[i] = server.memory(i);
    }
  }

  /** Puts a neighbour where it was after a tick, unless it stands there already. */
  private void place(Neighbour n, int stateTick, SnapshotDecoder decoder) {
    boolean there = known(n, stateTick, decoder);
    if (!there) {
      settle(n, n.before.x, n.before.y, n.before.angle);
      return;
    }
    if (settle(n, target.x, target.y, target.angle)) {
      n.pose(scratch);
      if (close(scratch, target)) {
        return;
      }
    }
    Body<Entity> body = n.body();
    body.setPose(target.x, target.y, target.angle);
    body.setVelocity(target.vx, target.vy);
    body.setAngularVelocity(target.omega);
  }

  /** Reads a neighbour's state after a tick into {@link #target}, from what has arrived. */
  private boolean known(Neighbour n, int stateTick, SnapshotDecoder decoder) {
    EntityHistory history = decoder.history(n.id);
    if (history == null || history.size() == 0) {
      return false;
    }
    int index = history.indexAt(stateTick);
    if (index < 0 || !history.alive(index) || history.generation(index) != n.generation) {
      index = 0; // it is younger than the tick
    }
    if (!history.alive(index) || history.generation(index) != n.generation) {
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

  private boolean neighboursAgree(int stateTick, SnapshotDecoder decoder) {
    for (int i = 0; i < others.size(); i++) {
      Neighbour n = others.get(i);
      if (!n.at(stateTick, scratch)) {
        return false;
      }
      if (known(n, stateTick, decoder) && !close(scratch, target)) {
        return false;
      }
    }
    return true;
  }

  private static boolean close(Pose a, Pose b) {
    return Math.abs(a.x - b.x) <= POSITION_TOLERANCE
        && Math.abs(a.y - b.y) <= POSITION_TOLERANCE
        && Math.abs(a.vx - b.vx) <= VELOCITY_TOLERANCE
        && Math.abs(a.vy - b.vy) <= VELOCITY_TOLERANCE
        && Math.abs(a.omega - b.omega) <= OMEGA_TOLERANCE
        && Math.abs(Pose.wrap(a.angle - b.angle)) <= ANGLE_TOLERANCE;
  }

  // ---- who is near

  /** Chooses whom to predict; false when somebody came or went. */
  private boolean choose(SnapshotDecoder decoder, int stateTick) {
    boolean same = true;
    for (int i = 0; i < others.size(); i++) {
      others.get(i).wanted = false;
    }
    gather(decoder, stateTick);
    spread(decoder);
    dropFarthest();
    for (int i = 0; i < candidates; i++) {
      EntityHistory history = decoder.history(candidateId[i]);
      Neighbour n = find(candidateId[i]);
      Archetype archetype = simulation.archetypes().get(history.archetype(0));
      if (n != null && (n.generation != history.generation(0) || n.archetype != archetype)) {
        others.remove(n);
        remove(n);
        n = null;
      }
      if (n == null) {
        n = new Neighbour(candidateId[i], history.generation(0), archetype, history.owner(0), 0);
        others.add(n);
        same = false;
      }
      n.wanted = true;
    }
    for (int i = 0; i < others.size(); i++) {
      Neighbour n = others.get(i);
      n.held = !n.wanted || leansOnStranger(n.id, decoder);
    }
    for (int i = others.size() - 1; i >= 0; i--) {
      Neighbour n = others.get(i);
      EntityHistory history = decoder.history(n.id);
      boolean gone = history == null || !history.alive() || history.generation(0) != n.generation;
      if (gone || n.faded()) {
        others.remove(i);
        remove(n);
      }
    }
    return same;
  }

  private void gather(SnapshotDecoder decoder, int stateTick) {
    candidates = 0;
    chosen.clear();
    if (maxNearBodies == 0) {
      return;
    }
    Body<Entity> body = own.body();
    float lead = Math.max(0, tick - stateTick) * simulation.tickSeconds();
    int limit = decoder.slotLimit();
    for (int id = 0; id < limit; id++) {
      if (!isPredictable(id, decoder)) {
        continue;
      }
      EntityHistory history = decoder.history(id);
      Archetype archetype = simulation.archetypes().get(history.archetype(0));
      States s = states.of(history);
      float dx = s.x(0) - body.x();
      float dy = s.y(0) - body.y();
      float vx = s.vx(0);
      float vy = s.vy(0);
      float distance =
          (float) Math.sqrt(dx * dx + dy * dy)
              - reachOf[archetype.index()]
              - (float) Math.sqrt(vx * vx + vy * vy) * lead;
      Neighbour n = find(id);
      if (distance <= nearMetres * (n != null ? HYSTERESIS : 1)) {
        candidate(id, n != null ? distance / HYSTERESIS : distance);
      }
    }
  }

  private boolean isPredictable(int id, SnapshotDecoder decoder) {
    EntityHistory history = decoder.history(id);
    if (id == own.id || history == null || !history.alive()) {
      return false;
    }
    Archetype archetype = simulation.archetypes().get(history.archetype(0));
    return archetype != null && archetype.type() != BodyType.STATIC && !archetype.sensor();
  }

  /** What leans on a predicted body is predicted too: half a stack would fall into the rest. */
  private void spread(SnapshotDecoder decoder) {
    int limit = decoder.slotLimit();
    for (int i = 0; i < candidates; i++) { // grows as it goes
      for (int id = 0; id < limit; id++) {
        if (!chosen.get(id)
            && isPredictable(id, decoder)
            && isTouching(candidateId[i], id, decoder)) {
          candidate(id, candidateDistance[i] + TOUCH);
        }
      }
    }
  }

  /** Whether a body has company that is not predicted, because there are too many of them. */
  private boolean leansOnStranger(int id, SnapshotDecoder decoder) {
    if (!tooMany) {
      return false;
    }
    int limit = decoder.slotLimit();
    for (int other = 0; other < limit; other++) {
      if (!chosen.get(other) && isPredictable(other, decoder) && isTouching(id, other, decoder)) {
        return true;
      }
    }
    return false;
  }

  /** By the circles around them: generous, so that nothing that leans is missed. */
  private boolean isTouching(int a, int b, SnapshotDecoder decoder) {
    EntityHistory one = decoder.history(a);
    float oneX = states.of(one).x(0);
    float oneY = states.of(one).y(0);
    EntityHistory two = decoder.history(b);
    States s = states.of(two);
    float dx = s.x(0) - oneX;
    float dy = s.y(0) - oneY;
    float reach = reachOf[one.archetype(0)] + reachOf[two.archetype(0)] + TOUCH;
    return dx * dx + dy * dy <= reach * reach;
  }

  private void dropFarthest() {
    tooMany = candidates > maxNearBodies;
    while (candidates > maxNearBodies) {
      int farthest = 0;
      for (int i = 1; i < candidates; i++) {
        if (candidateDistance[i] > candidateDistance[farthest]) {
          farthest = i;
        }
      }
      candidates--;
      chosen.clear(candidateId[farthest]);
      candidateId[farthest] = candidateId[candidates];
      candidateDistance[farthest] = candidateDistance[candidates];
    }
  }

  private void candidate(int id, float distance) {
    if (candidates == candidateId.length) {
      candidateId = Arrays.copyOf(candidateId, candidates * 2);
      candidateDistance = Arrays.copyOf(candidateDistance, candidates * 2);
    }
    chosen.set(id);
    candidateId[candidates] = id;
    candidateDistance[candidates++] = distance;
  }

  // ---- the picture

  /** Lets time pass for what fades. */
  public void advance(float seconds) {
    if (own != null) {
      own.advance(seconds);
    }
    for (int i = 0; i < others.size(); i++) {
      others.get(i).advance(seconds);
    }
  }

  /**
   * Share of the prediction in what is drawn of an entity, 0..1; 0 when it is not predicted.
   *
   * @param id its slot
   * @param fraction how much of the tick after {@link #tick}'s predecessor has passed, 0..1
   * @param out receives the predicted pose with what is left of corrections; unchanged at 0
   */
  public float drawn(int id, int generation, float fraction, Pose out) {
    if (!active) {
      return 0;
    }
    Neighbour n = own.id == id ? own : find(id);
    if (n == null || n.generation != generation || n.entity == null || n.share() == 0) {
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

  /** Whether it was right in every bit. */
  public boolean exact() {
    return compared && exact;
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

  /** Offset still shown of earlier corrections of the own body, metres. */
  public float visualErrorMetres() {
    return own == null ? 0 : own.error.metres();
  }
}
