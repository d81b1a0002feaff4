package carom.sim;

import carom.physics.Body;
import carom.physics.Collision;
import carom.physics.CollisionListener;
import carom.physics.Joint;
import carom.physics.JointListener;
import carom.physics.QueryFilter;
import carom.physics.math.Aabb;
import carom.sim.entity.CallRules;
import carom.sim.entity.Contact;
import carom.sim.entity.HostEntity;
import carom.sim.entity.HostPlayer;
import carom.sim.field.FieldStore;
import carom.sim.level.Archetype;
import carom.sim.match.MatchClock;
import carom.sim.match.MatchPhase;
import carom.sim.message.Message;
import carom.sim.message.WaitingMessages;
import carom.sim.pool.Pools;
import carom.sim.ruling.ForceCheck;
import carom.sim.trigger.OverlapUse;
import carom.sim.trigger.Triggers;
import java.util.function.Consumer;

/**
 * One step of a simulation: which of the game's methods are called when, on which side, and what
 * each of them may do meanwhile.
 *
 * <pre>
 *   AUTHORITY    paths  message  beforeStep   input...  forces...  physics  entered, left  afterStep
 *   PREDICTION   paths  rulings of the server input...  forces...  physics  rulings
 *                                                                  └ collision, hit, broke
 * </pre>
 *
 * <p>It allocates nothing of its own.
 */
final class Tick {
  private final SimulationHost simulation;
  private final SimParts parts;
  private final Spawner spawner;
  private final Game game;
  private final CallRules calls;
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

  /** The phases of the match, or null if the game has none. */
  private MatchClock clock;

  /** Creates the step of a simulation, and listens to what its world tells from now on. */
  Tick(SimulationHost simulation, SimParts parts, Spawner spawner) {
    this.simulation = simulation;
    this.parts = parts;
    this.spawner = spawner;
    game = parts.game;
    calls = parts.calls;
    fields = parts.fields;
    pools = parts.pools;
    seconds = 1f / parts.tickRate;
    forceCheck = new ForceCheck(parts.world, parts.findings);
    overlapUse = new OverlapUse(parts.findings);
    if (parts.role == Role.AUTHORITY) {
      parts.triggers = new Triggers(parts.entities, parts.statics, new Visits());
      parts.entities.overlapReader(overlapUse::read);
    }
    parts.world.listener(new Collisions());
    parts.world.jointListener(new Joints());
  }

  /** Begins the match's phases, if it has any; once, after the game's set-up. */
  void beginClock() {
    clock = game.clock();
    if (clock != null) {
      clock.setUp(simulation, parts.tickRate);
    }
  }

  /** Computes the tick after the present one. */
  void step() {
    parts.journals.stepping(simulation);
    parts.tick++;
    parts.inTick = true;
    try {
      compute();
      parts.players.endTick();
    } finally {
      parts.inTick = false;
      fields.end();
    }
    parts.capturePoses();
    parts.journals.stepped(simulation);
  }

  private void compute() {
    parts.entities.followPaths(parts.tick);
    ruleBeforeStep();
    parts.interference.beginInputs();
    for (int i = 0; i < parts.players.limit(); i++) {
      HostPlayer player = parts.players.get(i);
      if (player != null && player.isAlive()) {
        takeInput(player);
      }
    }
    fields.end();
    applyForces();
    if (parts.triggers != null) {
      parts.triggers.settle();
    }
    during("hit");
    calls.inPhysics(true);
    try {
      parts.world.step(seconds);
    } finally {
      calls.inPhysics(false);
    }
    ruleAfterStep();
  }

  private void ruleBeforeStep() {
    if (parts.role == Role.AUTHORITY) {
      parts.interference.beginRules();
      during("message");
      parts.received.forEach(handleMessage);
      parts.received.clear();
      during("beforeStep");
      if (clock != null) {
        followClock();
      }
      game.beforeStep(simulation);
      parts.interference.endRulesBeforeStep(parts.tick);
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
      simulation.playNext(clock.next());
    }
  }

  private void ruleAfterStep() {
    if (parts.role == Role.AUTHORITY) {
      parts.interference.beginRules();
      parts.triggers.tell();
      during("afterStep");
      game.afterStep(simulation);
      parts.triggers.tell();
      during("a callback between two steps");
      parts.interference.endRulesAfterStep(parts.tick);
    } else if (parts.rulings != null) {
      parts.rulings.afterStep();
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
    fields.beginInput(player, player.fieldValues(), player.entity().fieldValues());
    calls.inInput(true);
    overlapUse.inputOf(player);
    spawner.beginInput(player);
    try {
      game.input(simulation, player, player.input());
    } finally {
      spawner.endInput();
      overlapUse.inputOf(null);
      calls.inInput(false);
    }
    if (parts.role == Role.PREDICTION) {
      spawner.dropUnpredicted(player);
    }
    if (fields.hasReadHidden() && parts.rulings != null) {
      parts.rulings.readHidden(player, fields.hasReadUntold());
    } else if (fields.hasReadHidden()) {
      parts.interference.endInput(player, parts.tick, fields);
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
    calls.inForces(true);
    fields.beginForces();
    queryScope(geometry);
    try {
      parts.world.forEachAwake(forces);
    } finally {
      queryScope(null);
      fields.end();
      calls.inForces(false);
    }
    if (decides) {
      pools.close();
    }
  }

  private void queryScope(QueryFilter<HostEntity> scope) {
    parts.world.queryScope(scope);
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

  /** Names the method of the game that runs from now on, for advice to its developer. */
  private void during(String callback) {
    if (parts.fieldUse != null) {
      parts.fieldUse.during(callback);
    }
  }

  private final class Visits implements Triggers.Listener {
    @Override
    public void entered(HostEntity sensor, HostEntity visitor) {
      during("entered");
      game.entered(simulation, sensor, visitor);
    }

    @Override
    public void left(HostEntity sensor, HostEntity visitor) {
      during("left");
      game.left(simulation, sensor, visitor);
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
      fields.beginCollision();
      boolean responds = game.collision(simulation, contact.of(c));
      fields.end();
      return responds;
    }

    @Override
    public void hit(Collision<HostEntity> c) {
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
