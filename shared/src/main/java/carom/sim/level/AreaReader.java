package carom.sim.level;

import static carom.sim.level.LevelReader.MAX_COORDINATE;
import static carom.sim.level.LevelReader.with;
import static carom.sim.level.ShapeReader.MAX_SIZE;
import static carom.sim.level.ShapeReader.MIN_SIZE;
import static carom.text.JsonFields.box;
import static carom.text.JsonFields.color;
import static carom.text.JsonFields.integer;
import static carom.text.JsonFields.knownFields;
import static carom.text.JsonFields.number;
import static carom.text.JsonFields.require;
import static carom.text.JsonFields.required;
import static carom.text.JsonFields.text;
import static carom.text.JsonFields.vector;
import static carom.text.JsonFields.word;
import static carom.text.JsonFields.wrong;

import carom.physics.effects.Attractor;
import carom.text.Json;
import carom.text.JsonException;
import java.util.List;

/** Reads the areas of a level file: water, wind, gravity, drag and attractors. */
final class AreaReader {
  private static final List<String> AREA = List.of("type", "name", "tag", "color");
  private static final List<String> BOX_AREA = with(AREA, "min", "max");
  static final List<String> WATER = with(BOX_AREA, "density", "drag", "angularDrag", "flow");
  static final List<String> WIND = with(BOX_AREA, "velocity", "rate", "drag", "lift");
  static final List<String> GRAVITY = with(BOX_AREA, "gravity");
  static final List<String> DRAG = with(BOX_AREA, "drag", "angularDrag");
  static final List<String> ATTRACTOR =
      with(AREA, "at", "range", "strength", "swirl", "falloff", "core");
  static final List<String> AREAS = List.of("water", "wind", "gravity", "drag", "attractor");
  static final List<String> FALLOFFS = List.of("constant", "linear", "inverseSquare");
  private static final float[] ZERO = new float[2];

  private AreaReader() {}

  /** Returns an area. */
  static Area area(Json node) throws JsonException {
    require(node, Json.Kind.OBJECT);
    required(node, "type");
    String type = word(node, "type", AREAS, "");
    Area area;
    try {
      area =
          switch (type) {
            case "water" -> water(node);
            case "wind" -> wind(node);
            case "gravity" -> gravityArea(node);
            case "drag" -> dragArea(node);
            default -> attractor(node);
          };
    } catch (IllegalArgumentException e) {
      throw wrong(node, ": " + e.getMessage());
    }
    Json areaName = node.fields.get("name");
    return area.named(areaName == null ? "" : text(areaName))
        .onlyTag(integer(node, "tag", Area.ANY_TAG, 0, 65535))
        .colored(color(node, "color", area.rgb()));
  }

  private static Area water(Json node) throws JsonException {
    knownFields(node, WATER);
    float[] box = box(node, MAX_COORDINATE);
    float[] flow = node.fields.containsKey("flow") ? vector(node.fields.get("flow"), 1000) : ZERO;
    required(node, "density");
    return Area.water(box[0], box[1], box[2], box[3], number(node, "density", 1, 0.001f, 1000))
        .drag(number(node, "drag", 1, 0, 1000), number(node, "angularDrag", 1, 0, 1000))
        .flow(flow[0], flow[1]);
  }

  private static Area wind(Json node) throws JsonException {
    knownFields(node, WIND);
    float[] box = box(node, MAX_COORDINATE);
    float[] velocity = vector(required(node, "velocity"), 1000);
    float rate = number(node, "rate", 1, 0, 1000);
    Area wind = Area.wind(box[0], box[1], box[2], box[3], velocity[0], velocity[1], rate);
    if (!node.fields.containsKey("drag") && !node.fields.containsKey("lift")) {
      return wind;
    }
    if (node.fields.containsKey("rate")) {
      throw wrong(
          node.fields.get("rate"), " stands beside drag or lift; a wind has one of the two");
    }
    return wind.onEdges(number(node, "drag", 1, 0, 1000), number(node, "lift", 1, 0, 1000));
  }

  private static Area gravityArea(Json node) throws JsonException {
    knownFields(node, GRAVITY);
    float[] box = box(node, MAX_COORDINATE);
    float[] gravity = vector(required(node, "gravity"), 1000);
    return Area.gravity(box[0], box[1], box[2], box[3], gravity[0], gravity[1]);
  }

  private static Area dragArea(Json node) throws JsonException {
    knownFields(node, DRAG);
    float[] box = box(node, MAX_COORDINATE);
    required(node, "drag");
    float drag = number(node, "drag", 1, 0, 1000);
    return Area.drag(
        box[0], box[1], box[2], box[3], drag, number(node, "angularDrag", drag, 0, 1000));
  }

  private static Area attractor(Json node) throws JsonException {
    knownFields(node, ATTRACTOR);
    float[] at = vector(required(node, "at"), MAX_COORDINATE);
    required(node, "range");
    required(node, "strength");
    float range = number(node, "range", 1, MIN_SIZE, MAX_SIZE);
    String falloff = word(node, "falloff", FALLOFFS, FALLOFFS.get(0));
    return Area.attractor(at[0], at[1], range, number(node, "strength", 0, -10_000, 10_000))
        .swirl(number(node, "swirl", 0, -10_000, 10_000))
        .falloff(
            Attractor.Falloff.values()[FALLOFFS.indexOf(falloff)],
            number(node, "core", Math.max(0.01f, 0.01f * range), 0.01f, Math.max(0.01f, range)));
  }
}
