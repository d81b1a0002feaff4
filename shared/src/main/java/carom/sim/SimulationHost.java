package carom.sim;

import carom.physics.Body;
import carom.physics.BodyDef;
import carom.physics.Joint;
import carom.physics.JointDef;
import carom.physics.Queries;
import carom.physics.World;
import carom.physics.archive.ArchiveReader;
import carom.physics.effects.Effect;
import carom.physics.effects.Explosion;
import carom.physics.effects.Hover;
import carom.physics.math.Limits;
import carom.physics.math.SimRandom;
import carom.physics.math.Transform;
import carom.sim.entity.AreaForces;
import carom.sim.entity.Assemblies;
import carom.sim.entity.Assembly;
import carom.sim.entity.Entity;
import carom.sim.entity.EntityJoint;
import carom.sim.entity.EntityQueries;
import carom.sim.entity.EntityTable;
import carom.sim.entity.HostEntity;
import carom.sim.entity.HostPlayer;
import carom.sim.entity.Input;
import carom.sim.entity.JointTable;
import carom.sim.entity.Newcomer;
import carom.sim.entity.Player;
import carom.sim.entity.PlayerTable;
import carom.sim.event.EventKind;
import carom.sim.event.EventKinds;
import carom.sim.field.Countdown;
import carom.sim.field.Field;
import carom.sim.field.FieldValues;
import carom.sim.field.Schema;
import carom.sim.field.Scope;
import carom.sim.level.Archetype;
import carom.sim.level.Archetypes;
import carom.sim.level.Level;
import carom.sim.message.Message;
import carom.sim.message.MessageKind;
import carom.sim.message.MessageKinds;
import carom.sim.message.PlayerColour;
import carom.sim.message.PlayerRole;
import carom.sim.message.WaitingMessages;
import carom.sim.outbox.Delivery;
import carom.sim.outbox.Event;
import carom.sim.outbox.NextMatch;
import carom.sim.outbox.Outbox;
import carom.sim.phase.Findings;
import carom.sim.phase.RuleWatch;
import carom.sim.pool.Pools;
import carom.sim.ruling.InterferenceLog;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.function.BiFunction;
import java.util.function.Consumer;
import java.util.function.Predicate;

/**
 * A world, its entities and players, and the game that rules them, as the program that runs it
 * holds it: a server's room, a client's prediction, a test. It is a pure function of (state,
 * inputs, tick): equal levels, seeds, tick rates and inputs give equal {@linkplain #stateHash state
 * hashes} on every machine.
 *
 * <p>Tick 0 is the state after set-up. {@link #step} computes the next tick in this order: paths of
 * kinematic bodies, players' {@linkplain Game#message messages}, {@link Game#beforeStep}, each
 * player's {@link Game#input} by player id, {@link Game#rules}, areas and {@link Game#forces} on
 * each awake body, the physics, {@link Game#entered} and {@link Game#left}, the level's triggers,
 * {@link Game#afterStep}. While a step runs, {@link #tick} is the tick being computed.
 *
 * <p>Games see it as a {@link Simulation} or a {@link Match}, and never as this. What only one kind
 * of program calls is in parts: {@link #mirror} for a client, {@link #outbox} for what goes to
 * players. {@link SimParts} draws how the class is built.
 *
 * <p>A simulation belongs to one thread. A step allocates nothing of its own once arrays have
 * grown.
 */
public final class SimulationHost implements Match, Rules {
  /** Most players at a time; ids are 0..1,023. */
  public static final int MAX_PLAYERS = PlayerTable.MAX_PLAYERS;

  /** Most entities at a time; ids are 0..65534. */
  public static final int MAX_ENTITIES = EntityTable.MAX_ENTITIES;

  private static final Transform HERE = new Transform();

