package carom.sim;

import carom.physics.BodyDef;
import carom.physics.Joint;
import carom.physics.JointDef;
import carom.physics.Queries;
import carom.physics.World;
import carom.physics.archive.ArchiveReader;
import carom.sim.area.AreaForces;
import carom.sim.entity.HostEntity;
import carom.sim.entity.EntityTable;
import carom.sim.entity.PartNames;
import carom.sim.entity.HostPlayer;
import carom.sim.entity.PlayerTable;
import carom.sim.event.EventKind;
import carom.sim.event.EventKinds;
import carom.sim.field.Countdown;
import carom.sim.field.Field;
import carom.sim.field.FieldHolder;
import carom.sim.field.FieldValues;
import carom.sim.field.Schema;
import carom.sim.field.Scope;
import carom.sim.finding.Findings;
import carom.sim.joint.Assemblies;
import carom.sim.joint.Assembly;
import carom.sim.joint.JointTable;
import carom.sim.level.Archetype;
import carom.sim.level.Archetypes;
import carom.sim.level.Level;
import carom.sim.match.MatchClock;
import carom.sim.match.NextMatch;
import carom.sim.message.Message;
import carom.sim.message.MessageKind;
import carom.sim.message.MessageKinds;
import carom.sim.message.PlayerRole;
import carom.sim.message.WaitingMessages;
import carom.sim.outbox.Delivery;
import carom.sim.outbox.Event;
import carom.sim.outbox.Outbox;
import carom.sim.pool.Pools;
import carom.sim.random.SimRandom;
import carom.sim.ruling.InterferenceLog;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;

/**
 * A world, its entities and players, and the game that rules them. It is a pure function of (state,
 * inputs, tick): equal levels, seeds, tick rates and inputs give equal {@linkplain #stateHash state
 * hashes} on every machine.
 *
 * <p>Tick 0 is the state after set-up. {@link #step} computes the next tick in this order: paths of
 * kinematic bodies, players' {@linkplain Game#message messages}, {@link Game#beforeStep}, each
 * player's {@link Game#input} by player id, areas and {@link Game#forces} on each awake body, the
 * physics, {@link Game#entered} and {@link Game#left}, {@link Game#afterStep}. While a step runs,
 * {@link #tick} is the tick being computed.
 *
 * <p>Games call most of this class. What only the program around it calls is in parts: {@link
 * #mirror} for a client, {@link #outbox} for what goes to players. {@link SimParts} draws how the
 * class is built.
 *
 * <p>A simulation belongs to one thread. A step allocates nothing of its own once arrays have
 * grown.
 */
public final class SimulationHost extends FieldHolder<HostEntity, HostPlayer> {
  /** Most players at a time; ids are 0..1,023. */
  public static final int MAX_PLAYERS = PlayerTable.MAX_PLAYERS;

  /** Most entities at a time; ids are 0..65534. */
  public static final int MAX_ENTITIES = EntityTable.MAX_ENTITIES;

