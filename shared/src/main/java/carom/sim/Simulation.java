package carom.sim;

import carom.physics.Body;
import carom.physics.BodyDef;
import carom.physics.Collision;
import carom.physics.CollisionListener;
import carom.physics.Joint;
import carom.physics.JointDef;
import carom.physics.JointListener;
import carom.physics.Queries;
import carom.physics.QueryFilter;
import carom.physics.World;
import carom.physics.archive.ArchiveReader;
import carom.physics.math.Aabb;
import carom.sim.area.AreaForces;
import carom.sim.entity.Entity;
import carom.sim.entity.EntityTable;
import carom.sim.entity.Player;
import carom.sim.entity.PlayerTable;
import carom.sim.event.EventKind;
import carom.sim.event.EventKinds;
import carom.sim.event.NoticeQueue;
import carom.sim.field.EntityRef;
import carom.sim.field.FieldHolder;
import carom.sim.field.FieldStore;
import carom.sim.field.FieldUse;
import carom.sim.field.FieldValues;
import carom.sim.field.Schema;
import carom.sim.field.Scope;
import carom.sim.finding.Findings;
import carom.sim.history.PoseHistory;
import carom.sim.joint.Assemblies;
import carom.sim.joint.Assembly;
import carom.sim.joint.AssemblyDef;
import carom.sim.joint.JointTable;
import carom.sim.level.Archetype;
import carom.sim.level.ArchetypeDef;
import carom.sim.level.Archetypes;
import carom.sim.level.Level;
import carom.sim.level.LevelJoint;
import carom.sim.match.NextMatch;
import carom.sim.message.Message;
import carom.sim.message.MessageKind;
import carom.sim.message.MessageKinds;
import carom.sim.message.PlayerRole;
import carom.sim.message.WaitingMessages;
import carom.sim.pool.PoolDef;
import carom.sim.pool.Pools;
import carom.sim.random.SimRandom;
import carom.sim.ruling.ForceCheck;
import carom.sim.ruling.InterferenceLog;
import carom.sim.spawn.Origin;
import carom.sim.spawn.OwnSpawns;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.function.Consumer;

/**
 * A world, its entities and players, and the game that rules them. It is a pure function of (state,
 * inputs, tick): equal levels, seeds, tick rates and inputs give equal {@linkplain #stateHash state
 * hashes} on every machine.
 *
 * <p>Tick 0 is the state after set-up. {@link #step} computes the next tick in this order: paths of
 * kinematic bodies, players' {@linkplain Game#message messages}, {@link Game#beforeStep}, each
 * player's {@link Game#input} by player id, areas and {@link Game#forces} on each awake body, the
 * physics, {@link Game#afterStep}. While a step runs, {@link #tick} is the tick being computed.
 *
 * <p>A simulation belongs to one thread. A step allocates nothing of its own once arrays have
 * grown.
 *
 * <p><b>Length.</b> This is the one class that games call. More than half of it is documentation,
 * and its parts are classes of their own: {@link EntityTable}, {@link PlayerTable}, {@link
 * EventLog}, {@link NoticeQueue}, {@link InterferenceLog}, {@link PoseHistory} and {@link
 * SimState}.
 */
public final class Simulation extends FieldHolder<Entity, Player> {
  /** Most players at a time; ids are 0..1,023. */
  public static final int MAX_PLAYERS = PlayerTable.MAX_PLAYERS;

  /** Most entities at a time; ids are 0..65534. */
  public static final int MAX_ENTITIES = EntityTable.MAX_ENTITIES;

  /** Most notices that wait for {@link #drainNotices}. More are dropped and counted. */
  public static final int MAX_NOTICES = 16;

  /** Longest notice, in characters. The rest is cut off. */
  public static final int MAX_NOTICE_LENGTH = 120;

  /** Most events that wait for {@link #drainEvents}. Beyond, the oldest are dropped and counted. */
  public static final int MAX_EVENTS = 1 << 10;

  /**
   * Most messages that wait for {@link #drainMessages}. Beyond, new ones are dropped and counted.
   */
  public static final int MAX_MESSAGES = 1 << 10;

  private final Game game;
  private final Level level;
  private final int tickRate;
  private final float tickSeconds;
  private final Role role;
  private final CallRules calls;
  private final World<Entity> world;
  private final Archetypes archetypes = new Archetypes();
  private final SimRandom random;
  private final FieldStore fields;

  /** What notes how the game uses its fields; null on PREDICTION. */
  private final FieldUse fieldUse;

  private final FieldValues match;
  private final List<Entity> statics = new ArrayList<>();
  private final PlayerTable players;
  private final EntityTable entities;
  private final Findings findings = new Findings();
  private final JointTable<Entity> joints;
  private final Assemblies assemblies = new Assemblies(archetypes);
  private final ForceCheck forceCheck;
  private final InterferenceLog interference;
  private final NoticeQueue notices = new NoticeQueue(MAX_NOTICES, MAX_NOTICE_LENGTH);
  private final EventKinds eventKinds = new EventKinds();
  private final EventLog events = new EventLog();
  private final MessageKinds messageKinds = new MessageKinds();
  private final WaitingMessages received = new WaitingMessages();
  private final WaitingMessages.Reader handleMessage = this::handle;
  private final ArrayDeque<Delivery> sent = new ArrayDeque<>();
  private long droppedMessages;
  private final AreaForces<Entity> areas;
  private final Pools pools;
  private final Aabb moving = new Aabb();
  private final QueryFilter<Entity> geometry = (body, shape) -> body.user().isLevel();
  private final Consumer<Body<Entity>> forces = this::applyForces;

  private int tick;
  private boolean inTick;

  /** How many calls of {@link Game#join} and {@link Game#leave} are on the stack. */
  private int inGame;

  /** Who is becoming a spectator; null mostly. */
  private Player retiring;

  private Journal journal;
  private NextMatch nextMatch;

  /** What is known of the server's rules, on PREDICTION; may be null. */
  private Rulings rulings;

