package carom.sim;

import carom.physics.Collision;
import carom.sim.entity.HostEntity;
import carom.sim.entity.HostPlayer;
import carom.sim.event.Audience;
import carom.sim.event.EventKind;
import carom.sim.field.Countdown;
import carom.sim.field.Field;
import carom.sim.field.FieldHolder;
import carom.sim.field.Flag;
import carom.sim.field.FloatField;
import carom.sim.field.IntField;
import carom.sim.field.Schema;
import carom.sim.field.Scope;
import carom.sim.level.Archetype;
import carom.sim.level.LevelTrigger;
import carom.sim.level.LevelTrigger.Action;
import carom.sim.level.LevelTrigger.Condition;
import carom.sim.level.LevelTrigger.Verb;
import carom.sim.outbox.Event;
import carom.sim.outbox.NextMatch;
import carom.sim.phase.Phase;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.Consumer;

/**
 * Runs the triggers of a level, on the server and on each client that predicts. What it remembers
 * from tick to tick is in {@link RuleWords}, so that it is saved, hashed, sent and rolled back.
 *
 * <p>Conditions that happen at a moment (enter, leave, hit) are asked at each such moment. The
 * others are asked once a tick, and what they do follows from the difference to the tick before.
 *
 * <p>A client does what it can compute: it asks no condition about what it isn't told, and leaves
 * all but moves, pushes, switches, what is removed and fields that all are told to the server. Of
 * what it lacks it learns by the words of the match and by rulings.
 */
final class LevelRules {
  /** Bits of {@link RuleWords#state}. */
  private static final int HELD = 1;

  private static final int FIRED = 2;
  private static final int SWITCHED = 4;
  private static final int DUE_ELSE = 8;

  /** A condition with what its names mean here. */
  private record Node(
      Condition condition, int sensor, Field<?> field, List<Node> parts, boolean isPredicted) {}

  /** An action with what its names mean here. */
  private record Act(
      Action action,
      Archetype archetype,
      Field<?> field,
      EventKind event,
      int to,
      boolean isPredicted) {}

  private record Rule(LevelTrigger trigger, Node when, List<Act> then, List<Act> otherwise) {}

  /** Triggers spawn only while there are fewer entities than this beyond the level's own. */
  static final int MAX_SPAWNED = 512;

  private final SimulationHost simulation;
  private final SimParts parts;
  private final RuleWords words;
  private final boolean decides;
  private final List<Rule> rules = new ArrayList<>();

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
  private final Consumer<HostEntity> offerInside = this::offerInside;

  LevelRules(SimulationHost simulation, SimParts parts) {
    this.simulation = simulation;
    this.parts = parts;
    words = parts.ruleWords;
    decides = parts.role == Role.AUTHORITY;
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
    Field<?> field = null;
    if (c.cause() == LevelTrigger.Cause.FIELD) {
      field = field(c.where() + ".field", c.name());
      if (!(field instanceof IntField || field instanceof FloatField || field instanceof Flag)) {
        throw new IllegalArgumentException(
            c.where() + ".field is \"" + field + "\"; triggers compare numbers, times and flags");
      }
    }
    boolean isPredicted =
        c.cause() != LevelTrigger.Cause.SCORE && (field == null || isShared(field));
    List<Node> nodes = new ArrayList<>();
    for (Condition part : c.parts()) {
      nodes.add(node(part));
      isPredicted &= nodes.get(nodes.size() - 1).isPredicted;
    }
    int sensor = c.cause() == LevelTrigger.Cause.INSIDE ? parts.inside.find(c.name()) : -1;
    return new Node(c, sensor, field, nodes, isPredicted);
  }

  private List<Act> acts(List<Action> actions) {
    List<Act> acts = new ArrayList<>();
    for (Action a : actions) {
      acts.add(
          switch (a.verb()) {
            case MOVE -> new Act(a, null, null, null, parts.moves.find(a.body()), true);
            case SPAWN -> new Act(a, archetype(a), null, null, 0, false);
            case SET, ADD -> {
              Field<?> field = writable(a);
              yield new Act(a, null, field, null, 0, isShared(field));
            }
            case EVENT -> new Act(a, null, null, event(a), 0, false);
            case ENABLE, DISABLE -> new Act(a, null, null, null, trigger(a.name()), true);
            case REMOVE, IMPULSE, TELEPORT -> new Act(a, null, null, null, 0, true);
            default -> new Act(a, null, null, null, 0, false);
          });
    }
    return acts;
  }

