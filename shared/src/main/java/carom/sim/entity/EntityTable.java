package carom.sim.entity;

import carom.physics.Body;
import carom.physics.BodyContactVisitor;
import carom.physics.BodyDef;
import carom.physics.BodyVisitor;
import carom.physics.Joint;
import carom.physics.World;
import carom.physics.math.Limits;
import carom.physics.math.SimRandom;
import carom.physics.math.Transform;
import carom.physics.math.Trig;
import carom.physics.rows.JointDefRow;
import carom.sim.field.FieldStore;
import carom.sim.field.FieldValues;
import carom.sim.field.Schema;
import carom.sim.level.Archetype;
import carom.sim.level.Archetypes;
import carom.sim.level.Level;
import carom.sim.level.ScriptedMotion;
import carom.sim.phase.Phase;
import carom.sim.phase.Phases;
import carom.sim.phase.RuleWatch;
import carom.sim.spawn.Origin;
import java.util.Arrays;
import java.util.function.BiConsumer;
import java.util.function.IntSupplier;
import java.util.function.Predicate;

/**
 * The entities of a simulation by id, their bodies, and their part of its state. A free id keeps
 * its generation, so that its next entity gets another one.
 */
public final class EntityTable
    implements TrackedBodies<HostEntity>, FieldStore.References<HostEntity, HostPlayer> {
  /** Most entities at a time; ids are 0..65534. */
  public static final int MAX_ENTITIES = 65_535;

  /** Answers what entities ask of the simulation around the table. */
  public interface Answers {
    /** Destroys an entity, as {@link Entity#despawn} says. */
    void despawn(HostEntity entity);

    /** Returns a body of an entity's assembly, as {@link Entity#part} says. */
    HostEntity part(HostEntity entity, String name);

    /** Returns a joint of an entity's assembly, as {@link Entity#joint} says. */
    EntityJoint joint(HostEntity entity, String name);

    /** Returns whether an entity is in a sensor, as {@link Entity#isInside} says. */
    boolean isInside(HostEntity entity, String sensor);

    /** Creates what a player fires, as {@link Player#spawn} says. */
    HostEntity spawn(Archetype archetype, float x, float y, float angle, HostPlayer owner);
  }

  private final World<HostEntity> world;
  private final AreaForces<HostEntity> areas;
  private final Assemblies assemblies;
  private final JointTable<HostEntity> joints;
  private final int tickRate;
  private final FieldStore fields;
  private final EntityFields entityFields;
  private final PlayerTable players;
  private final ArchetypeChange changes;
  private final Phases<HostPlayer> phases;
  private RuleWatch watch;
  private HostEntity[] entities = new HostEntity[64];
  private byte[] generations = new byte[64];
  private final ProvisionalEntities provisional = new ProvisionalEntities();
  private final Ground ground = new Ground();
  private EntityJoint[] faces = {};
  private EntityContactVisitor contacts;
  private final BodyContactVisitor<HostEntity> onContact =
      (other, x, y, impulse) -> contacts.contact(other.user(), x, y, impulse);
  private HostEntity overlapped;
  private Predicate<Entity> overlaps;
  private final BodyVisitor<HostEntity> onOverlap = this::overlap;
  private Answers answers;
  private BiConsumer<HostEntity, HostEntity> overlapReader = (asked, other) -> {};

  /** Number above all ids that were ever used. */
  private int capacity;

  private int count;

  /** Lower bound of the free ids. */
  private int firstFree;

  private long version;

  /**
   * Creates the table of a simulation's entities and players, which is empty.
   *
   * @param clock returns the tick
   */
  public EntityTable(
      World<HostEntity> world,
      AreaForces<HostEntity> areas,
      Assemblies assemblies,
      JointTable<HostEntity> joints,
      int tickRate,
      Schema schema,
      Archetypes archetypes,
      Phases<HostPlayer> phases,
      IntSupplier clock) {
    this.areas = areas;
    this.assemblies = assemblies;
    this.joints = joints;
    this.world = world;
    this.tickRate = tickRate;
    this.phases = phases;
    fields = new FieldStore(schema, clock, this, phases);
    entityFields = new EntityFields(fields);
    players =
        new PlayerTable(
            fields,
            phases::requireAuthority,
            phases::requireTold,
            (archetype, x, y, angle, owner) -> answers.spawn(archetype, x, y, angle, owner));
    changes = new ArchetypeChange(this, areas, phases, archetypes);
  }

  /** Returns the entity under an id, or null when the id is free or out of range. */
  public HostEntity get(int id) {
    if (Origin.isProvisional(id)) {
      return provisional.get(id);
    }
    return id >= 0 && id < capacity ? entities[id] : null;
  }

  /** Sets what entities ask; once, before the first exists. */
  public void answers(Answers asked) {
    answers = asked;
  }

  Answers answers() {
    return answers;
  }

  Ground ground() {
    return ground;
  }

  int tickRate() {
    return tickRate;
  }

  /** Visits a body's contacts as a game sees them; a visitor may ask for those of another body. */
  void forEachContact(Body<HostEntity> body, EntityContactVisitor visitor) {
    EntityContactVisitor outer = contacts;
    contacts = visitor;
    try {
      body.forEachContact(onContact);
    } finally {
      contacts = outer;
    }
  }

  /** Sets what is told of entities that rules change, or null; mostly it is null. */
  public void watch(RuleWatch told) {
    watch = told;
  }

  /** Notes that the game changes an entity. */
  void changing(HostEntity entity) {
    if (phases.now() == Phase.RULES) {
      phases.requireOutsideRules("a change of " + entity);
    }
    despawning(entity);
  }

  /** Notes that the game despawns an entity. */
  void despawning(HostEntity entity) {
    if (watch != null && phases.now().isOfRules()) {
      watch.changes(entity.ownerId(), true);
    }
  }

  /** Sets what receives each overlap that a game reads. */
  public void overlapReader(BiConsumer<HostEntity, HostEntity> reader) {
    overlapReader = reader;
  }

  /** Visits an entity's overlaps as a game sees them; a visitor may ask for those of another. */
  void forEachOverlap(HostEntity asked, Predicate<Entity> visitor) {
    HostEntity outer = overlapped;
    Predicate<Entity> outerVisitor = overlaps;
    overlapped = asked;
    overlaps = visitor;
    try {
      asked.body().forEachOverlap(onOverlap);
    } finally {
      overlapped = outer;
      overlaps = outerVisitor;
    }
  }

  private boolean overlap(Body<HostEntity> other) {
    overlapReader.accept(overlapped, other.user());
    return overlaps.test(other.user());
  }

  /** Destroys a joint, if it is there. */
  void destroy(Joint<HostEntity> joint) {
    if (joint.isValid()) {
      world.destroyJoint(joint);
    }
  }

  /** Returns the face of a joint, or null for none; the same for the same joint. */
  public EntityJoint face(Joint<HostEntity> joint) {
    if (joint == null) {
      return null;
    }
    int index = joint.index();
    if (index >= faces.length) {
      faces = Arrays.copyOf(faces, Math.max(index + 1, 2 * faces.length));
    }
    if (faces[index] == null || EntityJoint.engineOf(faces[index]) != joint) {
      faces[index] = new EntityJoint(joint);
    }
    return faces[index];
  }

  /** Returns the entities that a client has before the server tells them. */
  public ProvisionalEntities provisional() {
    return provisional;
  }

  /** Returns the participants. */
  public PlayerTable players() {
    return players;
  }

  /** Returns the declared fields and the rules of writing them. */
  public FieldStore fields() {
    return fields;
  }

  /** Returns what lets entities become other archetypes. */
  ArchetypeChange changes() {
    return changes;
  }

  /** Lets the fields of an entity count as begun as its archetype says; their values stay. */
  void begunAs(HostEntity entity) {
    entityFields.begunAs(entity.archetype(), entity.fieldValues());
  }

  /** Creates the fields of an entity, which begin as its archetype says. */
  FieldValues newFields(Archetype archetype, boolean ofLevel) {
    return entityFields.create(archetype, ofLevel);
  }

  /**
   * Checks that archetypes use declared fields only.
   *
   * @throws IllegalArgumentException if one doesn't
   */
  public void checkFields(Archetypes archetypes) {
    entityFields.check(archetypes);
  }

  @Override
  public HostEntity entity(int id, int generation) {
    HostEntity entity = get(id);
    return entity != null && entity.generation() == generation ? entity : null;
  }

  @Override
  public HostPlayer player(int id) {
    return players.get(id);
  }

  /** Returns whether an entity has not been despawned. */
  public boolean holds(HostEntity entity) {
    return get(entity.id()) == entity;
  }

  /** Returns a number above all ids that were ever used. */
  public int capacity() {
    return capacity;
  }

  /** Returns the number of entities. */
  public int count() {
    return count;
  }

  /** Returns a number that changes with each {@link #noteChange}. */
  public long version() {
    return version;
  }

  /** Notes that an entity is about to be put elsewhere, or has been: its area, if any, wakes. */
  void wakeAround(HostEntity entity) {
    areas.wakeAround(entity.id());
  }

  /** Notes that an entity came, went or was teleported. */
  void noteChange() {
    version++;
  }

  @Override
  public int limit() {
    return capacity;
  }

  @Override
  public Body<HostEntity> body(int id) {
    HostEntity entity = entities[id];
    return entity == null ? null : entity.body();
  }

  @Override
  public Archetype archetype(int id) {
    return entities[id].archetype();
  }

  @Override
  public boolean isTracked(Body<HostEntity> body) {
    return body.user() != null && !body.user().isLevel();
  }

  /** Creates an entity of static level geometry. The table does not list it. */
  public HostEntity createStatic(Archetype archetype, Level.Placement p) {
    HostEntity entity = new HostEntity(this, HostEntity.LEVEL, 0, archetype, HostEntity.NO_OWNER);
    createBody(entity, p.x(), p.y(), p.angle());
    return entity;
  }

  /**
   * Creates an entity under the smallest free id.
   *
   * @param tick determines where on its path a kinematic body begins
   */
  public HostEntity spawn(
      Archetype archetype, float x, float y, float angle, int ownerId, int tick) {
    int id = takeFreeId(archetype);
    return add(
        new HostEntity(this, id, generations[id] & 0xff, archetype, ownerId), x, y, angle, tick);
  }

  /** Creates an entity without an owner under the smallest free id, with a body as defined. */
  public HostEntity spawn(Archetype archetype, BodyDef def) {
    int id = takeFreeId(archetype);
    HostEntity entity =
        new HostEntity(this, id, generations[id] & 0xff, archetype, HostEntity.NO_OWNER);
    entity.body(world.createBody(def, entity));
    return register(entity, true);
  }

  /** Creates an entity under a given id; see {@code Simulation.spawnAs}. */
  public HostEntity spawnAs(
      int id,
      int generation,
      Archetype archetype,
      float x,
      float y,
      float angle,
      int ownerId,
      boolean mayBeBody,
      int tick) {
    if (id < 0 || id >= MAX_ENTITIES || generation < 0 || generation > 255) {
      throw new IllegalArgumentException(
          "id=" + id + " generation=" + generation + " is outside 0..65534, 0..255");
    }
    grow(id);
    if (entities[id] != null) {
      throw new IllegalStateException(
          "id=" + id + " is taken by " + entities[id] + "; despawn it first");
    }
    HostEntity entity = new HostEntity(this, id, generation, archetype, ownerId);
    createBody(entity, x, y, angle, tick);
    return register(entity, mayBeBody);
  }

  /**
   * Creates an entity that the server hasn't told yet, in place of one of the same id. It has no
   * part in the order of ids.
   *
   * @param id its origin, or {@link Origin#passing}
   */
  public HostEntity spawnProvisional(
      int id, Archetype archetype, float x, float y, float angle, int ownerId, int tick) {
    if (provisional.get(id) != null) {
      despawn(provisional.get(id));
    }
    HostEntity entity = new HostEntity(this, id, 0, archetype, ownerId);
    createBody(entity, x, y, angle, tick);
    provisional.add(entity);
    noteChange();
    areas.come(id, entity.body(), archetype);
    return entity;
  }

  /**
   * Notes that {@code Game.input} of an entity's owner spawned it. If the owner has too many of
   * them, the oldest is an entity like others from now on, or goes if it is provisional.
   */
  public void setOrigin(HostEntity entity, int origin) {
    HostPlayer owner = players.get(entity.ownerId());
    if (owner == null || origin == entity.origin()) {
      return;
    }
    owner.removeSpawned(entity);
    entity.origin(origin);
    if (origin == Origin.NONE) {
      return;
    }
    HostEntity oldest = owner.addSpawned(entity);
    if (oldest != null) {
      oldest.origin(Origin.NONE);
      if (oldest.isProvisional()) {
        despawn(oldest);
      }
    }
  }

  /** Creates the bodies and joints of an assembly; returns its root. */
  public HostEntity spawn(Assembly assembly, float x, float y, float angle, int ownerId, int tick) {
    if (count + assembly.bodyCount() > MAX_ENTITIES) {
      throw new IllegalStateException(
          "assembly=" + assembly + " can't be spawned: entities=" + count + " is the limit");
    }
    Transform pose = new Transform();
    pose.set(x, y, Trig.cos(angle), Trig.sin(angle));
    HostEntity[] members = new HostEntity[assembly.bodyCount()];
    for (int i = 0; i < members.length; i++) {
      Limits.position("x", xOf(assembly, i, pose));
      Limits.position("y", yOf(assembly, i, pose));
      Limits.range("angle", angle + assembly.angle(i), -1e5f, 1e5f);
    }
    for (int i = 0; i < members.length; i++) {
      members[i] =
          spawn(
              assembly.archetypes().get(i),
              xOf(assembly, i, pose),
              yOf(assembly, i, pose),
              angle + assembly.angle(i),
              ownerId,
              tick);
      members[i].rootId(members[0].id());
    }
    for (int i = 0; i < assembly.jointCount(); i++) {
      int at = i * JointDefRow.INTS;
      Body<HostEntity> a = members[assembly.bodyA(i)].body();
      Body<HostEntity> b = members[assembly.bodyB(i)].body();
      joints.place(pose, members[0].id(), i, a, b, assembly.definitions(), at);
    }
    return members[0];
  }

  private static float xOf(Assembly assembly, int part, Transform pose) {
    return pose.x + pose.cos * assembly.x(part) - pose.sin * assembly.y(part);
  }

  private static float yOf(Assembly assembly, int part, Transform pose) {
    return pose.y + pose.sin * assembly.x(part) + pose.cos * assembly.y(part);
  }

  /** Moves an assembly rigidly to where its root shall be. */
  void moveAssembly(HostEntity root, float x, float y, float angle) {
    Transform before = new Transform();
    Body<HostEntity> body = root.body();
    before.set(body.x(), body.y(), body.cos(), body.sin());
    Transform after = new Transform();
    after.set(x, y, Trig.cos(angle), Trig.sin(angle));
    for (int i = 0; i < capacity; i++) {
      if (isPartOf(root, entities[i])) {
        entities[i].requireRoom(before, after);
      }
    }
    wakeAround(root);
    for (int i = 0; i < capacity; i++) {
      if (isPartOf(root, entities[i])) {
        entities[i].teleportWith(before, after);
      }
    }
    body.setPose(x, y, angle);
    joints.assemblyMoved(root.id(), before, after);
  }

  private static boolean isPartOf(HostEntity root, HostEntity entity) {
    return entity != null && entity != root && entity.rootId() == root.id();
  }

  /** Makes an entity a member of the assembly whose root has an id. */
  public void join(int root, HostEntity member) {
    member.rootId(root);
  }

  private int takeFreeId(Archetype archetype) {
    int id = firstFree;
    while (id < capacity && entities[id] != null) {
      id++;
    }
    firstFree = id;
    if (id == MAX_ENTITIES) {
      throw new IllegalStateException(
          "archetype=" + archetype + " can't be spawned: entities=" + id + " is the limit");
    }
    grow(id);
    return id;
  }

  private void grow(int id) {
    if (id >= entities.length) {
      int size = Math.min(MAX_ENTITIES, Math.max(id + 1, entities.length * 2));
      entities = Arrays.copyOf(entities, size);
      generations = Arrays.copyOf(generations, size);
    }
  }

  private HostEntity add(HostEntity entity, float x, float y, float angle, int tick) {
    createBody(entity, x, y, angle, tick);
    return register(entity, true);
  }

  private void createBody(HostEntity entity, float x, float y, float angle, int tick) {
    ScriptedMotion path = entity.archetype().motion();
    if (path == null) {
      createBody(entity, x, y, angle);
    } else {
      createBody(entity, path.x(tick, tickRate), path.y(tick, tickRate), angle);
    }
  }

  /** Creates the body. Players' bodies never sleep, because a game may act on them at any time. */
  private void createBody(HostEntity entity, float x, float y, float angle) {
    BodyDef body = entity.archetype().body(x, y, angle);
    body.sleepAllowed(entity.ownerId() == HostEntity.NO_OWNER);
    entity.body(world.createBody(body, entity));
  }

  private HostEntity register(HostEntity entity, boolean mayBeBody) {
    int id = entity.id();
    entities[id] = entity;
    noteChange();
    generations[id] = (byte) entity.generation();
    capacity = Math.max(capacity, id + 1);
    count++;
    HostPlayer owner = players.get(entity.ownerId());
    boolean isBody = mayBeBody && !assemblies.isPart(entity.archetype());
    if (isBody && owner != null && owner.body == null) {
      owner.body = entity;
    }
    areas.come(id, entity.body(), entity.archetype());
    return entity;
  }

  /** Destroys an entity that the table {@linkplain #holds holds}, and its body. */
  public void despawn(HostEntity entity) {
    int id = entity.id();
    areas.go(id);
    world.destroyBody(entity.body());
    noteChange();
    if (entity.origin() != Origin.NONE && players.get(entity.ownerId()) != null) {
      players.get(entity.ownerId()).removeSpawned(entity);
    }
    if (entity.isProvisional()) {
      provisional.remove(entity);
      return;
    }
    entities[id] = null;
    generations[id] = (byte) (entity.generation() + 1);
    count--;
    firstFree = Math.min(firstFree, id);
    HostPlayer owner = players.get(entity.ownerId());
    if (owner != null && owner.body == entity) {
      owner.body = null;
    }
  }

  /** Moves every body with a path to where it was a tick ago, with the velocity to where it is. */
  public void followPaths(int tick) {
    for (int i = 0; i < capacity; i++) {
      HostEntity e = entities[i];
      if (e == null || e.archetype().motion() == null) {
        continue;
      }
      e.archetype().motion().drive(e.body(), tick, tickRate);
    }
    for (int i = 0; i < provisional.count(); i++) {
      HostEntity e = provisional.at(i);
      if (e.archetype().motion() != null) {
        e.archetype().motion().drive(e.body(), tick, tickRate);
      }
    }
  }

  /** Mixes everything that decides the entities' future, except their bodies, into a state hash. */
  public long hash(long hash) {
    long h = hash;
    for (int i = 0; i < capacity; i++) {
      HostEntity e = entities[i];
      long identity = generations[i] & 0xff;
      if (e != null) {
        identity |= (long) (e.archetype().index() + 1) << 8 | (long) (e.ownerId() + 1) << 32;
        h = e.fieldValues().hash(h);
        h = SimRandom.mix(h, ((long) e.tag() << 32) | (e.bodySlot() & 0xffffffffL));
        h = e.rootId() == HostEntity.NO_ROOT ? h : SimRandom.mix(h, e.rootId());
        h = e.origin() == Origin.NONE ? h : SimRandom.mix(h, e.origin());
      }
      h = SimRandom.mix(h, identity);
    }
    return provisional.hash(h);
  }

  /** Copies the entities' state to a saved one. */
  public void save(SavedEntities s) {
    s.ensureRoom(Math.max(generations.length, capacity + provisional.count()));
    int end = capacity + provisional.count();
    Arrays.fill(s.entities, end, Math.max(end, s.capacity + s.provisionalCount), null);
    s.capacity = capacity;
    s.count = count;
    System.arraycopy(generations, 0, s.generations, 0, capacity);
    for (int i = 0; i < capacity; i++) {
      s.save(i, entities[i]);
    }
    provisional.save(s);
  }

  /** Takes the entities' state from a saved one. */
  public void restore(SavedEntities s) {
    int before = capacity;
    capacity = s.capacity;
    count = s.count;
    grow(capacity - 1);
    System.arraycopy(s.entities, 0, entities, 0, capacity);
    noteChange();
    areas.clear();
    Arrays.fill(entities, capacity, Math.max(before, capacity), null);
    System.arraycopy(s.generations, 0, generations, 0, capacity);
    Arrays.fill(generations, capacity, Math.max(before, capacity), (byte) 0);
    for (int i = 0; i < players.limit(); i++) {
      if (players.get(i) != null) {
        players.get(i).clearSpawned();
      }
    }
    for (int i = 0; i < capacity; i++) {
      if (entities[i] != null) {
        s.restore(i, entities[i]);
        addRestored(entities[i]);
      }
    }
    provisional.restore(s);
    for (int i = 0; i < provisional.count(); i++) {
      addRestored(provisional.at(i));
    }
    firstFree = 0;
  }

  private void addRestored(HostEntity entity) {
    areas.add(entity.id(), entity.body(), entity.archetype());
    HostPlayer owner = players.get(entity.ownerId());
    if (owner != null && entity.origin() != Origin.NONE) {
      entity.fieldValues().spawner(owner);
      owner.addSpawned(entity);
    }
  }
}
