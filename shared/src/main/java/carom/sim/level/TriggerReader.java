package carom.sim.level;

import static carom.sim.level.LevelReader.MAX_COORDINATE;
import static carom.text.JsonFields.bool;
import static carom.text.JsonFields.integer;
import static carom.text.JsonFields.knownFields;
import static carom.text.JsonFields.list;
import static carom.text.JsonFields.number;
import static carom.text.JsonFields.require;
import static carom.text.JsonFields.required;
import static carom.text.JsonFields.text;
import static carom.text.JsonFields.unknownWord;
import static carom.text.JsonFields.vector;
import static carom.text.JsonFields.word;
import static carom.text.JsonFields.wrong;

import carom.physics.BodyType;
import carom.sim.level.LevelTrigger.Action;
import carom.sim.level.LevelTrigger.Cause;
import carom.sim.level.LevelTrigger.Condition;
import carom.sim.level.LevelTrigger.Verb;
import carom.sim.level.LevelTrigger.Who;
import carom.text.Json;
import carom.text.JsonException;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;

/** Reads the {@code triggers} of a level file, after its statics and bodies. */
final class TriggerReader {
  static final List<String> TRIGGER =
      List.of("name", "when", "do", "else", "after", "every", "once", "enabled");
  static final int MAX_ACTIONS = 16;
  static final int MAX_PARTS = 16;
  static final float MIN_SECONDS = 0.0625f;
  static final float MAX_IMPULSE = 10_000;

  /** The causes of conditions, each with the fields that may stand beside it. */
  static final Map<String, List<String>> CAUSES = new TreeMap<>();

  /** The verbs of actions, each with the fields that may stand beside it. */
  static final Map<String, List<String>> VERBS = new TreeMap<>();

  private static final List<String> WHO = List.of("any", "player", "body");
  private static final List<String> SCOPES = List.of("match.", "player.");
  private static final int MAX_NUMBER = 1_000_000_000;

  static {
    CAUSES.put("enter", List.of("who"));
    CAUSES.put("leave", List.of("who"));
    CAUSES.put("inside", List.of("who", "least"));
    CAUSES.put("hit", List.of("who", "impulse"));
    CAUSES.put("timer", List.of());
    CAUSES.put("field", List.of("least", "most"));
    CAUSES.put("score", List.of());
    CAUSES.put("all", List.of());
    CAUSES.put("any", List.of());
    VERBS.put("move", List.of("to", "seconds"));
    VERBS.put("spawn", List.of("at"));
    VERBS.put("remove", List.of());
    VERBS.put("impulse", List.of("on"));
    VERBS.put("teleport", List.of("on"));
    VERBS.put("score", List.of());
    VERBS.put("checkpoint", List.of());
    VERBS.put("set", List.of("to"));
    VERBS.put("add", List.of("by"));
    VERBS.put("notice", List.of());
    VERBS.put("event", List.of("at"));
    VERBS.put("enable", List.of());
    VERBS.put("disable", List.of());
    VERBS.put("next", List.of());
  }

  private final LevelReader level;
  private final String file;
  private final LevelJointReader items;
  private final List<LevelTrigger> triggers = new ArrayList<>();
  private final Set<String> sensors = new TreeSet<>();
  private final Set<String> bodies = new TreeSet<>();
  private final Set<String> names = new TreeSet<>();
  private final Set<Integer> moved = new TreeSet<>();

  /** Creates the reader of a level whose statics and bodies have been read. */
  TriggerReader(LevelReader level, String file, LevelJointReader items) {
    this.level = level;
    this.file = file;
    this.items = items;
    for (ArchetypeDef def : level.archetypes) {
      (def.sensor ? sensors : bodies).add(def.name);
    }
  }

  /** Reads all triggers of a file. */
  List<LevelTrigger> read(Json root) throws JsonException {
    List<Json> nodes = list(root, "triggers", LevelTrigger.MAX);
    for (Json node : nodes) {
      knownFields(node, TRIGGER);
      Json name = node.fields.get("name");
      if (name != null && !names.add(text(name))) {
        throw wrong(name, "=" + name.shown() + " names several triggers; give each its own name");
      }
    }
    for (Json node : nodes) {
      triggers.add(trigger(node));
    }
    return triggers;
  }

