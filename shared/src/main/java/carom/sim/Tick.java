package carom.sim;

import carom.physics.Body;
import carom.physics.Collision;
import carom.physics.CollisionListener;
import carom.physics.Joint;
import carom.physics.JointListener;
import carom.physics.QueryFilter;
import carom.physics.math.Aabb;
import carom.sim.entity.Contact;
import carom.sim.entity.HostEntity;
import carom.sim.entity.HostPlayer;
import carom.sim.field.FieldStore;
import carom.sim.level.Archetype;
import carom.sim.message.Message;
import carom.sim.message.WaitingMessages;
import carom.sim.phase.Phase;
import carom.sim.phase.Phases;
import carom.sim.pool.Pools;
import java.util.function.Consumer;

/**
 * One step of a simulation: which of the game's methods are called when, on which side, and what
 * each of them may do meanwhile.
 *
 * <pre>
 *   AUTHORITY    paths  message  beforeStep   input...  rules  forces...  physics  entered, left  level's triggers  afterStep
 *   PREDICTION   paths  rulings of the server input...  rules  forces...  physics  level's triggers  rulings
 *                                                                         └ collision, hit, broke
 * </pre>
 *
 * <p>It allocates nothing of its own.
 */
final class Tick {
  private final SimulationHost simulation;
  private final SimParts parts;
  private final Game game;
  private final Phases<HostPlayer> phases;
  private final FieldStore fields;
  private final Pools pools;
  private final float seconds;
  private final Contact contact = new Contact();
  private final ForceCheck forceCheck;
  private final OverlapUse overlapUse;
  private final Aabb moving = new Aabb();
  private final QueryFilter<HostEntity> geometry = (body, shape) -> body.user().isLevel();
  private final Consumer<Body<HostEntity>> forces = this::applyForces;
  private final WaitingMessages.Reader handleMessage = this::handle;

  /** The triggers of the level; null if there are none. */
  private final LevelRules levelRules;

  /** The phases of the match, or null if the game has none. */
  private MatchClock clock;

  /** Creates the step of a simulation, and listens to what its world tells from now on. */
  Tick(SimulationHost simulation, SimParts parts) {
    this.simulation = simulation;
    this.parts = parts;
    game = parts.game;
    phases = parts.phases;
    fields = parts.fields;
    pools = parts.pools;
    seconds = 1f / parts.tickRate;
    forceCheck = new ForceCheck(parts.world, parts.findings);
    overlapUse = new OverlapUse(phases, parts.findings);
    parts.moves = new RuleMoves(simulation, parts);
    parts.inside = new SensorCounts(simulation, parts);
    levelRules = parts.level.triggers().isEmpty() ? null : new LevelRules(simulation, parts);
    boolean decides = parts.role == Role.AUTHORITY;
    if (decides || levelRules != null) {
      parts.triggers = new Triggers(parts.entities, parts.statics, new Visits());
    }
    if (decides) {
      parts.entities.overlapReader(overlapUse::read);
    }
    parts.world.listener(new Collisions());
    parts.world.jointListener(new Joints());
  }

  /** Begins the match's phases and the level's triggers, if any; once, after the set-up. */
  void begin() {
    parts.inside.begin();
    if (levelRules != null) {
      levelRules.begin();
    }
    clock = game.clock();
    if (clock != null) {
      clock.setUp(simulation, parts.tickRate);
    }
  }

  /** Computes the tick after the present one. */
  void step() {
    parts.journals.stepping(simulation);
    parts.tick++;
    phases.beginStep();
    try {
      compute();
      parts.players.endTick();
    } finally {
      phases.endStep();
    }
    parts.capturePoses();
    parts.journals.stepped(simulation);
  }

  private void compute() {
    parts.entities.followPaths(parts.tick);
    ruleBeforeStep();
    for (int i = 0; i < parts.players.limit(); i++) {
      HostPlayer player = parts.players.get(i);
      if (player != null && player.isAlive()) {
        takeInput(player);
      }
    }
    if (parts.hasRules) {
      applyRules();
    }
    applyForces();
    if (parts.triggers != null) {
      parts.triggers.settle();
    }
    Phase outer = phases.begin(Phase.PHYSICS);
    parts.world.step(seconds);
    phases.end(outer);
    ruleAfterStep();
  }

  /** Lets what moves go on, and the game's rules that clients run, too. */
  private void applyRules() {
    Phase outer = phases.begin(Phase.RULES);
    parts.moves.drive();
    if (parts.rules != null) {
      parts.world.queryScope(geometry);
      try {
        parts.rules.accept(simulation);
      } finally {
        parts.world.queryScope(null);
      }
    }
    phases.end(outer);
  }

  private void ruleBeforeStep() {
    if (parts.role == Role.AUTHORITY) {
      Phase outer = phases.begin(Phase.MESSAGE);
      parts.received.forEach(handleMessage);
      parts.received.clear();
      phases.end(outer);
      outer = phases.begin(Phase.BEFORE_STEP);
      if (clock != null) {
        followClock();
      }
      game.beforeStep(simulation);
      phases.end(outer);
    } else if (parts.rulings != null) {
      parts.rulings.beforeStep();
    }
  }

