package carom.client.prediction;

import carom.client.interpolation.DecodedHistory;
import carom.client.interpolation.Pose;
import carom.client.interpolation.StateHistory;
import carom.client.interpolation.Velocity;
import carom.net.snapshot.EntityHistory;
import carom.net.snapshot.SnapshotDecoder;
import carom.net.snapshot.exact.RelayedInputs;
import carom.net.snapshot.frame.Ownership;
import carom.net.snapshot.table.JointWords;
import carom.net.snapshot.table.TableInbox;
import carom.physics.Body;
import carom.physics.BodyType;
import carom.physics.rows.JointDefRow;
import carom.sim.SimulationHost;
import carom.sim.entity.HostEntity;
import carom.sim.entity.JointTable;
import carom.sim.level.Archetype;
import carom.sim.near.JointDefinitions;
import carom.sim.near.Neighbourhood;

/**
 * Gives a prediction the content of decoded snapshots: the identity of entities, their quantised
 * states, and the relayed inputs of other players. One prediction's; allocates nothing.
 */
final class SnapshotRecords implements Neighbourhood.Identity, JointDefinitions {
  /** Longest time that the newest state is extrapolated in a straight line, ticks. */
  private static final int MAX_EXTRAPOLATION_TICKS = 9;

  private final SimulationHost simulation;
  private final DecodedHistory states = new DecodedHistory();
  private final SpawnMatches spawns;
  private final Velocity velocity;
  private SnapshotDecoder decoder;

  /**
   * Creates the records of a prediction; {@link #readFrom} must follow.
   *
   * @param playerId the own player's id
   */
  public SnapshotRecords(SimulationHost simulation, int playerId) {
    this.simulation = simulation;
    velocity = new Velocity(simulation.tickRate());
    spawns = new SpawnMatches(playerId);
  }

  /** Returns which entities the own player's spawns are. */
  public SpawnMatches spawns() {
    return spawns;
  }

  /** Sets the decoder to read from. */
  public void readFrom(SnapshotDecoder newDecoder) {
    decoder = newDecoder;
  }

  /** Returns the inputs of other players that the server relayed. */
  public RelayedInputs inputs() {
    return decoder.inputs();
  }

  @Override
  public JointDefinitions joints() {
    return this;
  }

  @Override
  public boolean read(int key, int[] to) {
    if (!isJointKnown(key)) {
      return false;
    }
    TableInbox tables = decoder.tables();
    int row = JointTable.index(key);
    to[ROOT] = tables.get(JointWords.TABLE, row, JointWords.ROOT);
    to[NUMBER] = tables.get(JointWords.TABLE, row, JointWords.NUMBER);
    for (int i = 0; i < JointDefRow.INTS; i++) {
      to[DEFINITION + i] = tables.get(JointWords.TABLE, row, JointWords.DEFINITION + i);
    }
    return true;
  }

  /** Returns a number above the rows of all joints that were told. */
  public int jointLimit() {
    return decoder.tables().room(JointWords.TABLE);
  }

  /** Returns the key of the joint of a row, or -1 if there is none. */
  public int jointKey(int row) {
    TableInbox tables = decoder.tables();
    return tables.isPresent(JointWords.TABLE, row)
        ? JointTable.key(row, tables.identity(JointWords.TABLE, row))
        : -1;
  }

  /** Returns a word of the row of a joint; {@link JointWords} declares them. */
  public int jointWord(int row, int word) {
    return decoder.tables().get(JointWords.TABLE, row, word);
  }

  /**
   * Holds the bodies of a simulation that joints tie to bodies it lacks, because there are more
   * than a predicted set holds. They keep their velocity, without forces, until the next exact
   * state.
   */
  public void holdCut(SimulationHost s) {
    for (int i = 0; i < jointLimit(); i++) {
      if (jointKey(i) >= 0) {
        int endA = jointWord(i, JointWords.END_A);
        int endB = jointWord(i, JointWords.END_B);
        HostEntity a = find(s, endA);
        HostEntity b = find(s, endB);
        if (endA >= 0 && endB >= 0 && (a == null) != (b == null)) {
          Body<HostEntity> body = (a == null ? b : a).body();
          if (body.type() == BodyType.DYNAMIC) {
            body.setType(BodyType.KINEMATIC);
          }
        }
      }
    }
  }

  private static HostEntity find(SimulationHost s, int key) {
    HostEntity e = key < 0 ? null : s.entity(Neighbourhood.id(key));
    return e != null && e.generation() == Neighbourhood.generation(key) ? e : null;
  }

  /** Returns whether the definition of a joint is known. */
  public boolean isJointKnown(int key) {
    TableInbox tables = decoder.tables();
    int row = JointTable.index(key);
    return row < JointTable.MAX_JOINTS
        && tables.isPresent(JointWords.TABLE, row)
        && tables.identity(JointWords.TABLE, row) == JointTable.generation(key);
  }

  /** Returns the archetype of an entity by its newest record; null if there is no such one. */
  public Archetype archetype(int id) {
    return simulation.archetypes().get(decoder.history(id).archetype(0));
  }

  @Override
  public int owner(int key) {
    return Ownership.player(ownership(key));
  }

  @Override
  public boolean isBody(int key) {
    return Ownership.isBody(ownership(key));
  }

  /**
   * Returns the {@link Ownership} by the newest record of an entity, or that of the own spawn which
   * became the entity before its first record came.
   */
  private int ownership(int key) {
    EntityHistory history = decoder.history(Neighbourhood.id(key));
    for (int i = 0; history != null && i < history.size(); i++) {
      if (history.alive(i) && history.generation(i) == Neighbourhood.generation(key)) {
        return history.ownership(i);
      }
    }
    return spawns.ownership(key);
  }

  @Override
  public int origin(int key) {
    return spawns.origin(key);
  }

  /** Returns whether the newest record of a slot is this entity's, with a known archetype. */
  public boolean isKnown(int key) {
    EntityHistory history = decoder.history(Neighbourhood.id(key));
    return history != null
        && history.alive()
        && history.generation(0) == Neighbourhood.generation(key)
        && archetype(Neighbourhood.id(key)) != null;
  }

  /** Returns the teleport counter of an entity, or 0 if no record tells. */
  public int teleports(int id, int generation) {
    EntityHistory history = decoder.history(id);
    boolean known = history != null && history.alive() && history.generation(0) == generation;
    return known ? history.teleports(0) : 0;
  }

  /**
   * Reads the quantised pose of an entity after a tick and its derived velocity, extrapolated from
   * the last record before.
   *
   * @param out receives the state; unchanged when the result is false
   * @return whether a record tells
   */
  public boolean readPose(int key, int tick, Pose out) {
    int generation = Neighbourhood.generation(key);
    EntityHistory history = decoder.history(Neighbourhood.id(key));
    int index = history.indexAt(tick);
    if (index < 0 || !history.alive(index) || history.generation(index) != generation) {
      index = 0; // the entity is younger than the tick
    }
    if (!history.alive(index) || history.generation(index) != generation) {
      return false;
    }
    StateHistory s = states.of(history);
    int age = Math.max(0, Math.min(MAX_EXTRAPOLATION_TICKS, tick - s.tick(index)));
    float seconds = age * simulation.tickSeconds();
    velocity.measure(s, index);
    out.set(
        s.x(index) + velocity.vx * seconds,
        s.y(index) + velocity.vy * seconds,
        s.angle(index) + velocity.omega * seconds,
        velocity.vx,
        velocity.vy,
        velocity.omega);
    return true;
  }
}