  private final SimParts parts;
  private final Spawner spawner;
  private final Tick ticks;
  private final Participants participants;
  private final PartNames names;
  private final Mirror mirror;
  private final Outbox outbox;
  private final Queries<HostEntity> past;
  private final EntityQueries queries;
  private final EntityQueries seen;
  private final Present<Entity> entities;
  private final Present<Player> players;

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
  public SimulationHost(Game game, Level level, long seed, int tickRate, Role role) {
    if (tickRate < 1 || tickRate > 1000) {
      throw new IllegalArgumentException("tickRate=" + tickRate + " is outside 1..1000");
    }
    parts = new SimParts(game, level, seed, tickRate, role);
    spawner = new Spawner(parts);
    ticks = new Tick(this, parts);
    participants = new Participants(this, parts, spawner);
    names = new PartNames(level, parts.assemblies, parts.entities, parts.joints);
    mirror = new Mirror(parts);
    outbox = new Outbox(role == Role.AUTHORITY);
    World<HostEntity> world = parts.world;
    past = parts.history == null ? world.queries() : world.queries(parts.history);
    queries = new EntityQueries(world.queries());
    seen = new EntityQueries(past);
    entities = new Present<>(parts.entities::capacity, parts.entities::get);
    players = new Present<>(parts.players::limit, parts.players::get);
    parts.entities.answers(new Answers());
    parts.buildLevel();
    game.setUp(new SetUp(parts));
    if (role == Role.AUTHORITY) {
      game.begin(this);
    }
    ticks.begin();
    parts.closeDeclarations();
    parts.capturePoses();
  }

  /**
   * Returns the schema of a game on a level: its fields, those of its {@linkplain Game#clock
   * clock}, and what rules that clients run keep of this level.
   */
  public static Schema schemaOf(Game game, Level level) {
    List<Field<?>> fields = new ArrayList<>(game.fields());
    if (game.clock() != null) {
      fields.addAll(MatchClock.fields());
    }
    fields.addAll(RuleWords.of(level, game.rules(level) != null).fields());
    return Schema.of(fields);
  }

  /**
   * Adds a journal, which receives everything that enters from now on. Journals are not part of the
   * state.
   */
  public void addJournal(Journal journal) {
    parts.journals.add(journal);
  }

  /** Removes a journal; nothing happens if it isn't there. */
  public void removeJournal(Journal journal) {
    parts.journals.remove(journal);
  }

  /** Returns what takes over the server's state; of use on {@link Role#PREDICTION} only. */
  public Mirror mirror() {
    return mirror;
  }

  /** Returns what the game has said since it was drained last: notices, events and messages. */
  public Outbox outbox() {
    return outbox;
  }

  /** Returns the physics world. */
  public World<HostEntity> world() {
    return parts.world;
  }

  /**
   * Returns the engine's queries about the world as a player saw it, as {@link #asSeenBy} does. On
   * {@link Role#PREDICTION} they are about the predicted world.
   */
  public Queries<HostEntity> pastQueries(HostPlayer player) {
    if (parts.history != null) {
      parts.history.look(parts.tick, player.viewDelay());
    } else if (parts.role == Role.AUTHORITY) {
      throw new IllegalStateException(
          "game " + parts.game.name() + " doesn't look back; make Game.looksBack return true");
    }
    return past;
  }

  @Override
  public int tick() {
    return parts.tick;
  }

  @Override
  public int tickRate() {
    return parts.tickRate;
  }

  @Override
  public float tickSeconds() {
    return 1f / parts.tickRate;
  }

  @Override
  public int ticks(float seconds) {
    return Countdown.ticks(seconds, parts.tickRate);
  }

  /** Returns whether the simulation decides or predicts. */
  public Role role() {
    return parts.role;
  }

  @Override
  public Level level() {
    return parts.level;
  }

  /** Returns the rules. */
  public Game game() {
    return parts.game;
  }

  @Override
  public SimRandom random() {
    return parts.random;
  }

  /**
   * Returns the fields that the game declares. {@link #get}, {@link #set} and {@link #add} of this
   * class are for those of the match.
   */
  public Schema schema() {
    return parts.fields.schema();
  }

