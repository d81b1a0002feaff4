package carom.sim;

import carom.physics.Body;
import carom.physics.BodyVisitor;
import carom.physics.Collision;
import carom.sim.entity.HostEntity;
import carom.sim.entity.HostPlayer;
import carom.sim.event.Audience;
import carom.sim.event.EventKind;
import carom.sim.field.Count;
import carom.sim.field.Countdown;
import carom.sim.field.EntityRef;
import carom.sim.field.Field;
import carom.sim.field.FieldHolder;
import carom.sim.field.Flag;
import carom.sim.field.FloatField;
import carom.sim.field.IntField;
import carom.sim.field.Real;
import carom.sim.field.Schema;
import carom.sim.field.Scope;
import carom.sim.level.Archetype;
import carom.sim.level.Level;
import carom.sim.level.LevelTrigger;
import carom.sim.level.LevelTrigger.Action;
import carom.sim.level.LevelTrigger.Condition;
import carom.sim.level.LevelTrigger.Verb;
import carom.sim.outbox.Event;
import carom.sim.outbox.NextMatch;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * Runs the triggers of a level, on {@code AUTHORITY} only. What it remembers from tick to tick is
 * in fields of the match, so that it is saved, restored and hashed with them.
 *
 * <p>Conditions that happen at a moment (enter, leave, hit) are asked at each such moment. The
 * others are asked once a tick, and what they do follows from the difference to the tick before.
 */
final class LevelRules {
  /** Bits of {@link #STATE}. */
  private static final int HELD = 1;

  private static final int FIRED = 2;
  private static final int SWITCHED = 4;
  private static final int DUE_ELSE = 8;

  private static final Count STATE =
      Field.count("triggerState", 0, 15)
          .of(Scope.MATCH)
          .to(Audience.NOBODY)
          .times(LevelTrigger.MAX);

  /** The tick at which what waits happens; 0 for nothing. */
  private static final Count DUE = ticks("triggerDue", LevelTrigger.MAX);

  /** The tick at which what repeats happens again. */
  private static final Count AGAIN = ticks("triggerAgain", LevelTrigger.MAX);

  /** The entity that set off what waits. */
  private static final EntityRef BY =
      Field.entity("triggerBy").of(Scope.MATCH).to(Audience.NOBODY).times(LevelTrigger.MAX);

  /** The tick at which a body that moves is there; 0 for one that stays. */
  private static final Count UNTIL = ticks("triggerMoveUntil", LevelTrigger.MAX_MOVED);

  private static final Real TO_X = place("triggerMoveX");
  private static final Real TO_Y = place("triggerMoveY");

  /** The fields of a match whose level has triggers. */
  static final List<Field<?>> FIELDS = List.of(STATE, DUE, AGAIN, BY, UNTIL, TO_X, TO_Y);

  /** Difference of velocities, m/s, below which a body that moves keeps its own. */
  private static final float SAME_VELOCITY = 1e-3f;

  /** The highest speed of a body that moves, m/s along an axis; what needs more comes later. */
  private static final float MAX_SPEED = 500;

  /** A condition with what its names mean here. */
  private record Node(
      Condition condition,
      List<HostEntity> statics,
      List<Integer> bodies,
      Field<?> field,
      List<Node> parts) {}

  /** An action with what its names mean here. */
  private record Act(Action action, Archetype archetype, Field<?> field, EventKind event, int to) {}

  private record Rule(LevelTrigger trigger, Node when, List<Act> then, List<Act> otherwise) {}

  private final SimulationHost simulation;
  private final SimParts parts;
  private final List<Rule> rules = new ArrayList<>();

  /** Numbers in {@link Level#bodies} of the bodies that are moved. */
  private final List<Integer> moved = new ArrayList<>();

  // Hits of the tick that is computed; nothing is left of them between two ticks.
  private int hits;
  private HostEntity[] hitPairs = new HostEntity[32];
  private float[] impulses = new float[16];

  // The moment that is looked at: its cause, and two entities.
  private LevelTrigger.Cause moment;
  private HostEntity first;
  private HostEntity second;
  private float impulse;

  // Scratch of a question.
  private HostEntity visitor;
  private LevelTrigger.Who who = LevelTrigger.Who.ANY;
  private int inside;
  private final BodyVisitor<HostEntity> count = this::count;

