package carom.sim.level;

import carom.json.Json;
import carom.json.JsonException;
import carom.physics.BodyType;
import carom.physics.Material;
import carom.physics.effects.Attractor;
import carom.physics.geometry.Box;
import carom.physics.geometry.Capsule;
import carom.physics.geometry.Chain;
import carom.physics.geometry.Circle;
import carom.physics.geometry.Compound;
import carom.physics.geometry.Convex;
import carom.physics.geometry.Polygon;
import carom.physics.geometry.Segment;
import carom.physics.geometry.Shape;
import carom.sim.pool.PoolDef;
import carom.sim.pool.Pools;
import carom.text.Suggestion;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/**
 * Turns a JSON tree into the contents of a {@link Level}, and refuses everything else with a
 * sentence that names the place, the value and the limit. {@code levels/level.schema.json} gives
 * editors the same rules; a test compares the two.
 *
 * <p><b>Length.</b> The class holds the whole grammar of the file format.
 */
final class LevelReader {
  static final int MAX_STATIC_ITEMS = 2048;
  static final int MAX_BODY_ITEMS = 1024;
  static final int MAX_PLACEMENTS = 16_384;
  static final int MAX_SPAWNS = 1024;
  static final int MAX_ZONES = 256;
  static final int MAX_AREAS = 256;
  static final int MAX_PARTS = 32;
  static final int MAX_POINTS = 8;
  static final int MAX_CHAIN_POINTS = 256;
  static final float MAX_COORDINATE = 10_000;
  static final float MIN_SIZE = 0.05f;
  static final float MAX_SIZE = 2_000;

  static final List<String> ROOT =
      List.of(
          "$schema",
          "name",
          "game",
          "gravity",
          "bounds",
          "theme",
          "materials",
          "spawns",
          "zones",
          "areas",
          "pools",
          "statics",
          "bodies",
          "joints");
  static final List<String> BOUNDS = List.of("min", "max");
  static final List<String> THEME = List.of("background", "sky", "grid", "accent");
  static final List<String> MATERIAL =
      List.of("density", "friction", "restitution", "surfaceSpeed");
  static final List<String> SPAWN = List.of("name", "at", "team");
  static final List<String> ZONE = List.of("name", "min", "max", "team", "color");
  static final List<String> STATIC =
      List.of(
          "name",
          "at",
          "angle",
          "shape",
          "material",
          "color",
          "outline",
          "look",
          "oneWay",
          "sensor",
          "tag",
          "repeat");
  static final List<String> BODY =
      with(
          STATIC,
          "fields",
          "type",
          "linearDamping",
          "angularDamping",
          "gravityScale",
          "fixedRotation",
          "motion",
          "spin",
          "area");
  private static final List<String> AREA = List.of("type", "name", "tag", "color");
  private static final List<String> BOX_AREA = with(AREA, "min", "max");
  static final List<String> WATER = with(BOX_AREA, "density", "drag", "angularDrag", "flow");
  static final List<String> WIND = with(BOX_AREA, "velocity", "rate");
  static final List<String> GRAVITY = with(BOX_AREA, "gravity");
  static final List<String> DRAG = with(BOX_AREA, "drag", "angularDrag");
  static final List<String> ATTRACTOR =
      with(AREA, "at", "range", "strength", "swirl", "falloff", "core");
  static final List<String> AREAS = List.of("water", "wind", "gravity", "drag", "attractor");
  static final List<String> POOL =
      List.of(
          "type name color min max spacing density drag most lifetime fill drains spouts"
              .split(" "));
  static final List<String> SPOUT = List.of("name", "at", "direction", "width", "speed", "open");
  static final List<String> POOLS = List.of("water", "sand");
  static final List<String> FALLOFFS = List.of("constant", "linear", "inverseSquare");
  static final List<String> CIRCLE = List.of("type", "radius", "at");
  static final List<String> BOX = List.of("type", "width", "height", "at");
  static final List<String> POLYGON = List.of("type", "points");
  static final List<String> CAPSULE = List.of("type", "from", "to", "radius");
  static final List<String> SEGMENT = List.of("type", "from", "to");
  static final List<String> CHAIN = List.of("type", "points", "loop");
  static final List<String> COMPOUND = List.of("type", "parts");
  static final List<String> MOTION = List.of("to", "period", "phase", "eased");
  static final List<String> REPEAT = List.of("columns", "rows", "step");
  static final List<String> SHAPES =
      List.of("circle", "box", "polygon", "capsule", "segment", "chain", "compound");
  static final List<String> LINES = List.of("segment", "chain");
  static final List<String> TYPES = List.of("dynamic", "kinematic");
  static final List<String> LOOKS = looks();

