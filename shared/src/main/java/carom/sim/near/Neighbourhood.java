package carom.sim.near;

import carom.physics.rows.BodyRow;
import carom.physics.rows.ExactRows;
import carom.physics.rows.FieldRow;
import carom.physics.rows.RowKind;
import carom.physics.rows.Rows;
import carom.sim.SimulationHost;
import carom.sim.entity.HostEntity;
import carom.sim.entity.HostPlayer;
import carom.sim.level.Archetype;
import carom.sim.spawn.Origin;
import java.util.Arrays;

/**
 * The exact state of some entities of a simulation, as numbers. A server sends it so that a
 * client's simulation of the same entities continues bit for bit as the server's does.
 *
 * <p>The numbers are {@link ExactRows}: a row per entity, with its {@link #key}; a row per joint
 * and per contact among them and with the level's statics; and rows of the fields of the entities
 * and of the players whose bodies they are. Entities are in the order of their bodies in the world
 * they were read from. The order is part of the state, because the solver follows it.
 *
 * <p>Mutable, reused; allocates only to grow. One thread.
 */
public final class Neighbourhood {
  private static final int EVERYBODY = -1;

  private final ExactRows rows = new ExactRows();
  private final FieldRows fields;
  private final int viewer;

  /** Entities to read, or scratch of {@link #despawnAll}. */
  private HostEntity[] listed = new HostEntity[8];

  private int listedCount;
  private int leaks;
  private final NearJoints joints = new NearJoints();

  /** Creates an empty neighbourhood with all fields that are sent to a player. */
  public Neighbourhood() {
    this(EVERYBODY);
  }

  /**
   * Creates an empty neighbourhood with the fields that a player's client can predict: those of
   * that player and its entities, and of others those that are told to {@code NEAR} or {@code ALL}.
   *
   * @param viewer the player's id
   */
  public Neighbourhood(int viewer) {
    this.viewer = viewer;
    fields = new FieldRows(viewer);
  }

  /** Returns a key that tells entities apart, including earlier ones with the same id. */
  public static int key(int id, int generation) {
    return id | generation << 16;
  }

  /** Returns the id in a key. */
  public static int id(int key) {
    return key & 0xffff;
  }

  /** Returns the generation in a key. */
  public static int generation(int key) {
    return key >>> 16;
  }

  /**
   * Returns whether entities of an archetype affect others: they are solid, carry an area, or are
   * sensors that {@linkplain SimulationHost#hasRules rules} may ask.
   */
  public static boolean affectsOthers(SimulationHost s, Archetype archetype) {
    return !archetype.sensor() || archetype.area() != null || s.hasRules();
  }

  /** Removes all entities and contacts. */
  public void clear() {
    Arrays.fill(listed, 0, listedCount, null);
    listedCount = 0;
    rows.clear();
  }

  /** Lists an entity, in any order; {@link #read} sorts them. */
  public void add(HostEntity entity) {
    if (listedCount == listed.length) {
      listed = Arrays.copyOf(listed, 2 * listedCount);
    }
    listed[listedCount++] = entity;
  }

  /** Reads the state of the listed entities from the simulation they belong to. */
  public void read(SimulationHost s) {
    sort();
    rows.clear();
    for (int i = 0; i < listedCount; i++) {
      rows.addBody(listed[i].body().index());
    }
    leaks = s.world().readRows(rows);
    joints.read(s, rows);
    Rows bodies = rows.bodies();
    for (int i = 0; i < listedCount; i++) {
      HostEntity e = listed[i];
      bodies.set(i, BodyRow.KEY, key(e.id(), e.generation()));
      bodies.set(i, BodyRow.ARCHETYPE, e.archetype().index());
      HostPlayer owner = e.owner();
      fields.read(s.schema(), i, e, owner, rows.of(RowKind.FIELDS));
    }
  }

  /**
   * Lists and reads the viewer's own body, and all entities that affect the motion of others: by
   * what they are, or by a joint. A sensor that hangs on a car has a mass, too.
   */
  public void readAll(SimulationHost s) {
    clear();
    for (int id = 0; id < s.entityCapacity(); id++) {
      HostEntity e = s.entity(id);
      if (e != null && (affectsOthers(s, e.archetype()) || e.body().hasJoints() || isOwnBody(e))) {
        add(e);
      }
    }
    read(s);
  }

  private boolean isOwnBody(HostEntity e) {
    return e.ownerId() == viewer && e.owner() != null && e.owner().entity() == e;
  }

  /**
   * Sorts the listed entities by the order of their bodies in the world. Insertion sort is fast
   * because they are nearly sorted.
   */
  private void sort() {
    for (int i = 1; i < listedCount; i++) {
      HostEntity e = listed[i];
      int j = i;
      for (; j > 0 && listed[j - 1].body().index() > e.body().index(); j--) {
        listed[j] = listed[j - 1];
      }
      listed[j] = e;
    }
  }