  LevelRules(SimulationHost simulation, SimParts parts) {
    this.simulation = simulation;
    this.parts = parts;
  }

  private static Count ticks(String name, int times) {
    return Field.count(name, 0, Integer.MAX_VALUE).of(Scope.MATCH).to(Audience.NOBODY).times(times);
  }

  private static Real place(String name) {
    return Field.real(name).of(Scope.MATCH).to(Audience.NOBODY).times(LevelTrigger.MAX_MOVED);
  }

  // ---- what names mean

  /**
   * Looks up what the triggers name, after the game's set-up.
   *
   * @throws IllegalArgumentException if the game lacks it; the message names the place in the file
   */
  void begin() {
    for (LevelTrigger trigger : parts.level.triggers()) {
      rules.add(
          new Rule(trigger, node(trigger.when()), acts(trigger.then()), acts(trigger.otherwise())));
    }
  }

  private Node node(Condition c) {
    List<HostEntity> statics = new ArrayList<>();
    List<Integer> bodies = new ArrayList<>();
    if (c.cause() == LevelTrigger.Cause.INSIDE) {
      for (HostEntity entity : parts.statics) {
        if (isSensor(entity, c.name())) {
          statics.add(entity);
        }
      }
      for (int i = 0; i < parts.level.bodies().size(); i++) {
        int archetype = parts.level.bodies().get(i).archetype();
        if (parts.archetypes.get(archetype).name().equals(c.name())) {
          bodies.add(i);
        }
      }
    }
    Field<?> field = null;
    if (c.cause() == LevelTrigger.Cause.FIELD) {
      field = field(c.where() + ".field", c.name());
      if (!(field instanceof IntField || field instanceof FloatField || field instanceof Flag)) {
        throw new IllegalArgumentException(
            c.where() + ".field is \"" + field + "\"; triggers compare numbers, times and flags");
      }
    }
    List<Node> nodes = new ArrayList<>();
    for (Condition part : c.parts()) {
      nodes.add(node(part));
    }
    return new Node(c, statics, bodies, field, nodes);
  }

  private List<Act> acts(List<Action> actions) {
    List<Act> acts = new ArrayList<>();
    for (Action a : actions) {
      acts.add(
          switch (a.verb()) {
            case MOVE -> new Act(a, null, null, null, movedIndex(a.body()));
            case SPAWN -> new Act(a, archetype(a), null, null, 0);
            case SET, ADD -> new Act(a, null, writable(a), null, 0);
            case EVENT -> new Act(a, null, null, event(a), 0);
            case ENABLE, DISABLE -> new Act(a, null, null, null, trigger(a.name()));
            default -> new Act(a, null, null, null, 0);
          });
    }
    return acts;
  }

  private int movedIndex(int body) {
    if (!moved.contains(body)) {
      moved.add(body);
    }
    return moved.indexOf(body);
  }

  private Archetype archetype(Action a) {
    Archetype found = parts.archetypes.find(a.name());
    if (found == null) {
      List<String> known = new ArrayList<>();
      for (int i = 0; i < parts.archetypes.size(); i++) {
        known.add(parts.archetypes.get(i).name());
      }
      throw unknown(a, "an archetype of the level or of its game", known);
    }
    if (found.motion() != null) {
      throw new IllegalArgumentException(
          a.where() + "=\"" + a.name() + "\" has a \"motion\", which belongs to one body only");
    }
    return found;
  }

  private EventKind event(Action a) {
    List<String> known = new ArrayList<>();
    for (int i = 0; i < parts.eventKinds.size(); i++) {
      if (parts.eventKinds.get(i).name().equals(a.name())) {
        return parts.eventKinds.get(i);
      }
      known.add(parts.eventKinds.get(i).name());
    }
    throw unknown(a, "an event of the game", known);
  }

  private static IllegalArgumentException unknown(Action a, String what, List<String> known) {
    return LevelTrigger.unknown(a.where(), a.name(), what, known);
  }

  private int trigger(String name) {
    int at = 0;
    while (!parts.level.triggers().get(at).name().equals(name)) {
      at++;
    }
    return at;
  }

