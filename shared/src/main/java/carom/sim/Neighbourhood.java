package carom.sim;

import carom.physics.dynamics.Excerpt;
import carom.physics.math.StateHash;
import carom.sim.level.Archetype;
import java.util.Arrays;

/**
 * The exact state of some entities of a simulation, as numbers: what a server sends so that a
 * client's simulation of the same entities goes on to the bit as the server's does.
 *
 * <p>Per entity: who it is, the {@linkplain Excerpt exact state} of its body, and the memory of the
 * player whose body it is. And the contacts among them and with the level's statics. Entities stand
 * in the order of their bodies in the world they were read from, which is part of the state: the
 * solver follows it.
 *
 * <p>Mutable, reused; allocates only to grow. One thread.
 */
public final class Neighbourhood {
  /** Numbers per entity: {@link #key}, the body's, the memory of its player. */
  public static final int ENTITY_INTS = 1 + Excerpt.BODY_INTS + Player.MEMORY_SIZE;

  /** Numbers per contact, see {@link Excerpt#CONTACT_INTS}. */
  public static final int CONTACT_INTS = Excerpt.CONTACT_INTS;

  private static final int MEMORY = 1 + Excerpt.BODY_INTS;

  private final Excerpt excerpt = new Excerpt();
  private Entity[] listed = new Entity[8];
  private int count;
  private int[] entities = new int[8 * ENTITY_INTS];
  private int contactCount;
  private int[] contacts = new int[8 * CONTACT_INTS];