  /** Returns the values of the match's fields. */
  @Override
  public FieldValues fieldValues() {
    return parts.match;
  }

  /** Returns a number that grows with each change of a field in a scope. */
  public long fieldChanges(Scope scope) {
    return parts.fields.changes(scope);
  }

  /** Returns the registered archetypes. */
  public Archetypes archetypes() {
    return parts.archetypes;
  }

  /** Returns the registered assemblies: groups of bodies and joints, such as cars. */
  public Assemblies assemblies() {
    return parts.assemblies;
  }

  /** Returns the registered kinds of events. */
  public EventKinds eventKinds() {
    return parts.eventKinds;
  }

  /** Returns the registered kinds of messages, the built-in ones first. */
  public MessageKinds messageKinds() {
    return parts.messageKinds;
  }

  /** Returns the static geometry of the level, in file order; unmodifiable. */
  public List<HostEntity> statics() {
    return Collections.unmodifiableList(parts.statics);
  }

  @Override
  public HostEntity spawn(Archetype archetype, float x, float y, float angle, Player owner) {
    Limits.notNull("archetype", archetype);
    return spawner.spawn(archetype, x, y, angle, (HostPlayer) owner);
  }

  /**
   * Creates an entity without an owner under the smallest free id. Its body may have more than the
   * archetype says: filters, a mass. Clients that predict it know pose, velocity and archetype
   * only, and {@link #findings} says what they lack.
   *
   * @param archetype its archetype, with the same shapes; its path is ignored
   * @param def the definition of the body
   * @throws IllegalStateException on {@link Role#PREDICTION}, in {@link Game#input}, during the
   *     physics, or beyond {@value #MAX_ENTITIES}
   */
  public HostEntity spawn(Archetype archetype, BodyDef def) {
    parts.phases.requireOutsideInput("spawn(archetype, def)");
    parts.phases.requireAuthority("spawn");
    return parts.entities.spawn(archetype, def);
  }

  @Override
  public HostEntity spawn(Assembly assembly, float x, float y, float angle, Player owner) {
    parts.phases.requireOutsideInput("spawn(assembly, ...)");
    parts.phases.requireAuthority("spawn");
    Limits.notNull("assembly", assembly);
    int ownerId = owner == null ? HostEntity.NO_OWNER : owner.id();
    return parts.entities.spawn(assembly, x, y, angle, ownerId, parts.tick);
  }

  /**
   * Creates a joint between bodies of the world. Clients mirror and predict it. It goes with either
   * of its bodies, when a game destroys it, or when it breaks.
   *
   * @return the joint, whose motor, limits, spring and target may be changed at any time; those
   *     that {@link Game#input} changes are predicted
   * @throws IllegalStateException on {@link Role#PREDICTION}, during the physics, or beyond {@value
   *     JointTable#MAX_JOINTS} joints
   */
  public Joint<HostEntity> connect(JointDef<HostEntity> def) {
    parts.phases.requireAuthority("connect");
    return parts.world.createJoint(def);
  }

  /** Returns what is known of the joints beyond the physics: keys, definitions, assemblies. */
  public JointTable<HostEntity> joints() {
    return parts.joints;
  }

  /**
   * Destroys an entity with its joints, and with the root of an assembly all of it. If it was a
   * player's body, the player then has none. Nothing happens when the entity is gone already.
   *
   * <p>{@link Game#input} may call it on both roles. A client predicts it for what belongs to the
   * player and isn't its body. All else stays there until the server's word.
   *
   * @throws IllegalStateException during the physics
   */
  public void despawn(HostEntity entity) {
    spawner.despawn(entity);
    participants.tellVisits();
  }

  /** Returns a number above all entity ids. It never shrinks, except by {@link #restore}. */
  public int entityCapacity() {
    return parts.entities.capacity();
  }

  /**
   * Returns a number that changes whenever an entity may have come, gone or been teleported, and
   * when the state is restored. While it stays the same, ids, archetypes and owners stay the same
   * too; tags may change.
   *
   * @return meaningful only compared with an earlier one of this simulation; not part of the state
   */
  public long rosterVersion() {
    return parts.entities.version();
  }