  /** What is known of the entities that the own player's input spawned, on PREDICTION. */
  private OwnSpawns ownSpawns;

  /** The player whose input runs, or null. */
  private Player inputOf;

  /** Number of spawns of that call. */
  private int spawnsOfInput;

  /** Past poses on AUTHORITY if the game looks back; otherwise null. */
  private final PoseHistory<Entity> history;

  private final Queries<Entity> past;

  /** The phases of the match, or null if the game has none. */
  private final MatchClock clock;

  /**
   * Builds the level and sets the game up. The simulation is then at tick 0.
   *
   * @param game an instance for this simulation alone, see {@link Game}
   * @param level the level to play
   * @param seed the seed of {@link #random}
   * @param tickRate steps per second, 1..1000
   * @param role whether it decides or predicts
   * @throws IllegalArgumentException when a number is out of range
   */
  public Simulation(Game game, Level level, long seed, int tickRate, Role role) {
    if (tickRate < 1 || tickRate > 1000) {
      throw new IllegalArgumentException("tickRate=" + tickRate + " is outside 1..1000");
    }
    this.game = game;
    this.level = level;
    this.tickRate = tickRate;
    tickSeconds = 1f / tickRate;
    this.role = role;
    calls = new CallRules(role);
    random = new SimRandom(seed);
    world = new World<>(game.world(level));
    world.listener(new Listener());
    areas =
        new AreaForces<>(
            world,
            level.areas(),
            (carrier, power) -> carrier.user().get(power),
            role == Role.AUTHORITY);
    Schema schema = schemaOf(game);
    joints = new JointTable<>(world, role == Role.AUTHORITY);
    entities =
        new EntityTable(
            world,
            areas,
            assemblies,
            joints,
            tickRate,
            schema,
            this::tick,
            calls::requireAuthority);
    players = entities.players();
    fields = entities.fields();
    match = fields.create(Scope.MATCH);
    fieldUse = role == Role.AUTHORITY ? fields.noteUse(findings, this::nameOf) : null;
    world.jointListener(new Joints());
    forceCheck = new ForceCheck(world, findings);
    interference = new InterferenceLog(entities, players, findings);
    history = role == Role.AUTHORITY && game.looksBack() ? newHistory() : null;
    past = history == null ? world.queries() : world.queries(history);
    for (ArchetypeDef def : level.archetypes()) {
      archetypes.add(def);
    }
    for (Level.Placement p : level.statics()) {
      statics.add(entities.createStatic(archetypes.get(p.archetype()), p));
    }
    if (role == Role.AUTHORITY) {
      for (Level.Placement p : level.bodies()) {
        spawn(archetypes.get(p.archetype()), p.x(), p.y(), p.angle(), null);
      }
    }
    if (role == Role.AUTHORITY) {
      connectLevel();
    }
    pools = new Pools(tickRate, role == Role.AUTHORITY);
    for (PoolDef def : level.pools()) {
      pools.add(def);
    }
    game.setUp(this);
    clock = game.clock();
    if (clock != null) {
      clock.setUp(this);
    }
    PoolGround.begin(pools, game, level, archetypes, tickRate);
    archetypes.close();
    entities.checkFields(archetypes);
    eventKinds.close();
    messageKinds.close();
    if (role == Role.PREDICTION) {
      fields.predict();
    }
    if (history != null) {
      history.capture(tick);
    }
  }

  /** Returns the schema of a game: its fields and those of its {@linkplain Game#clock clock}. */
  public static Schema schemaOf(Game game) {
    return Schema.of(MatchClock.fieldsOf(game));
  }

  /**
   * Sets the journal, which receives everything that enters from now on. It is not part of the
   * state.
   *
   * @param newJournal null for none
   */
  public void journal(Journal newJournal) {
    journal = newJournal;
  }

  /**
   * Sets what is known of the server's rules.
   *
   * @param known asked in every step from now on
   * @throws IllegalStateException on {@link Role#AUTHORITY}
   */
  public void rulings(Rulings known) {
    calls.requirePrediction("rulings");
    rulings = known;
  }

  /**
   * Sets what is known of the entities that the own player's {@link Game#input} spawns. Without it,
   * they live until the end of the call.
   *
   * @throws IllegalStateException on {@link Role#AUTHORITY}
   */
  public void ownSpawns(OwnSpawns known) {
    calls.requirePrediction("ownSpawns");
    ownSpawns = known;
  }

  /** Returns the physics world. */
  public World<Entity> world() {
    return world;
  }

  /**
   * Returns queries about the world as a player saw it when it gave the input for this tick. Each
   * body is where that player's screen showed it, {@link Player#viewDelay} ago, at most a quarter
   * of a second. Bodies that came or went since then are not found. The player's own body was on
   * its screen where it is now, so leave it out by a filter. On {@link Role#PREDICTION} the queries
   * are about the predicted world.
   *
   * @param player the player who saw it
   * @return valid until the next call; allocates nothing
   * @throws IllegalStateException on {@link Role#AUTHORITY}, when {@link Game#looksBack} is false
   */
  public Queries<Entity> asSeenBy(Player player) {
    calls.requireOutsideForces("asSeenBy");
    if (history != null) {
      history.look(tick, player.viewDelay());
    } else if (role == Role.AUTHORITY) {
      throw new IllegalStateException(
          "game " + game.name() + " doesn't look back; make Game.looksBack return true");
    }
    return past;
  }

  /** Returns the tick of the present state, or during a step the tick being computed. */
  public int tick() {
    return tick;
  }

  /**
   * Sets the tick of the mirrored state, so that paths of kinematic bodies and timers agree with
   * the server's.
   *
   * @throws IllegalStateException on {@link Role#AUTHORITY}
   */
  public void tick(int value) {
    calls.requirePrediction("tick");
    tick = value;
  }

  /** Returns the number of steps per second. */
  public int tickRate() {
    return tickRate;
  }