  /** Makes an empty one. */
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
    Arrays.fill(listed, 0, count, null);
    count = 0;
    contactCount = 0;
  }

  /** Lists an entity, whatever the order; {@link #read} puts them in order. */
  public void add(Entity entity) {
    if (count == listed.length) {
      listed = Arrays.copyOf(listed, 2 * count);
    }
    listed[count++] = entity;
  }

  /**
   * Adds an entity that comes from elsewhere, at the end.
   *
   * @param from holds its numbers
   * @param at where they begin
   */
  public void add(int[] from, int at) {
    ensure(count + 1);
    System.arraycopy(from, at, entities, count * ENTITY_INTS, ENTITY_INTS);
    if (count == listed.length) {
      listed = Arrays.copyOf(listed, 2 * count);
    }
    count++;
  }

  /**
   * Adds a contact that comes from elsewhere, at the end.
   *
   * @param from holds its numbers
   * @param at where they begin
   */
  public void addContact(int[] from, int at) {
    ensureContacts(contactCount + 1);
    System.arraycopy(from, at, contacts, contactCount * CONTACT_INTS, CONTACT_INTS);
    contactCount++;
  }

  /** Reads the listed entities out of the simulation they belong to. */
  public void read(Simulation s) {
    sort(count);
    excerpt.clear();
    for (int i = 0; i < count; i++) {
      excerpt.add(listed[i].body().index());
    }
    s.world().read(excerpt);
    ensure(count);
    for (int i = 0; i < count; i++) {
      Entity e = listed[i];
      int at = i * ENTITY_INTS;
      entities[at] = key(e.id(), e.generation());
      System.arraycopy(
          excerpt.bodies(), i * Excerpt.BODY_INTS, entities, at + 1, Excerpt.BODY_INTS);
      Player owner = s.owner(e);
      if (owner != null && owner.body() == e) {
        System.arraycopy(owner.memory(), 0, entities, at + MEMORY, Player.MEMORY_SIZE);
      } else {
        Arrays.fill(entities, at + MEMORY, at + ENTITY_INTS, 0);
      }
    }
    contactCount = excerpt.contactCount();
    ensureContacts(contactCount);
    System.arraycopy(excerpt.contacts(), 0, contacts, 0, contactCount * CONTACT_INTS);
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
  private void sort(int n) {
    for (int i = 1; i < n; i++) {
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
    excerpt.clear();
    for (int i = 0; i < count; i++) {
      int at = i * ENTITY_INTS;
      int id = id(entities[at]);
      int owner = who.owner(id);
      if (owner != Entity.NO_OWNER && s.player(owner) == null) {
        s.joinAs(owner, "");
      }
      listed[i] = s.spawnAs(id, generation(entities[at]), who.archetype(id), 0, 0, 0, owner);
      excerpt.add(listed[i].body().index());
      System.arraycopy(
          entities, at + 1, excerpt.bodies(), i * Excerpt.BODY_INTS, Excerpt.BODY_INTS);
      Player player = s.player(owner);
      if (player != null && player.body() == listed[i]) {
        System.arraycopy(entities, at + MEMORY, player.memory(), 0, Player.MEMORY_SIZE);
      }
    }
    for (int i = 0; i < contactCount; i++) {
      int to = excerpt.addContact();
      System.arraycopy(contacts, i * CONTACT_INTS, excerpt.contacts(), to, CONTACT_INTS);
    }
    s.world().write(excerpt);
  }

  /** The last slot first: the world hands free slots out again in reverse, so in order. */
  private void despawnAll(Simulation s) {
    int n = 0;
    for (int id = 0; id < s.entityCapacity(); id++) {
      Entity e = s.entity(id);
      if (e != null) {
        if (n == listed.length) {
          listed = Arrays.copyOf(listed, 2 * n);
        }
        listed[n++] = e;
      }
    }
    sort(n);
    while (n > 0) {
      s.despawn(listed[--n]);
    }
  }

  /** Entities listed. */
  public int count() {
    return count;
  }

  /** The entities' numbers, {@link #ENTITY_INTS} each; the live array, replaced when it grows. */
  public int[] entities() {
    return entities;
  }

  /** Contacts held. */
  public int contactCount() {
    return contactCount;
  }

  /** The contacts' numbers, {@link #CONTACT_INTS} each; the live array, replaced when it grows. */
  public int[] contacts() {
    return contacts;
  }

  /** Contacts with bodies that are not listed, when it was read. */
  public int leaks() {
    return excerpt.leaks();
  }

  /**
   * Where an entity stands in the list, or -1.
   *
   * @param likely where it probably stands, not negative: there the search begins
   */
  public int find(int key, int likely) {
    for (int i = 0, at = likely; i < count; i++, at++) {
      at = at < count ? at : 0;
      if (entities[at * ENTITY_INTS] == key) {
        return at;
      }
    }
    return -1;
  }

  /** Whether a listed entity's body is awake and may move. */
  public boolean awake(int index) {
    return entities[index * ENTITY_INTS + 1 + Excerpt.REST] != Excerpt.ASLEEP;
  }

  /**
   * Equal neighbourhoods have equal hashes; 64 bits of all numbers. Each entity and each contact is
   * hashed for itself first, so that a processor does several at a time.
   */
  public long hash() {
    long h = StateHash.mix(StateHash.SEED, count);
    for (int i = 0; i < count; i++) {
      h = StateHash.mix(h, entityHash(i));
    }
    for (int i = 0; i < contactCount; i++) {
      h = StateHash.mix(h, hash(contacts, i * CONTACT_INTS, CONTACT_INTS));
    }
    return StateHash.finish(h);
  }

  /** A hash of a listed entity's numbers alone. */
  public long entityHash(int index) {
    return hash(entities, index * ENTITY_INTS, ENTITY_INTS);
  }

  /** Of an odd number of ints. */
  private static long hash(int[] numbers, int at, int count) {
    long h = StateHash.mix(StateHash.SEED, numbers[at]);
    for (int i = at + 1; i < at + count; i += 2) {
      h = StateHash.mix(h, (long) numbers[i] << Integer.SIZE | numbers[i + 1] & 0xffffffffL);
    }
    return h;
  }

  /** Copies another one's numbers. */
  public void set(Neighbourhood other) {
    clear();
    for (int i = 0; i < other.count; i++) {
      add(other.entities, i * ENTITY_INTS);
    }
    for (int i = 0; i < other.contactCount; i++) {
      addContact(other.contacts, i * CONTACT_INTS);
    }
  }

  private void ensure(int n) {
    if (n * ENTITY_INTS > entities.length) {
      entities = Arrays.copyOf(entities, Math.max(n * ENTITY_INTS, 2 * entities.length));
    }
  }

  private void ensureContacts(int n) {
    if (n * CONTACT_INTS > contacts.length) {
      contacts = Arrays.copyOf(contacts, Math.max(n * CONTACT_INTS, 2 * contacts.length));
    }
  }
}