  @Override
  public int entityCount() {
    return parts.entities.count();
  }

  @Override
  public HostEntity entity(int id) {
    return parts.entities.get(id);
  }

  /** Returns a number above all ids of players and spectators. */
  public int playerCapacity() {
    return parts.players.limit();
  }

  @Override
  public HostPlayer player(int id) {
    return parts.players.get(id);
  }

  /** Returns the player or spectator under an id, or null; games ask for {@link #player}. */
  public HostPlayer participant(int id) {
    return parts.players.participant(id);
  }

  @Override
  public int playerCount() {
    return parts.players.count();
  }

  @Override
  public int teamSize(int team) {
    return parts.players.teamSize(team);
  }

  @Override
  public boolean allReady() {
    return parts.players.allReady();
  }

  @Override
  public HostPlayer leader() {
    return parts.players.leader();
  }

  /**
   * Adds a player under the smallest free id. The game gives it a body. If {@link Game#maxPlayers}
   * play already, it watches instead, and the game doesn't hear of it.
   *
   * @throws IllegalStateException on {@link Role#PREDICTION}, or when {@value #MAX_PLAYERS} players
   *     play
   */
  public HostPlayer join(String name) {
    return participants.join(name);
  }

  /**
   * Adds a player under an id that was promised to it, as {@link #join(String)} does.
   *
   * @throws IllegalStateException on {@link Role#PREDICTION}, or when the id is taken
   */
  public HostPlayer join(int id, String name) {
    return join(id, Newcomer.stranger(name), 0, 0);
  }

  /**
   * Adds a player who brings a team and a score from the match before, and what an account has
   * kept. {@link Game#join} finds all of it set.
   *
   * @throws IllegalStateException as {@link #join(int, String)}
   * @throws IllegalArgumentException if the account's values are none of this game
   */
  public HostPlayer join(int id, Newcomer newcomer, int team, int score) {
    return participants.join(id, newcomer, team, score);
  }

  /**
   * Adds a spectator under an id that was promised to it. {@link Game#join} isn't called.
   *
   * @throws IllegalStateException as {@link #join(int, String)}
   */
  public HostPlayer joinAsSpectator(int id, String name) {
    return joinAsSpectator(id, Newcomer.stranger(name));
  }

  /**
   * Adds a spectator, as {@link #joinAsSpectator(int, String)} does.
   *
   * @throws IllegalArgumentException as {@link #join(int, Newcomer, int, int)}
   */
  public HostPlayer joinAsSpectator(int id, Newcomer newcomer) {
    return participants.joinAsSpectator(id, newcomer);
  }

  @Override
  public void role(Player participant, PlayerRole role) {
    participants.role(host(participant), Limits.notNull("role", role));
  }

  /**
   * Gives a participant back what an account has kept, between two steps: what has changed since
   * doesn't count. Nothing happens when the participant is gone.
   *
   * @param values in the order of {@link Schema#lastingWords}
   * @throws IllegalStateException on {@link Role#PREDICTION}, or within a step
   * @throws IllegalArgumentException if they are none of this game
   */
  public void keep(HostPlayer participant, int[] values) {
    participants.keep(participant, values);
  }

  /**
   * Removes a player or spectator and despawns everything the player owns. Nothing happens when it
   * is gone already.
   */
  public void leave(HostPlayer player) {
    participants.leave(player);
  }

  @Override
  public void playNext(NextMatch next) {
    outbox.playNext(Limits.notNull("next", next));
  }

  @Override
  public void notice(String text) {
    outbox.notice(Limits.notNull("text", text));
  }