  /** Returns the time from tick to tick, in seconds. */
  public float tickSeconds() {
    return tickSeconds;
  }

  /** Returns a time in ticks, rounded, and at least 1. */
  public int ticks(float seconds) {
    return Math.max(1, Math.round(seconds * tickRate));
  }

  /** Returns whether the simulation decides or predicts. */
  public Role role() {
    return role;
  }

  /** Returns the level that is played. */
  public Level level() {
    return level;
  }

  /** Returns the rules. */
  public Game game() {
    return game;
  }

  /** Returns the random numbers, which only {@link Role#AUTHORITY} may draw. */
  public SimRandom random() {
    calls.requireOutsideForces("random");
    return random;
  }

  /**
   * Returns the fields that the game declares. {@link #get}, {@link #set} and {@link #add} of this
   * class are for those of the match.
   */
  public Schema schema() {
    return fields.schema();
  }

  /** Returns the values of the match's fields. */
  @Override
  public FieldValues fieldValues() {
    return match;
  }

  /** Returns a number that grows with each change of a field in a scope. */
  public long fieldChanges(Scope scope) {
    return fields.changes(scope);
  }

  /** Returns the registered archetypes. */
  public Archetypes archetypes() {
    return archetypes;
  }

  /** Returns the registered assemblies: groups of bodies and joints, such as cars. */
  public Assemblies assemblies() {
    return assemblies;
  }

  /** Returns the registered kinds of events. */
  public EventKinds eventKinds() {
    return eventKinds;
  }

  /** Returns the registered kinds of messages, the built-in ones first. */
  public MessageKinds messageKinds() {
    return messageKinds;
  }

  /** Returns the static geometry of the level, in file order; unmodifiable. */
  public List<Entity> statics() {
    return Collections.unmodifiableList(statics);
  }

  /**
   * Creates an entity under the smallest free id. An entity owned by a player without a body
   * becomes the player's body.
   *
   * <p>{@link Game#input} may call it on both roles for what belongs to its player, and give the
   * new entity a velocity and fields. That player's client has it at once, as a {@linkplain
   * Entity#isProvisional provisional} one, and it becomes the server's or goes when the server's
   * word is there. What the input of others spawns, a client keeps until the end of the call only.
   * {@link Player#spawned} finds it again.
   *
   * @param archetype its archetype
   * @param x position of the body's origin, metres
   * @param y position of the body's origin, metres
   * @param angle radians, counterclockwise
   * @param owner the player it belongs to, or null; in {@link Game#input} its player
   * @throws IllegalStateException during the physics, beyond {@value #MAX_ENTITIES}, in {@link
   *     Game#input} beyond {@value Origin#MOST_PER_CALL} in a call, and on {@link Role#PREDICTION}
   *     anywhere else
   * @throws IllegalArgumentException in {@link Game#input}, if the owner isn't its player
   */
  public Entity spawn(Archetype archetype, float x, float y, float angle, Player owner) {
    if (inputOf != null) {
      return spawnInInput(archetype, x, y, angle, owner);
    }
    calls.requireAuthority("spawn");
    int ownerId = owner == null ? Entity.NO_OWNER : owner.id();
    return entities.spawn(archetype, x, y, angle, ownerId, tick);
  }

  private Entity spawnInInput(Archetype archetype, float x, float y, float angle, Player owner) {
    if (owner != inputOf) {
      throw new IllegalArgumentException(
          "owner="
              + owner
              + " isn't the player whose Game.input runs, "
              + inputOf
              + "; spawn what belongs to others in Game.beforeStep or Game.afterStep");
    }
    if (spawnsOfInput == Origin.MOST_PER_CALL) {
      throw new IllegalStateException(
          "spawns=" + spawnsOfInput + " is the most that one call of Game.input may make");
    }
    int id = owner.id();
    int origin = Origin.of(tick, spawnsOfInput++);
    Entity entity;
    if (role == Role.AUTHORITY) {
      entity = entities.spawn(archetype, x, y, angle, id, tick);
    } else {
      int key = ownSpawns == null ? OwnSpawns.UNKNOWN : ownSpawns.key(origin);
      Entity known = key < 0 ? null : entities.get(key & 0xffff);
      if (known != null && known.generation() == key >>> 16) {
        despawn(known); // the tick is computed again
        known = null;
      }
      entity =
          key < 0 || known != null
              ? entities.spawnProvisional(origin, archetype, x, y, angle, id, tick)
              : entities.spawnAs(key & 0xffff, key >>> 16, archetype, x, y, angle, id, false, tick);
    }
    entity.fieldValues().spawner(owner);
    entities.setOrigin(entity, origin);
    return entity;
  }

  /** Removes what an input spawned that isn't the own player's. */
  private void endInput(Player player) {
    boolean foreseen = ownSpawns != null && ownSpawns.foresees(player.id());
    for (int i = entities.provisional().count() - 1; i >= 0 && !foreseen; i--) {
      if (entities.provisional().at(i).ownerId() == player.id()) {
        entities.despawn(entities.provisional().at(i));
      }
    }
  }

  /**
   * Returns the number of {@linkplain Entity#isProvisional provisional} entities; 0 on {@link
   * Role#AUTHORITY}. They aren't below {@link #entityCapacity}.
   */
  public int provisionalCount() {
    return entities.provisional().count();
  }

  /** Returns a provisional entity, in the order in which they were spawned. */
  public Entity provisional(int index) {
    return entities.provisional().at(index);
  }

  /**
   * Mirrors which spawn of its owner's {@link Game#input} an entity of the server is. A provisional
   * entity of that origin goes, and fields that mean it mean this one.
   *
   * @param entity an entity that isn't provisional
   * @param origin see {@link Entity#origin}; nothing happens if it is none
   * @throws IllegalStateException on {@link Role#AUTHORITY}
   */
  public void identify(Entity entity, int origin) {
    calls.requirePrediction("identify");
    if (origin == Origin.NONE) {
      return;
    }
    if (entities.get(origin) != null) {
      entities.despawn(entities.get(origin));
    }
    replaceReferences(EntityRef.word(origin, 0), EntityRef.word(entity.id(), entity.generation()));
    entity.fieldValues().spawner(owner(entity));
    entities.setOrigin(entity, origin);
  }