  private static final Material DEFAULT_MATERIAL = new Material(1, 0.5f, 0);
  private static final float[] ZERO = new float[2];
  private static final float RAD_PER_DEGREE = (float) (Math.PI / 180);

  String name;
  String game;
  float gravityX;
  float gravityY;
  Level.Bounds bounds;
  Level.Theme theme;
  final List<ArchetypeDef> archetypes = new ArrayList<>();
  final List<Level.Placement> statics = new ArrayList<>();
  final List<Level.Placement> bodies = new ArrayList<>();
  final List<Level.Spawn> spawns = new ArrayList<>();
  final List<Level.Zone> zones = new ArrayList<>();
  final List<Area> areas = new ArrayList<>();
  final List<PoolDef> pools = new ArrayList<>();
  final List<LevelJoint> joints = new ArrayList<>();

  private final String file;
  private final LevelJointReader jointReader = new LevelJointReader(this);
  private final Map<String, Material> materials = new LinkedHashMap<>();

  LevelReader(String file, byte[] bytes) throws LevelException {
    this.file = file;
    readRoot(parse(file, bytes));
  }

  private void readRoot(Json root) throws LevelException {
    knownFields(root, ROOT);
    Json schema = root.fields.get("$schema");
    if (schema != null) {
      require(schema, Json.Kind.STRING);
    }
    name = text(required(root, "name"));
    game = text(required(root, "game"));
    float[] gravity = vector(required(root, "gravity"), 1000);
    gravityX = gravity[0];
    gravityY = gravity[1];
    readBounds(required(root, "bounds"));
    readTheme(root.fields.get("theme"));
    readMaterials(root.fields.get("materials"));
    for (Json spawn : list(root, "spawns", MAX_SPAWNS)) {
      readSpawn(spawn);
    }
    for (Json zone : list(root, "zones", MAX_ZONES)) {
      readZone(zone);
    }
    for (Json area : list(root, "areas", MAX_AREAS)) {
      areas.add(area(area));
    }
    for (Json pool : list(root, "pools", Pools.MAX_POOLS)) {
      pools.add(pool(pool));
    }
    for (Json body : list(root, "statics", MAX_STATIC_ITEMS)) {
      readBody(body, STATIC, statics);
    }
    for (Json body : list(root, "bodies", MAX_BODY_ITEMS)) {
      readBody(body, BODY, bodies);
    }
    for (Json joint : list(root, "joints", LevelJointReader.MAX_JOINTS)) {
      joints.add(jointReader.read(joint));
    }
  }

  private void readBounds(Json node) throws LevelException {
    knownFields(node, BOUNDS);
    float[] min = vector(required(node, "min"), MAX_COORDINATE);
    float[] max = vector(required(node, "max"), MAX_COORDINATE);
    requireOrder(node, min, max);
    bounds = new Level.Bounds(min[0], min[1], max[0], max[1]);
  }

  private void readTheme(Json node) throws LevelException {
    int background = 0x10161f;
    if (node == null) {
      theme = new Level.Theme(background, background, 0x1b2531, 0xffd166);
      return;
    }
    knownFields(node, THEME);
    background = color(node, "background", background);
    theme =
        new Level.Theme(
            background,
            color(node, "sky", background),
            color(node, "grid", 0x1b2531),
            color(node, "accent", 0xffd166));
  }

