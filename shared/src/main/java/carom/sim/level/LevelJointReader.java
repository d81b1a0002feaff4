package carom.sim.level;

import static carom.text.JsonFields.bool;
import static carom.text.JsonFields.knownFields;
import static carom.text.JsonFields.number;
import static carom.text.JsonFields.require;
import static carom.text.JsonFields.required;
import static carom.text.JsonFields.text;
import static carom.text.JsonFields.unknownWord;
import static carom.text.JsonFields.vector;
import static carom.text.JsonFields.word;
import static carom.text.JsonFields.wrong;

import carom.physics.Body;
import carom.physics.BodyType;
import carom.physics.Joint;
import carom.physics.JointDef;
import carom.physics.World;
import carom.physics.WorldDef;
import carom.physics.rows.JointDefRow;
import carom.text.Json;
import carom.text.JsonException;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/**
 * Reads the {@code joints} of a level file. Each is made once in a world of its own, with its
 * bodies where the level places them; so what the engine refuses is refused with its place in the
 * file, and the joint's definition is known.
 */
final class LevelJointReader {
  static final int MAX_JOINTS = 4096;

  static final List<String> REVOLUTE = withFieldsOfAll("at", "limits", "motor", "spring", "rest");
  static final List<String> DISTANCE =
      withFieldsOfAll("from", "to", "limits", "motor", "spring", "rest");
  static final List<String> RATCHET = withFieldsOfAll("at", "tooth", "motor", "spring", "rest");
  static final List<String> GROOVE = withFieldsOfAll("from", "to", "at");
  static final List<String> FRICTION = withFieldsOfAll("at", "maxForce", "maxTorque");
  static final List<String> ROPE = withFieldsOfAll("from", "to", "length");
  static final List<String> PRISMATIC =
      withFieldsOfAll("at", "axis", "limits", "motor", "spring", "rest");
  static final List<String> WELD = withFieldsOfAll("at", "spring", "angularSpring");
  static final List<String> MOTOR =
      withFieldsOfAll("maxForce", "maxTorque", "spring", "angularSpring");
  static final List<String> MOUSE =
      List.of("type", "name", "b", "collide", "breaks", "at", "maxForce", "spring");
  static final List<String> GEAR = withFieldsOfAll("ratio");
  static final List<String> RACK = withFieldsOfAll("axis", "ratio");
  static final List<String> PULLEY =
      withFieldsOfAll("from", "to", "groundFrom", "groundTo", "ratio");
  static final List<String> MOTOR_FIELDS = List.of("speed", "max");
  static final List<String> SPRING = List.of("hertz", "damping");
  static final List<String> BREAKS = List.of("force", "torque");
  static final List<String> TYPES =
      List.of(
          "revolute",
          "distance",
          "rope",
          "prismatic",
          "weld",
          "wheel",
          "motor",
          "mouse",
          "gear",
          "rack",
          "pulley",
          "ratchet",
          "groove",
          "friction");

  private static final float RAD_PER_DEGREE = (float) (Math.PI / 180);
  private static final float MAX_FORCE = 1e9f;

  /** Bodies of one item of the file: from one number on, in statics or in bodies. */
  private record Item(boolean isStatic, int first, int count, boolean isAmbiguous) {}

  private final LevelReader file;
  private final Map<String, Item> items = new LinkedHashMap<>();
  private final World<Object> world = new World<>(new WorldDef());
  private final Map<Integer, Body<Object>> bodies = new TreeMap<>();

  LevelJointReader(LevelReader file) {
    this.file = file;
  }

  /** Returns the fields that all joints with two ends have, and more. */
  private static List<String> withFieldsOfAll(String... more) {
    List<String> fields = new ArrayList<>(List.of("type", "name", "a", "b", "collide", "breaks"));
    fields.addAll(List.of(more));
    return List.copyOf(fields);
  }

  /** Notes the bodies of an item, by which joints may name them. */
  void item(String name, boolean isStatic, int first, int count) {
    items.merge(
        name,
        new Item(isStatic, first, count, false),
        (one, other) -> new Item(one.isStatic, one.first, one.count, true));
  }

  /** Reads a joint. */
  LevelJoint read(Json node) throws JsonException {
    require(node, Json.Kind.OBJECT);
    required(node, "type");
    String type = word(node, "type", TYPES, "");
    knownFields(node, fields(type));
    Json nameNode = node.fields.get("name");
    Json aNode = node.fields.get("a");
    int a = aNode == null ? LevelJoint.GROUND : body(aNode);
    int b = body(required(node, "b"));
    if (!moves(a) && !moves(b)) {
      throw wrong(node, " holds no dynamic body; name one as \"a\" or \"b\"");
    }
    int[] definition = new int[JointDefRow.INTS];
    try {
      Body<Object> bodyA = a == LevelJoint.GROUND ? null : made(a);
      JointDef<Object> def = def(type, node, bodyA, made(b));
      def.collideConnected(bool(node, "collide", type.equals("mouse") || type.equals("friction")));
      breaks(node, def);
      Joint<Object> joint = world.createJoint(def);
      world.readJoint(joint, definition, 0);
    } catch (IllegalArgumentException | IllegalStateException e) {
      throw wrong(node, ": " + e.getMessage());
    }
    return new LevelJoint(nameNode == null ? "" : text(nameNode), a, b, definition);
  }