  private void replaceReferences(int word, int by) {
    match.replaceEntity(word, by);
    for (int i = 0; i < players.limit(); i++) {
      if (players.get(i) != null) {
        players.get(i).fieldValues().replaceEntity(word, by);
      }
    }
    for (int i = 0; i < entities.capacity(); i++) {
      if (entities.get(i) != null) {
        entities.get(i).fieldValues().replaceEntity(word, by);
      }
    }
  }

  /**
   * Creates an entity without an owner under the smallest free id. Its body may have more than the
   * archetype says: filters, velocities, a bullet. Clients that predict it know the archetype only.
   *
   * @param archetype its archetype, with the same shapes; its path is ignored
   * @param def the definition of the body
   * @throws IllegalStateException on {@link Role#PREDICTION}, in {@link Game#input}, during the
   *     physics, or beyond {@value #MAX_ENTITIES}
   */
  public Entity spawn(Archetype archetype, BodyDef def) {
    calls.requireOutsideInput("spawn(archetype, def)");
    calls.requireAuthority("spawn");
    return entities.spawn(archetype, def);
  }

  /**
   * Creates the bodies of an assembly as entities, and its joints. All belong to one owner. If that
   * is a player without a body, the root becomes the player's body.
   *
   * @param assembly what to make
   * @param x where the assembly's origin is, metres
   * @param y where the assembly's origin is, metres
   * @param angle of the whole assembly, radians, counterclockwise
   * @param owner the player it belongs to, or null
   * @return the root
   * @throws IllegalStateException on {@link Role#PREDICTION}, in {@link Game#input}, during the
   *     physics, or beyond {@value #MAX_ENTITIES}
   */
  public Entity spawn(Assembly assembly, float x, float y, float angle, Player owner) {
    calls.requireOutsideInput("spawn(assembly, ...)");
    calls.requireAuthority("spawn");
    int ownerId = owner == null ? Entity.NO_OWNER : owner.id();
    return entities.spawn(assembly, x, y, angle, ownerId, tick);
  }

  /**
   * Creates a joint between bodies of the world. Clients mirror and predict it. It goes with either
   * of its bodies, by {@link #disconnect}, or when it breaks.
   *
   * @return the joint, whose motor, limits, spring and target may be changed at any time; those
   *     that {@link Game#input} changes are predicted
   * @throws IllegalStateException on {@link Role#PREDICTION}, during the physics, or beyond {@value
   *     JointTable#MAX_JOINTS} joints
   */
  public Joint<Entity> connect(JointDef<Entity> def) {
    calls.requireAuthority("connect");
    return world.createJoint(def);
  }

  /**
   * Destroys a joint. Nothing happens if it is gone already.
   *
   * @throws IllegalStateException on {@link Role#PREDICTION} or during the physics
   */
  public void disconnect(Joint<Entity> joint) {
    calls.requireAuthority("disconnect");
    if (joint.isValid()) {
      world.destroyJoint(joint);
    }
  }

  /** Makes the level's joints, which so get the first indices in file order. */
  private void connectLevel() {
    for (int i = 0; i < level.joints().size(); i++) {
      LevelJoint joint = level.joints().get(i);
      Body<Entity> a = levelBody(joint.a());
      joints.create(0, JointTable.LEVEL, i, a, levelBody(joint.b()), joint.definition(), 0);
    }
  }

  private Body<Entity> levelBody(int end) {
    if (end == LevelJoint.GROUND) {
      return null;
    }
    return (end < 0 ? statics.get(~end) : entities.get(end)).body();
  }

  /**
   * Returns a joint of the level by its name; both roles.
   *
   * @return null if it broke or was destroyed, or if this client doesn't simulate it
   * @throws IllegalArgumentException if the level has no joint of that name
   */
  public Joint<Entity> joint(String name) {
    for (int i = 0; i < level.joints().size(); i++) {
      if (level.joints().get(i).name().equals(name)) {
        return joints.find(JointTable.LEVEL, i);
      }
    }
    throw new IllegalArgumentException(
        "level=" + level.name() + " has no joint with \"name\": \"" + name + "\"");
  }

  /**
   * Returns a joint of an assembly by its name; both roles.
   *
   * @param member any entity of the assembly
   * @param name as the {@link AssemblyDef} gives it
   * @return null if it broke or was destroyed, or if this client doesn't simulate it
   * @throws IllegalArgumentException if the assembly has no joint of that name; the message lists
   *     the names
   */
  public Joint<Entity> joint(Entity member, String name) {
    Entity root = member.root();
    return joints.find(root.id(), assembly(root).joint(name));
  }

  /**
   * Returns a body of an assembly by its name; both roles. Clients know the members by their joints
   * and find none whose joints are all gone.
   *
   * @param member any entity of the assembly
   * @param name as the {@link AssemblyDef} gives it
   * @return null if it was despawned, or if this client doesn't know it
   * @throws IllegalArgumentException if the assembly has no body of that name; the message lists
   *     the names
   */
  public Entity part(Entity member, String name) {
    Entity root = member.root();
    Assembly assembly = assembly(root);
    Archetype archetype = assembly.archetypes().get(assembly.body(name));
    for (int i = 0; i < entities.capacity(); i++) {
      Entity e = entities.get(i);
      if (e != null && e.root() == root && e.archetype() == archetype) {
        return e;
      }
    }
    return null;
  }

  private Assembly assembly(Entity root) {
    Assembly assembly = assemblies.of(root.archetype());
    if (assembly == null) {
      throw new IllegalArgumentException(
          root + " is no assembly; spawn it by spawn(Assembly, ...)");
    }
    return assembly;
  }