  private Field<?> writable(Action a) {
    Field<?> field = field(a.where(), a.name());
    boolean isNumber =
        (field instanceof IntField && !(field instanceof Countdown)) || field instanceof FloatField;
    if (!isNumber && !(a.verb() == Verb.SET && field instanceof Flag)) {
      throw new IllegalArgumentException(
          a.where() + " is \"" + field + "\"; triggers set numbers and flags, and add to numbers");
    }
    if (a.verb() == Verb.SET) {
      try {
        field.startsFrom(a.value());
      } catch (IllegalArgumentException e) {
        throw new IllegalArgumentException(a.where() + ": " + e.getMessage(), e);
      }
    } else if (field instanceof IntField && a.amount() != Math.rint(a.amount())) {
      throw new IllegalArgumentException(
          a.where() + ": by=" + a.amount() + " must be a whole number, because \"" + field + "\"");
    }
    return field;
  }

  private Field<?> field(String where, String path) {
    Scope scope = path.startsWith("player.") ? Scope.PLAYER : Scope.MATCH;
    Schema schema = parts.fields.schema();
    String name = path.substring(path.indexOf('.') + 1);
    Field<?> field = schema.find(scope, name);
    if (field != null && field.times() == 1 && !FIELDS.contains(field)) {
      return field;
    }
    List<String> known = new ArrayList<>();
    for (Field<?> other : schema.fields()) {
      if (other.scope() == scope && other.times() == 1 && !FIELDS.contains(other)) {
        known.add(other.path());
      }
    }
    throw LevelTrigger.unknown(where, path, "a field of the game with one value", known);
  }

  // ---- moments

  /** Receives that an entity entered a sensor, or left it. Either may be despawned. */
  void visit(boolean enters, HostEntity sensor, HostEntity guest) {
    if (guest.isLevel()) {
      return;
    }
    happen(enters ? LevelTrigger.Cause.ENTER : LevelTrigger.Cause.LEAVE, sensor, guest, 0);
  }

  /** Receives an impact, during the physics. */
  void hit(Collision<HostEntity> c) {
    if (hits == impulses.length) {
      impulses = Arrays.copyOf(impulses, 2 * hits);
      hitPairs = Arrays.copyOf(hitPairs, 4 * hits);
    }
    impulses[hits] = c.impulse();
    hitPairs[2 * hits] = c.self().user();
    hitPairs[2 * hits + 1] = c.other().user();
    hits++;
  }

  private void happen(LevelTrigger.Cause cause, HostEntity one, HostEntity other, float force) {
    for (int i = 0; i < rules.size(); i++) {
      Rule rule = rules.get(i);
      if (rule.trigger.when().isEvent() && isEnabled(i)) {
        moment = cause;
        first = one;
        second = other;
        impulse = force;
        visitor = null;
        if (holds(rule.when)) {
          start(i, false, visitor);
        }
      }
    }
    moment = null;
    first = null;
    second = null;
  }

  // ---- each tick

  /** Runs the triggers after the physics of a tick. */
  void run() {
    for (int i = 0; i < hits; i++) {
      happen(LevelTrigger.Cause.HIT, hitPairs[2 * i], hitPairs[2 * i + 1], impulses[i]);
    }
    Arrays.fill(hitPairs, 0, 2 * hits, null);
    hits = 0;
    for (int i = 0; i < rules.size(); i++) {
      int due = simulation.get(DUE, i);
      if (due != 0 && parts.tick >= due) {
        simulation.set(DUE, i, 0);
        perform(i, has(i, DUE_ELSE), (HostEntity) simulation.get(BY, i));
      }
      if (!rules.get(i).trigger.when().isEvent() && isEnabled(i)) {
        follow(i);
      }
    }
    for (int i = 0; i < moved.size(); i++) {
      drive(i);
    }
  }

  private void follow(int i) {
    Rule rule = rules.get(i);
    visitor = null;
    boolean holds = holds(rule.when);
    boolean held = has(i, HELD);
    mark(i, HELD, holds);
    float every = rule.trigger.every();
    if (holds && (!held || (every > 0 && parts.tick >= simulation.get(AGAIN, i)))) {
      simulation.set(AGAIN, i, every > 0 ? parts.tick + simulation.ticks(every) : 0);
      start(i, false, visitor);
    } else if (held && !holds && !rule.otherwise.isEmpty()) {
      start(i, true, null);
    }
  }

