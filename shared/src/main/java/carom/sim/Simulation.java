package carom.sim;

import carom.physics.Body;
import carom.physics.BodyDef;
import carom.physics.Collision;
import carom.physics.CollisionListener;
import carom.physics.Queries;
import carom.physics.World;
import carom.physics.archive.ArchiveReader;
import carom.sim.event.EventKind;
import carom.sim.event.EventKinds;
import carom.sim.level.Archetype;
import carom.sim.level.ArchetypeDef;
import carom.sim.level.Archetypes;
import carom.sim.level.Level;
import carom.sim.level.ScriptedMotion;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.function.Consumer;

/**
 * A world, its entities and players, and the game that rules them: a pure function of (state,
 * inputs, tick). Equal levels, seeds, tick rates and inputs give equal {@linkplain #stateHash state
 * hashes} on every machine.
 *
 * <p>Tick 0 is the state after set-up. {@link #step} computes the next tick in this order: paths of
 * kinematic bodies, {@link Game#beforeStep}, each player's {@link Game#input} by player id, the
 * physics, {@link Game#afterStep}. While a step runs, {@link #tick} is the tick being computed.
 *
 * <p>Belongs to one thread. A step allocates nothing of its own once arrays have grown.
 */
public final class Simulation {
  /** Most players at a time; ids are 0..1,023. */
  public static final int MAX_PLAYERS = 1_024;

  /** Most entities at a time; ids are 0..65534. */
  public static final int MAX_ENTITIES = 65_535;

  /** Notices kept until somebody drains them; more are dropped and counted. */
  public static final int MAX_NOTICES = 16;

  /** Longest notice, characters; the rest is cut. */
  public static final int MAX_NOTICE_LENGTH = 120;

  /** Events kept until somebody drains them; beyond, the oldest are dropped and counted. */
  public static final int MAX_EVENTS = 1 << 10;

  private final Game game;
  private final Level level;
  private final int tickRate;
  private final float tickSeconds;
  private final Role role;
  private final World<Entity> world;
  private final Archetypes archetypes = new Archetypes();
  private final SimRandom random;
  private final int[] memory;
  private final List<Entity> statics = new ArrayList<>();
  private final Player[] players = new Player[MAX_PLAYERS];
  private final ArrayDeque<String> notices = new ArrayDeque<>();
  private final EventKinds eventKinds = new EventKinds();
  private final EventLog events = new EventLog();

  /** Ids of all players are below. */
  private int playerLimit;

  private Entity[] entities = new Entity[64];
  private final Roster roster = new Roster();
  private byte[] generations = new byte[64];

  /** All ids that were ever used are below: free slots keep their generation. */
  private int entityCapacity;

  private int entityCount;

  /** No id below is free. */
  private int firstFree;

  private int tick;
  private long droppedNotices;
  private boolean stepping;
  private boolean inTick;
  private Journal journal;

  /** Whose {@link Entity#ruledTick} somebody wants to know in the next step. */
  private Entity[] watched = new Entity[16];

  private int watchedCount;

  /** On AUTHORITY, if the game looks back; else null. */
  private final PoseHistory history;

  private final Queries<Entity> past;

