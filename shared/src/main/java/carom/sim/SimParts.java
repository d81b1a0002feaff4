package carom.sim;

import carom.physics.Body;
import carom.physics.World;
import carom.physics.WorldDef;
import carom.physics.math.SimRandom;
import carom.sim.entity.AreaForces;
import carom.sim.entity.Assemblies;
import carom.sim.entity.EntityTable;
import carom.sim.entity.HostEntity;
import carom.sim.entity.HostPlayer;
import carom.sim.entity.JointTable;
import carom.sim.entity.PlayerTable;
import carom.sim.entity.PoseHistory;
import carom.sim.event.EventKinds;
import carom.sim.field.FieldStore;
import carom.sim.field.FieldValues;
import carom.sim.field.Schema;
import carom.sim.field.Scope;
import carom.sim.level.Archetype;
import carom.sim.level.Archetypes;
import carom.sim.level.Level;
import carom.sim.level.LevelJoint;
import carom.sim.message.MessageKinds;
import carom.sim.message.WaitingMessages;
import carom.sim.phase.Findings;
import carom.sim.phase.Phases;
import carom.sim.pool.PoolDef;
import carom.sim.pool.Pools;
import carom.sim.ruling.InterferenceLog;
import carom.sim.ruling.Rulings;
import carom.sim.spawn.OwnSpawns;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;

/**
 * The parts of a simulation: its state, and what it was made with.
 *
 * <pre>
 *   Simulation, the face ──► Tick, Participants, Mirror ──► Spawner ──► SimParts
 *         └────────────────► SimState, Outbox
 * </pre>
 *
 * <p>Each of these does one thing with the parts. They see what is right of them and never each
 * other.
 */
final class SimParts {
  final Game game;
  final Level level;
  final int tickRate;
  final Role role;
  final Phases<HostPlayer> phases;
  final WorldDef worldDef;
  final World<HostEntity> world;

  final Archetypes archetypes = new Archetypes();
  final Assemblies assemblies = new Assemblies(archetypes);
  final EventKinds eventKinds = new EventKinds();
  final MessageKinds messageKinds = new MessageKinds();
  final SimRandom random;
  final AreaForces<HostEntity> areas;
  final JointTable<HostEntity> joints;
  final EntityTable entities;
  final PlayerTable players;
  final FieldStore fields;
  final FieldValues match;
  final AllFields allFields;
  final Pools pools;
  final WaitingMessages received = new WaitingMessages();

  /** The static geometry of the level, in file order. */
  final List<HostEntity> statics = new ArrayList<>();

  /** Past poses on AUTHORITY if the game looks back; otherwise null. */
  final PoseHistory<HostEntity> history;

  final Findings findings = new Findings();
  final InterferenceLog interference;

  /** The rules of the game that clients run; null if it has none on this level. */
  final Consumer<Rules> rules;

  /** True if there are rules that clients run: the game has some, or the level has triggers. */
  final boolean hasRules;

  /** Fields of the match in which these rules keep what they remember. */
  final RuleWords ruleWords;

  /** The bodies that these rules move; null until the step is made. */
  RuleMoves moves;

  /** Counts of what is in sensors that these rules ask about; null until the step is made. */
  SensorCounts inside;

  /**
   * The visits of entities to sensors; null on PREDICTION without triggers of the level, and until
   * the step is made.
   */
  Triggers triggers;

  /** Answers about the level's sensors; null until the level is built. */
  LevelSensors sensors;

  /** The tick of the present state, or during a step the tick being computed. */
  int tick;

  /** Receive what enters. */
  final Journals journals = new Journals();

  /** The client's knowledge of the server's rules, on PREDICTION; may be null. */
  Rulings rulings;

  /** The client's knowledge of the entities that the own player's input spawned, on PREDICTION. */
  OwnSpawns ownSpawns;