  /** Tells the game of the phase that begins, and asks for the next match when this one is done. */
  private void followClock() {
    MatchPhase begins = clock.beforeStep(simulation, parts.players, parts.tickRate);
    if (begins != null) {
      game.phase(simulation, begins);
    }
    if (clock.isDone(simulation, parts.players)) {
      simulation.playNext(game.next(simulation));
    }
  }

  private void ruleAfterStep() {
    if (parts.role == Role.AUTHORITY) {
      Phase outer = phases.begin(Phase.AFTER_STEP);
      count();
      parts.triggers.tell();
      runTriggers();
      game.afterStep(simulation);
      parts.triggers.tell();
      phases.end(outer);
      return;
    }
    count();
    if (levelRules != null) {
      parts.triggers.tell();
      runTriggers();
      parts.triggers.tell();
    }
    if (parts.rulings != null) {
      parts.rulings.afterStep();
    }
  }

  private void count() {
    if (parts.hasRules) {
      Phase outer = phases.begin(Phase.TRIGGERS);
      parts.inside.count();
      phases.end(outer);
    }
  }

  private void runTriggers() {
    if (levelRules != null) {
      Phase outer = phases.begin(Phase.TRIGGERS);
      levelRules.run();
      phases.end(outer);
    }
  }

  private void handle(int playerId, Message message) {
    HostPlayer player = parts.players.participant(playerId);
    if (player != null) { // one handled before may have removed it
      BuiltInMessages.handle(simulation, player, message);
    }
  }

  private void takeInput(HostPlayer player) {
    if (parts.rulings != null && parts.rulings.input(player)) {
      return;
    }
    Phase outer = phases.beginInput(player);
    game.input(simulation, player, player.input());
    phases.end(outer);
    if (parts.rulings != null && fields.hasReadHidden()) {
      parts.rulings.readHidden(player, fields.hasReadUntold());
    }
  }

  /** Lets areas, pools and the game's forces act on each awake body. */
  private void applyForces() {
    boolean decides = parts.role == Role.AUTHORITY;
    parts.areas.begin();
    if (decides) {
      pools.step(parts.tick);
    }
    for (int i = 0; i < pools.count(); i++) {
      if (pools.readMoving(i, parts.tick, moving)) {
        parts.areas.wake(moving);
      }
    }
    forceCheck.beginTick(decides ? parts.tick : 1);
    Phase outer = phases.begin(Phase.FORCES);
    parts.world.queryScope(geometry);
    try {
      parts.world.forEachAwake(forces);
    } finally {
      parts.world.queryScope(null);
    }
    phases.end(outer);
    if (decides) {
      pools.close();
    }
  }

  private void applyForces(Body<HostEntity> body) {
    HostEntity entity = body.user();
    Archetype kind = entity.archetype();
    parts.areas.act(body, kind, seconds);
    if (!kind.sensor()) {
      pools.act(parts.world, body, parts.tick, kind.index(), kind.shapes(), kind.reach());
    }
    forceCheck.begin(body);
    game.forces(simulation, entity);
    forceCheck.end(body, parts.tick);
  }

  private final class Visits implements Triggers.Listener {
    @Override
    public void entered(HostEntity sensor, HostEntity visitor) {
      tell(Phase.ENTERED, sensor, visitor);
    }

    @Override
    public void left(HostEntity sensor, HostEntity visitor) {
      tell(Phase.LEFT, sensor, visitor);
    }

    private void tell(Phase phase, HostEntity sensor, HostEntity visitor) {
      if (levelRules != null) {
        Phase outer = phases.begin(Phase.TRIGGERS);
        levelRules.visit(phase == Phase.ENTERED, sensor, visitor);
        phases.end(outer);
      }
      if (parts.role == Role.PREDICTION) {
        return;
      }
      Phase outer = phases.begin(phase);
      try { // no step may run, which would end it
        if (phase == Phase.ENTERED) {
          game.entered(simulation, sensor, visitor);
        } else {
          game.left(simulation, sensor, visitor);
        }
      } finally {
        phases.end(outer);
      }
    }
  }

  private final class Collisions implements CollisionListener<HostEntity> {
    @Override
    public void begin(Collision<HostEntity> c) {
      if (parts.triggers != null) {
        parts.triggers.begin(c);
      }
    }

    @Override
    public void end(Collision<HostEntity> c) {
      if (parts.triggers != null) {
        parts.triggers.end(c);
      }
    }

    @Override
    public boolean preSolve(Collision<HostEntity> c) {
      Phase outer = phases.begin(Phase.COLLISION);
      boolean responds = game.collision(simulation, contact.of(c));
      phases.end(outer);
      return responds;
    }

    @Override
    public void hit(Collision<HostEntity> c) {
      if (levelRules != null) {
        levelRules.hit(c);
      }
      game.hit(simulation, contact.of(c));
    }
  }

  private final class Joints implements JointListener<HostEntity> {
    @Override
    public void broke(Joint<HostEntity> joint) {
      game.broke(simulation, parts.entities.face(joint));
    }

    @Override
    public void created(Joint<HostEntity> joint) {
      parts.joints.created(joint);
    }

    @Override
    public void destroyed(Joint<HostEntity> joint) {
      parts.joints.destroyed();
    }
  }
}
