package carom.sim;

import carom.physics.WorldState;
import carom.physics.archive.Archive;
import carom.physics.archive.ArchiveReader;
import carom.physics.archive.ArchiveWriter;
import carom.sim.entity.HostEntity;
import carom.sim.entity.JointTable;
import carom.sim.entity.PoseHistory;
import carom.sim.entity.SavedEntities;
import carom.sim.entity.SavedFields;
import carom.sim.entity.SavedPlayers;
import carom.sim.field.Scope;
import carom.sim.level.Level;
import carom.sim.pool.PoolsState;

/**
 * A saved {@link SimulationHost}. Its arrays are its own and are reused from save to save. It
 * belongs to the simulation that filled it, and its contents are internal.
 */
public final class SimState {
  /**
   * Version of the layout of {@link #write}, that of the world included. Every change of the layout
   * raises it. It says nothing about arithmetic: a build that computes otherwise may read the state
   * and go on from it.
   */
  public static final int LAYOUT = 2;

  final SimParts owner;
  final SavedFields fields;
  final SavedEntities entities;
  final SavedPlayers players;
  WorldState world;
  int tick;
  long random;
  final JointTable.Saved joints = new JointTable.Saved();
  PoseHistory<HostEntity> history;

  /** The state of water and sand; null if there is none, and on PREDICTION. */
  PoolsState pools;

  SimState(SimParts owner) {
    this.owner = owner;
    fields = new SavedFields(owner.fields.schema());
    entities = new SavedEntities(fields);
    players = new SavedPlayers(fields);
  }

  /**
   * Checks that the state is of a simulation with these parts.
   *
   * @throws IllegalArgumentException when another simulation made it
   */
  void requireOf(SimParts parts) {
    if (owner != parts) {
      throw new IllegalArgumentException("the state belongs to another simulation");
    }
  }

  /** Copies the present state of the parts. */
  void save() {
    world = owner.world.save(world);
    tick = owner.tick;
    random = owner.random.state();
    fields.save(owner.match, 0);
    owner.players.save(players);
    owner.entities.save(entities);
    owner.joints.save(joints);
    if (owner.role == Role.AUTHORITY && owner.pools.count() > 0) {
      pools = owner.pools.save(pools);
    }
    if (owner.history != null) {
      history = history == null ? owner.newHistory() : history;
      owner.history.copyTo(history);
    }
  }

  /** Gives the parts this state. Messages that wait for the next step are dropped. */
  void restore() {
    owner.world.restore(world);
    owner.received.clear();
    owner.tick = tick;
    owner.random.state(random);
    fields.restore(owner.match, 0);
    owner.players.restore(players);
    owner.entities.restore(entities);
    owner.joints.restore(joints);
    if (owner.triggers != null) {
      owner.triggers.restore();
    }
    if (pools != null) {
      owner.pools.restore(pools);
    }
    if (owner.history != null) {
      history.copyTo(owner.history);
    }
  }

  /** Returns a word of the match's fields. */
  public int matchWord(int index) {
    return fields.matchWord(index);
  }

  /** Returns the tick of the state. */
  public int tick() {
    return tick;
  }

  /**
   * Appends the state to an archive: everything that {@link SimulationHost#stateHash} covers, the
   * names of players, and the past that {@link SimulationHost#asSeenBy} uses. {@link
   * SimulationHost#read} reads it.
   *
   * @param archive receives it
   * @throws IllegalArgumentException if the world has blown up, see {@link WorldState#write}
   */
  public void write(ArchiveWriter archive) {
    pass(archive);
    if (pools != null) {
      pools.write(archive);
    }
    world.write(archive);
  }

  /** Reads a state that {@link #write} has written, for a simulation of the same level and game. */
  static SimState read(SimParts owner, ArchiveReader archive) {
    SimState s = new SimState(owner);
    s.pass(archive);
    if (owner.pools.count() > 0) {
      s.pools = owner.pools.read(archive);
    }
    s.world = owner.world.read(archive, s.entities::user);
    s.entities.attachBodies(archive, owner.world, s.world);
    if (!archive.isEmpty()) {
      throw archive.refused("bytes are left over");
    }
    return s;
  }

  private void pass(Archive a) {
    Level level = owner.level;
    long hash = a.bits("level", level.contentHash());
    a.require(
        hash == level.contentHash(), "the state belongs to another level than " + level.name());
    int rate = a.integer("tick rate", owner.tickRate, 1, 1_000);
    a.require(
        rate == owner.tickRate, "tickRate=" + rate + " is not this simulation's " + owner.tickRate);
    fields.passSchema(a);
    fields.pass(a, Scope.MATCH, 0);
    tick = a.integer("tick", tick, 0, Integer.MAX_VALUE);
    random = a.bits("random", random);
    entities.pass(a, owner.entities, owner.archetypes);
    joints.pass(a);
    players.pass(a, owner.players, entities);
    boolean looksBack = owner.history != null;
    if (a.flag("looking back", looksBack)) {
      a.require(looksBack, "this game doesn't look back");
      if (a.reads()) {
        history = owner.newHistory();
      }
      history.pass(a, tick);
    } else {
      a.require(!looksBack, "this game looks back");
    }
  }
}