  static List<String> fields(String type) {
    return switch (type) {
      case "revolute" -> REVOLUTE;
      case "distance" -> DISTANCE;
      case "rope" -> ROPE;
      case "prismatic", "wheel" -> PRISMATIC;
      case "weld" -> WELD;
      case "motor" -> MOTOR;
      case "mouse" -> MOUSE;
      case "gear" -> GEAR;
      case "rack" -> RACK;
      case "ratchet" -> RATCHET;
      case "groove" -> GROOVE;
      case "friction" -> FRICTION;
      default -> PULLEY;
    };
  }

  /** Returns the definition of a joint of a type. */
  private JointDef<Object> def(String type, Json node, Body<Object> a, Body<Object> b)
      throws JsonException {
    switch (type) {
      case "revolute" -> {
        float[] at = point(node, "at");
        return driven(node, JointDef.revolute(a, b, at[0], at[1]), RAD_PER_DEGREE, RAD_PER_DEGREE);
      }
      case "distance" -> {
        float[] from = point(node, "from");
        float[] to = point(node, "to");
        return driven(node, JointDef.distance(a, b, from[0], from[1], to[0], to[1]), 1, 1);
      }
      case "rope" -> {
        float[] from = point(node, "from");
        float[] to = point(node, "to");
        required(node, "length");
        float length = number(node, "length", 1, 0, LevelReader.MAX_COORDINATE);
        return JointDef.rope(a, b, from[0], from[1], to[0], to[1], length);
      }
      case "prismatic" -> {
        float[] at = point(node, "at");
        float[] axis = axis(node);
        return driven(node, JointDef.prismatic(a, b, at[0], at[1], axis[0], axis[1]), 1, 1);
      }
      case "wheel" -> {
        float[] at = point(node, "at");
        float[] axis = axis(node);
        JointDef<Object> wheel = JointDef.wheel(a, b, at[0], at[1], axis[0], axis[1]);
        return driven(node, wheel, 1, RAD_PER_DEGREE);
      }
      case "weld" -> {
        float[] at = point(node, "at");
        return springs(node, JointDef.weld(a, b, at[0], at[1]));
      }
      case "motor" -> {
        return springs(
            node, JointDef.motor(a, b, force(node, "maxForce"), force(node, "maxTorque")));
      }
      case "mouse" -> {
        float[] at = point(node, "at");
        return springs(node, JointDef.mouse(b, at[0], at[1], force(node, "maxForce")));
      }
      case "gear" -> {
        return JointDef.gear(requiredBody(node, a), b, ratio(node));
      }
      case "ratchet" -> {
        float[] at = point(node, "at");
        required(node, "tooth");
        float turn = RAD_PER_DEGREE;
        float tooth = number(node, "tooth", 0, -5000, 5000) * turn;
        return driven(node, JointDef.ratchet(a, b, at[0], at[1], tooth), turn, turn);
      }
      case "groove" -> {
        float[] to = point(node, "to");
        float[] at = point(node, "at");
        float[] p = point(node, "from");
        return JointDef.groove(a, b, p[0], p[1], to[0], to[1], at[0], at[1]);
      }
      case "friction" -> {
        float[] at = point(node, "at");
        return JointDef.friction(
            a, b, at[0], at[1], force(node, "maxForce"), force(node, "maxTorque"));
      }
      case "rack" -> {
        float[] axis = axis(node);
        return JointDef.rack(requiredBody(node, a), b, axis[0], axis[1], ratio(node));
      }
      default -> {
        float[] from = point(node, "from");
        float[] to = point(node, "to");
        float[] groundA = point(node, "groundFrom");
        float[] groundB = point(node, "groundTo");
        return JointDef.pulley(
            requiredBody(node, a),
            b,
            from[0],
            from[1],
            to[0],
            to[1],
            groundA[0],
            groundA[1],
            groundB[0],
            groundB[1],
            ratio(node));
      }
    }
  }

  private Body<Object> requiredBody(Json node, Body<Object> a) throws JsonException {
    required(node, "a");
    return a;
  }