  /**
   * Builds the level and sets the game up, up to tick 0.
   *
   * @param game an instance of its own, see {@link Game}
   * @param level where it is played
   * @param seed of {@link #random}
   * @param tickRate steps per second, 1..1000
   * @param role to decide or to foresee
   * @throws IllegalArgumentException when a number is out of range
   */
  public Simulation(Game game, Level level, long seed, int tickRate, Role role) {
    if (tickRate < 1 || tickRate > 1000) {
      throw new IllegalArgumentException("tickRate=" + tickRate + " is outside 1..1000");
    }
    int memorySize = game.memorySize(level);
    if (memorySize < 0 || memorySize > 65_536) {
      throw new IllegalArgumentException(
          "memorySize=" + memorySize + " of game " + game.name() + " is outside 0..65536");
    }
    this.game = game;
    this.level = level;
    this.tickRate = tickRate;
    tickSeconds = 1f / tickRate;
    this.role = role;
    random = new SimRandom(seed);
    memory = new int[memorySize];
    world = new World<>(game.world(level));
    world.listener(new Listener());
    history = role == Role.AUTHORITY && game.looksBack() ? new PoseHistory(this) : null;
    past = history == null ? world.queries() : world.queries(history);
    for (ArchetypeDef def : level.archetypes()) {
      archetypes.add(def);
    }
    for (Level.Placement p : level.statics()) {
      statics.add(
          embody(
              new Entity(roster, Entity.LEVEL, 0, archetypes.get(p.archetype()), Entity.NO_OWNER),
              p.x(),
              p.y(),
              p.angle()));
    }
    if (role == Role.AUTHORITY) {
      for (Level.Placement p : level.bodies()) {
        spawn(archetypes.get(p.archetype()), p.x(), p.y(), p.angle(), null);
      }
    }
    game.setUp(this);
    archetypes.close();
    eventKinds.close();
    if (history != null) {
      history.capture();
    }
  }

  /**
   * Sets who hears what enters from now on; not part of the state.
   *
   * @param newJournal null for nobody
   */
  public void journal(Journal newJournal) {
    journal = newJournal;
  }

  /** The physics. */
  public World<Entity> world() {
    return world;
  }

  /**
   * Questions about the world as a player saw it when it gave the input for this tick: each body
   * where that player's screen showed it, {@link Player#viewDelay} ago, at most a quarter of a
   * second; bodies that came since then are not there, those that went since aren't either. What
   * the player steers itself was where it is now on its screen: leave it out by a filter.
   *
   * <p>On {@link Role#PREDICTION} these are questions about the predicted world as it is: what the
   * player sees, as far as it is predicted.
   *
   * @param player who saw it
   * @return valid until the next call; allocates nothing
   * @throws IllegalStateException on {@link Role#AUTHORITY}, when {@link Game#looksBack} says no
   */
  public Queries<Entity> asSeenBy(Player player) {
    if (history != null) {
      history.look(player.viewDelay());
    } else if (role == Role.AUTHORITY) {
      throw new IllegalStateException(
          "game " + game.name() + " doesn't look back; let Game.looksBack return true");
    }
    return past;
  }

  /** The tick whose state stands here; during a step, the tick being computed. */
  public int tick() {
    return tick;
  }

  /**
   * Says which tick the mirrored state belongs to, so that paths of kinematic bodies and timers
   * agree with the server's.
   *
   * @throws IllegalStateException on {@link Role#AUTHORITY}
   */
  public void tick(int value) {
    requirePrediction("tick");
    tick = value;
  }

  /** Steps per second. */
  public int tickRate() {
    return tickRate;
  }

  /** Seconds from tick to tick. */
  public float tickSeconds() {
    return tickSeconds;
  }

  /** How many ticks a time takes: rounded, one at least. */
  public int ticks(float seconds) {
    return Math.max(1, Math.round(seconds * tickRate));
  }

  /** To decide or to foresee. */
  public Role role() {
    return role;
  }

  /** Where it is played. */
  public Level level() {
    return level;
  }

  /** The rules. */
  public Game game() {
    return game;
  }

  /** Random numbers; for {@link Role#AUTHORITY} only. */
  public SimRandom random() {
    return random;
  }

  /**
   * The game's own ints, as many as it asked for with {@link Game#memorySize}, 0 at first: timers,
   * goals, whatever changes while playing. Hashed and saved, not sent to clients. The live array.
   */
  public int[] memory() {
    return memory;
  }

  /** The kinds of entities. */
  public Archetypes archetypes() {
    return archetypes;
  }

  /** The kinds of events. */
  public EventKinds eventKinds() {
    return eventKinds;
  }

  /** The static geometry of the level, in file order; unmodifiable. */
  public List<Entity> statics() {
    return Collections.unmodifiableList(statics);
  }