  private LevelTrigger trigger(Json node) throws JsonException {
    Json name = node.fields.get("name");
    Condition when = condition(required(node, "when"));
    List<Action> then = actions(required(node, "do"), when.hasVisitor(), "the condition");
    Json elseNode = node.fields.get("else");
    List<Action> otherwise = elseNode == null ? List.of() : actions(elseNode, false, "\"else\"");
    if (when.isEvent()) {
      for (String lasting : List.of("else", "every")) {
        if (node.fields.containsKey(lasting)) {
          throw wrong(
              node.fields.get(lasting),
              " needs a condition that lasts, such as \"inside\"; enter, leave and hit happen at a"
                  + " moment");
        }
      }
    }
    if (node.fields.containsKey("once") && node.fields.get("once").truth) {
      for (String again : List.of("else", "every")) {
        if (node.fields.containsKey(again)) {
          throw wrong(node.fields.get(again), " contradicts \"once\"; remove one of the two");
        }
      }
    }
    return new LevelTrigger(
        name == null ? "" : name.text,
        when,
        then,
        otherwise,
        number(node, "after", 0, 0, LevelTrigger.MAX_SECONDS),
        number(node, "every", 0, MIN_SECONDS, LevelTrigger.MAX_SECONDS),
        bool(node, "once", false),
        bool(node, "enabled", true));
  }

  private Condition condition(Json node) throws JsonException {
    String kind = kind(node, CAUSES);
    Json value = node.fields.get(kind);
    Cause cause = Cause.valueOf(kind.toUpperCase(Locale.ROOT));
    String name = "";
    double least = 0;
    double most = Double.POSITIVE_INFINITY;
    List<Condition> parts = new ArrayList<>();
    switch (cause) {
      case ENTER, LEAVE -> name = sensor(value);
      case INSIDE -> {
        name = sensor(value);
        least = integer(node, "least", 1, 1, MAX_NUMBER);
      }
      case HIT -> {
        name = known(value, bodies, "the \"name\" of one of \"bodies\" or \"statics\" that touch");
        least = number(node, "impulse", 0, 0, MAX_IMPULSE);
      }
      case TIMER -> least = number(node, kind, 0, 0, LevelTrigger.MAX_SECONDS);
      case SCORE -> least = integer(node, kind, 0, -MAX_NUMBER, MAX_NUMBER);
      case FIELD -> {
        name = field(value, SCOPES.subList(0, 1));
        if (!node.fields.containsKey("least") && !node.fields.containsKey("most")) {
          throw wrong(node, " needs \"least\" or \"most\", or both: the limits of the field");
        }
        least = limit(node, "least", Double.NEGATIVE_INFINITY);
        most = limit(node, "most", Double.POSITIVE_INFINITY);
      }
      default -> {
        for (Json part : list(node, kind, MAX_PARTS)) {
          parts.add(condition(part));
        }
        if (parts.isEmpty()) {
          throw wrong(value, " has no conditions; give it 1.." + MAX_PARTS);
        }
      }
    }
    Who who = Who.valueOf(word(node, "who", WHO, "any").toUpperCase(Locale.ROOT));
    return new Condition(cause, where(node), name, who, least, most, List.copyOf(parts));
  }

  private static double limit(Json node, String field, double otherwise) throws JsonException {
    return node.fields.containsKey(field)
        ? number(node, field, 0, -MAX_NUMBER, MAX_NUMBER)
        : otherwise;
  }

  private List<Action> actions(Json node, boolean hasVisitor, String where) throws JsonException {
    List<Json> nodes = node.kind == Json.Kind.ARRAY ? node.items : List.of(node);
    if (nodes.isEmpty() || nodes.size() > MAX_ACTIONS) {
      throw wrong(node, " has " + nodes.size() + " actions, must be 1.." + MAX_ACTIONS);
    }
    List<Action> actions = new ArrayList<>();
    for (Json each : nodes) {
      Action action = action(each);
      if (action.needsVisitor() && !hasVisitor) {
        throw wrong(
            each,
            " acts on what sets the trigger off, but "
                + where
                + " has nothing that does; use enter, leave, inside, hit or score in \"when\", or"
                + " name a body");
      }
      actions.add(action);
    }
    return List.copyOf(actions);
  }