  /** Returns what is known of the joints beyond the physics: keys, definitions, assemblies. */
  public JointTable<Entity> joints() {
    return joints;
  }

  /**
   * Mirrors a joint of the server. Joints must be mirrored in ascending order of their keys.
   *
   * @param key as the server's {@link JointTable} has it
   * @param root id of the root of its assembly, or as {@link JointTable#root} says
   * @param number which joint of it
   * @param a null for the world
   * @param b another entity
   * @param definition what it is made with, see {@link World#createJoint(Body, Body, int[], int)}
   * @param at where that begins
   * @throws IllegalStateException on {@link Role#AUTHORITY}
   * @throws IllegalArgumentException if the definition is damaged; no joint is made then
   */
  public Joint<Entity> connectAs(
      int key, int root, int number, Entity a, Entity b, int[] definition, int at) {
    calls.requirePrediction("connectAs");
    Joint<Entity> joint =
        joints.create(key, root, number, a == null ? null : a.body(), b.body(), definition, at);
    if (root >= 0) {
      if (a != null) {
        entities.join(root, a);
      }
      entities.join(root, b);
    }
    return joint;
  }

  /**
   * Mirrors an entity of the server under the server's id. An entity under that id with another
   * generation or archetype must be despawned before. If the owner is a player here and has no
   * body, this becomes the body.
   *
   * @param id 0..65534
   * @param generation 0..255
   * @param archetype its archetype
   * @param x position of the body's origin, metres
   * @param y position of the body's origin, metres
   * @param angle radians, counterclockwise
   * @param ownerId a player's id, whether the player is known here or not, or {@link
   *     Entity#NO_OWNER}
   * @throws IllegalStateException on {@link Role#AUTHORITY}, or when the id is taken
   * @throws IllegalArgumentException when the id or generation is out of range
   */
  public Entity spawnAs(
      int id, int generation, Archetype archetype, float x, float y, float angle, int ownerId) {
    return spawnAs(id, generation, archetype, x, y, angle, ownerId, true);
  }

  /**
   * Mirrors an entity of the server as the other {@code spawnAs}.
   *
   * @param mayBeBody whether it becomes the body of its owner if that has none
   */
  public Entity spawnAs(
      int id,
      int generation,
      Archetype archetype,
      float x,
      float y,
      float angle,
      int ownerId,
      boolean mayBeBody) {
    calls.requirePrediction("spawnAs");
    return entities.spawnAs(id, generation, archetype, x, y, angle, ownerId, mayBeBody, tick);
  }

  /**
   * Destroys an entity with its joints, and with the root of an assembly all of it. If it was a
   * player's body, the player then has none. Nothing happens when the entity is gone already.
   *
   * <p>{@link Game#input} may call it on both roles. A client foresees it for what belongs to the
   * player and isn't its body. All else stays there until the server's word.
   *
   * @throws IllegalStateException during the physics
   */
  public void despawn(Entity entity) {
    calls.requireOutsidePhysics("despawn");
    if (!entities.holds(entity) || (inputOf != null && !mayDespawn(entity))) {
      return;
    }
    if (history != null) {
      history.forget(entity.bodySlot());
    }
    if (entity.isRoot()) {
      for (int i = 0; i < entities.capacity(); i++) {
        Entity member = entities.get(i);
        if (member != null && member != entity && member.root() == entity) {
          despawn(member);
        }
      }
    }
    entities.despawn(entity);
  }

  /** Returns whether a server, or a client that foresees it, despawns an entity in an input. */
  private boolean mayDespawn(Entity entity) {
    boolean isOwn = entity.ownerId() == inputOf.id() && entity != inputOf.body();
    return role == Role.AUTHORITY || isOwn;
  }

  /** Returns a number above all entity ids. It never shrinks, except by {@link #restore}. */
  public int entityCapacity() {
    return entities.capacity();
  }

  /**
   * Returns a number that changes whenever an entity may have come, gone or been teleported, and
   * when the state is restored. While it stays the same, ids, archetypes and owners stay the same
   * too; tags may change.
   *
   * @return meaningful only compared with an earlier one of this simulation; not part of the state
   */
  public long rosterVersion() {
    return entities.version();
  }

  EntityTable entities() {
    return entities;
  }

  /** Returns the number of entities. */
  public int entityCount() {
    return entities.count();
  }

  /** Returns the entity under an id, or null when the id is free or out of range. */
  public Entity entity(int id) {
    calls.requireOutsideForces("entity");
    return entities.get(id);
  }

  /** Returns a number above all ids of players and spectators. */
  public int playerCapacity() {
    return players.limit();
  }

  /**
   * Returns the player under an id, or null when the id is free, out of range or that of a
   * spectator.
   */
  public Player player(int id) {
    calls.requireOutsideForces("player");
    return players.get(id);
  }

  /**
   * Returns the player or spectator under an id, or null when the id is free or out of range. Games
   * ask for {@link #player} instead.
   */
  public Player participant(int id) {
    calls.requireOutsideForces("participant");
    return players.participant(id);
  }

  /** Returns the number of players, without spectators. */
  public int playerCount() {
    return players.count();
  }

  /** Returns the number of players in a team, without spectators. */
  public int teamSize(int team) {
    return players.teamSize(team);
  }

  /** Returns whether there are players, and all of them are {@linkplain Player#isReady ready}. */
  public boolean allReady() {
    return players.allReady();
  }

  /** Returns the player that owns an entity, or null. */
  public Player owner(Entity entity) {
    return players.get(entity.ownerId());
  }

  /**
   * Adds a player under the smallest free id. The game gives it a body. If {@link Game#maxPlayers}
   * play already, it watches instead, and the game doesn't hear of it.
   *
   * @throws IllegalStateException on {@link Role#PREDICTION}, or when {@value #MAX_PLAYERS} players
   *     play
   */
  public Player join(String name) {
    int id = players.freeId();
    if (id == MAX_PLAYERS) {
      throw new IllegalStateException("players=" + id + " is the limit; " + name + " can't join");
    }
    return join(id, name);
  }