  @Override
  public Event emit(EventKind kind) {
    Limits.notNull("kind", kind);
    return outbox.event(kind, parts.phases.isInStep() ? parts.tick : parts.tick + 1);
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
  public boolean receive(HostPlayer player, Message message) {
    parts.phases.requireAuthority("receive");
    parts.messageKinds.indexOf(message.kind(), MessageKind.Direction.FROM_CLIENT);
    return parts.received.add(player.id(), message);
  }

  /** Passes on the messages that the next step will handle, in that order, and keeps them. */
  public void forEachReceived(WaitingMessages.Reader reader) {
    parts.received.forEach(reader);
  }

  @Override
  public Delivery send(Message message) {
    MessageKind kind = Limits.notNull("message", message).kind();
    parts.messageKinds.indexOf(kind, MessageKind.Direction.FROM_SERVER);
    return outbox.send(message);
  }

  /**
   * Computes the next tick from each player's {@link HostPlayer#input} and {@link
   * HostPlayer#viewDelay}.
   */
  public void step() {
    ticks.step();
  }

  /** Returns the areas of the level and those that entities carry. For reading only. */
  public AreaForces<HostEntity> areas() {
    return parts.areas;
  }

  /**
   * Returns the water and sand of the level, and what the game adds in {@link Game#setUp}. On
   * {@link Role#PREDICTION} the client moves them on.
   */
  public Pools pools() {
    return parts.pools;
  }

  /** Returns the log of what the game did to bodies; filled on {@link Role#AUTHORITY} only. */
  public InterferenceLog interference() {
    return parts.interference;
  }

  /**
   * Returns what the game does again and again although no client can predict it, with advice; on
   * {@link Role#AUTHORITY}, about what clients predict. No part of the state.
   */
  public Findings findings() {
    return parts.findings;
  }

  /** Sets what is told of each change that the game's rules make, or null for nothing. */
  public void watchRules(RuleWatch watch) {
    parts.entities.watch(watch);
    parts.fields.ruleWrites(
        watch == null ? null : values -> watch.changes(parts.allFields.playerOf(values), false));
  }

  /**
   * Returns 64 bits of everything that decides the future: tick, world, random numbers, fields,
   * players with score, team, role and input, entities with archetype, owner and tag. Equal runs
   * have equal hashes.
   */
  public long stateHash() {
    return parts.hash();
  }

  /**
   * Saves everything that {@link #stateHash} covers, and the handles.
   *
   * @param reuse a state of this simulation to overwrite, or null for a new one
   * @return the saved state
   */
  public SimState save(SimState reuse) {
    SimState s = reuse == null ? new SimState(parts) : reuse;
    s.requireOf(parts);
    s.save();
    return s;
  }

  /**
   * Returns to a saved state. The ticks that follow are the same, bit by bit. Entities and players
   * that have gone since are back under their old handles; those that came since are gone.
   *
   * @throws IllegalArgumentException when another simulation made the state
   */
  public void restore(SimState s) {
    s.requireOf(parts);
    parts.phases.requireOutsidePhysics("restore");
    s.restore();
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
    return SimState.read(parts, archive);
  }

  // ---- what games see of it, see Simulation and Match

  @Override
  public Archetype archetype(String name) {
    return parts.archetype(name);
  }

  @Override
  public EntityJoint joint(String name) {
    return parts.entities.face(names.joint(name));
  }

  @Override
  public EntityQueries queries() {
    return queries;
  }

  @Override
  public EntityQueries asSeenBy(Player p) {
    pastQueries(host(p));
    return seen;
  }

  @Override
  public int countInside(String sensor) {
    return parts.inside.players(sensor) + parts.inside.bodies(sensor);
  }

  @Override
  public int playersInside(String sensor) {
    return parts.inside.players(sensor);
  }

  @Override
  public void forEachInside(String sensor, Consumer<Entity> visitor) {
    parts.inside.forEach(sensor, Limits.notNull("visitor", visitor));
  }

  @Override
  public void move(String body, float x, float y, float seconds) {
    parts.moves.start(parts.moves.find(body), x, y, seconds);
  }

  /**
   * Returns whether there are rules that clients run: {@link Game#rules}, or triggers of the level.
   */
  public boolean hasRules() {
    return parts.hasRules;
  }

  /** Returns whether a field is one in which rules keep what the game's own fields don't hold. */
  public boolean isOfRules(Field<?> field) {
    return parts.ruleWords.fields().contains(field);
  }

  /** Returns the number of bodies of the level that rules may move. */
  public int movableCount() {
    return parts.moves.count();
  }

  /** Returns a body that rules may move, or null if it is gone or not predicted here. */
  public HostEntity movable(int index) {
    return parts.moves.get(index);
  }

  @Override
  public void act(Effect effect, Entity entity) {
    parts.phases.requireOutsideRules("act");
    Limits.notNull("effect", effect)
        .act(parts.world, bodyOf("entity", entity), HERE, 1, tickSeconds());
  }

  @Override
  @SuppressWarnings("unchecked") // it sees bodies alone, and nothing of their users
  public boolean hover(Hover<?> how, Entity entity) {
    parts.phases.requireOutsideRules("hover");
    return ((Hover<HostEntity>) Limits.notNull("how", how))
        .apply(parts.world, bodyOf("entity", entity), tickSeconds());
  }

  @Override
  public void forEachInBox(
      float minX, float minY, float maxX, float maxY, Predicate<Entity> visitor) {
    Limits.notNull("visitor", visitor);
    parts.world.queryAabb(minX, minY, maxX, maxY, body -> visitor.test(body.user()));
  }

  @Override
  public void explode(Explosion explosion) {
    Limits.notNull("explosion", explosion).explode(parts.world);
  }

  @Override
  public EntityJoint connect(
      Entity a, Entity b, BiFunction<Body<Object>, Body<Object>, JointDef<Object>> how) {
    parts.phases.requireAuthority("connect");
    Body<HostEntity> second = bodyOf("b", b);
    JointDef<Object> def = Limits.notNull("how", how).apply(JointEnds.FIRST, JointEnds.SECOND);
    Body<HostEntity> first = a == null ? null : ((HostEntity) a).body();
    return parts.entities.face(parts.world.createJoint(first, second, def));
  }

  @Override
  public Iterable<Entity> entities() {
    return entities;
  }

  @Override
  public Iterable<Player> players() {
    return players;
  }

  @Override
  public String name(Player p) {
    return host(p).name();
  }

  @Override
  public int score(Player p) {
    return host(p).score();
  }

  @Override
  public void score(Player p, int points) {
    host(p).score(points);
  }

  @Override
  public int team(Player p) {
    return host(p).team();
  }

  @Override
  public void team(Player p, int team) {
    host(p).team(team);
  }

  @Override
  public PlayerColour colour(Player p) {
    return host(p).colour();
  }

  @Override
  public boolean isReady(Player p) {
    return host(p).isReady();
  }

  @Override
  public void ready(Player p, boolean value) {
    host(p).ready(value);
  }

  @Override
  public boolean isSpectator(Player p) {
    return host(p).isSpectator();
  }

  @Override
  public Input input(Player p) {
    return host(p).input();
  }

  private static HostPlayer host(Player player) {
    return (HostPlayer) Limits.notNull("player", player);
  }

  private static Body<HostEntity> bodyOf(String name, Entity entity) {
    return ((HostEntity) Limits.notNull(name, entity)).body();
  }

  /** Answers what entities ask of the simulation. */
  private final class Answers implements EntityTable.Answers {
    @Override
    public void despawn(HostEntity entity) {
      SimulationHost.this.despawn(entity);
    }

    @Override
    public HostEntity part(HostEntity entity, String name) {
      return names.body(entity, name);
    }

    @Override
    public EntityJoint joint(HostEntity entity, String name) {
      return parts.entities.face(names.joint(entity, name));
    }

    @Override
    public boolean isInside(HostEntity entity, String sensor) {
      return parts.sensors.contain(entity, sensor);
    }

    @Override
    public HostEntity spawn(Archetype archetype, float x, float y, float angle, HostPlayer owner) {
      return spawner.fire(archetype, x, y, angle, owner);
    }
  }
}
