package carom.sim.entity;

import carom.physics.Body;
import carom.physics.World;
import carom.physics.WorldState;
import carom.physics.archive.Archive;
import carom.physics.archive.ArchiveReader;
import carom.sim.field.Scope;
import carom.sim.level.Archetype;
import carom.sim.level.Archetypes;
import carom.sim.spawn.Origin;
import java.util.Arrays;

/** The saved state of an {@link EntityTable}, a column each. The arrays are reused. */
public final class SavedEntities {
  private static final int ENTITY_BYTES = 1 + 7 * Integer.BYTES;

  final SavedFields fields;
  int count;
  int capacity;
  HostEntity[] entities = {};
  private Archetype[] archetypes = {};
  int[] tags = {};
  int[] teleports = {};
  int[] roots = {};
  int[] origins = {};
  byte[] generations = {};

  /** Number of provisional entities, which follow after {@link #capacity} places. */
  int provisionalCount;

  /** Body slot of each entity, by entity id; used while the state is read or written. */
  private int[] slots = {};

  /** Body slots in use, sorted, each above an entity's id; used while the state is read. */
  private long[] bySlot = {};

  /**
   * Creates the state of no entities.
   *
   * @param fields receives their fields
   */
  public SavedEntities(SavedFields fields) {
    this.fields = fields;
  }

  /** Makes room. What was saved is lost when there isn't enough. */
  void ensureRoom(int room) {
    if (entities.length < room) {
      entities = new HostEntity[room];
      archetypes = new Archetype[room];
      tags = new int[room];
      roots = new int[room];
      origins = new int[room];
      teleports = new int[room];
      generations = new byte[room];
    }
  }

  /** Saves an entity at a place, or that there is none. Ids are places. */
  void save(int at, HostEntity entity) {
    entities[at] = entity;
    if (entity != null) {
      archetypes[at] = entity.archetype();
      tags[at] = entity.tag();
      teleports[at] = entity.teleports();
      roots[at] = entity.rootId();
      origins[at] = entity.origin();
      fields.save(entity.fieldValues(), at);
    } else {
      tags[at] = 0;
      teleports[at] = 0;
      roots[at] = HostEntity.NO_ROOT;
      origins[at] = Origin.NONE;
    }
  }

  /** Gives an entity what was saved at a place. */
  void restore(int at, HostEntity entity) {
    entity.archetype(archetypes[at]);
    entity.tag(tags[at]);
    entity.teleports(teleports[at]);
    entity.rootId(roots[at]);
    entity.origin(origins[at]);
    fields.restore(entity.fieldValues(), at);
  }

  /**
   * Reads or writes the state, but for the bodies.
   *
   * @param table those of its entities that are the same are taken over
   */
  public void pass(Archive a, EntityTable table, Archetypes registered) {
    int n = a.count("entities", capacity, EntityTable.MAX_ENTITIES, ENTITY_BYTES);
    int[] kinds = new int[n];
    int[] owners = new int[n];
    if (a.reads()) {
      capacity = n;
      ensureRoom(n);
    }
    slots = new int[n];
    for (int id = 0; !a.reads() && id < n; id++) {
      HostEntity e = entities[id];
      kinds[id] = e == null ? -1 : archetypes[id].index();
      owners[id] = e == null ? HostEntity.NO_OWNER : e.ownerId();
      slots[id] = e == null ? -1 : e.bodySlot();
    }
    a.bytes("generation of entity", generations, n, Byte.MIN_VALUE, Byte.MAX_VALUE);
    a.integers("archetype of entity", kinds, n, -1, registered.size() - 1);
    a.integers("owner of entity", owners, n, HostEntity.NO_OWNER, PlayerTable.MAX_PLAYERS - 1);
    a.integers("tag of entity", tags, n, Integer.MIN_VALUE, Integer.MAX_VALUE);
    a.integers("teleports of entity", teleports, n, Integer.MIN_VALUE, Integer.MAX_VALUE);
    a.integers("root of entity", roots, n, HostEntity.NO_ROOT, EntityTable.MAX_ENTITIES - 1);
    a.integers("origin of entity", origins, n, Origin.NONE, Origin.LAST);
    a.integers("body of entity", slots, n, -1, Integer.MAX_VALUE);
    for (int id = 0; id < n; id++) {
      if (kinds[id] >= 0) {
        fields.pass(a, Scope.ENTITY, id);
      }
      if (a.reads() && kinds[id] >= 0) {
        a.require(slots[id] >= 0, "entity=" + id + " has no body");
        archetypes[id] = registered.get(kinds[id]);
        entities[id] = entity(table, id, archetypes[id], owners[id]);
        count++;
      }
    }
    if (a.reads()) {
      listBySlot();
    }
  }

  /** Returns the table's own entity if it is the same one, and a new one otherwise. */
  private HostEntity entity(EntityTable table, int id, Archetype kind, int ownerId) {
    int generation = generations[id] & 0xff;
    HostEntity known = table.get(id);
    boolean same =
        known != null
            && known.generation() == generation
            && known.ownerId() == ownerId
            && known.bodySlot() == slots[id];
    return same ? known : new HostEntity(table, id, generation, kind, ownerId);
  }

  private void listBySlot() {
    bySlot = new long[count];
    int n = 0;
    for (int id = 0; id < capacity; id++) {
      if (entities[id] != null) {
        bySlot[n++] = (long) slots[id] << 32 | id;
      }
    }
    Arrays.sort(bySlot);
  }

  /** Returns the entity with the body in a slot, or null for static level geometry. */
  public HostEntity user(int slot) {
    int i = Arrays.binarySearch(bySlot, (long) slot << 32);
    int at = i < 0 ? -1 - i : i;
    return at < bySlot.length && bySlot[at] >>> 32 == slot ? entities[(int) bySlot[at]] : null;
  }

  /** Gives the entities that were read their bodies, of a world that was read. */
  public void attachBodies(ArchiveReader archive, World<HostEntity> world, WorldState state) {
    for (int id = 0; id < capacity; id++) {
      if (entities[id] != null) {
        attachBody(archive, id, world.bodyIn(state, slots[id]));
      }
    }
  }

  private void attachBody(ArchiveReader archive, int id, Body<HostEntity> body) {
    if (body == null || body.user() != entities[id]) {
      throw archive.refused("body=" + slots[id] + " isn't that of entity=" + id);
    }
    HostEntity e = entities[id];
    if (e.body() == null) {
      e.body(body);
    } else if (e.body() != body) {
      throw archive.refused("entity=" + id + " has another body=" + e.bodySlot());
    }
  }
}