  /**
   * Adds limits, motor, spring and rest.
   *
   * @param unit of the coordinate: metres, or radians per degree
   * @param speedUnit of the motor
   */
  private JointDef<Object> driven(Json node, JointDef<Object> def, float unit, float speedUnit)
      throws JsonException {
    Json limits = node.fields.get("limits");
    if (limits != null) {
      float[] range = vector(limits, 1e6f);
      def.limits(range[0] * unit, range[1] * unit);
    }
    Json motor = node.fields.get("motor");
    if (motor != null) {
      knownFields(motor, MOTOR_FIELDS);
      required(motor, "speed");
      required(motor, "max");
      def.motor(
          number(motor, "speed", 0, -10_000, 10_000) * speedUnit,
          number(motor, "max", 0, 0, MAX_FORCE));
    }
    if (node.fields.containsKey("rest")) {
      def.rest(number(node, "rest", 0, -1e6f, 1e6f) * unit);
    }
    return springs(node, def);
  }

  private JointDef<Object> springs(Json node, JointDef<Object> def) throws JsonException {
    Json spring = node.fields.get("spring");
    if (spring != null) {
      def.spring(hertz(spring), number(spring, "damping", 0.5f, 0, 100));
    }
    Json angular = node.fields.get("angularSpring");
    if (angular != null) {
      def.angularSpring(hertz(angular), number(angular, "damping", 0.5f, 0, 100));
    }
    return def;
  }

  private float hertz(Json spring) throws JsonException {
    knownFields(spring, SPRING);
    required(spring, "hertz");
    return number(spring, "hertz", 1, 0, 1000);
  }

  private void breaks(Json node, JointDef<Object> def) throws JsonException {
    Json breaks = node.fields.get("breaks");
    if (breaks != null) {
      knownFields(breaks, BREAKS);
      float most = Float.POSITIVE_INFINITY;
      boolean force = breaks.fields.containsKey("force");
      boolean torque = breaks.fields.containsKey("torque");
      if (!force && !torque) {
        throw wrong(breaks, " has neither \"force\" nor \"torque\"; give one");
      }
      def.breaksAt(
          force ? number(breaks, "force", 0, 0, MAX_FORCE) : most,
          torque ? number(breaks, "torque", 0, 0, MAX_FORCE) : most);
    }
  }

  private float[] point(Json node, String field) throws JsonException {
    return vector(required(node, field), LevelReader.MAX_COORDINATE);
  }

  private float[] axis(Json node) throws JsonException {
    return vector(required(node, "axis"), 1000);
  }

  private float force(Json node, String field) throws JsonException {
    required(node, field);
    return number(node, field, 0, 0, MAX_FORCE);
  }

  private float ratio(Json node) throws JsonException {
    required(node, "ratio");
    return number(node, "ratio", 1, -1000, 1000);
  }

  /** Returns the body that a word names: NAME, or NAME[n] for one of several. */
  int body(Json node) throws JsonException {
    require(node, Json.Kind.STRING);
    Item item = items.get(node.text);
    int number = 0;
    if (item == null && node.text.endsWith("]") && node.text.lastIndexOf('[') > 0) {
      int open = node.text.lastIndexOf('[');
      item = items.get(node.text.substring(0, open));
      number = itemNumber(node.text.substring(open + 1, node.text.length() - 1));
    } else if (item != null && item.count > 1) {
      throw wrong(
          node, "=" + node.shown() + " has " + item.count + " bodies; write " + node.text + "[0]");
    }
    if (item == null) {
      List<String> names = new ArrayList<>(items.keySet());
      throw unknownWord(node, names, "the \"name\" of one of \"bodies\" or \"statics\"");
    }
    if (item.isAmbiguous) {
      throw wrong(node, "=" + node.shown() + " names several items; give each its own name");
    }
    if (number < 0 || number >= item.count) {
      int last = item.count - 1;
      throw wrong(node, "=" + node.shown() + " must have a number in 0.." + last);
    }
    return item.isStatic ? ~(item.first + number) : item.first + number;
  }

  /** Returns a number, or -1 if the text is none. */
  private static int itemNumber(String text) {
    try {
      return Integer.parseInt(text);
    } catch (NumberFormatException e) {
      return -1;
    }
  }

  private boolean moves(int body) {
    return body >= 0
        && file.archetypes.get(file.bodies.get(body).archetype()).type == BodyType.DYNAMIC;
  }

  /** Makes a body where it is at tick 0, once. */
  private Body<Object> made(int body) {
    return bodies.computeIfAbsent(
        body,
        number -> {
          Level.Placement p = body < 0 ? file.statics.get(~body) : file.bodies.get(body);
          ArchetypeDef def = file.archetypes.get(p.archetype());
          float x = def.motion == null ? p.x() : def.motion.x(0, 1);
          float y = def.motion == null ? p.y() : def.motion.y(0, 1);
          return world.createBody(new Archetype(0, def).body(x, y, p.angle()), null);
        });
  }
}