  /**
   * Creates an entity under the smallest free id. An entity owned by a player without a body
   * becomes the player's body.
   *
   * @param archetype its kind
   * @param x position of the body's origin, metres
   * @param y position of the body's origin, metres
   * @param angle radians, counterclockwise
   * @param owner the player it belongs to, or null
   * @throws IllegalStateException on {@link Role#PREDICTION}, during the physics, or beyond {@value
   *     #MAX_ENTITIES}
   */
  public Entity spawn(Archetype archetype, float x, float y, float angle, Player owner) {
    int id = freeId(archetype);
    int ownerId = owner == null ? Entity.NO_OWNER : owner.id();
    return add(new Entity(roster, id, generations[id] & 0xff, archetype, ownerId), x, y, angle);
  }

  /**
   * Creates an entity of nobody under the smallest free id, whose body is more than its archetype
   * says: filters, velocities, a bullet. Clients that foresee it know the archetype only.
   *
   * @param archetype its kind, with the same shapes; its path is ignored
   * @param def what the body is made from
   * @throws IllegalStateException on {@link Role#PREDICTION}, during the physics, or beyond {@value
   *     #MAX_ENTITIES}
   */
  public Entity spawn(Archetype archetype, BodyDef def) {
    int id = freeId(archetype);
    Entity entity = new Entity(roster, id, generations[id] & 0xff, archetype, Entity.NO_OWNER);
    entity.body(world.createBody(def, entity));
    return enlist(entity);
  }