  private void readMaterials(Json node) throws LevelException {
    if (node == null) {
      return;
    }
    require(node, Json.Kind.OBJECT);
    for (Map.Entry<String, Json> entry : node.fields.entrySet()) {
      materials.put(entry.getKey(), newMaterial(entry.getValue()));
    }
  }

  private Material newMaterial(Json node) throws LevelException {
    knownFields(node, MATERIAL);
    return new Material(
        number(node, "density", DEFAULT_MATERIAL.density(), 0.001f, 1000),
        number(node, "friction", DEFAULT_MATERIAL.friction(), 0, 10),
        number(node, "restitution", DEFAULT_MATERIAL.restitution(), 0, 2),
        0,
        number(node, "surfaceSpeed", 0, -1000, 1000),
        0);
  }

  private Material material(Json node) throws LevelException {
    if (node == null) {
      return DEFAULT_MATERIAL;
    }
    if (node.kind != Json.Kind.STRING) {
      return newMaterial(node);
    }
    Material material = materials.get(node.text);
    if (material == null) {
      throw unknownWord(node, materials.keySet(), "a name under \"materials\"");
    }
    return material;
  }

  private void readSpawn(Json node) throws LevelException {
    knownFields(node, SPAWN);
    Json spawnName = node.fields.get("name");
    float[] at = vector(required(node, "at"), MAX_COORDINATE);
    if (!bounds.contains(at[0], at[1])) {
      throw wrong(
          node.fields.get("at"),
          "=[" + at[0] + ", " + at[1] + "] must lie inside the level's bounds");
    }
    spawns.add(
        new Level.Spawn(
            spawnName == null ? "player" : text(spawnName),
            at[0],
            at[1],
            integer(node, "team", 0, 0, 255)));
  }

  private void readZone(Json node) throws LevelException {
    knownFields(node, ZONE);
    String zoneName = text(required(node, "name"));
    float[] min = vector(required(node, "min"), MAX_COORDINATE);
    float[] max = vector(required(node, "max"), MAX_COORDINATE);
    requireOrder(node, min, max);
    zones.add(
        new Level.Zone(
            zoneName,
            min[0],
            min[1],
            max[0],
            max[1],
            integer(node, "team", 0, 0, 255),
            color(node, "color", -1)));
  }

