package carom.sim.level;

import static carom.text.JsonFields.bool;
import static carom.text.JsonFields.box;
import static carom.text.JsonFields.color;
import static carom.text.JsonFields.integer;
import static carom.text.JsonFields.knownFields;
import static carom.text.JsonFields.list;
import static carom.text.JsonFields.number;
import static carom.text.JsonFields.require;
import static carom.text.JsonFields.required;
import static carom.text.JsonFields.text;
import static carom.text.JsonFields.vector;
import static carom.text.JsonFields.word;
import static carom.text.JsonFields.wrong;

import carom.physics.BodyType;
import carom.physics.ChainDef;
import carom.physics.MotionLocks;
import carom.physics.ShapeDef;
import carom.sim.level.ShapeReader.BodyShapes;
import carom.sim.pool.PoolDef;
import carom.sim.pool.Pools;
import carom.text.Json;
import carom.text.JsonException;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/**
 * Turns a JSON tree into the contents of a {@link Level}, and refuses everything else with a
 * sentence that names the place, the value and the limit. {@code levels/level.schema.json} gives
 * editors the same rules; a test compares the two. Shapes, materials, areas, pools, joints and
 * triggers have readers of their own.
 */
final class LevelReader {
  static final int MAX_VERSION = 65_535;
  static final int MAX_STATIC_ITEMS = 2048;
  static final int MAX_BODY_ITEMS = 1024;
  static final int MAX_PLACEMENTS = 16_384;

  /** Most kinds of bodies. The other quarter of all archetypes is the game's. */
  static final int MAX_ARCHETYPES = Archetypes.MAX * 3 / 4;

  /**
   * Most convex parts of all placed statics and bodies together: what a level costs in memory and
   * time before the first player comes, about 30 MB. A file of 4 kB can ask for millions.
   */
  static final int MAX_PLACED_PARTS = 65_536;

  static final int MAX_SPAWNS = 1024;
  static final int MAX_ZONES = 256;
  static final int MAX_AREAS = 256;
  static final float MAX_COORDINATE = 10_000;