  /** Gives the owner of entities, and what joints are, for {@link #write}. */
  public interface Identity {
    /** Returns what knows the definitions of joints. */
    default JointDefinitions joints() {
      return (key, to) -> false;
    }

    /** Returns the player that the entity of a key belongs to, or {@link HostEntity#NO_OWNER}. */
    int owner(int key);

    /** Returns whether the entity of a key may be the body of its owner. */
    default boolean isBody(int key) {
      return true;
    }

    /** Returns which spawn of the own player's input an entity is, if any; see {@link Origin}. */
    default int origin(int key) {
      return Origin.NONE;
    }
  }

  /**
   * Makes these entities the only ones of a simulation, in exactly this state. Owners that the
   * simulation lacks join it. From then on the simulation continues as the one that was read, as
   * long as the inputs are the same and nothing else comes near.
   *
   * @param s of role {@code Role.PREDICTION}, of the same level and game
   * @param who gives owners and definitions of joints
   */
  public void write(SimulationHost s, Identity who) {
    despawnAll(s, who);
    Rows bodies = rows.bodies();
    for (int i = 0; i < bodies.count(); i++) {
      int key = bodies.get(i, BodyRow.KEY);
      int id = id(key);
      int owner = who.owner(key);
      if (owner != HostEntity.NO_OWNER && s.player(owner) == null) {
        s.mirror().join(owner, "");
      }
      Archetype archetype = s.archetypes().get(bodies.get(i, BodyRow.ARCHETYPE));
      HostEntity e =
          s.mirror().spawn(id, generation(key), archetype, 0, 0, 0, owner, who.isBody(key));
      s.mirror().identify(e, who.origin(key));
      rows.setSlot(i, e.body().index());
      HostPlayer player = s.player(owner);
      if (player != null && player.entity() == e) {
        fields.reset(s.schema(), player);
      }
    }
    joints.make(s, rows, who.joints());
    joints.toggle(s, rows);
    s.world().writeRows(rows);
    joints.toggle(s, rows);
    writeFields(s);
  }

  private void writeFields(SimulationHost s) {
    Rows from = rows.of(RowKind.FIELDS);
    for (int row = 0; row < from.count(); row++) {
      HostEntity e = s.entity(id(key(from.get(row, FieldRow.PLACE))));
      HostPlayer owner = e.owner();
      boolean isBody = owner != null && owner.entity() == e;
      fields.write(s.schema(), from.ints(), from.at(row), e, isBody ? owner : null);
    }
  }

  /**
   * Destroys all joints and despawns all entities, with the provisional ones that these rows are
   * of. New bodies and joints then get slots in order.
   */
  private void despawnAll(SimulationHost s, Identity who) {
    s.world().destroyJoints();
    Arrays.fill(listed, 0, listedCount, null);
    listedCount = 0;
    for (int id = 0; id < s.entityCapacity(); id++) {
      HostEntity e = s.entity(id);
      if (e != null) {
        add(e);
      }
    }
    for (int i = 0; s.mirror().provisionalCount() > 0 && i < count(); i++) {
      int origin = who.origin(key(i));
      HostEntity e = origin == Origin.NONE ? null : s.entity(origin);
      if (e != null) {
        add(e);
      }
    }
    sort();
    while (listedCount > 0) {
      s.despawn(listed[--listedCount]);
      listed[listedCount] = null;
    }
    s.world().sortFreeBodies();
  }

  /** Returns the live rows, which the caller may change. */
  public ExactRows rows() {
    return rows;
  }

  /** Returns the number of entities that have been read or added to {@link #rows}. */
  public int count() {
    return rows.bodies().count();
  }

  /** Returns the {@link #key} of an entity. */
  public int key(int index) {
    return rows.bodies().get(index, BodyRow.KEY);
  }

  /**
   * Returns the number of contacts with bodies that were not listed, and of bodies that lost a
   * contact by a call since the step, as of the last {@link #read}.
   */
  public int leaks() {
    return leaks;
  }

  /**
   * Returns the number of joints with bodies that were not listed, as of the last {@link #read}.
   * The listed bodies then don't move as these rows say.
   */
  public int cutJoints() {
    return rows.cutJoints();
  }

  /**
   * Returns the place of an entity in the list, or -1.
   *
   * @param likely its probable place, not negative; the search begins there
   */
  public int find(int key, int likely) {
    int count = count();
    for (int i = 0, at = likely; i < count; i++, at++) {
      at = at < count ? at : 0;
      if (key(at) == key) {
        return at;
      }
    }
    return -1;
  }

  /** Returns whether an entity's body is awake and may move. */
  public boolean awake(int index) {
    return !rows.isAsleep(index);
  }

  /** Returns a 64-bit hash of all numbers. Equal neighbourhoods have equal hashes. */
  public long hash() {
    return rows.hash();
  }
}