  /**
   * Adds a player under an id that was promised to it, as {@link #join(String)} does.
   *
   * @param id 0..1,023
   * @param name any text
   * @throws IllegalStateException on {@link Role#PREDICTION}, or when the id is taken or out of
   *     range
   */
  public Player join(int id, String name) {
    return join(id, name, 0, 0);
  }

  /**
   * Adds a player who brings a team and a score from the match before. {@link Game#join} finds them
   * set.
   *
   * @throws IllegalStateException as {@link #join(int, String)}
   */
  public Player join(int id, String name, int team, int score) {
    calls.requireAuthority("join");
    requireFree(id);
    if (journal != null) {
      if (team != 0 || score != 0) {
        throw new IllegalStateException(
            "a journal can't tell what " + name + " brings: team=" + team + " score=" + score);
      }
      journal.joining(this, id, name);
    }
    boolean full = players.count() >= game.maxPlayers();
    Player player = players.add(id, name);
    if (full) {
      players.become(player, PlayerRole.SPECTATOR);
      Talk.tell(this, player, Talk.refusalWhenFull(this));
      return player;
    }
    player.team(team);
    player.score(score);
    enter(player);
    return player;
  }

  /**
   * Adds a spectator under an id that was promised to it. {@link Game#join} isn't called.
   *
   * @throws IllegalStateException as {@link #join(int, String)}
   */
  public Player joinAsSpectator(int id, String name) {
    calls.requireAuthority("joinAsSpectator");
    requireFree(id);
    if (journal != null) {
      journal.watching(this, id, name);
    }
    Player player = players.add(id, name);
    players.become(player, PlayerRole.SPECTATOR);
    return player;
  }

  /**
   * Makes a player a spectator, or a spectator a player. For the game a player who becomes a
   * spectator leaves: {@link Game#leave} is called, everything the player owns is despawned, and
   * its fields, score and team are gone. A spectator who becomes a player joins: {@link Game#join}
   * is called. Id, name and link stay. Nothing happens when the participant has the role already,
   * or has left.
   *
   * @throws IllegalStateException on {@link Role#PREDICTION}, during the physics, or in {@link
   *     Game#leave} for the player who leaves
   */
  public void role(Player participant, PlayerRole role) {
    calls.requireAuthority("role");
    if (participant == retiring) {
      throw new IllegalStateException("the role of " + participant + " can't change in Game.leave");
    }
    if (players.participant(participant.id()) != participant || participant.role() == role) {
      return;
    }
    if (journal != null && !inTick && inGame == 0) {
      journal.changing(this, participant.id(), role);
    }
    if (role == PlayerRole.PLAYER) {
      players.become(participant, role);
      enter(participant);
    } else {
      retiring = participant;
      try {
        retire(participant);
      } finally {
        retiring = null;
      }
      players.become(participant, role);
      forget(participant.id());
    }
  }

  /** Lets a player into the game. */
  private void enter(Player player) {
    interference.beginRules();
    inGame++;
    try {
      game.join(this, player);
    } finally {
      inGame--;
    }
  }

  /** Takes a player out of the game, with everything the player owns. */
  private void retire(Player player) {
    interference.beginRules();
    inGame++;
    try {
      game.leave(this, player);
    } finally {
      inGame--;
    }
    for (int i = 0; i < entities.capacity(); i++) {
      Entity entity = entities.get(i);
      if (entity != null && entity.ownerId() == player.id()) {
        despawn(entity);
      }
    }
  }

  /**
   * Mirrors a player of the server, usually the client's own. The body follows by {@link #spawnAs}.
   *
   * @param id 0..1,023, as the server says
   * @param name its name
   * @throws IllegalStateException on {@link Role#AUTHORITY}, or when the id is taken
   */
  public Player joinAs(int id, String name) {
    calls.requirePrediction("joinAs");
    requireFree(id);
    return players.add(id, name);
  }

  /**
   * Removes a player or spectator and despawns everything the player owns. Nothing happens when it
   * is gone already.
   */
  public void leave(Player player) {
    calls.requireOutsidePhysics("leave");
    int id = player.id();
    if (players.participant(id) != player) {
      return;
    }
    received.forget(id);
    if (journal != null) {
      journal.leaving(this, id);
    }
    if (role == Role.AUTHORITY && !player.isSpectator()) {
      retire(player);
    }
    players.remove(id);
    forget(id);
  }

  /** Sets all fields that mean a player who left to null. */
  private void forget(int playerId) {
    match.forget(playerId);
    for (int i = 0; i < players.limit(); i++) {
      if (players.participant(i) != null) {
        players.participant(i).fieldValues().forget(playerId);
      }
    }
    for (int i = 0; i < entities.capacity(); i++) {
      if (entities.get(i) != null) {
        entities.get(i).fieldValues().forget(playerId);
      }
    }
  }

  /**
   * Asks the room to play something else after this tick: another level, or another game. It loads
   * while this match goes on, which takes some ticks, and then begins at tick 0 with the same
   * players. If it can't be played, this match goes on. Of several wishes in a tick the last
   * counts, and while one loads, further ones are ignored. It is not part of the state; without a
   * room, and on {@link Role#PREDICTION}, nothing happens.
   */
  public void playNext(NextMatch next) {
    if (role == Role.AUTHORITY) {
      nextMatch = next;
    }
  }

  /**
   * Says that the match is over: the room goes on with the next level of its rotation. In a room
   * without a rotation nothing happens, so the game should begin again by itself.
   */
  public void matchOver() {
    playNext(NextMatch.OF_ROTATION);
  }

  /** Returns what the game wants to be played next, and forgets it; null for nothing. */
  public NextMatch takeNextMatch() {
    NextMatch taken = nextMatch;
    nextMatch = null;
    return taken;
  }