  static final List<String> ROOT =
      List.of(
          "$schema",
          "version",
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
          "joints",
          "triggers");
  static final List<String> BOUNDS = List.of("min", "max");
  static final List<String> THEME = List.of("background", "sky", "grid", "accent");
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
          "lockX",
          "lockY",
          "motion",
          "spin",
          "area");
  static final List<String> MOTION = List.of("to", "period", "phase", "eased");
  static final List<String> REPEAT = List.of("columns", "rows", "step");
  static final List<String> TYPES = List.of("dynamic", "kinematic");
  static final List<String> LOOKS = looks();

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
  final List<LevelTrigger> triggers = new ArrayList<>();

  /** The item in the file of each archetype. */
  final List<Json> items = new ArrayList<>();

  private final String file;
  private final List<LevelException> problems; // or null if the first one ends the reading
  private final LevelJointReader jointReader = new LevelJointReader(this);
  private final MaterialReader materials = new MaterialReader();
  private int placedParts;

  /** Reads one item of a list. */
  private interface ItemReader {
    void read(Json item) throws JsonException;
  }

  LevelReader(String file, byte[] bytes) throws LevelException {
    this.file = file;
    problems = null;
    try {
      readRoot(Json.parse(bytes));
    } catch (JsonException e) {
      throw problem(e);
    }
  }

  /**
   * Reads as far as it can.
   *
   * @param problems receives what is wrong; if there is anything, what was read is of no use
   */
  LevelReader(String file, Json root, List<LevelException> problems) {
    this.file = file;
    this.problems = problems;
    try {
      readRoot(root);
    } catch (JsonException e) {
      problems.add(problem(e));
    }
  }

  private LevelException problem(JsonException e) {
    return new LevelException(file, e.line(), e.column(), e.path(), e.getMessage());
  }

  private void each(Json root, String field, int limit, ItemReader reader) throws JsonException {
    for (Json item : list(root, field, limit)) {
      try {
        reader.read(item);
      } catch (JsonException e) {
        if (problems == null) {
          throw e;
        }
        problems.add(problem(e));
      }
    }
  }

  private void readRoot(Json root) throws JsonException {
    readVersion(root); // before the fields, which a newer form may have more of
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
    materials.readNamed(root.fields.get("materials"));
    each(root, "spawns", MAX_SPAWNS, this::readSpawn);
    each(root, "zones", MAX_ZONES, this::readZone);
    each(root, "areas", MAX_AREAS, area -> areas.add(AreaReader.area(area)));
    each(root, "pools", Pools.MAX_POOLS, pool -> pools.add(PoolReader.pool(pool)));
    each(root, "statics", MAX_STATIC_ITEMS, body -> readBody(body, STATIC, statics));
    each(root, "bodies", MAX_BODY_ITEMS, body -> readBody(body, BODY, bodies));
    if (problems != null && !problems.isEmpty()) {
      return; // what joints and triggers name may be what can't be read
    }
    each(root, "joints", LevelJointReader.MAX_JOINTS, joint -> joints.add(jointReader.read(joint)));
    triggers.addAll(new TriggerReader(this, file, jointReader).read(root));
  }

  private static void readVersion(Json root) throws JsonException {
    require(root, Json.Kind.OBJECT);
    int version = integer(root, "version", Level.VERSION, 1, MAX_VERSION);
    if (version > Level.VERSION) {
      throw wrong(
          root.fields.get("version"),
          "="
              + version
              + " is newer than "
              + Level.VERSION
              + ", the newest that this program reads; use a newer Carom");
    }
  }

  private void readBounds(Json node) throws JsonException {
    knownFields(node, BOUNDS);
    float[] box = box(node, MAX_COORDINATE);
    bounds = new Level.Bounds(box[0], box[1], box[2], box[3]);
  }

  private void readTheme(Json node) throws JsonException {
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

  private void readSpawn(Json node) throws JsonException {
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

  private void readZone(Json node) throws JsonException {
    knownFields(node, ZONE);
    String zoneName = text(required(node, "name"));
    float[] box = box(node, MAX_COORDINATE);
    zones.add(
        new Level.Zone(
            zoneName,
            box[0],
            box[1],
            box[2],
            box[3],
            integer(node, "team", 0, 0, 255),
            color(node, "color", -1)));
  }

  private void readBody(Json node, List<String> known, List<Level.Placement> out)
      throws JsonException {
    knownFields(node, known);
    boolean isStatic = known == STATIC;
    Json shape = required(node, "shape");
    List<BodyShapes> made = ShapeReader.bodies(shape, node.fields.get("material"), materials);
    if (!isStatic && made.size() > 1) {
      throw wrong(
          shape,
          " needs "
              + made.size()
              + " bodies, because a body takes "
              + ChainDef.MAX_BODY_PARTS
              + " lines of one color; move the item to \"statics\", or make it several items");
    }
    if (archetypes.size() + made.size() > MAX_ARCHETYPES) {
      throw wrong(
          shape,
          " brings the number of kinds of bodies to "
              + (archetypes.size() + made.size())
              + ", beyond the limit of "
              + MAX_ARCHETYPES
              + "; use fewer colors along the chain");
    }
    for (int i = 0; i < made.size(); i++) {
      readBody(node, isStatic, made.get(i), i == 0, out);
    }
  }

  /**
   * Reads one of the bodies that an item needs.
   *
   * @param isNamed whether joints find it by the item's name
   */
  private void readBody(
      Json node, boolean isStatic, BodyShapes made, boolean isNamed, List<Level.Placement> out)
      throws JsonException {
    Json bodyName = node.fields.get("name");
    ArchetypeDef def = new ArchetypeDef(bodyName == null ? node.path() : text(bodyName));
    float[] at = vector(required(node, "at"), MAX_COORDINATE);
    float angle = number(node, "angle", 0, -360, 360) * RAD_PER_DEGREE;
    for (ShapeDef shape : made.shapes()) {
      def.shape(shape.shape(), shape.material());
    }
    def.oneWay(bool(node, "oneWay", false));
    def.sensor(bool(node, "sensor", false));
    def.tag(integer(node, "tag", 0, 0, 65535));
    def.appearance(appearance(node, isStatic, made.rgb()));
    if (isStatic) {
      def.type(BodyType.STATIC);
    } else {
      readMoving(node, def, at);
    }
    int first = out.size();
    place(node, at, angle, made.parts(), out);
    if (isNamed) {
      jointReader.item(def.name, isStatic, first, out.size() - first);
    }
    archetypes.add(def);
    items.add(node);
  }

  private void readMoving(Json node, ArchetypeDef def, float[] at) throws JsonException {
    boolean kinematic = word(node, "type", TYPES, "dynamic").equals("kinematic");
    def.type(kinematic ? BodyType.KINEMATIC : BodyType.DYNAMIC);
    Json shape = node.fields.get("shape");
    if (!kinematic && ShapeReader.LINES.contains(shape.fields.get("type").text)) {
      throw wrong(
          shape.fields.get("type"),
          " is a line without mass; move the item to \"statics\", set \"type\": \"kinematic\","
              + " or use a capsule");
    }
    def.linearDamping(number(node, "linearDamping", 0, 0, 100));
    def.angularDamping(number(node, "angularDamping", 0, 0, 100));
    def.gravityScale(number(node, "gravityScale", 1, -10, 10));
    def.motionLocks(
        new MotionLocks(
            bool(node, "lockX", false),
            bool(node, "lockY", false),
            bool(node, "fixedRotation", false)));
    readFields(node.fields.get("fields"), def);
    Json area = node.fields.get("area");
    if (area != null) {
      def.area(AreaReader.area(area));
    }
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

  private void readFields(Json node, ArchetypeDef def) throws JsonException {
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

  private void place(Json node, float[] at, float angle, int parts, List<Level.Placement> out)
      throws JsonException {
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
    placedParts += columns * rows * parts;
    if (placedParts > MAX_PLACED_PARTS) {
      throw wrong(
          node,
          " brings the number of convex parts to "
              + placedParts
              + ", beyond the limit of "
              + MAX_PLACED_PARTS
              + "; repeat it less often, or give its shape fewer points or parts (it has "
              + parts
              + ")");
    }
    for (int row = 0; row < rows; row++) {
      for (int column = 0; column < columns; column++) {
        out.add(
            new Level.Placement(
                archetypes.size(), at[0] + column * step[0], at[1] + row * step[1], angle));
      }
    }
  }

  private Appearance appearance(Json node, boolean isStatic, int materialRgb) throws JsonException {
    boolean hasColour = materialRgb >= 0 || node.fields.containsKey("color");
    boolean isWall = isStatic && (hasColour || !bool(node, "sensor", false)); // what holds looks so
    String look = word(node, "look", LOOKS, isWall ? "wall" : "plain");
    int usual = isStatic ? 0x3d5a80 : 0xb08968;
    int rgb = color(node, "color", materialRgb < 0 ? usual : materialRgb);
    Appearance plain = Appearance.of(rgb, Appearance.Look.valueOf(look.toUpperCase(Locale.ROOT)));
    return new Appearance(rgb, color(node, "outline", plain.outlineRgb()), plain.look());
  }

  static List<String> with(List<String> base, String... more) {
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
