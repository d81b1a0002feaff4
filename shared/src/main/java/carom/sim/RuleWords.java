package carom.sim;

import carom.sim.event.Audience;
import carom.sim.field.Count;
import carom.sim.field.EntityRef;
import carom.sim.field.Field;
import carom.sim.field.Real;
import carom.sim.field.Scope;
import carom.sim.level.Level;
import carom.sim.level.LevelTrigger;
import carom.sim.level.LevelTrigger.Action;
import carom.sim.level.LevelTrigger.Condition;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/**
 * Hidden fields of the match, in which rules that clients run keep what the game's own fields don't
 * hold: how far the level's triggers are, which bodies move where, and how many are in sensors. All
 * players are told them. So they are saved, recorded, hashed, sent, predicted and rolled back as
 * fields are.
 *
 * <p>There are as many values as the level needs, up to the next power of two, so that not every
 * level makes fields of its own. Immutable; any thread.
 */
final class RuleWords {
  /** The fields of one number of triggers, bodies and sensors. */
  private static final Map<Long, RuleWords> MADE = new TreeMap<>();

  /** Value of {@link #players} and {@link #bodies} of a sensor that no rule has asked for. */
  static final int NEVER_ASKED = -1;

  private static final int MAX_INSIDE = 65_535;

  /** By trigger: bits that {@link LevelRules} declares. */
  final Count state;

  /** By trigger: the tick at which what waits happens; 0 for nothing. */
  final Count due;

  /** By trigger: the tick at which what repeats happens again. */
  final Count again;

  /** By trigger: the entity that set off what waits. */
  final EntityRef by;

  /** By body that moves: the last tick of its way. */
  final Count until;

  final Real toX;
  final Real toY;

  /** By sensor: how many players' bodies are in it. */
  final Count players;

  /** By sensor: how many bodies are in it that belong to nobody. */
  final Count bodies;

  private final List<Field<?>> fields = new ArrayList<>();

  private RuleWords(int triggers, int moved, int sensors) {
    state = count("rulesState", 0, 15, triggers);
    due = count("rulesDue", 0, Integer.MAX_VALUE, triggers);
    again = count("rulesAgain", 0, Integer.MAX_VALUE, triggers);
    by = add(Field.entity("rulesBy").of(Scope.MATCH).to(Audience.ALL), triggers);
    until = count("rulesUntil", 0, Integer.MAX_VALUE, moved);
    toX = add(Field.real("rulesX").of(Scope.MATCH).to(Audience.ALL), moved);
    toY = add(Field.real("rulesY").of(Scope.MATCH).to(Audience.ALL), moved);
    players = inside("rulesPlayers", sensors);
    bodies = inside("rulesBodies", sensors);
  }

  private Count inside(String name, int times) {
    Count unasked = Field.count(name, NEVER_ASKED, MAX_INSIDE).startsAt(NEVER_ASKED);
    return add(unasked.of(Scope.MATCH).to(Audience.ALL), times);
  }

  private Count count(String name, int min, int max, int times) {
    return add(Field.count(name, min, max).of(Scope.MATCH).to(Audience.ALL), times);
  }

  private <F extends Field<F>> F add(F field, int times) {
    if (times == 0) {
      return field; // no value of it is ever asked for
    }
    F made = field.times(times);
    fields.add(made);
    return made;
  }

  /** Returns the words that a level needs in a game, which may have rules. */
  static RuleWords of(Level level, boolean hasRules) {
    return of(
        level.triggers().size(), moved(level, hasRules).size(), sensors(level, hasRules).size());
  }

  private static synchronized RuleWords of(int triggers, int moved, int sensors) {
    int t = roundedUp(triggers);
    int m = roundedUp(moved);
    int s = roundedUp(sensors);
    return MADE.computeIfAbsent((long) t << 40 | (long) m << 20 | s, key -> new RuleWords(t, m, s));
  }

  private static int roundedUp(int number) {
    return number < 2 ? number : Integer.highestOneBit(number - 1) << 1;
  }

  /** Returns the fields that have values. */
  List<Field<?>> fields() {
    return fields;
  }

  /**
   * Returns the bodies that rules may move, as numbers in {@link Level#bodies}: those that triggers
   * move and, in a game with rules, other kinematic ones without a motion.
   */
  static List<Integer> moved(Level level, boolean hasRules) {
    List<Integer> moved = new ArrayList<>();
    for (LevelTrigger trigger : level.triggers()) {
      addMoved(trigger.then(), moved);
      addMoved(trigger.otherwise(), moved);
    }
    for (int i = 0; hasRules && i < level.bodies().size(); i++) {
      boolean hasRoom = moved.size() < LevelTrigger.MAX_MOVED;
      if (hasRoom && level.isMovable(i) && !moved.contains(i)) {
        moved.add(i);
      }
    }
    return moved;
  }

  private static void addMoved(List<Action> actions, List<Integer> moved) {
    for (Action action : actions) {
      if (action.verb() == LevelTrigger.Verb.MOVE && !moved.contains(action.body())) {
        moved.add(action.body());
      }
    }
  }

  /**
   * Returns the names of the sensors that rules may ask who is inside: those of triggers and, in a
   * game with rules, of all static ones.
   */
  static List<String> sensors(Level level, boolean hasRules) {
    List<String> names = new ArrayList<>();
    for (LevelTrigger trigger : level.triggers()) {
      addSensors(trigger.when(), names);
    }
    for (String name : hasRules ? level.sensorNames() : List.<String>of()) {
      if (!names.contains(name)) {
        names.add(name);
      }
    }
    return names;
  }

  private static void addSensors(Condition condition, List<String> names) {
    if (condition.cause() == LevelTrigger.Cause.INSIDE && !names.contains(condition.name())) {
      names.add(condition.name());
    }
    for (Condition part : condition.parts()) {
      addSensors(part, names);
    }
  }
}