  private final SimParts parts;
  private final Spawner spawner;
  private final Tick ticks;
  private final Participants participants;
  private final PartNames names;
  private final Mirror mirror;
  private final Outbox outbox;
  private final Queries<HostEntity> past;

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
    ticks = new Tick(this, parts, spawner);
    participants = new Participants(this, parts, spawner);
    names = new PartNames(level, parts.assemblies, parts.entities, parts.joints);
    mirror = new Mirror(parts);
    outbox = new Outbox(role == Role.AUTHORITY);
    World<HostEntity> world = parts.world;
    past = parts.history == null ? world.queries() : world.queries(parts.history);
    world.seal(parts.seal);
    parts.buildLevel();
    game.setUp(this);
    parts.seal.endSetUp();
    ticks.beginClock();
    parts.closeDeclarations();
    parts.capturePoses();
  }

  /** Returns the schema of a game: its fields and those of its {@linkplain Game#clock clock}. */
  public static Schema schemaOf(Game game) {
    List<Field<?>> fields = new ArrayList<>(game.fields());
    if (game.clock() != null) {
      fields.addAll(MatchClock.fields());
    }
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
   * Returns queries about the world as a player saw it when it gave the input for this tick. Each
   * body is where that player's screen showed it, {@link HostPlayer#viewDelay} ago, at most a quarter
   * of a second. Bodies that came or went since then are not found. The player's own body was on
   * its screen where it is now, so leave it out by a filter. On {@link Role#PREDICTION} the queries
   * are about the predicted world.
   *
   * @param player the player who saw it
   * @return valid until the next call; allocates nothing
   * @throws IllegalStateException on {@link Role#AUTHORITY}, when {@link Game#looksBack} is false
   */
  public Queries<HostEntity> asSeenBy(HostPlayer player) {
    parts.calls.requireOutsideForces("asSeenBy");
    if (parts.history != null) {
      parts.history.look(parts.tick, player.viewDelay());
    } else if (parts.role == Role.AUTHORITY) {
      throw new IllegalStateException(
          "game " + parts.game.name() + " doesn't look back; make Game.looksBack return true");
    }
    return past;
  }

  /** Returns the tick of the present state, or during a step the tick being computed. */
  public int tick() {
    return parts.tick;
  }

  /** Returns the number of steps per second. */
  public int tickRate() {
    return parts.tickRate;
  }

  /** Returns the time from tick to tick, in seconds. */
  public float tickSeconds() {
    return 1f / parts.tickRate;
  }

  /** Returns a time in ticks, rounded, and at least 1. */
  public int ticks(float seconds) {
    return Countdown.ticks(seconds, parts.tickRate);
  }

  /** Returns whether the simulation decides or predicts. */
  public Role role() {
    return parts.role;
  }

  /** Returns the level that is played. */
  public Level level() {
    return parts.level;
  }

  /** Returns the rules. */
  public Game game() {
    return parts.game;
  }

  /** Returns the random numbers, which only {@link Role#AUTHORITY} may draw. */
  public SimRandom random() {
    parts.calls.requireOutsideForces("random");
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

  /**
   * Returns whether an entity overlaps or touches a sensor of the level; both roles, {@link
   * Game#input} and {@link Game#forces} included. It follows from where the entity is now.
   *
   * @param entity an entity that exists; in {@link Game#input} the player's body, or what the
   *     player fired
   * @param sensor the name of {@code statics} of the level that are sensors
   * @throws IllegalArgumentException if the level has none of that name
   */
  public boolean isInside(HostEntity entity, String sensor) {
    return parts.sensors.contain(entity, sensor);
  }

  /** Returns the static geometry of the level, in file order; unmodifiable. */
  public List<HostEntity> statics() {
    return Collections.unmodifiableList(parts.statics);
  }

  /**
   * Creates an entity under the smallest free id. An entity owned by a player without a body
   * becomes the player's body.
   *
   * <p>{@link Game#input} may call it on both roles for what belongs to its player, and give the
   * new entity a velocity and fields. That player's client has it at once, as a {@linkplain
   * HostEntity#isProvisional provisional} one, and it becomes the server's or goes when the server's
   * word is there. What the input of others spawns, a client keeps until the end of the call only.
   * {@link HostPlayer#spawned} finds it again.
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
  public HostEntity spawn(Archetype archetype, float x, float y, float angle, HostPlayer owner) {
    return spawner.spawn(archetype, x, y, angle, owner);
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
    parts.calls.requireOutsideInput("spawn(archetype, def)");
    parts.calls.requireAuthority("spawn");
    return parts.entities.spawn(archetype, def);
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
  public HostEntity spawn(Assembly assembly, float x, float y, float angle, HostPlayer owner) {
    parts.calls.requireOutsideInput("spawn(assembly, ...)");
    parts.calls.requireAuthority("spawn");
    int ownerId = owner == null ? HostEntity.NO_OWNER : owner.id();
    return parts.entities.spawn(assembly, x, y, angle, ownerId, parts.tick);
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
  public Joint<HostEntity> connect(JointDef<HostEntity> def) {
    parts.calls.requireAuthority("connect");
    return parts.world.createJoint(def);
  }

  /**
   * Destroys a joint. Nothing happens if it is gone already.
   *
   * @throws IllegalStateException on {@link Role#PREDICTION} or during the physics
   */
  public void disconnect(Joint<HostEntity> joint) {
    parts.calls.requireAuthority("disconnect");
    if (joint.isValid()) {
      parts.world.destroyJoint(joint);
    }
  }

  /**
   * Returns a joint of the level by its name; both roles.
   *
   * @return null if it broke or was destroyed, or if this client doesn't simulate it
   * @throws IllegalArgumentException if the level has no joint of that name
   */
  public Joint<HostEntity> joint(String name) {
    return names.joint(name);
  }

  /**
   * Returns a joint of an assembly by its name; both roles.
   *
   * @param member any entity of the assembly
   * @param name as the {@code AssemblyDef} gives it
   * @return null if it broke or was destroyed, or if this client doesn't simulate it
   * @throws IllegalArgumentException if the assembly has no joint of that name
   */
  public Joint<HostEntity> joint(HostEntity member, String name) {
    return names.joint(member, name);
  }

  /**
   * Returns a body of an assembly by its name; both roles. Clients know the members by their joints
   * and find none whose joints are all gone.
   *
   * @param member any entity of the assembly
   * @param name as the {@code AssemblyDef} gives it
   * @return null if it was despawned, or if this client doesn't know it
   * @throws IllegalArgumentException if the assembly has no body of that name
   */
  public HostEntity part(HostEntity member, String name) {
    return names.body(member, name);
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

  /** Returns the number of entities. */
  public int entityCount() {
    return parts.entities.count();
  }

  /** Returns the entity under an id, or null when the id is free or out of range. */
  public HostEntity entity(int id) {
    parts.calls.requireOutsideForces("entity");
    return parts.entities.get(id);
  }

  /** Returns a number above all ids of players and spectators. */
  public int playerCapacity() {
    return parts.players.limit();
  }

  /** Returns the player under an id, or null when there is none; a spectator is none. */
  public HostPlayer player(int id) {
    parts.calls.requireOutsideForces("player");
    return parts.players.get(id);
  }

  /** Returns the player or spectator under an id, or null; games ask for {@link #player}. */
  public HostPlayer participant(int id) {
    parts.calls.requireOutsideForces("participant");
    return parts.players.participant(id);
  }

  /** Returns the number of players, without spectators. */
  public int playerCount() {
    return parts.players.count();
  }

  /** Returns the number of players in a team, without spectators. */
  public int teamSize(int team) {
    return parts.players.teamSize(team);
  }

  /** Returns whether there are players, and all of them are {@linkplain HostPlayer#isReady ready}. */
  public boolean allReady() {
    return parts.players.allReady();
  }

  /** Returns the player with the highest score, or null if several have it. */
  public HostPlayer leader() {
    parts.calls.requireOutsideForces("leader");
    return parts.players.leader();
  }

  /** Returns the player that owns an entity, or null. */
  public HostPlayer owner(HostEntity entity) {
    return parts.players.get(entity.ownerId());
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
    return join(id, name, 0, 0);
  }

  /**
   * Adds a player who brings a team and a score from the match before. {@link Game#join} finds them
   * set.
   *
   * @throws IllegalStateException as {@link #join(int, String)}
   */
  public HostPlayer join(int id, String name, int team, int score) {
    return participants.join(id, name, team, score);
  }

  /**
   * Adds a spectator under an id that was promised to it. {@link Game#join} isn't called.
   *
   * @throws IllegalStateException as {@link #join(int, String)}
   */
  public HostPlayer joinAsSpectator(int id, String name) {
    return participants.joinAsSpectator(id, name);
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
  public void role(HostPlayer participant, PlayerRole role) {
    participants.role(participant, role);
  }

  /**
   * Removes a player or spectator and despawns everything the player owns. Nothing happens when it
   * is gone already.
   */
  public void leave(HostPlayer player) {
    participants.leave(player);
  }

  /**
   * Asks the room to play something else after this tick: another level, or another game. It loads
   * while this match goes on, which takes some ticks, and then begins at tick 0 with the same
   * players. If it can't be played, this match goes on. Of several requests in a tick the last
   * counts, and while one loads, further ones are ignored. It is not part of the state; without a
   * room, and on {@link Role#PREDICTION}, nothing happens.
   */
  public void playNext(NextMatch next) {
    outbox.playNext(next);
  }

  /**
   * Says that the match is over: the room goes on with the next level of its rotation. In a room
   * without a rotation nothing happens, so the game should begin again by itself.
   */
  public void matchOver() {
    playNext(NextMatch.OF_ROTATION);
  }

  /**
   * Sends a short text to all players, such as who scored. It is not part of the state. On {@link
   * Role#PREDICTION} nothing happens.
   *
   * @param text cut to {@value Outbox#MAX_NOTICE_LENGTH} characters
   */
  public void notice(String text) {
    outbox.notice(text);
  }

  /**
   * Emits an event. Any method of {@link Game} may call it, {@code input} and {@code hit} of both
   * roles included; between two steps it belongs to the next one. It changes nothing that is hashed
   * or saved. A client's prediction emits an event again when it computes a tick again; its
   * listeners receive the event once.
   *
   * @param kind as registered in {@link Game#setUp}
   * @return the event to fill in; reused once it was {@linkplain Outbox#drainEvents drained}
   */
  public Event emit(EventKind kind) {
    return outbox.event(kind, parts.inTick ? parts.tick : parts.tick + 1);
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
    parts.calls.requireAuthority("receive");
    parts.messageKinds.indexOf(message.kind(), MessageKind.Direction.FROM_CLIENT);
    return parts.received.add(player.id(), message);
  }

  /** Passes on the messages that the next step will handle, in that order, and keeps them. */
  public void forEachReceived(WaitingMessages.Reader reader) {
    parts.received.forEach(reader);
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
    parts.messageKinds.indexOf(message.kind(), MessageKind.Direction.FROM_SERVER);
    return outbox.send(message);
  }

  /**
   * Computes the next tick from each player's {@link HostPlayer#input} and {@link HostPlayer#viewDelay}.
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
    parts.calls.requireOutsidePhysics("restore");
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
}