  private int freeId(Archetype archetype) {
    requireAuthority("spawn");
    int id = firstFree;
    while (id < entityCapacity && entities[id] != null) {
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

  /**
   * Mirrors an entity of the server under the server's id. An entity under that id with another
   * generation or archetype must be despawned before. If the owner is a player here and has no
   * body, this becomes the body.
   *
   * @param id 0..65534
   * @param generation 0..255
   * @param archetype its kind
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
    requirePrediction("spawnAs");
    if (id < 0 || id >= MAX_ENTITIES || generation < 0 || generation > 255) {
      throw new IllegalArgumentException(
          "id=" + id + " generation=" + generation + " is outside 0..65534, 0..255");
    }
    grow(id);
    if (entities[id] != null) {
      throw new IllegalStateException(
          "id=" + id + " is taken by " + entities[id] + "; despawn it first");
    }
    return add(new Entity(roster, id, generation, archetype, ownerId), x, y, angle);
  }

  /**
   * Destroys an entity; if it was a player's body, the player has none then. Nothing happens when
   * it is gone already.
   *
   * @throws IllegalStateException during the physics
   */
  public void despawn(Entity entity) {
    requireQuiet("despawn");
    int id = entity.id();
    if (id < 0 || id >= entityCapacity || entities[id] != entity) {
      return;
    }
    if (history != null) {
      history.forget(entity.bodySlot());
    }
    world.destroyBody(entity.body());
    entities[id] = null;
    roster.change();
    generations[id] = (byte) (entity.generation() + 1);
    entityCount--;
    firstFree = Math.min(firstFree, id);
    Player owner = player(entity.ownerId());
    if (owner != null && owner.body == entity) {
      owner.body = null;
    }
  }

  /** All entity ids are below this number; it never shrinks, except by {@link #restore}. */
  public int entityCapacity() {
    return entityCapacity;
  }

  /**
   * A number that changes whenever an entity may have come, gone or been teleported, or the state
   * was restored; all else of who is there, but for tags, stays as it is.
   *
   * @return meaningful only compared with an earlier one of this simulation; not part of the state
   */
  public long rosterVersion() {
    return roster.version();
  }

  /** What its entities tell their changes to. */
  Roster roster() {
    return roster;
  }

  /** How many entities there are. */
  public int entityCount() {
    return entityCount;
  }

  /** The entity under an id, or null when the id is free or out of range. */
  public Entity entity(int id) {
    return id >= 0 && id < entityCapacity ? entities[id] : null;
  }

  /** All player ids are below this number. */
  public int playerCapacity() {
    return playerLimit;
  }

  /** The player under an id, or null when the id is free or out of range. */
  public Player player(int id) {
    return id >= 0 && id < playerLimit ? players[id] : null;
  }

  /** The player an entity belongs to, or null. */
  public Player owner(Entity entity) {
    return player(entity.ownerId());
  }

  /**
   * Lets a player in under the smallest free id; the game gives it a body.
   *
   * @throws IllegalStateException on {@link Role#PREDICTION}, or when {@value #MAX_PLAYERS} players
   *     play
   */
  public Player join(String name) {
    int id = 0;
    while (id < playerLimit && players[id] != null) {
      id++;
    }
    if (id == MAX_PLAYERS) {
      throw new IllegalStateException("players=" + id + " is the limit; " + name + " can't join");
    }
    return join(id, name);
  }

  /**
   * Lets a player in under an id that was promised to it; the game gives it a body.
   *
   * @param id 0..1,023
   * @throws IllegalStateException on {@link Role#PREDICTION}, or when the id is taken or out of
   *     range
   */
  public Player join(int id, String name) {
    requireAuthority("join");
    if (id < 0 || id >= MAX_PLAYERS || players[id] != null) {
      throw new IllegalStateException(
          "player id=" + id + " is taken or outside 0.." + (MAX_PLAYERS - 1));
    }
    if (journal != null) {
      journal.joining(this, id, name);
    }
    Player player = newPlayer(id, name);
    game.join(this, player);
    return player;
  }

  /**
   * Mirrors a player of the server, usually the client's own. The body follows by {@link #spawnAs}.
   *
   * @param id 0..1,023, as the server says
   * @param name its name
   * @throws IllegalStateException on {@link Role#AUTHORITY}, or when the id is taken
   */
  public Player joinAs(int id, String name) {
    requirePrediction("joinAs");
    if (id < 0 || id >= MAX_PLAYERS || players[id] != null) {
      throw new IllegalStateException(
          "player id=" + id + " is taken or outside 0.." + (MAX_PLAYERS - 1));
    }
    return newPlayer(id, name);
  }

  /** Lets a player go; despawns all the player owns. Nothing happens when the player is gone. */
  public void leave(Player player) {
    requireQuiet("leave");
    int id = player.id();
    if (players[id] != player) {
      return;
    }
    if (journal != null) {
      journal.leaving(this, id);
    }
    if (role == Role.AUTHORITY) {
      game.leave(this, player);
      for (int i = 0; i < entityCapacity; i++) {
        if (entities[i] != null && entities[i].ownerId() == id) {
          despawn(entities[i]);
        }
      }
    }
    players[id] = null;
    while (playerLimit > 0 && players[playerLimit - 1] == null) {
      playerLimit--;
    }
  }

  /**
   * Tells all players something short, such as who scored. The server sends it; it is not part of
   * the state. On {@link Role#PREDICTION} nothing happens.
   *
   * @param text cut to {@value #MAX_NOTICE_LENGTH} characters
   */
  public void notice(String text) {
    if (role != Role.AUTHORITY) {
      return;
    }
    if (notices.size() == MAX_NOTICES) {
      droppedNotices++;
      return;
    }
    notices.add(text.length() > MAX_NOTICE_LENGTH ? text.substring(0, MAX_NOTICE_LENGTH) : text);
  }

  /** Hands over the notices since the last call, oldest first, and forgets them. */
  public void drainNotices(Consumer<String> consumer) {
    while (!notices.isEmpty()) {
      consumer.accept(notices.remove());
    }
  }

  /** How many notices were lost because nobody drained them. */
  public long droppedNotices() {
    return droppedNotices;
  }

  /**
   * Tells that something happens, from anywhere in {@link Game}, {@code input} and {@code hit} of
   * both roles included; between two steps it belongs to the next. Changes nothing that is hashed
   * or saved. A client's own prediction tells it at once and again when it computes a tick again;
   * who hears has it once.
   *
   * @param kind as registered in {@link Game#setUp}
   * @return the event to fill in; used again once it was {@linkplain #drainEvents taken}
   */
  public Event emit(EventKind kind) {
    return events.add(kind, inTick ? tick : tick + 1);
  }

  /** Hands over the events since the last call in the order they were told, and forgets them. */
  public void drainEvents(Consumer<Event> consumer) {
    events.drain(consumer);
  }

  /** How many events were lost because {@value #MAX_EVENTS} were told and not drained. */
  public long droppedEvents() {
    return events.dropped();
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
    }
    if (history != null) {
      history.capture();
    }
    if (journal != null) {
      journal.stepped(this);
    }
  }

  private void computeTick() {
    movePaths();
    if (role == Role.AUTHORITY) {
      rulesBegin();
      game.beforeStep(this);
      rulesEnd(true);
    }
    for (int i = 0; i < playerLimit; i++) {
      Player player = players[i];
      if (player != null && player.body != null) {
        game.input(this, player, player.input());
      }
    }
    stepping = true;
    try {
      world.step(tickSeconds);
    } finally {
      stepping = false;
    }
    if (role == Role.AUTHORITY) {
      rulesBegin();
      game.afterStep(this);
      rulesEnd(false);
      Arrays.fill(watched, 0, watchedCount, null);
      watchedCount = 0;
    }
  }

  /**
   * Asks for {@link Entity#ruledTick} of the next step; on {@link Role#AUTHORITY}. What nobody
   * watches costs nothing.
   */
  public void watch(Entity entity) {
    if (entity.watchedTick == tick) {
      return;
    }
    entity.watchedTick = tick;
    if (watchedCount == watched.length) {
      watched = Arrays.copyOf(watched, 2 * watchedCount);
    }
    watched[watchedCount++] = entity;
  }

  /** Whether an entity of {@link #watched} is still there. */
  private boolean isHere(Entity entity) {
    return entity(entity.id()) == entity;
  }

  private void rulesBegin() {
    for (int i = 0; i < playerLimit; i++) {
      if (players[i] != null) {
        players[i].rulesBegin();
      }
    }
    for (int i = 0; i < watchedCount; i++) {
      if (isHere(watched[i])) {
        watched[i].rulesBegin(owner(watched[i]));
      }
    }
  }

  /** What is pushed after the physics shows a tick later. */
  private void rulesEnd(boolean early) {
    for (int i = 0; i < playerLimit; i++) {
      if (players[i] != null) {
        players[i].rulesEnd(early ? tick : tick + 1);
      }
    }
    for (int i = 0; i < watchedCount; i++) {
      if (isHere(watched[i])) {
        watched[i].rulesEnd(owner(watched[i]), tick, early);
      }
    }
  }

  /**
   * A 64-bit number of everything that decides the future: tick, world, random numbers, memory,
   * players with score, team, memory and input, entities with kind, owner and tag. Equal runs have
   * equal hashes.
   */
  public long stateHash() {
    long h = mix(world.stateHash(), tick);
    h = mix(h, random.state());
    for (int value : memory) {
      h = mix(h, value);
    }
    for (int i = 0; i < playerLimit; i++) {
      Player p = players[i];
      if (p != null) {
        h = mix(h, ((long) i << 32) | ((p.body == null ? -1 : p.body.id()) & 0xffffffffL));
        h = mix(h, ((long) p.score() << 32) | (p.team() & 0xffffffffL));
        h = mix(h, p.input().pack() | (long) p.viewDelay() << Input.PACKED_BITS);
        for (int value : p.memory()) {
          h = mix(h, value);
        }
      }
    }
    for (int i = 0; i < entityCapacity; i++) {
      Entity e = entities[i];
      long identity = generations[i] & 0xff;
      if (e != null) {
        identity |= (long) (e.archetype().index() + 1) << 8 | (long) (e.ownerId() + 1) << 32;
        h = mix(h, ((long) e.tag() << 32) | (e.bodySlot() & 0xffffffffL));
      }
      h = mix(h, identity);
    }
    return h;
  }

  /**
   * Saves everything that {@link #stateHash} covers, and the handles.
   *
   * @param reuse a state of this simulation to overwrite, or null for a new one
   */
  public SimState save(SimState reuse) {
    SimState s = reuse == null ? new SimState(this) : reuse;
    requireOwn(s);
    s.world = world.save(s.world);
    s.tick = tick;
    s.random = random.state();
    if (s.memory.length != memory.length) {
      s.memory = new int[memory.length];
    }
    System.arraycopy(memory, 0, s.memory, 0, memory.length);
    s.limitPlayers(playerLimit);
    for (int i = 0; i < playerLimit; i++) {
      Player p = players[i];
      s.players[i] = p;
      if (p != null) {
        s.bodies[i] = p.body;
        s.scores[i] = p.score();
        s.teams[i] = p.team();
        s.inputs[i] = p.input().pack();
        s.viewDelays[i] = p.viewDelay();
        System.arraycopy(p.memory(), 0, s.playerMemory, i * Player.MEMORY_SIZE, Player.MEMORY_SIZE);
      }
    }
    if (s.entities.length < generations.length) {
      s.entities = new Entity[generations.length];
      s.tags = new int[generations.length];
      s.teleports = new int[generations.length];
      s.generations = new byte[generations.length];
    }
    Arrays.fill(s.entities, entityCapacity, Math.max(entityCapacity, s.entityCapacity), null);
    s.entityCapacity = entityCapacity;
    s.entityCount = entityCount;
    System.arraycopy(entities, 0, s.entities, 0, entityCapacity);
    System.arraycopy(generations, 0, s.generations, 0, entityCapacity);
    for (int i = 0; i < entityCapacity; i++) {
      s.tags[i] = entities[i] == null ? 0 : entities[i].tag();
      s.teleports[i] = entities[i] == null ? 0 : entities[i].teleports();
    }
    if (history != null) {
      if (s.history == null) {
        s.history = new PoseHistory(this);
      }
      history.copyTo(s.history);
    }
    return s;
  }

  /**
   * Returns to a saved state; going on from there gives the same ticks bit by bit. Entities and
   * players that have gone since are back under their old handles, those that came since are gone.
   *
   * @throws IllegalArgumentException when another simulation made the state
   */
  public void restore(SimState s) {
    requireOwn(s);
    requireQuiet("restore");
    world.restore(s.world);
    tick = s.tick;
    random.state(s.random);
    System.arraycopy(s.memory, 0, memory, 0, memory.length);
    int oldPlayers = playerLimit;
    playerLimit = s.playerLimit;
    for (int i = 0; i < Math.max(oldPlayers, playerLimit); i++) {
      Player p = i < playerLimit ? s.players[i] : null;
      players[i] = p;
      if (p != null) {
        p.body = s.bodies[i];
        p.restore(s.scores[i], s.teams[i], s.inputs[i], s.viewDelays[i]);
        System.arraycopy(s.playerMemory, i * Player.MEMORY_SIZE, p.memory(), 0, Player.MEMORY_SIZE);
      }
    }
    int oldEntities = entityCapacity;
    entityCapacity = s.entityCapacity;
    entityCount = s.entityCount;
    System.arraycopy(s.entities, 0, entities, 0, entityCapacity);
    roster.change();
    Arrays.fill(entities, entityCapacity, Math.max(oldEntities, entityCapacity), null);
    System.arraycopy(s.generations, 0, generations, 0, entityCapacity);
    Arrays.fill(generations, entityCapacity, Math.max(oldEntities, entityCapacity), (byte) 0);
    for (int i = 0; i < entityCapacity; i++) {
      if (entities[i] != null) {
        entities[i].tag(s.tags[i]);
        entities[i].teleports(s.teleports[i]);
      }
    }
    firstFree = 0;
    if (history != null) {
      s.history.copyTo(history);
    }
  }

  /**
   * Reads a state that {@link SimState#write} has written, of the same level, game and tick rate,
   * to be taken over by {@link #restore}; this simulation isn't touched. Entities and players that
   * are here already keep their objects. Trusts nothing, see {@link World#read}.
   *
   * @param archive read to its end
   * @return the state, of this simulation
   * @throws carom.physics.archive.ArchiveException if the bytes are damaged or belong elsewhere
   */
  public SimState read(ArchiveReader archive) {
    return SimState.read(this, archive);
  }

  /** Whether the past is remembered. */
  boolean looksBack() {
    return history != null;
  }

  void requireAuthority(String what) {
    if (role != Role.AUTHORITY) {
      throw new IllegalStateException(what + " is for the AUTHORITY role only, this is " + role);
    }
    requireQuiet(what);
  }

  private void requirePrediction(String what) {
    if (role != Role.PREDICTION) {
      throw new IllegalStateException(what + " is for the PREDICTION role only, this is " + role);
    }
    requireQuiet(what);
  }

  private void requireQuiet(String what) {
    if (stepping) {
      throw new IllegalStateException(
          what + " can't happen while the physics step; do it in Game.afterStep");
    }
  }

  private void requireOwn(SimState s) {
    if (s.owner != this) {
      throw new IllegalArgumentException("the state belongs to another simulation");
    }
  }

  private Player newPlayer(int id, String name) {
    Player player = new Player(this, id, name);
    players[id] = player;
    playerLimit = Math.max(playerLimit, id + 1);
    return player;
  }

  private Entity add(Entity entity, float x, float y, float angle) {
    ScriptedMotion motion = entity.archetype().motion();
    if (motion == null) {
      embody(entity, x, y, angle);
    } else {
      embody(entity, motion.x(tick, tickRate), motion.y(tick, tickRate), angle);
    }
    return enlist(entity);
  }

  private Entity enlist(Entity entity) {
    int id = entity.id();
    entities[id] = entity;
    roster.change();
    generations[id] = (byte) entity.generation();
    entityCapacity = Math.max(entityCapacity, id + 1);
    entityCount++;
    Player owner = player(entity.ownerId());
    if (owner != null && owner.body == null) {
      owner.body = entity;
    }
    return entity;
  }

  /** Makes the body. Players' bodies never sleep: what games decide about them changes any time. */
  private Entity embody(Entity entity, float x, float y, float angle) {
    BodyDef body = entity.archetype().body(x, y, angle);
    body.sleepAllowed(entity.ownerId() == Entity.NO_OWNER);
    entity.body(world.createBody(body, entity));
    return entity;
  }

  private void grow(int id) {
    if (id >= entities.length) {
      int size = Math.min(MAX_ENTITIES, Math.max(id + 1, entities.length * 2));
      entities = Arrays.copyOf(entities, size);
      generations = Arrays.copyOf(generations, size);
    }
  }

  /**
   * Puts every body with a path where the path was a tick ago, to the bit, and gives it the
   * velocity that takes it on: a client that knows the tick computes the same.
   */
  private void movePaths() {
    for (int i = 0; i < entityCapacity; i++) {
      Entity e = entities[i];
      if (e == null || e.archetype().motion() == null) {
        continue;
      }
      ScriptedMotion m = e.archetype().motion();
      Body<Entity> body = e.body();
      float x = m.x(tick - 1, tickRate);
      float y = m.y(tick - 1, tickRate);
      if (body.x() != x || body.y() != y) {
        body.setPose(x, y, body.cos(), body.sin());
      }
      body.setVelocity((m.x(tick, tickRate) - x) * tickRate, (m.y(tick, tickRate) - y) * tickRate);
    }
  }

  private static long mix(long hash, long value) {
    return SimRandom.mix(hash * 0x9e3779b97f4a7c15L ^ value);
  }

  private final class Listener implements CollisionListener<Entity> {
    @Override
    public boolean preSolve(Collision<Entity> c) {
      return game.collision(Simulation.this, c);
    }

    @Override
    public void hit(Collision<Entity> c) {
      game.hit(Simulation.this, c);
    }
  }
}