  /**
   * Sends a short text to all players, such as who scored. It is not part of the state. On {@link
   * Role#PREDICTION} nothing happens.
   *
   * @param text cut to {@value #MAX_NOTICE_LENGTH} characters
   */
  public void notice(String text) {
    if (role == Role.AUTHORITY) {
      notices.add(text);
    }
  }

  /** Passes on the notices since the last call, oldest first, and forgets them. */
  public void drainNotices(Consumer<String> consumer) {
    notices.drain(consumer);
  }

  /** Returns the number of notices that were lost because {@value #MAX_NOTICES} waited. */
  public long droppedNotices() {
    return notices.dropped();
  }

  /**
   * Emits an event. Any method of {@link Game} may call it, {@code input} and {@code hit} of both
   * roles included; between two steps it belongs to the next one. It changes nothing that is hashed
   * or saved. A client's prediction emits an event again when it computes a tick again; its
   * listeners receive the event once.
   *
   * @param kind as registered in {@link Game#setUp}
   * @return the event to fill in; reused once it was {@linkplain #drainEvents drained}
   */
  public Event emit(EventKind kind) {
    return events.add(kind, inTick ? tick : tick + 1);
  }

  /** Passes on the events since the last call in the order they were emitted, and forgets them. */
  public void drainEvents(Consumer<Event> consumer) {
    events.drain(consumer);
  }

  /** Returns the number of events that were lost because {@value #MAX_EVENTS} waited. */
  public long droppedEvents() {
    return events.dropped();
  }

  /**
   * Hands over a message of a player, which {@link Game#message} receives in the next step. Of a
   * spectator the game receives none but chat. It is an input of that step: {@link #restore} drops
   * what waits.
   *
   * @param player who sent it
   * @param message a message that a client may send, of a registered kind
   * @return false when {@value WaitingMessages#MAX_PER_PLAYER} of the player wait; this one is
   *     dropped
   * @throws IllegalStateException on {@link Role#PREDICTION}
   * @throws IllegalArgumentException when the kind isn't registered, or clients don't send it
   */
  public boolean receive(Player player, Message message) {
    calls.requireAuthority("receive");
    messageKinds.indexOf(message.kind(), MessageKind.Direction.FROM_CLIENT);
    return received.add(player.id(), message);
  }

  /** Passes on the messages that the next step will handle, in that order, and keeps them. */
  public void forEachReceived(WaitingMessages.Reader reader) {
    received.forEach(reader);
  }

  /**
   * Sends a message to clients: {@code s.send(SOLD.of(3)).to(player)}. It is not part of the state.
   * On {@link Role#PREDICTION} nothing is sent.
   *
   * @param message of a kind that {@link Game#setUp} registered
   * @return what names the recipients
   * @throws IllegalArgumentException when the kind isn't registered, or clients send it
   */
  public Delivery send(Message message) {
    messageKinds.indexOf(message.kind(), MessageKind.Direction.FROM_SERVER);
    Delivery delivery = new Delivery(message);
    if (role == Role.AUTHORITY && sent.size() < MAX_MESSAGES) {
      sent.add(delivery);
    } else if (role == Role.AUTHORITY) {
      droppedMessages++;
    }
    return delivery;
  }

  /** Passes on the messages sent since the last call, oldest first, and forgets them. */
  public void drainMessages(Consumer<Delivery> consumer) {
    while (!sent.isEmpty()) {
      consumer.accept(sent.remove());
    }
  }

  /** Returns the number of messages that were lost because {@value #MAX_MESSAGES} waited. */
  public long droppedMessages() {
    return droppedMessages;
  }

  /**
   * Computes the next tick from each player's {@link Player#input} and {@link Player#viewDelay}.
   */
  public void step() {
    if (journal != null) {
      journal.stepping(this);
    }
    tick++;
    inTick = true;
    try {
      computeTick();
    } finally {
      inTick = false;
      fields.end();
    }
    if (history != null) {
      history.capture(tick);
    }
    if (journal != null) {
      journal.stepped(this);
    }
  }

  private void computeTick() {
    entities.followPaths(tick);
    if (role == Role.AUTHORITY) {
      interference.beginRules();
      during("message");
      received.forEach(handleMessage);
      received.clear();
      during("beforeStep");
      if (clock != null) {
        clock.beforeStep(this);
      }
      game.beforeStep(this);
      interference.endRulesBeforeStep(tick);
    } else if (rulings != null) {
      rulings.beforeStep(this);
    }
    for (int i = 0; i < players.limit(); i++) {
      Player player = players.get(i);
      if (player != null && player.isAlive()) {
        takeInput(player);
      }
    }
    fields.end();
    applyForces();
    during("hit");
    calls.inPhysics(true);
    try {
      world.step(tickSeconds);
    } finally {
      calls.inPhysics(false);
    }
    if (role == Role.AUTHORITY) {
      interference.beginRules();
      during("afterStep");
      game.afterStep(this);
      during("a callback between two steps");
      interference.endRulesAfterStep(tick);
    } else if (rulings != null) {
      rulings.afterStep(this);
    }
  }

  private void takeInput(Player player) {
    fields.beginInput(player, player.fieldValues(), player.body().fieldValues());
    calls.inInput(true);
    inputOf = player;
    spawnsOfInput = 0;
    try {
      game.input(this, player, player.input());
    } finally {
      inputOf = null;
      calls.inInput(false);
    }
    if (role == Role.PREDICTION) {
      endInput(player);
    }
  }

  private void handle(int playerId, Message message) {
    Player player = players.participant(playerId);
    if (player != null) { // one handled before may have removed it
      Talk.handle(this, player, message);
    }
  }

  private void during(String callback) {
    if (fieldUse != null) {
      fieldUse.during(callback);
    }
  }