  private void start(int i, boolean isElse, HostEntity by) {
    LevelTrigger trigger = rules.get(i).trigger;
    if (trigger.once() && has(i, FIRED)) {
      return;
    }
    mark(i, FIRED, true);
    if (trigger.after() == 0) {
      perform(i, isElse, by);
      return;
    }
    mark(i, DUE_ELSE, isElse);
    simulation.set(DUE, i, parts.tick + simulation.ticks(trigger.after()));
    simulation.set(BY, i, by);
  }

  private boolean isEnabled(int i) {
    return rules.get(i).trigger.enabled() != has(i, SWITCHED);
  }

  private boolean has(int i, int bit) {
    return (simulation.get(STATE, i) & bit) != 0;
  }

  private void mark(int i, int bit, boolean on) {
    int state = simulation.get(STATE, i);
    simulation.set(STATE, i, on ? state | bit : state & ~bit);
  }

  /** Moves a body on. It gets another velocity only where it has to, because clients are told. */
  private void drive(int at) {
    int until = simulation.get(UNTIL, at);
    HostEntity entity = until == 0 ? null : body(moved.get(at));
    if (entity == null) {
      return;
    }
    int left = until - parts.tick;
    float vx = 0;
    float vy = 0;
    if (left > 0) {
      vx = (simulation.get(TO_X, at) - entity.x()) * parts.tickRate / left;
      vy = (simulation.get(TO_Y, at) - entity.y()) * parts.tickRate / left;
    } else {
      simulation.set(UNTIL, at, 0);
    }
    float fastest = Math.max(Math.abs(vx), Math.abs(vy));
    if (fastest > MAX_SPEED) {
      vx *= MAX_SPEED / fastest;
      vy *= MAX_SPEED / fastest;
      simulation.set(UNTIL, at, Math.max(until, parts.tick + 2));
    }
    float difference = Math.abs(vx - entity.velocityX()) + Math.abs(vy - entity.velocityY());
    if (left <= 1 || difference > SAME_VELOCITY) {
      entity.setVelocity(vx, vy);
    }
  }

  // ---- conditions

  private boolean holds(Node node) {
    Condition c = node.condition;
    return switch (c.cause()) {
      case ENTER, LEAVE -> moment == c.cause() && isSensor(first, c.name()) && isBy(c, second);
      case HIT ->
          moment == c.cause()
              && impulse >= c.least()
              && ((isNamed(first, c.name()) && isBy(c, second))
                  || (isNamed(second, c.name()) && isBy(c, first)));
      case INSIDE -> countInside(node) >= c.least();
      case TIMER -> parts.tick >= (c.least() == 0 ? 0 : simulation.ticks((float) c.least()));
      case FIELD -> {
        double value = value(node.field);
        yield value >= c.least() && value <= c.most();
      }
      case SCORE -> hasScore(c.least());
      case ALL -> {
        boolean all = true;
        for (int i = 0; i < node.parts.size() && all; i++) {
          all = holds(node.parts.get(i));
        }
        yield all;
      }
      case ANY -> {
        boolean any = false;
        for (int i = 0; i < node.parts.size() && !any; i++) {
          any = holds(node.parts.get(i));
        }
        yield any;
      }
    };
  }

  private static boolean isNamed(HostEntity entity, String name) {
    return entity.archetype().name().equals(name);
  }

  private static boolean isSensor(HostEntity entity, String name) {
    return entity.archetype().sensor() && isNamed(entity, name);
  }

  private static boolean counts(LevelTrigger.Who who, HostEntity entity) {
    return who == LevelTrigger.Who.ANY || entity.isOwned() == (who == LevelTrigger.Who.PLAYER);
  }

  private boolean isBy(Condition c, HostEntity entity) {
    if (!counts(c.who(), entity)) {
      return false;
    }
    offer(entity);
    return true;
  }

  /** Makes an entity the visitor unless there is one: of players' first, then by the lowest id. */
  private void offer(HostEntity entity) {
    boolean isBetter =
        visitor == null
            || (entity.isOwned() && !visitor.isOwned())
            || (entity.isOwned() == visitor.isOwned() && entity.id() < visitor.id());
    if (!entity.isLevel() && isBetter) {
      visitor = entity;
    }
  }

  private int countInside(Node node) {
    inside = 0;
    who = node.condition.who();
    for (int i = 0; i < node.statics.size(); i++) {
      node.statics.get(i).body().forEachOverlap(count);
    }
    for (int i = 0; i < node.bodies.size(); i++) {
      HostEntity sensor = body(node.bodies.get(i));
      if (sensor != null && isSensor(sensor, node.condition.name())) {
        sensor.body().forEachOverlap(count);
      }
    }
    return inside;
  }