  /** Creates the parts of a simulation whose world is empty. */
  SimParts(Game game, Level level, long seed, int tickRate, Role role) {
    this.game = game;
    this.level = level;
    this.tickRate = tickRate;
    this.role = role;
    boolean decides = role == Role.AUTHORITY;
    phases = new Phases<>(decides);
    random = new SimRandom(seed);
    worldDef = game.world(level);
    world = new World<>(worldDef);
    areas =
        new AreaForces<>(
            world, level.areas(), (carrier, power) -> carrier.user().get(power), decides);
    rules = game.rules(level);
    hasRules = rules != null || !level.triggers().isEmpty();
    ruleWords = RuleWords.of(level, rules != null);
    Schema schema = SimulationHost.schemaOf(game, level);
    joints = new JointTable<>(world, decides);
    entities =
        new EntityTable(
            world, areas, assemblies, joints, tickRate, schema, archetypes, phases, () -> tick);
    players = entities.players();
    fields = entities.fields();
    match = fields.create(Scope.MATCH);
    allFields = new AllFields(match, entities);
    interference = new InterferenceLog(entities, phases, joints::key, findings, () -> tick);
    if (decides) {
      fields.noteUse(findings, allFields::nameOf);
      interference.listen();
    }
    history = decides && game.looksBack() ? newHistory() : null;
    pools = new Pools(tickRate, decides);
    level.archetypes().forEach(archetypes::add);
  }

  /** Creates what the level file places; on PREDICTION its static geometry and pools only. */
  void buildLevel() {
    for (Level.Placement p : level.statics()) {
      statics.add(entities.createStatic(archetypes.get(p.archetype()), p));
    }
    if (role == Role.AUTHORITY) {
      for (Level.Placement p : level.bodies()) {
        entities.spawn(
            archetypes.get(p.archetype()), p.x(), p.y(), p.angle(), HostEntity.NO_OWNER, tick);
      }
      connectLevel();
    }
    sensors = new LevelSensors(world, level, archetypes);
    for (PoolDef def : level.pools()) {
      pools.add(def);
    }
  }

  /** Makes the level's joints, which so get the first indices in file order. */
  private void connectLevel() {
    for (int i = 0; i < level.joints().size(); i++) {
      LevelJoint joint = level.joints().get(i);
      Body<HostEntity> a = body(joint.a());
      joints.create(0, JointTable.LEVEL, i, a, body(joint.b()), joint.definition(), 0);
    }
  }

  private Body<HostEntity> body(int end) {
    if (end == LevelJoint.GROUND) {
      return null;
    }
    return (end < 0 ? statics.get(~end) : entities.get(end)).body();
  }

  /** Returns a body of the level by its number, or null if it is gone or not predicted here. */
  HostEntity levelBody(int number) {
    HostEntity entity = entities.get(number);
    return entity == null || entity.generation() != 0 ? null : entity;
  }

  /**
   * Ends the declarations of the game's set-up.
   *
   * @throws IllegalArgumentException if they don't fit together
   */
  void closeDeclarations() {
    PoolGround.begin(pools, worldDef, level, archetypes, tickRate);
    archetypes.close();
    entities.checkFields(archetypes);
    eventKinds.close();
    messageKinds.close();
    phases.endStep();
  }

  /** Creates an empty history of the bodies. */
  PoseHistory<HostEntity> newHistory() {
    return new PoseHistory<>(world, entities, tickRate);
  }

  /** Remembers the present poses, if past ones are asked for. */
  void capturePoses() {
    if (history != null) {
      history.capture(tick);
    }
  }

  /**
   * Returns an archetype by its name.
   *
   * @throws IllegalArgumentException if there is none
   */
  Archetype archetype(String name) {
    Archetype found = archetypes.find(name);
    if (found == null) {
      throw new IllegalArgumentException(
          "archetype=\"" + name + "\" is neither in the level nor registered in Game.setUp");
    }
    return found;
  }

  /** Returns 64 bits of everything that decides the future. */
  long hash() {
    long h = SimRandom.mix(world.stateHash(), tick);
    h = SimRandom.mix(h, random.state());
    h = pools.count() == 0 ? h : SimRandom.mix(h, pools.stateHash());
    return joints.hash(entities.hash(players.hash(match.hash(h))));
  }
}