  private Action action(Json node) throws JsonException {
    String kind = kind(node, VERBS);
    Json value = node.fields.get(kind);
    Verb verb = Verb.valueOf(kind.toUpperCase(Locale.ROOT));
    String name = "";
    int body = Action.VISITOR;
    float[] at = new float[2];
    float amount = 0;
    Object set = null;
    switch (verb) {
      case MOVE -> {
        body = moved(value);
        at = vector(required(node, "to"), MAX_COORDINATE);
        amount = number(node, "seconds", 1, MIN_SECONDS, LevelTrigger.MAX_SECONDS);
      }
      case SPAWN -> {
        name = text(value);
        at = vector(required(node, "at"), MAX_COORDINATE);
      }
      case REMOVE -> body = target(value);
      case IMPULSE -> {
        at = vector(value, MAX_IMPULSE);
        body = target(node.fields.get("on"));
      }
      case TELEPORT -> {
        at = vector(value, MAX_COORDINATE);
        body = target(node.fields.get("on"));
      }
      case CHECKPOINT -> at = vector(value, MAX_COORDINATE);
      case SCORE -> amount = integer(node, kind, 0, -1000, 1000);
      case SET -> {
        name = field(value, SCOPES);
        set = value(required(node, "to"));
      }
      case ADD -> {
        name = field(value, SCOPES);
        required(node, "by");
        amount = number(node, "by", 0, -MAX_NUMBER, MAX_NUMBER);
      }
      case EVENT -> {
        name = text(value);
        Json place = node.fields.get("at");
        at = place == null ? null : vector(place, MAX_COORDINATE);
      }
      case ENABLE, DISABLE -> name = known(value, names, "the \"name\" of one of \"triggers\"");
      default -> name = text(value);
    }
    float x = at == null ? Float.NaN : at[0];
    float y = at == null ? Float.NaN : at[1];
    return new Action(verb, where(value), name, body, x, y, amount, set);
  }

  /** Returns which of some kinds a node is: the one word of them that it holds. */
  private static String kind(Json node, Map<String, List<String>> kinds) throws JsonException {
    require(node, Json.Kind.OBJECT);
    String found = null;
    for (String field : node.fields.keySet()) {
      if (kinds.containsKey(field)) {
        if (found != null) {
          throw wrong(
              node, " has both \"" + found + "\" and \"" + field + "\"; make it one for each");
        }
        found = field;
      }
    }
    List<String> known = new ArrayList<>(found == null ? kinds.keySet() : List.of(found));
    if (found != null) {
      known.addAll(kinds.get(found));
    }
    knownFields(node, known);
    if (found == null) {
      throw wrong(node, " is empty; it needs one of " + known);
    }
    return found;
  }

  private String sensor(Json node) throws JsonException {
    return known(
        node,
        sensors,
        "the \"name\" of one of \"statics\" or \"bodies\" with \"sensor\": true"
            + (sensors.isEmpty() ? ", of which there is none" : ", of " + shown(sensors)));
  }

  private static String known(Json node, Set<String> words, String limit) throws JsonException {
    require(node, Json.Kind.STRING);
    if (!words.contains(node.text)) {
      throw unknownWord(node, words, limit);
    }
    return node.text;
  }

  private static String shown(Set<String> words) {
    List<String> some = new ArrayList<>(words);
    return some.size() > 8 ? some.subList(0, 8) + " and more" : some.toString();
  }

  /** Returns the number of a body that an action acts on, or that of the visitor. */
  private int target(Json node) throws JsonException {
    if (node == null || (node.kind == Json.Kind.STRING && node.text.equals("visitor"))) {
      return Action.VISITOR;
    }
    int body = items.body(node);
    if (body < 0) {
      throw wrong(
          node, "=" + node.shown() + " never moves; name one of \"bodies\", or \"visitor\"");
    }
    return body;
  }

  private int moved(Json node) throws JsonException {
    int body = items.body(node);
    ArchetypeDef def = body < 0 ? null : level.archetypes.get(level.bodies.get(body).archetype());
    if (def == null || def.type != BodyType.KINEMATIC || def.motion != null) {
      throw wrong(
          node,
          "="
              + node.shown()
              + " must be one of \"bodies\" with \"type\": \"kinematic\" and without \"motion\"");
    }
    moved.add(body);
    if (moved.size() > LevelTrigger.MAX_MOVED) {
      throw wrong(node, " is one of more than " + LevelTrigger.MAX_MOVED + " bodies that move");
    }
    return body;
  }

  /** Returns the name of a field with its scope. */
  private static String field(Json node, List<String> scopes) throws JsonException {
    String name = text(node);
    for (String scope : scopes) {
      if (name.startsWith(scope)) {
        return name;
      }
    }
    throw wrong(node, "=" + node.shown() + " must begin with one of " + scopes);
  }

  private static Object value(Json node) throws JsonException {
    return switch (node.kind) {
      case NUMBER -> node.number;
      case BOOLEAN -> node.truth;
      default -> throw wrong(node, " must be a number, or true or false");
    };
  }

  private String where(Json node) {
    return file + ":" + node.line + ":" + node.column + ": " + node.path();
  }
}
