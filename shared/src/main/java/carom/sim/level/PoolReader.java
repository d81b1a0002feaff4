package carom.sim.level;

import static carom.sim.level.LevelReader.BOUNDS;
import static carom.sim.level.LevelReader.MAX_COORDINATE;
import static carom.text.JsonFields.bool;
import static carom.text.JsonFields.box;
import static carom.text.JsonFields.color;
import static carom.text.JsonFields.integer;
import static carom.text.JsonFields.knownFields;
import static carom.text.JsonFields.list;
import static carom.text.JsonFields.number;
import static carom.text.JsonFields.required;
import static carom.text.JsonFields.text;
import static carom.text.JsonFields.vector;
import static carom.text.JsonFields.word;
import static carom.text.JsonFields.wrong;

import carom.sim.pool.PoolDef;
import carom.text.Json;
import carom.text.JsonException;
import java.util.List;

/** Reads the pools of a level file: water and sand of particles. */
final class PoolReader {
  static final List<String> POOL =
      List.of(
          "type name color min max spacing density drag most lifetime fill drains spouts"
              .split(" "));
  static final List<String> SPOUT = List.of("name", "at", "direction", "width", "speed", "open");
  static final List<String> POOLS = List.of("water", "sand");

  private PoolReader() {}

  /** Returns a pool. */
  static PoolDef pool(Json node) throws JsonException {
    knownFields(node, POOL);
    required(node, "type");
    boolean water = word(node, "type", POOLS, "").equals("water");
    String poolName = text(required(node, "name"));
    float[] box = box(node, MAX_COORDINATE);
    float spacing = number(node, "spacing", 0.3f, 0.125f, 2);
    try {
      PoolDef def = PoolDef.water(poolName, box[0], box[1], box[2], box[3], spacing);
      def = water ? def : PoolDef.sand(poolName, box[0], box[1], box[2], box[3], spacing);
      def =
          def.density(number(node, "density", def.density(), 0.001f, 1000))
              .drag(number(node, "drag", def.drag(), 0, 1000))
              .most(integer(node, "most", def.most(), 1, PoolDef.MAX_PARTICLES))
              .lifetime(
                  number(node, "lifetime", PoolDef.MAX_LIFETIME, 0.125f, PoolDef.MAX_LIFETIME))
              .colored(color(node, "color", def.rgb()));
      for (Json fill : list(node, "fill", PoolDef.MAX_BOXES)) {
        knownFields(fill, BOUNDS);
        float[] b = box(fill, MAX_COORDINATE);
        def = def.fill(b[0], b[1], b[2], b[3]);
      }
      for (Json drain : list(node, "drains", PoolDef.MAX_BOXES)) {
        knownFields(drain, BOUNDS);
        float[] b = box(drain, MAX_COORDINATE);
        def = def.drain(b[0], b[1], b[2], b[3]);
      }
      for (Json spout : list(node, "spouts", PoolDef.MAX_SPOUTS)) {
        def = def.spout(spout(spout));
      }
      return def;
    } catch (IllegalArgumentException e) {
      throw wrong(node, ": " + e.getMessage());
    }
  }

  private static PoolDef.Spout spout(Json node) throws JsonException {
    knownFields(node, SPOUT);
    float[] at = vector(required(node, "at"), MAX_COORDINATE);
    float[] direction = vector(required(node, "direction"), 1);
    return new PoolDef.Spout(
        text(required(node, "name")),
        at[0],
        at[1],
        direction[0],
        direction[1],
        number(node, "width", 0, 0, 100),
        number(node, "speed", 5, 0, 50),
        bool(node, "open", true));
  }
}