  private boolean count(Body<HostEntity> body) {
    HostEntity entity = body.user();
    if (!entity.isLevel() && counts(who, entity)) {
      inside++;
      offer(entity);
    }
    return true;
  }

  private double value(Field<?> field) {
    if (field instanceof IntField<?> number) {
      return simulation.get(number);
    }
    if (field instanceof FloatField<?> number) {
      return simulation.get(number);
    }
    return simulation.get((Flag) field) ? 1 : 0;
  }

  private boolean hasScore(double least) {
    boolean found = false;
    for (int i = 0; i < parts.players.limit(); i++) {
      HostPlayer player = parts.players.get(i);
      if (player != null && player.score() >= least) {
        found = true;
        if (player.entity() != null) {
          offer(player.entity());
        }
      }
    }
    return found;
  }

  // ---- actions

  private void perform(int i, boolean isElse, HostEntity by) {
    List<Act> acts = isElse ? rules.get(i).otherwise : rules.get(i).then;
    for (int k = 0; k < acts.size(); k++) {
      HostEntity present = by != null && by.body().isValid() ? by : null;
      perform(acts.get(k), present);
    }
  }

  private void perform(Act act, HostEntity by) {
    Action a = act.action;
    HostEntity target = a.body() == Action.VISITOR ? by : body(a.body());
    HostPlayer player = by == null ? null : by.owner();
    switch (a.verb()) {
      case MOVE -> {
        simulation.set(UNTIL, act.to, parts.tick + simulation.ticks(a.amount()));
        simulation.set(TO_X, act.to, a.x());
        simulation.set(TO_Y, act.to, a.y());
      }
      case SPAWN -> {
        if (parts.entities.count() < SimulationHost.MAX_ENTITIES) {
          simulation.spawn(act.archetype, a.x(), a.y(), 0, null);
        }
      }
      case NOTICE -> simulation.notice(a.name());
      case EVENT -> tell(act, by);
      case ENABLE -> enable(act.to, true);
      case DISABLE -> enable(act.to, false);
      case NEXT -> simulation.playNext(NextMatch.level(a.name()));
      case SCORE -> {
        if (player != null) {
          simulation.addScore(player, (int) a.amount());
        }
      }
      case SET, ADD -> {
        if (act.field.scope() == Scope.MATCH) {
          write(act, simulation);
        } else if (player != null) {
          write(act, player);
        }
      }
      default -> {
        if (target != null) {
          act(a, target);
        }
      }
    }
  }

  private static void act(Action a, HostEntity target) {
    switch (a.verb()) {
      case REMOVE -> target.despawn();
      case IMPULSE -> target.applyImpulse(a.x(), a.y());
      default -> target.teleport(a.x(), a.y(), target.angle());
    }
  }

  private void tell(Act act, HostEntity by) {
    boolean hasPlace = !Float.isNaN(act.action.x());
    if (!hasPlace && by == null) {
      return;
    }
    Event event = simulation.emit(act.event);
    if (hasPlace) {
      event.at(act.action.x(), act.action.y());
    } else {
      event.of(by);
    }
  }

  private void enable(int i, boolean value) {
    mark(i, SWITCHED, rules.get(i).trigger.enabled() != value);
    if (!value) {
      mark(i, HELD, false);
      simulation.set(DUE, i, 0);
    }
  }

  private static void write(Act act, FieldHolder<?, ?> holder) {
    boolean sets = act.action.verb() == Verb.SET;
    Object value = act.action.value();
    if (act.field instanceof Flag flag) {
      holder.set(flag, (Boolean) value);
    } else if (act.field instanceof IntField<?> number && sets) {
      holder.set(number, ((Double) value).intValue());
    } else if (act.field instanceof IntField<?> number) {
      holder.add(number, (int) act.action.amount());
    } else if (act.field instanceof FloatField<?> number && sets) {
      holder.set(number, ((Double) value).floatValue());
    } else {
      holder.add((FloatField<?>) act.field, act.action.amount());
    }
  }

  /** Returns a body of the level, or null if it is gone. */
  private HostEntity body(int number) {
    HostEntity entity = parts.entities.get(number);
    return entity == null || entity.generation() != 0 ? null : entity;
  }
}
