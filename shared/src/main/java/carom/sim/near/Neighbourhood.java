package carom.sim.near;

import carom.physics.rows.BodyRow;
import carom.physics.rows.ExactRows;
import carom.physics.rows.Rows;
import carom.sim.Entity;
import carom.sim.Player;
import carom.sim.Role;
import carom.sim.Simulation;
import carom.sim.level.Archetype;
import java.util.Arrays;

/**
 * The exact state of some entities of a simulation, as numbers: what a server sends so that a
 * client's simulation of the same entities goes on to the bit as the server's does.
 *
 * <p>The numbers are {@link ExactRows}: a row per entity, with its {@link #key} and the memory of
 * the player whose body it is, and a row per contact among them and with the level's statics.
 * Entities stand in the order of their bodies in the world they were read from, which is part of
 * the state: the solver follows it.
 *
 * <p>Mutable, reused; allocates only to grow. One thread.
 */
public final class Neighbourhood {
  private final ExactRows rows = new ExactRows();

  /** Entities to be read, or scratch. */
  private Entity[] listed = new Entity[8];

  private int listedCount;
  private int leaks;

  /** Creates an empty one. */
  public Neighbourhood() {}

  /** Tells entities apart, those that had the same id before included. */
  public static int key(int id, int generation) {
    return id | generation << 16;
  }

  /** The id in a key. */
  public static int id(int key) {
    return key & 0xffff;
  }

  /** The generation in a key. */
  public static int generation(int key) {
    return key >>> 16;
  }

  /** Whether an entity can push others, so that it matters for what happens to them. */
  public static boolean isSolid(Archetype archetype) {
    return !archetype.sensor();
  }

  /** Removes all entities and contacts. */
  public void clear() {
    Arrays.fill(listed, 0, listedCount, null);
    listedCount = 0;
    rows.clear();
  }

  /** Lists an entity, whatever the order; {@link #read} puts them in order. */
  public void add(Entity entity) {
    if (listedCount == listed.length) {
      listed = Arrays.copyOf(listed, 2 * listedCount);
    }
    listed[listedCount++] = entity;
  }

  /** Reads the listed entities out of the simulation they belong to. */
  public void read(Simulation s) {
    sort();
    rows.clear();
    for (int i = 0; i < listedCount; i++) {
      rows.addBody(listed[i].body().index());
    }
    leaks = s.world().readRows(rows);
    Rows bodies = rows.bodies();
    for (int i = 0; i < listedCount; i++) {
      Entity e = listed[i];
      bodies.set(i, BodyRow.KEY, key(e.id(), e.generation()));
      Player owner = s.owner(e);
      if (owner != null && owner.body() == e) {
        System.arraycopy(
            owner.memory(), 0, bodies.ints(), bodies.at(i) + BodyRow.MEMORY, Player.MEMORY_SIZE);
      }
    }
  }

  /** Lists and reads all entities that can push others. */
  public void readAll(Simulation s) {
    clear();
    for (int id = 0; id < s.entityCapacity(); id++) {
      Entity e = s.entity(id);
      if (e != null && isSolid(e.archetype())) {
        add(e);
      }
    }
    read(s);
  }

  /** By the order of bodies in the world; they nearly are in order. */
  private void sort() {
    for (int i = 1; i < listedCount; i++) {
      Entity e = listed[i];
      int j = i;
      for (; j > 0 && listed[j - 1].body().index() > e.body().index(); j--) {
        listed[j] = listed[j - 1];
      }
      listed[j] = e;
    }
  }

  /** Who is who, for {@link #write}. */
  public interface Identity {
    /** The kind of an entity. */
    Archetype archetype(int id);

    /** The player an entity belongs to, or {@link Entity#NO_OWNER}. */
    int owner(int id);
  }

  /**
   * Makes these entities the only ones of a simulation, in exactly this state. Players they belong
   * to are mirrored as needed. From here on the simulation goes on as the one that was read, as
   * long as inputs are the same and nothing else comes near.
   *
   * @param s of role {@link Role#PREDICTION}, of the same level and game
   * @param who knows kinds and owners
   */
  public void write(Simulation s, Identity who) {
    despawnAll(s);
    Rows bodies = rows.bodies();
    for (int i = 0; i < bodies.count(); i++) {
      int key = bodies.get(i, BodyRow.KEY);
      int id = id(key);
      int owner = who.owner(id);
      if (owner != Entity.NO_OWNER && s.player(owner) == null) {
        s.joinAs(owner, "");
      }
      Entity e = s.spawnAs(id, generation(key), who.archetype(id), 0, 0, 0, owner);
      rows.setSlot(i, e.body().index());
      Player player = s.player(owner);
      if (player != null && player.body() == e) {
        System.arraycopy(
            bodies.ints(), bodies.at(i) + BodyRow.MEMORY, player.memory(), 0, Player.MEMORY_SIZE);
      }
    }
    s.world().writeRows(rows);
  }

  /** The last slot first: the world hands free slots out again in reverse, so in order. */
  private void despawnAll(Simulation s) {
    Arrays.fill(listed, 0, listedCount, null);
    listedCount = 0;
    for (int id = 0; id < s.entityCapacity(); id++) {
      Entity e = s.entity(id);
      if (e != null) {
        add(e);
      }
    }
    sort();
    while (listedCount > 0) {
      s.despawn(listed[--listedCount]);
      listed[listedCount] = null;
    }
  }

  /** Returns the numbers: the live rows, which may be changed. */
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

  /** Contacts with bodies that are not listed, when it was read. */
  public int leaks() {
    return leaks;
  }

  /**
   * Where an entity stands in the list, or -1.
   *
   * @param likely where it probably stands, not negative: there the search begins
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

  /** Equal neighbourhoods have equal hashes; 64 bits of all numbers. */
  public long hash() {
    return rows.hash();
  }
}