  private Area area(Json node) throws LevelException {
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

  private Area water(Json node) throws LevelException {
    knownFields(node, WATER);
    float[] box = box4(node);
    float[] flow = node.fields.containsKey("flow") ? vector(node.fields.get("flow"), 1000) : ZERO;
    required(node, "density");
    return Area.water(box[0], box[1], box[2], box[3], number(node, "density", 1, 0.001f, 1000))
        .drag(number(node, "drag", 1, 0, 1000), number(node, "angularDrag", 1, 0, 1000))
        .flow(flow[0], flow[1]);
  }

  private Area wind(Json node) throws LevelException {
    knownFields(node, WIND);
    float[] box = box4(node);
    float[] velocity = vector(required(node, "velocity"), 1000);
    float rate = number(node, "rate", 1, 0, 1000);
    return Area.wind(box[0], box[1], box[2], box[3], velocity[0], velocity[1], rate);
  }

  private Area gravityArea(Json node) throws LevelException {
    knownFields(node, GRAVITY);
    float[] box = box4(node);
    float[] gravity = vector(required(node, "gravity"), 1000);
    return Area.gravity(box[0], box[1], box[2], box[3], gravity[0], gravity[1]);
  }

  private Area dragArea(Json node) throws LevelException {
    knownFields(node, DRAG);
    float[] box = box4(node);
    required(node, "drag");
    float drag = number(node, "drag", 1, 0, 1000);
    return Area.drag(
        box[0], box[1], box[2], box[3], drag, number(node, "angularDrag", drag, 0, 1000));
  }

  private Area attractor(Json node) throws LevelException {
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

  private PoolDef pool(Json node) throws LevelException {
    knownFields(node, POOL);
    required(node, "type");
    boolean water = word(node, "type", POOLS, "").equals("water");
    String poolName = text(required(node, "name"));
    float[] box = box4(node);
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
        float[] b = box4(fill);
        def = def.fill(b[0], b[1], b[2], b[3]);
      }
      for (Json drain : list(node, "drains", PoolDef.MAX_BOXES)) {
        knownFields(drain, BOUNDS);
        float[] b = box4(drain);
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

  private PoolDef.Spout spout(Json node) throws LevelException {
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

  /** Returns the corners of an area: min x and y, max x and y. */
  private float[] box4(Json node) throws LevelException {
    float[] min = vector(required(node, "min"), MAX_COORDINATE);
    float[] max = vector(required(node, "max"), MAX_COORDINATE);
    requireOrder(node, min, max);
    return new float[] {min[0], min[1], max[0], max[1]};
  }

  private void readBody(Json node, List<String> known, List<Level.Placement> out)
      throws LevelException {
    knownFields(node, known);
    boolean isStatic = known == STATIC;
    Json bodyName = node.fields.get("name");
    ArchetypeDef def = new ArchetypeDef(bodyName == null ? node.path() : text(bodyName));
    float[] at = vector(required(node, "at"), MAX_COORDINATE);
    float angle = number(node, "angle", 0, -360, 360) * RAD_PER_DEGREE;
    Material material = material(node.fields.get("material"));
    def.shape(shape(required(node, "shape"), true), material);
    def.oneWay(bool(node, "oneWay", false));
    def.sensor(bool(node, "sensor", false));
    def.tag(integer(node, "tag", 0, 0, 65535));
    def.appearance(appearance(node, isStatic));
    if (isStatic) {
      def.type(BodyType.STATIC);
    } else {
      readMoving(node, def, at);
    }
    int first = out.size();
    place(node, at, angle, out);
    jointReader.item(def.name, isStatic, first, out.size() - first);
    archetypes.add(def);
  }

  private void readMoving(Json node, ArchetypeDef def, float[] at) throws LevelException {
    boolean kinematic = word(node, "type", TYPES, "dynamic").equals("kinematic");
    def.type(kinematic ? BodyType.KINEMATIC : BodyType.DYNAMIC);
    Json shape = node.fields.get("shape");
    if (!kinematic && LINES.contains(shape.fields.get("type").text)) {
      throw wrong(
          shape.fields.get("type"),
          " is a line without mass; move the item to \"statics\", set \"type\": \"kinematic\","
              + " or use a capsule");
    }
    def.linearDamping(number(node, "linearDamping", 0, 0, 100));
    def.angularDamping(number(node, "angularDamping", 0, 0, 100));
    def.gravityScale(number(node, "gravityScale", 1, -10, 10));
    def.fixedRotation(bool(node, "fixedRotation", false));
    readFields(node.fields.get("fields"), def);
    Json area = node.fields.get("area");
    def.area(area == null ? null : area(area));
    def.spin(number(node, "spin", 0, -1080, 1080) * RAD_PER_DEGREE);
    Json motion = node.fields.get("motion");
    if (motion != null) {
      knownFields(motion, MOTION);
      float[] to = vector(required(motion, "to"), MAX_COORDINATE);
      required(motion, "period");
      def.motion(
          new ScriptedMotion(
              at[0],
              at[1],
              to[0],
              to[1],
              number(motion, "period", 1, 0.1f, 600),
              number(motion, "phase", 0, 0, 1),
              bool(motion, "eased", true)));
    }
    for (String field : List.of("motion", "spin")) {
      if (node.fields.containsKey(field) && !kinematic) {
        throw wrong(
            node.fields.get(field), " moves only kinematic bodies; set \"type\": \"kinematic\"");
      }
    }
    if (motion != null && node.fields.containsKey("repeat")) {
      throw wrong(motion, " belongs to one body only; remove \"repeat\"");
    }
  }

  private void readFields(Json node, ArchetypeDef def) throws LevelException {
    if (node == null) {
      return;
    }
    require(node, Json.Kind.OBJECT);
    for (Map.Entry<String, Json> field : node.fields.entrySet()) {
      Json value = field.getValue();
      Object start =
          switch (value.kind) {
            case NUMBER -> value.number;
            case BOOLEAN -> value.truth;
            case STRING -> value.text;
            default -> throw wrong(value, " must be a number, true or false, or a text");
          };
      String where = file + ":" + value.line + ":" + value.column + ": " + value.path();
      def.levelFields.add(new LevelField(where, field.getKey(), start));
    }
  }

  private void place(Json node, float[] at, float angle, List<Level.Placement> out)
      throws LevelException {
    int columns = 1;
    int rows = 1;
    float[] step = {0, 0};
    Json repeat = node.fields.get("repeat");
    if (repeat != null) {
      knownFields(repeat, REPEAT);
      columns = integer(repeat, "columns", 1, 1, 100);
      rows = integer(repeat, "rows", 1, 1, 100);
      step = vector(required(repeat, "step"), MAX_COORDINATE);
    }
    if (out.size() + columns * rows > MAX_PLACEMENTS) {
      throw wrong(
          node,
          " brings the number of bodies to "
              + (out.size() + columns * rows)
              + ", beyond the limit of "
              + MAX_PLACEMENTS);
    }
    for (int row = 0; row < rows; row++) {
      for (int column = 0; column < columns; column++) {
        out.add(
            new Level.Placement(
                archetypes.size(), at[0] + column * step[0], at[1] + row * step[1], angle));
      }
    }
  }

  private Appearance appearance(Json node, boolean isStatic) throws LevelException {
    String look = word(node, "look", LOOKS, isStatic ? "wall" : "plain");
    int rgb = color(node, "color", isStatic ? 0x3d5a80 : 0xb08968);
    Appearance plain = Appearance.of(rgb, Appearance.Look.valueOf(look.toUpperCase(Locale.ROOT)));
    return new Appearance(rgb, color(node, "outline", plain.outlineRgb()), plain.look());
  }

  private Shape shape(Json node, boolean compoundAllowed) throws LevelException {
    require(node, Json.Kind.OBJECT);
    required(node, "type");
    String type = word(node, "type", SHAPES, "");
    if (type.equals("compound") && !compoundAllowed) {
      throw wrong(node.fields.get("type"), "=\"compound\" can't be part of a compound");
    }
    if (LINES.contains(type) && !compoundAllowed) {
      throw wrong(
          node.fields.get("type"),
          "=\"" + type + "\" is a line and can't be part of a compound; give it a body of its own");
    }
    try {
      return switch (type) {
        case "circle" -> circle(node);
        case "box" -> box(node);
        case "polygon" -> polygon(node);
        case "capsule" -> capsule(node);
        case "segment" -> segment(node);
        case "chain" -> chain(node);
        default -> compound(node);
      };
    } catch (IllegalArgumentException e) {
      throw wrong(node, ": " + e.getMessage());
    }
  }

  private Circle circle(Json node) throws LevelException {
    knownFields(node, CIRCLE);
    float[] at = offset(node);
    return new Circle(size(node, "radius"), at[0], at[1]);
  }

  private Box box(Json node) throws LevelException {
    knownFields(node, BOX);
    float[] at = offset(node);
    return new Box(size(node, "width") / 2, size(node, "height") / 2, at[0], at[1]);
  }

  private Polygon polygon(Json node) throws LevelException {
    knownFields(node, POLYGON);
    required(node, "points");
    List<Json> points = list(node, "points", MAX_POINTS);
    if (points.size() < 3) {
      throw wrong(node.fields.get("points"), " has " + points.size() + " points, needs 3 at least");
    }
    return Polygon.of(coordinates(points));
  }

  private float[] coordinates(List<Json> points) throws LevelException {
    float[] xy = new float[2 * points.size()];
    for (int i = 0; i < points.size(); i++) {
      float[] point = vector(points.get(i), MAX_SIZE);
      xy[2 * i] = point[0];
      xy[2 * i + 1] = point[1];
    }
    return xy;
  }

  private Capsule capsule(Json node) throws LevelException {
    knownFields(node, CAPSULE);
    float[] from = vector(required(node, "from"), MAX_SIZE);
    float[] to = vector(required(node, "to"), MAX_SIZE);
    return new Capsule(from[0], from[1], to[0], to[1], size(node, "radius"));
  }

  private Segment segment(Json node) throws LevelException {
    knownFields(node, SEGMENT);
    float[] from = vector(required(node, "from"), MAX_SIZE);
    float[] to = vector(required(node, "to"), MAX_SIZE);
    return new Segment(from[0], from[1], to[0], to[1]);
  }

  private Chain chain(Json node) throws LevelException {
    knownFields(node, CHAIN);
    required(node, "points");
    float[] xy = coordinates(list(node, "points", MAX_CHAIN_POINTS));
    return bool(node, "loop", false) ? Chain.loop(xy) : Chain.open(xy);
  }

  private Compound compound(Json node) throws LevelException {
    knownFields(node, COMPOUND);
    required(node, "parts");
    List<Json> parts = list(node, "parts", MAX_PARTS);
    if (parts.isEmpty()) {
      throw wrong(node.fields.get("parts"), " has no part, needs 1 at least");
    }
    Convex[] convex = new Convex[parts.size()];
    for (int i = 0; i < convex.length; i++) {
      convex[i] = (Convex) shape(parts.get(i), false);
    }
    return Compound.of(convex);
  }

  private float size(Json node, String field) throws LevelException {
    required(node, field);
    return number(node, field, 1, MIN_SIZE, MAX_SIZE);
  }

  private float[] offset(Json node) throws LevelException {
    Json at = node.fields.get("at");
    return at == null ? new float[2] : vector(at, MAX_SIZE);
  }

  private void requireOrder(Json node, float[] min, float[] max) throws LevelException {
    if (!(min[0] < max[0] && min[1] < max[1])) {
      throw wrong(
          node.fields.get("max"),
          String.format(
              Locale.ROOT,
              "=[%s, %s] must be right of and above min=[%s, %s]",
              max[0],
              max[1],
              min[0],
              min[1]));
    }
  }

  private List<Json> list(Json parent, String field, int limit) throws LevelException {
    Json node = parent.fields.get(field);
    if (node == null) {
      return List.of();
    }
    require(node, Json.Kind.ARRAY);
    if (node.items.size() > limit) {
      throw wrong(node, " has " + node.items.size() + " items, the limit is " + limit);
    }
    return node.items;
  }

  float[] vector(Json node, float limit) throws LevelException {
    require(node, Json.Kind.ARRAY);
    if (node.items.size() != 2) {
      throw wrong(node, " has " + node.items.size() + " numbers, needs 2: [x, y]");
    }
    return new float[] {
      number(node.items.get(0), -limit, limit), number(node.items.get(1), -limit, limit)
    };
  }

  float number(Json parent, String field, float otherwise, float min, float max)
      throws LevelException {
    Json node = parent.fields.get(field);
    return node == null ? otherwise : number(node, min, max);
  }

  private float number(Json node, float min, float max) throws LevelException {
    require(node, Json.Kind.NUMBER);
    if (!(node.number >= min && node.number <= max)) {
      throw wrong(node, "=" + node.shown() + " must be in " + plain(min) + ".." + plain(max));
    }
    return (float) node.number;
  }

  private int integer(Json parent, String field, int otherwise, int min, int max)
      throws LevelException {
    Json node = parent.fields.get(field);
    if (node == null) {
      return otherwise;
    }
    float value = number(node, min, max);
    if (value != Math.round(value)) {
      throw wrong(node, "=" + node.shown() + " must be a whole number");
    }
    return Math.round(value);
  }

  boolean bool(Json parent, String field, boolean otherwise) throws LevelException {
    Json node = parent.fields.get(field);
    if (node == null) {
      return otherwise;
    }
    require(node, Json.Kind.BOOLEAN);
    return node.truth;
  }

  String text(Json node) throws LevelException {
    require(node, Json.Kind.STRING);
    if (node.text.isBlank() || node.text.length() > 64) {
      throw wrong(node, "=" + node.shown() + " must have 1..64 characters");
    }
    return node.text;
  }

  String word(Json parent, String field, List<String> words, String otherwise)
      throws LevelException {
    Json node = parent.fields.get(field);
    if (node == null) {
      return otherwise;
    }
    require(node, Json.Kind.STRING);
    if (!words.contains(node.text)) {
      throw unknownWord(node, words, "one of " + words);
    }
    return node.text;
  }

  private int color(Json parent, String field, int otherwise) throws LevelException {
    Json node = parent.fields.get(field);
    if (node == null) {
      return otherwise;
    }
    require(node, Json.Kind.STRING);
    if (!node.text.matches("#[0-9a-fA-F]{6}")) {
      throw wrong(node, "=" + node.shown() + " must be a colour such as \"#ffd166\"");
    }
    return Integer.parseInt(node.text.substring(1), 16);
  }

  void knownFields(Json node, List<String> known) throws LevelException {
    require(node, Json.Kind.OBJECT);
    for (Map.Entry<String, Json> entry : node.fields.entrySet()) {
      if (!known.contains(entry.getKey())) {
        String hint = Suggestion.didYouMean(entry.getKey(), known);
        throw wrong(
            entry.getValue(), " is unknown" + (hint.isEmpty() ? "; known are " + known : hint));
      }
    }
  }

  Json required(Json parent, String field) throws LevelException {
    require(parent, Json.Kind.OBJECT);
    Json node = parent.fields.get(field);
    if (node == null) {
      String path = parent.path().isEmpty() ? field : parent.path() + "." + field;
      throw new LevelException(file, parent.line, parent.column, path, " is missing");
    }
    return node;
  }

  void require(Json node, Json.Kind kind) throws LevelException {
    if (node.kind != kind) {
      throw wrong(
          node,
          (node.path().isEmpty() ? "the file holds " : "=")
              + node.shown()
              + ", must be "
              + kind.words);
    }
  }

  LevelException unknownWord(Json node, Iterable<String> words, String limit) {
    List<String> known = new ArrayList<>();
    words.forEach(known::add);
    return wrong(
        node, "=" + node.shown() + " must be " + limit + Suggestion.didYouMean(node.text, known));
  }

  LevelException wrong(Json node, String problem) {
    return new LevelException(file, node.line, node.column, node.path(), problem);
  }

  /** Returns a number as people write it: 0.05, but 2000 rather than 2000.0. */
  private static String plain(float value) {
    return value == Math.rint(value) ? String.valueOf((long) value) : String.valueOf(value);
  }

  private static Json parse(String file, byte[] bytes) throws LevelException {
    try {
      return Json.parse(bytes);
    } catch (JsonException e) {
      throw new LevelException(file, e.line(), e.column(), e.path(), e.getMessage());
    }
  }

  private static List<String> with(List<String> base, String... more) {
    List<String> all = new ArrayList<>(base);
    all.addAll(List.of(more));
    return List.copyOf(all);
  }

  private static List<String> looks() {
    List<String> looks = new ArrayList<>();
    for (Appearance.Look look : Appearance.Look.values()) {
      looks.add(look.name().toLowerCase(Locale.ROOT));
    }
    return List.copyOf(looks);
  }
}