  /** Returns whether all clients near what has a field are told it. */
  private static boolean isShared(Field<?> field) {
    return field.audience() == Audience.NEAR || field.audience() == Audience.ALL;
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
    if (field != null && field.times() == 1 && !words.fields().contains(field)) {
      return field;
    }
    List<String> known = new ArrayList<>();
    for (Field<?> other : schema.fields()) {
      if (other.scope() == scope && other.times() == 1 && !words.fields().contains(other)) {
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
      if (rule.trigger.when().isEvent() && isAsked(i)) {
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
      int due = simulation.get(words.due, i);
      if (due != 0 && parts.tick >= due) {
        simulation.set(words.due, i, 0);
        perform(i, has(i, DUE_ELSE), (HostEntity) simulation.get(words.by, i));
      }
      if (!rules.get(i).trigger.when().isEvent() && isAsked(i)) {
        follow(i);
      }
    }
  }

  /** Returns whether the condition of a trigger is asked here and now. */
  private boolean isAsked(int i) {
    return (decides || rules.get(i).when.isPredicted) && isEnabled(i);
  }

  private void follow(int i) {
    Rule rule = rules.get(i);
    visitor = null;
    boolean holds = holds(rule.when);
    boolean held = has(i, HELD);
    mark(i, HELD, holds);
    float every = rule.trigger.every();
    if (holds && (!held || (every > 0 && parts.tick >= simulation.get(words.again, i)))) {
      simulation.set(words.again, i, every > 0 ? parts.tick + simulation.ticks(every) : 0);
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
    simulation.set(words.due, i, parts.tick + simulation.ticks(trigger.after()));
    simulation.set(words.by, i, by);
  }

  private boolean isEnabled(int i) {
    return rules.get(i).trigger.enabled() != has(i, SWITCHED);
  }

  private boolean has(int i, int bit) {
    return (simulation.get(words.state, i) & bit) != 0;
  }

  private void mark(int i, int bit, boolean on) {
    int state = simulation.get(words.state, i);
    simulation.set(words.state, i, on ? state | bit : state & ~bit);
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
    who = node.condition.who();
    parts.inside.forEach(node.sensor, offerInside);
    int players = who == LevelTrigger.Who.BODY ? 0 : parts.inside.players(node.sensor);
    int bodies = who == LevelTrigger.Who.PLAYER ? 0 : parts.inside.bodies(node.sensor);
    return players + bodies;
  }

  private void offerInside(HostEntity entity) {
    if (counts(who, entity)) {
      offer(entity);
    }
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
      if (decides || acts.get(k).isPredicted) {
        perform(acts.get(k), present);
      }
    }
  }

  private void perform(Act act, HostEntity by) {
    Action a = act.action;
    HostEntity target = a.body() == Action.VISITOR ? by : parts.levelBody(a.body());
    HostPlayer player = by == null ? null : by.owner();
    switch (a.verb()) {
      case MOVE -> parts.moves.start(act.to, a.x(), a.y(), a.amount());
      case SPAWN -> {
        if (parts.entities.count() < simulation.level().bodies().size() + MAX_SPAWNED) {
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
      case CHECKPOINT -> {
        if (player != null) {
          Phase outer = parts.phases.begin(Phase.AFTER_STEP); // the game may do what it may there
          parts.game.checkpoint(simulation, player, a.x(), a.y());
          parts.phases.end(outer);
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

  private void act(Action a, HostEntity target) {
    switch (a.verb()) {
      case REMOVE -> {
        if (decides || !target.isOwned()) { // a client never takes a player's body away
          target.despawn();
        }
      }
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
      simulation.set(words.due, i, 0);
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
}
