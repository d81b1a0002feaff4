package carom.sim;

import carom.physics.Body;
import carom.physics.WorldState;
import carom.physics.archive.Archive;
import carom.physics.archive.ArchiveReader;
import carom.physics.archive.ArchiveWriter;
import carom.sim.field.SavedFields;
import carom.sim.field.Scope;
import carom.sim.history.PoseHistory;
import carom.sim.joint.JointTable;
import carom.sim.level.Archetype;
import carom.sim.level.Level;
import carom.sim.pool.PoolsState;
import carom.sim.spawn.Origin;
import java.util.Arrays;

/**
 * A saved {@link Simulation}. Its arrays are its own and are reused from save to save. It belongs
 * to the simulation that filled it, and its contents are internal.
 */
public final class SimState {
  /**
   * Version of the layout of {@link #write}, that of the world included. Every change of the layout
   * raises it. It says nothing about arithmetic: a build that computes otherwise may read the state
   * and go on from it.
   */
  public static final int LAYOUT = 1;

  private static final int MAX_NAME = 1 << 16;
  private static final int ENTITY_BYTES = 1 + 7 * Integer.BYTES;

  final Simulation owner;
  final SavedFields fields;
  WorldState world;
  int tick;
  long random;
  int playerLimit;
  Player[] players = {};
  Entity[] bodies = {};
  int[] scores = {};
  int[] teams = {};
  int[] standings = {};
  long[] inputs = {};
  int[] viewDelays = {};
  int entityCount;
  int entityCapacity;
  Entity[] entities = {};
  int[] tags = {};
  int[] teleports = {};
  int[] roots = {};
  int[] origins = {};
  int provisionalCount;
  final JointTable.Saved joints = new JointTable.Saved();
  byte[] generations = {};
  PoseHistory<Entity> history;

  /** The state of water and sand; null if there is none, and on PREDICTION. */
  PoolsState pools;

  /** Body slot of each entity, by entity id; used while the state is read or written. */
  private int[] slots = {};

  /** Body slots in use, sorted, each above an entity's id; used while the state is read. */
  private long[] bySlot = {};

  SimState(Simulation owner) {
    this.owner = owner;
    fields = new SavedFields(owner.schema());
  }

  /** Sets a number above all ids of players, and forgets the players beyond it. */
  void limitPlayers(int limit) {
    if (limit > players.length) {
      int grown = Math.max(limit, 2 * players.length);
      players = Arrays.copyOf(players, grown);
      bodies = Arrays.copyOf(bodies, grown);
      scores = Arrays.copyOf(scores, grown);
      teams = Arrays.copyOf(teams, grown);
      standings = Arrays.copyOf(standings, grown);
      inputs = Arrays.copyOf(inputs, grown);
      viewDelays = Arrays.copyOf(viewDelays, grown);
    }
    Arrays.fill(players, limit, Math.max(limit, playerLimit), null);
    playerLimit = limit;
  }

  /** Makes room for entities. What was saved is lost when there isn't enough. */
  void ensureEntities(int room) {
    if (entities.length < room) {
      entities = new Entity[room];
      tags = new int[room];
      roots = new int[room];
      origins = new int[room];
      teleports = new int[room];
      generations = new byte[room];
    }
  }

  /** Saves an entity at a place, or that there is none. Ids are places. */
  void save(int at, Entity entity) {
    entities[at] = entity;
    if (entity != null) {
      tags[at] = entity.tag();
      teleports[at] = entity.teleports();
      roots[at] = entity.rootId();
      origins[at] = entity.origin();
      fields.save(entity.fieldValues(), at);
    } else {
      tags[at] = 0;
      teleports[at] = 0;
      roots[at] = Entity.NO_ROOT;
      origins[at] = Origin.NONE;
    }
  }

  /** Gives an entity what was saved at a place. */
  void restore(int at, Entity entity) {
    entity.tag(tags[at]);
    entity.teleports(teleports[at]);
    entity.rootId(roots[at]);
    entity.origin(origins[at]);
    fields.restore(entity.fieldValues(), at);
  }

  /** Copies the remembered poses of a simulation, if there are any. */
  void saveHistory(PoseHistory<Entity> from) {
    if (from != null) {
      if (history == null) {
        history = owner.newHistory();
      }
      from.copyTo(history);
    }
  }

  /** Returns the tick of the state. */
  public int tick() {
    return tick;
  }