  /** Names what has values: a player, an entity or the match. */
  private String nameOf(FieldValues values) {
    for (int i = 0; i < players.limit(); i++) {
      if (players.get(i) != null && players.get(i).fieldValues() == values) {
        return "player " + i;
      }
    }
    for (int i = 0; i < entities.capacity(); i++) {
      if (entities.get(i) != null && entities.get(i).fieldValues() == values) {
        return "entity " + i;
      }
    }
    return values == match ? "the match" : "a player or entity that is gone";
  }

  /** Lets areas, pools and the game's forces act on each awake body. */
  private void applyForces() {
    areas.begin();
    if (role == Role.AUTHORITY) {
      pools.step(tick);
    }
    for (int i = 0; i < pools.count(); i++) {
      if (pools.readMoving(i, tick, moving)) {
        areas.wake(moving);
      }
    }
    forceCheck.beginTick(role == Role.AUTHORITY ? tick : 1);
    calls.inForces(true);
    fields.beginForces();
    world.queryScope(geometry);
    try {
      world.forEachAwake(forces);
    } finally {
      world.queryScope(null);
      fields.end();
      calls.inForces(false);
    }
    if (role == Role.AUTHORITY) {
      pools.close();
    }
  }

  private void applyForces(Body<Entity> body) {
    Entity entity = body.user();
    Archetype kind = entity.archetype();
    areas.act(body, kind, tickSeconds);
    if (!kind.sensor()) {
      pools.act(world, body, tick, kind.index(), kind.shapes(), kind.reach());
    }
    forceCheck.begin(body);
    game.forces(this, entity);
    forceCheck.end(body, tick);
  }

  /** Returns the areas of the level and those that entities carry. For reading only. */
  public AreaForces<Entity> areas() {
    return areas;
  }

  /**
   * Returns the water and sand of the level, and what the game adds in {@link Game#setUp}. On
   * {@link Role#PREDICTION} the client moves them on.
   */
  public Pools pools() {
    return pools;
  }

  /** Returns the log of what the game did to bodies; filled on {@link Role#AUTHORITY} only. */
  public InterferenceLog interference() {
    return interference;
  }

  /**
   * Returns what the game does again and again although no client can foresee it, with advice.
   * Filled on {@link Role#AUTHORITY} only, and only about what clients predict; no part of the
   * state.
   */
  public Findings findings() {
    return findings;
  }

  /**
   * Returns 64 bits of everything that decides the future: tick, world, random numbers, fields,
   * players with score, team, role and input, entities with archetype, owner and tag. Equal runs
   * have equal hashes.
   */
  public long stateHash() {
    long h = SimRandom.mix(world.stateHash(), tick);
    h = SimRandom.mix(h, random.state());
    h = pools.count() == 0 ? h : SimRandom.mix(h, pools.stateHash());
    return joints.hash(entities.hash(players.hash(match.hash(h))));
  }

  /**
   * Saves everything that {@link #stateHash} covers, and the handles.
   *
   * @param reuse a state of this simulation to overwrite, or null for a new one
   * @return the saved state
   */
  public SimState save(SimState reuse) {
    SimState s = reuse == null ? new SimState(this) : reuse;
    requireOwn(s);
    s.world = world.save(s.world);
    s.tick = tick;
    s.random = random.state();
    s.fields.save(match, 0);
    players.save(s.players);
    entities.save(s.entities);
    joints.save(s.joints);
    if (role == Role.AUTHORITY && pools.count() > 0) {
      s.pools = pools.save(s.pools);
    }
    s.saveHistory(history);
    return s;
  }

  /**
   * Returns to a saved state. The ticks that follow are the same, bit by bit. Entities and players
   * that have gone since are back under their old handles; those that came since are gone.
   *
   * @throws IllegalArgumentException when another simulation made the state
   */
  public void restore(SimState s) {
    requireOwn(s);
    calls.requireOutsidePhysics("restore");
    world.restore(s.world);
    received.clear();
    tick = s.tick;
    random.state(s.random);
    s.fields.restore(match, 0);
    players.restore(s.players);
    entities.restore(s.entities);
    joints.restore(s.joints);
    if (s.pools != null) {
      pools.restore(s.pools);
    }
    if (history != null) {
      s.history.copyTo(history);
    }
  }

  /**
   * Reads a state that {@link SimState#write} has written, of the same level, game and tick rate.
   * {@link #restore} takes it over; until then this simulation is not touched. Entities and players
   * that exist here already keep their objects. The bytes are not trusted, see {@link World#read}.
   *
   * @param archive read to its end
   * @return the state, of this simulation
   * @throws carom.physics.archive.ArchiveException if the bytes are damaged or belong elsewhere
   */
  public SimState read(ArchiveReader archive) {
    return SimState.read(this, archive);
  }

  /** Creates an empty history of this simulation's bodies. */
  PoseHistory<Entity> newHistory() {
    return new PoseHistory<>(world, entities, tickRate);
  }

  /** Returns whether past poses are remembered. */
  boolean looksBack() {
    return history != null;
  }

  private void requireFree(int playerId) {
    if (playerId < 0 || playerId >= MAX_PLAYERS || players.participant(playerId) != null) {
      throw new IllegalStateException(
          "player id=" + playerId + " is taken or outside 0.." + (MAX_PLAYERS - 1));
    }
  }

  private void requireOwn(SimState s) {
    if (s.owner != this) {
      throw new IllegalArgumentException("the state belongs to another simulation");
    }
  }

  private final class Listener implements CollisionListener<Entity> {
    @Override
    public boolean preSolve(Collision<Entity> c) {
      fields.beginCollision();
      boolean responds = game.collision(Simulation.this, c);
      fields.end();
      return responds;
    }

    @Override
    public void hit(Collision<Entity> c) {
      game.hit(Simulation.this, c);
    }
  }

  private final class Joints implements JointListener<Entity> {
    @Override
    public void broke(Joint<Entity> joint) {
      game.broke(Simulation.this, joint);
    }

    @Override
    public void created(Joint<Entity> joint) {
      joints.created(joint);
    }

    @Override
    public void destroyed(Joint<Entity> joint) {
      joints.destroyed();
    }
  }
}