  /**
   * Appends the state to an archive: everything that {@link Simulation#stateHash} covers, the names
   * of players, and the past that {@link Simulation#asSeenBy} uses. {@link Simulation#read} reads
   * it.
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
  static SimState read(Simulation owner, ArchiveReader archive) {
    SimState s = new SimState(owner);
    s.pass(archive);
    if (owner.pools().count() > 0) {
      s.pools = owner.pools().read(archive);
    }
    s.world = owner.world().read(archive, s::user);
    for (int id = 0; id < s.entityCapacity; id++) {
      if (s.entities[id] != null) {
        s.attachBody(archive, id);
      }
    }
    if (!archive.isEmpty()) {
      throw archive.refused("bytes are left over");
    }
    return s;
  }

  private void pass(Archive a) {
    Level level = owner.level();
    long hash = a.bits("level", level.contentHash());
    a.require(
        hash == level.contentHash(), "the state belongs to another level than " + level.name());
    int rate = a.integer("tick rate", owner.tickRate(), 1, 1_000);
    a.require(
        rate == owner.tickRate(),
        "tickRate=" + rate + " is not this simulation's " + owner.tickRate());
    fields.passSchema(a);
    fields.pass(a, Scope.MATCH, 0);
    tick = a.integer("tick", tick, 0, Integer.MAX_VALUE);
    random = a.bits("random", random);
    passEntities(a);
    joints.pass(a);
    limitPlayers(a.count("players", playerLimit, Simulation.MAX_PLAYERS, Integer.BYTES));
    for (int id = 0; id < playerLimit; id++) {
      if (a.flag("player", players[id] != null)) {
        passPlayer(a, id);
      }
    }
    if (a.flag("looking back", owner.looksBack())) {
      a.require(owner.looksBack(), "this game doesn't look back");
      if (a.reads()) {
        history = owner.newHistory();
      }
      history.pass(a, tick);
    } else {
      a.require(!owner.looksBack(), "this game looks back");
    }
  }

  private void passPlayer(Archive a, int id) {
    String name = a.text("name", players[id] == null ? "" : players[id].name(), MAX_NAME);
    if (a.reads()) {
      Player known = owner.participant(id);
      players[id] =
          known != null && known.name().equals(name) ? known : new Player(owner, id, name);
    }
    int least = Integer.MIN_VALUE;
    int most = Integer.MAX_VALUE;
    int body = bodies[id] == null ? -1 : bodies[id].id();
    body = a.integer("body of player", body, -1, entityCapacity - 1);
    a.require(body < 0 || entities[body] != null, "player=" + id + " has no body=" + body);
    bodies[id] = body < 0 ? null : entities[body];
    scores[id] = a.integer("score", scores[id], least, most);
    teams[id] = a.integer("team", teams[id], least, most);
    standings[id] = a.integer("role and readiness", standings[id], 0, 2);
    a.require(body < 0 || standings[id] != 1, "player=" + id + " watches and has body=" + body);
    inputs[id] = a.bits("input", inputs[id]);
    viewDelays[id] = a.integer("view delay", viewDelays[id], 0, Player.MAX_VIEW_DELAY);
    fields.pass(a, Scope.PLAYER, id);
  }

  private void passEntities(Archive a) {
    int n = a.count("entities", entityCapacity, Simulation.MAX_ENTITIES, ENTITY_BYTES);
    int[] kinds = new int[n];
    int[] owners = new int[n];
    if (a.reads()) {
      entityCapacity = n;
      ensureEntities(n);
    }
    slots = new int[n];
    for (int id = 0; !a.reads() && id < n; id++) {
      Entity e = entities[id];
      kinds[id] = e == null ? -1 : e.archetype().index();
      owners[id] = e == null ? Entity.NO_OWNER : e.ownerId();
      slots[id] = e == null ? -1 : e.bodySlot();
    }
    a.bytes("generation of entity", generations, n, Byte.MIN_VALUE, Byte.MAX_VALUE);
    a.integers("archetype of entity", kinds, n, -1, owner.archetypes().size() - 1);
    a.integers("owner of entity", owners, n, Entity.NO_OWNER, Simulation.MAX_PLAYERS - 1);
    a.integers("tag of entity", tags, n, Integer.MIN_VALUE, Integer.MAX_VALUE);
    a.integers("teleports of entity", teleports, n, Integer.MIN_VALUE, Integer.MAX_VALUE);
    a.integers("root of entity", roots, n, Entity.NO_ROOT, Simulation.MAX_ENTITIES - 1);
    a.integers("origin of entity", origins, n, Origin.NONE, Origin.LAST);
    a.integers("body of entity", slots, n, -1, Integer.MAX_VALUE);
    for (int id = 0; id < n; id++) {
      if (kinds[id] >= 0) {
        fields.pass(a, Scope.ENTITY, id);
      }
      if (a.reads() && kinds[id] >= 0) {
        a.require(slots[id] >= 0, "entity=" + id + " has no body");
        entities[id] = entity(id, owner.archetypes().get(kinds[id]), owners[id]);
        entityCount++;
      }
    }
    if (a.reads()) {
      listBySlot();
    }
  }

  /** Returns the simulation's own entity if it is the same one, and a new one otherwise. */
  private Entity entity(int id, Archetype kind, int ownerId) {
    int generation = generations[id] & 0xff;
    Entity known = owner.entity(id);
    boolean same =
        known != null
            && known.generation() == generation
            && known.archetype() == kind
            && known.ownerId() == ownerId
            && known.bodySlot() == slots[id];
    return same ? known : new Entity(owner.entities(), id, generation, kind, ownerId);
  }

  private void listBySlot() {
    bySlot = new long[entityCount];
    int n = 0;
    for (int id = 0; id < entityCapacity; id++) {
      if (entities[id] != null) {
        bySlot[n++] = (long) slots[id] << 32 | id;
      }
    }
    Arrays.sort(bySlot);
  }

  /** Returns the entity with the body in a slot, or null for static level geometry. */
  private Entity user(int slot) {
    int i = Arrays.binarySearch(bySlot, (long) slot << 32);
    int at = i < 0 ? -1 - i : i;
    return at < bySlot.length && bySlot[at] >>> 32 == slot ? entities[(int) bySlot[at]] : null;
  }

  private void attachBody(ArchiveReader archive, int id) {
    Body<Entity> body = owner.world().bodyIn(world, slots[id]);
    if (body == null || body.user() != entities[id]) {
      throw archive.refused("body=" + slots[id] + " isn't that of entity=" + id);
    }
    Entity e = entities[id];
    if (e.body() == null) {
      e.body(body);
    } else if (e.body() != body) {
      throw archive.refused("entity=" + id + " has another body=" + e.bodySlot());
    }
  }
}
