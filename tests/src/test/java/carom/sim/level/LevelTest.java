package carom.sim.level;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertDoesNotThrow;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.physics.Body;
import carom.physics.BodyDef;
import carom.physics.BodyType;
import carom.physics.Material;
import carom.physics.World;
import carom.physics.WorldDef;
import carom.physics.effects.Wind;
import carom.physics.geometry.Box;
import carom.physics.geometry.Shape;
import carom.physics.settings.MixingRule;
import carom.sim.SchemaChecker;
import carom.text.Json;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;

/** Goal: every mistake in a level file is answered with its place. Method: one small file each. */
class LevelTest {
  /**
   * A file, what the message must begin with, and whether the schema can see the mistake as well.
   */
  private record Case(String name, String json, String message, boolean schema) {}

  private static final String HEAD =
      """
      {
      "name": "t", "game": "arena", "gravity": [0, -10],
      "bounds": {"min": [-10, -10], "max": [10, 10]},
      """;
  private static final String BOX = "\"shape\": {\"type\": \"box\", \"width\": 1, \"height\": 1}";

  private static Case field(String name, String rest, String message) {
    return new Case(name, HEAD + rest + "\n}", "t.json:" + message, true);
  }

  private static Case meaning(String name, String rest, String message) {
    return new Case(name, HEAD + rest + "\n}", "t.json:" + message, false);
  }

  private static List<Case> cases() {
    List<Case> c = new ArrayList<>();
    c.add(new Case("empty", "", "t.json:1:1: the file is empty", false));
    c.add(
        new Case(
            "not an object", "[1]", "t.json:1:1: the file holds a list, must be an object", true));
    c.add(new Case("no JSON", "{\n  name: 1}", "t.json:2:3: not JSON", false));
    c.add(new Case("cut", "{\"name\": \"a\",", "t.json:1:", false));
    c.add(new Case("NaN", "{\"gravity\": [NaN, 0]}", "t.json:1:", false));
    c.add(
        new Case(
            "two documents",
            HEAD + "\"spawns\": []} {}",
            "t.json:4:15: nothing may follow",
            false));
    c.add(new Case("missing", "{\n \"name\": \"a\"\n}", "t.json:1:1: game is missing", true));
    c.add(
        field(
            "unknown",
            "\"statics\": [],\n \"bodys\": []",
            "5:11: bodys is unknown; did you mean \"bodies\"?"));
    c.add(
        field(
            "unknown, nothing like it", "\"xyz\": 1", "4:8: xyz is unknown; known are [$schema,"));
    c.add(
        meaning(
            "twice", "\"spawns\": [],\n\"spawns\": []", "5:1: spawns stands here a second time"));
    c.add(field("wrong type", "\"spawns\": {}", "4:11: spawns=an object, must be a list"));
    c.add(field("null", "\"spawns\": null", "4:11: spawns=null, must be a list"));
    c.add(
        field(
            "short point",
            "\"spawns\": [{\"at\": [1]}]",
            "4:19: spawns[0].at has 1 numbers, needs 2: [x, y]"));
    c.add(
        field(
            "far away",
            "\"spawns\": [{\"at\": [1e5, 0]}]",
            "4:20: spawns[0].at[0]=1e5 must be in -10000..10000"));
    c.add(
        field(
            "infinite",
            "\"spawns\": [{\"at\": [1e999, 0]}]",
            "4:20: spawns[0].at[0]=1e999 must be in -10000..10000"));
    c.add(
        meaning(
            "out of bounds",
            "\"spawns\": [{\"at\": [11, 0]}]",
            "4:19: spawns[0].at=[11.0, 0.0] must lie inside the level's bounds"));
    c.add(
        field(
            "fraction",
            "\"spawns\": [{\"at\": [1, 0], \"team\": 1.5}]",
            "4:35: spawns[0].team=1.5 must be a whole number"));
    c.add(
        meaning(
            "turned zone",
            "\"zones\": [{\"name\":\"z\", \"min\": [0, 0], \"max\": [1, 0]}]",
            "4:46: zones[0].max=[1.0, 0.0] must be right of and above min=[0.0, 0.0]"));
    addAreas(c);
    c.add(
        field(
            "colour",
            "\"theme\": {\"sky\": \"blue\"}",
            "4:18: theme.sky=\"blue\" must be a colour such as \"#ffd166\""));
    c.add(
        field(
            "negative radius",
            "\"bodies\": [{\"at\": [0, 0], \"shape\":\n{\"type\": \"circle\", \"radius\": -1}}]",
            "5:30: bodies[0].shape.radius=-1 must be in 0.05..2000"));
    c.add(
        field(
            "text for number",
            "\"bodies\": [{\"at\": [0, 0], \"shape\":\n{\"type\": \"circle\", \"radius\": \"1\"}}]",
            "5:30: bodies[0].shape.radius=\"1\", must be a number"));
    c.add(
        field(
            "shape type",
            "\"statics\": [{\"at\": [0, 0], \"shape\": {\"type\": \"bix\"}}]",
            "4:46: statics[0].shape.type=\"bix\" must be one of [circle, box, polygon, capsule,"
                + " segment, chain, compound]; did you mean \"box\"?"));
    c.add(
        field(
            "shape missing",
            "\"statics\": [{\"at\": [0, 0]}]",
            "4:13: statics[0].shape is missing"));
    c.add(
        field(
            "two points",
            "\"statics\": [{\"at\": [0, 0], \"shape\": {\"type\": \"polygon\", \"points\":"
                + " [[0,0],[1,1]]}}]",
            "4:67: statics[0].shape.points has 2 points, needs 3 at least"));
    c.add(
        meaning(
            "flat polygon",
            "\"statics\": [{\"at\": [0, 0], \"shape\": {\"type\": \"polygon\", \"points\":"
                + " [[0,0],[1,1],[2,2]]}}]",
            "4:37: statics[0].shape: outline turns back on itself at point=0"));
    c.add(
        meaning(
            "crossing polygon",
            "\"statics\": [{\"at\": [0, 0], \"shape\": {\"type\": \"polygon\", \"points\":"
                + " [[0,0],[2,2],[2,0],[0,2]]}}]",
            "4:37: statics[0].shape: outline edge=0 (from point 0) meets edge=2"));
    c.add(
        field(
            "mixing",
            "\"materials\": {\"ice\": {\"frictionMixing\": \"mni\"}}",
            "4:41: materials.ice.frictionMixing=\"mni\" must be one of"));
    c.add(
        meaning(
            "two winds",
            "\"areas\": [{\"type\": \"wind\", \"min\": [0, 0], \"max\": [1, 1], \"velocity\":"
                + " [1, 0],\n\"rate\": 1, \"lift\": 1}]",
            "5:9: areas[0].rate stands beside drag or lift"));
    c.add(
        field(
            "nested compound",
            "\"statics\": [{\"at\": [0, 0], \"shape\": {\"type\": \"compound\", \"parts\":\n"
                + "[{\"type\": \"compound\", \"parts\": []}]}}]",
            "5:11: statics[0].shape.parts[0].type=\"compound\" can't be part of a compound"));
    c.addAll(contentCases());
    return c;
  }

  /** Returns the cases of materials and of what stands in a level. */
  private static List<Case> contentCases() {
    List<Case> c = new ArrayList<>();
    c.add(
        meaning(
            "material unknown",
            "\"materials\": {\"wood\": {}}, \"statics\": [{\"at\": [0, 0], \"material\": \"wod\", "
                + BOX
                + "}]",
            "4:67: statics[0].material=\"wod\" must be a name under \"materials\"; did you mean"));
    c.add(
        field(
            "damped static",
            "\"statics\": [{\"at\": [0, 0], \"linearDamping\": 1, " + BOX + "}]",
            "4:45: statics[0].linearDamping is unknown; known are"));
    c.add(
        meaning(
            "dynamic on a path",
            "\"bodies\": [{\"at\": [0, 0], \"motion\": {\"to\": [1, 0], \"period\": 2}, "
                + BOX
                + "}]",
            "4:37: bodies[0].motion moves only kinematic bodies; set \"type\": \"kinematic\""));
    c.add(
        field(
            "path without period",
            "\"bodies\": [{\"at\": [0, 0], \"type\": \"kinematic\", \"motion\": {\"to\": [1, 0]}, "
                + BOX
                + "}]",
            "4:58: bodies[0].motion.period is missing"));
    c.add(
        field(
            "too many columns",
            "\"bodies\": [{\"at\": [0, 0], \"repeat\": {\"columns\": 101, \"step\": [1, 1]}, "
                + BOX
                + "}]",
            "4:49: bodies[0].repeat.columns=101 must be in 1..100"));
    c.add(
        meaning(
            "too many bodies",
            "\"bodies\": [{\"at\": [0, 0], \"repeat\": {\"columns\": 100, \"rows\": 100, \"step\":"
                + " [1, 1]}, "
                + BOX
                + "}, {\"at\": [0, 0], \"repeat\": {\"columns\": 100, \"rows\": 64, \"step\":"
                + " [1, 1]}, "
                + BOX
                + "}]",
            "4:136: bodies[1] brings the number of bodies to 16400, beyond the limit of 16384"));
    StringBuilder points = new StringBuilder("[0, 0]");
    for (int i = 1; i < 256; i++) {
      points.append(", [").append(i).append(", ").append(i % 2).append(']');
    }
    c.add(
        meaning(
            "a small file of millions of parts",
            "\"statics\": [{\"at\": [0, 0], \"repeat\": {\"columns\": 100, \"rows\": 100, \"step\":"
                + " [0, 0]}, \"shape\": {\"type\": \"chain\", \"points\": ["
                + points
                + "]}}]",
            "4:13: statics[0] brings the number of convex parts to 2550000, beyond the limit of"
                + " 65536; repeat it less often, or give its shape fewer points or parts (it has"
                + " 255)"));
    c.add(
        meaning(
            "too few materials of a chain",
            "\"statics\": [{\"at\": [0, 0], \"shape\": {\"type\": \"chain\", \"points\": [[0, 0],"
                + " [1, 0], [2, 1]], \"materials\": [{}]}}]",
            "4:104: statics[0].shape.materials has 1 entries, must have 2: one material for each"
                + " line"));
    c.add(
        meaning(
            "too few materials of a closed chain",
            "\"statics\": [{\"at\": [0, 0], \"shape\": {\"type\": \"chain\", \"points\": [[0, 0],"
                + " [1, 0], [1, 1]], \"loop\": true, \"materials\": [{}, {}]}}]",
            "4:118: statics[0].shape.materials has 2 entries, must have 3: one material for each"
                + " line"));
    c.add(
        meaning(
            "a chain's material unknown",
            "\"materials\": {\"grass\": {}}, \"statics\": [{\"at\": [0, 0], \"shape\": {\"type\":"
                + " \"chain\", \"points\": [[0, 0], [1, 0], [2, 1]], \"materials\": [\"grass\","
                + " \"gras\"]}}]",
            "4:142: statics[0].shape.materials[1]=\"gras\" must be a name under \"materials\"; did"
                + " you mean \"grass\"?"));
    c.add(
        meaning(
            "a material beside those of a chain",
            "\"statics\": [{\"at\": [0, 0], \"material\": {}, \"shape\": {\"type\": \"chain\","
                + " \"points\": [[0, 0], [1, 0]], \"materials\": [{}]}}]",
            "4:40: statics[0].material has no effect beside \"materials\" of the chain; remove"
                + " one"));
    c.add(
        field(
            "long name",
            "\"zones\": [{\"name\": \"" + "x".repeat(65) + "\"}]",
            "4:20: zones[0].name=\"" + "x".repeat(40) + "...\" must have 1..64 characters"));
    return c;
  }

  private static void addAreas(List<Case> c) {
    c.add(
        field(
            "area without a type",
            "\"areas\": [{\"min\": [0, 0], \"max\": [1, 1]}]",
            "4:11: areas[0].type is missing"));
    c.add(
        field(
            "area of an unknown type",
            "\"areas\": [{\"type\": \"watr\"}]",
            "4:20: areas[0].type=\"watr\" must be one of [water, wind, gravity, drag, attractor];"
                + " did you mean \"water\"?"));
    c.add(
        field(
            "area with another's field",
            "\"areas\": [{\"type\": \"water\", \"min\": [0, 0], \"max\": [1, 1], \"density\": 1,"
                + " \"velocity\": [1, 0]}]",
            "4:85: areas[0].velocity is unknown; known are [type, name, tag, color, min, max,"
                + " density, drag, angularDrag, flow]"));
    c.add(
        field(
            "water without density",
            "\"areas\": [{\"type\": \"water\", \"min\": [0, 0], \"max\": [1, 1]}]",
            "4:11: areas[0].density is missing"));
    c.add(
        field(
            "wind too fast",
            "\"areas\": [{\"type\": \"wind\", \"min\": [0, 0], \"max\": [1, 1], \"velocity\":"
                + " [2000, 0]}]",
            "4:71: areas[0].velocity[0]=2000 must be in -1000..1000"));
    c.add(
        meaning(
            "turned area",
            "\"areas\": [{\"type\": \"drag\", \"min\": [0, 0], \"max\": [1, 0], \"drag\": 1}]",
            "4:50: areas[0].max=[1.0, 0.0] must be right of and above min=[0.0, 0.0]"));
    c.add(
        meaning(
            "attractor whose core is beyond its range",
            "\"areas\": [{\"type\": \"attractor\", \"at\": [0, 0], \"range\": 2, \"strength\": 1,"
                + " \"core\": 3}]",
            "4:82: areas[0].core=3 must be in 0.01..2"));
    c.add(
        field(
            "static with an area",
            "\"statics\": [{\"at\": [0, 0], \"area\": {}, " + BOX + "}]",
            "4:36: statics[0].area is unknown; known are"));
  }

  @TestFactory
  List<DynamicTest> namesThePlaceOfEveryMistake() {
    List<DynamicTest> tests = new ArrayList<>();
    for (Case c : cases()) {
      tests.add(
          DynamicTest.dynamicTest(
              c.name,
              () -> {
                LevelException e = assertThrows(LevelException.class, () -> parse(c.json));
                assertTrue(
                    e.getMessage().startsWith(c.message),
                    "expected: " + c.message + "\n but was: " + e.getMessage());
                assertFalse(e.getMessage().contains("\n"), e.getMessage());
              }));
    }
    return tests;
  }

  @TestFactory
  List<DynamicTest> theSchemaRefusesTheSameMistakes() throws Exception {
    SchemaChecker schema = SchemaChecker.levels();
    List<DynamicTest> tests = new ArrayList<>();
    for (Case c : cases()) {
      if (c.schema) {
        tests.add(
            DynamicTest.dynamicTest(
                c.name,
                () -> assertNotEquals("", schema.check(Json.parse(c.json.getBytes(UTF_8))))));
      }
    }
    return tests;
  }

  @Test
  void aLimitIsWithinItsRange() {
    String crates =
        "\"bodies\": [{\"at\": [0, 0], \"shape\": {\"type\": \"circle\", \"radius\": %s}}]}";
    for (String radius : List.of("0.05", "2000")) {
      assertDoesNotThrow(() -> parse(HEAD + String.format(Locale.ROOT, crates, radius)), radius);
    }
    for (String radius : List.of("0.0499", "2000.1", "1e300")) {
      String json = HEAD + String.format(Locale.ROOT, crates, radius);
      assertThrows(LevelException.class, () -> parse(json), radius);
    }
  }

  @Test
  void theSchemaAcceptsWhatShips() throws Exception {
    SchemaChecker schema = SchemaChecker.levels();
    for (String name :
        List.of(
            "arena",
            "rink",
            "cars",
            "quarry",
            "harbour",
            "sandbox",
            "commons",
            "lagoon",
            "orbit",
            "platformer",
            "rockets",
            "ruins",
            "shooter",
            "sluice")) {
      Level level = Level.builtIn(name);
      assertEquals("", schema.check(Json.parse(level.source())));
    }
    assertEquals("", schema.check(Json.parse((HEAD + "\"zones\": []}").getBytes(UTF_8))));
  }

  @Test
  void aConcavePolygonBecomesItsConvexPartsAndMaterialsHaveRules() throws Exception {
    String l =
        "{\"type\": \"polygon\", \"points\": [[0, 0], [2, 0], [2, 1], [1, 1], [1, 2], [0, 2]]}";
    String wall =
        "{\"at\": [0, 0], \"material\": {\"frictionMixing\": \"min\", \"restitutionMixing\":"
            + " \"geometricMean\"}, \"shape\": "
            + l
            + "}";
    String pieces =
        "{\"at\": [4, 0], \"shape\": {\"type\": \"compound\", \"parts\": ["
            + l
            + ", {\"type\": \"circle\", \"radius\": 1}]}}";
    byte[] good =
        (HEAD + "\"statics\": [" + wall + "], \"bodies\": [" + pieces + "]}").getBytes(UTF_8);
    Level level = Level.parse("t.json", good);
    Shape shape = level.archetypes().get(0).shapes.get(0);
    assertEquals(2, shape.parts().size());
    assertEquals(3, shape.area(), 1e-6);
    assertEquals(3, level.archetypes().get(1).shapes.get(0).parts().size());
    Material material = level.archetypes().get(0).materials.get(0);
    assertEquals(MixingRule.MIN, material.frictionMixing());
    assertEquals(MixingRule.GEOMETRIC_MEAN, material.restitutionMixing());
    assertEquals("", SchemaChecker.levels().check(Json.parse(good)));
  }

  @Test
  void theLinesOfAChainHaveMaterialsOfTheirOwn() throws Exception {
    byte[] good =
        (HEAD
                + "\"materials\": {\"ice\": {\"friction\": 0}}, \"statics\": [{\"at\": [0, 0],"
                + " \"shape\": {\"type\": \"chain\", \"points\": [[-20, 0], [0, 0], [10, 0],"
                + " [20, 0], [30, 0]], \"materials\": [{\"friction\": 1}, \"ice\", \"ice\","
                + " {\"friction\": 1}]}}]}")
            .getBytes(UTF_8);
    assertEquals("", SchemaChecker.levels().check(Json.parse(good)));
    Archetype ground = new Archetype(0, Level.parse("t.json", good).archetypes().get(0));
    assertEquals(List.of(1f, 0f, 1f), ground.materials().stream().map(Material::friction).toList());
    assertEquals(
        List.of(1, 2, 1), ground.shapes().stream().map(piece -> piece.parts().size()).toList());

    World<Object> world = new World<>(new WorldDef());
    world.createBody(ground.body(0, 0, 0), null);
    Body<Object> box =
        world.createBody(
            new BodyDef(BodyType.DYNAMIC)
                .shape(new Box(0.5f, 0.5f), new Material(1, 1, 0))
                .position(-8, 0.5f)
                .velocity(14, 0),
            null);
    float before = slide(world, box, 0);
    assertTrue(before < 12, "it slows down on the first line, speed=" + before);
    float onIce = slide(world, box, 18);
    assertEquals(before, onIce, 0.5f, "it keeps its speed on ice, over the joint of two lines");
    for (int tick = 0; tick < 120; tick++) {
      world.step(1 / 60f);
    }
    assertEquals(0, box.velocityX(), 0.01f);
    assertTrue(box.x() < 30, "it stops on the last line, x=" + box.x());
  }

  /** Lets a body slide until it passes x; returns its speed there. */
  private static float slide(World<Object> world, Body<Object> body, float x) {
    for (int tick = 0; body.x() < x; tick++) {
      assertTrue(tick < 300, "x=" + body.x());
      world.step(1 / 60f);
    }
    return body.velocityX();
  }

  @Test
  void aWindWithLiftBlowsAgainstEdges() throws Exception {
    byte[] good =
        (HEAD
                + "\"areas\": [{\"type\": \"wind\", \"min\": [0, 0], \"max\": [9, 9],"
                + " \"velocity\": [5, 0], \"lift\": 0.5}]}")
            .getBytes(UTF_8);
    Level level = Level.parse("t.json", good);
    World<Object> world = new World<>(new WorldDef());
    assertEquals(Wind.class, level.areas().get(0).effect(world).getClass());
    assertEquals("", SchemaChecker.levels().check(Json.parse(good)));
  }

  @Test
  void linesAndCapsulesAreReadAndLinesHaveNoPlaceAmongDynamicBodies() throws Exception {
    String lines =
        "{\"at\": [0, 0], \"shape\": {\"type\": \"chain\", \"loop\": true, \"points\": [[0, 0], [4,"
            + " 0], [2, 3]]}},{\"at\": [1, 0], \"shape\": {\"type\": \"segment\", \"from\": [0, 0],"
            + " \"to\": [2, 0]}}";
    String capsule =
        "{\"at\": [0, 0], \"shape\": {\"type\": \"capsule\", \"from\": [0, 0], \"to\": [0, 1],"
            + " \"radius\": 0.3}}";
    byte[] good =
        (HEAD + "\"statics\": [" + lines + "], \"bodies\": [" + capsule + "]}").getBytes(UTF_8);
    Level level = Level.parse("t.json", good);
    assertEquals("Chain(points=3, loop=true)", shape(level, 0));
    assertEquals("Segment(0.0 0.0, 2.0 0.0)", shape(level, 1));
    assertEquals("Capsule(0.0 0.0, 0.0 1.0, radius=0.3)", shape(level, 2));
    assertEquals("", SchemaChecker.levels().check(Json.parse(good)));
    byte[] bad = (HEAD + "\"bodies\": [" + lines + "]}").getBytes(UTF_8);
    String message =
        assertThrows(LevelException.class, () -> Level.parse("t.json", bad)).getMessage();
    assertTrue(message.contains("bodies[0].shape.type is a line without mass"), message);
  }

  private static String shape(Level level, int archetype) {
    return level.archetypes().get(archetype).shapes.get(0).toString();
  }

  @Test
  void schemaAndReaderKnowTheSameFields() throws Exception {
    SchemaChecker schema = SchemaChecker.levels();
    assertEquals(LevelReader.ROOT, schema.fields(null));
    assertEquals(LevelReader.BOUNDS, schema.fields("bounds"));
    assertEquals(LevelReader.THEME, schema.fields("theme"));
    assertEquals(MaterialReader.FIELDS, schema.fields("material"));
    assertEquals(LevelReader.SPAWN, schema.fields("spawn"));
    assertEquals(LevelReader.ZONE, schema.fields("zone"));
    assertEquals(LevelReader.STATIC, schema.fields("static"));
    assertEquals(LevelReader.BODY, schema.fields("body"));
    assertEquals(AreaReader.WATER, schema.fields("water"));
    assertEquals(AreaReader.WIND, schema.fields("wind"));
    assertEquals(AreaReader.GRAVITY, schema.fields("gravity"));
    assertEquals(AreaReader.DRAG, schema.fields("drag"));
    assertEquals(AreaReader.ATTRACTOR, schema.fields("attractor"));
    for (String type : ShapeReader.TYPES) {
      assertEquals(ShapeReader.fields(type), schema.fields(type));
    }
    assertEquals(LevelReader.MOTION, schema.fields("motion"));
    assertEquals(LevelReader.REPEAT, schema.fields("repeat"));
    assertEquals(LevelJointReader.REVOLUTE, schema.fields("revolute"));
    assertEquals(LevelJointReader.DISTANCE, schema.fields("distance"));
    assertEquals(LevelJointReader.ROPE, schema.fields("rope"));
    assertEquals(LevelJointReader.PRISMATIC, schema.fields("prismatic"));
    assertEquals(LevelJointReader.PRISMATIC, schema.fields("wheel"));
    assertEquals(LevelJointReader.RATCHET, schema.fields("ratchet"));
    assertEquals(LevelJointReader.GROOVE, schema.fields("groove"));
    assertEquals(LevelJointReader.FRICTION, schema.fields("friction"));
    assertEquals(LevelJointReader.WELD, schema.fields("weld"));
    assertEquals(LevelJointReader.MOTOR, schema.fields("motorJoint"));
    assertEquals(LevelJointReader.MOUSE, schema.fields("mouse"));
    assertEquals(LevelJointReader.GEAR, schema.fields("gear"));
    assertEquals(LevelJointReader.RACK, schema.fields("rack"));
    assertEquals(LevelJointReader.PULLEY, schema.fields("pulley"));
    assertEquals(LevelJointReader.MOTOR_FIELDS, schema.fields("drive"));
    assertEquals(LevelJointReader.SPRING, schema.fields("spring"));
    assertEquals(LevelJointReader.BREAKS, schema.fields("breaks"));
    assertEquals(LevelReader.LOOKS, schema.words("look"));
    assertEquals(TriggerReader.TRIGGER, schema.fields("trigger"));
    assertEquals(TriggerReader.CAUSES, schema.kinds("condition"));
    assertEquals(TriggerReader.VERBS, schema.kinds("action"));
  }

  @Test
  void refusesAFileBeyondTheLimit() {
    LevelException e =
        assertThrows(
            LevelException.class, () -> Level.parse("t.json", new byte[Level.MAX_BYTES + 1]));
    assertTrue(e.getMessage().contains("limit of 4194304 bytes"), e.getMessage());
  }

  @Test
  void refusesBytesThatAreNoText() {
    byte[] bytes = (HEAD + "\"zones\": []}").getBytes(UTF_8);
    bytes[12] = (byte) 0xff;
    assertThrows(LevelException.class, () -> Level.parse("t.json", bytes));
  }

  @Test
  void survivesDamageAtEveryByte() throws Exception {
    byte[] good = Level.builtIn("arena").source();
    for (int i = 0; i < good.length; i += 7) {
      byte[] bad = good.clone();
      bad[i] = (byte) (i * 31);
      parseOrRefuse(bad);
      parseOrRefuse(Arrays.copyOf(good, i));
    }
  }

  private static void parseOrRefuse(byte[] bytes) {
    try {
      Level.parse("t.json", bytes);
    } catch (LevelException e) {
      assertTrue(e.getMessage().startsWith("t.json"), e.getMessage());
    }
  }

  @Test
  void saysWhichFileCantBeRead() {
    LevelException e =
        assertThrows(LevelException.class, () -> Level.load(Path.of("no", "such.json")));
    assertTrue(e.getMessage().startsWith("such.json: can't read"), e.getMessage());
    e = assertThrows(LevelException.class, () -> Level.builtIn("nowhere"));
    assertTrue(e.getMessage().contains("comes with the program"), e.getMessage());
  }

  @Test
  void readsWhatTheFileSays() throws Exception {
    Level level =
        parse(
            HEAD
                + "\"spawns\": [{\"at\": [1, 2]}, {\"name\": \"ball\", \"at\": [3, 4], \"team\":"
                + " 2}],\n"
                + "\"bodies\": [{\"at\": [5, 6], \"angle\": 90, \"repeat\": {\"columns\": 2,"
                + " \"rows\": 2, \"step\": [1, 2]}, "
                + BOX
                + "}]}");
    assertEquals("arena", level.gameName());
    assertEquals(-10, level.gravityY());
    assertEquals(List.of(new Level.Spawn("ball", 3, 4, 2)), level.spawns("ball"));
    assertEquals("player", level.spawns().get(0).name());
    assertEquals(4, level.bodies().size());
    Level.Placement last = level.bodies().get(3);
    assertEquals(6, last.x());
    assertEquals(8, last.y());
    assertEquals((float) (Math.PI / 2), last.angle(), 1e-6f);
  }

  @Test
  void aFileMayNameItsVersionAndANewerOneIsRefused() throws Exception {
    assertEquals("t", parse(HEAD + "\"version\": " + Level.VERSION + "}").name());
    byte[] newer = (HEAD + "\"version\": 7, \"gadgets\": []}").getBytes(UTF_8);
    LevelException e = assertThrows(LevelException.class, () -> Level.parse("t.json", newer));
    assertEquals(
        "t.json:4:12: version=7 is newer than 1, the newest that this program reads; use a newer"
            + " Carom",
        e.getMessage());
  }

  @Test
  void aCheckNamesEveryProblem() {
    CheckedLevel checked =
        CheckedLevel.of(
            "t.json",
            (HEAD
                    + "\"spawns\": [{\"at\": [99, 0]}, {\"at\": [0]}],\n\"bodies\": [{\"at\": [0,"
                    + " 0], \"shape\": {\"type\": \"circle\", \"radius\": -1}}],\n\"joints\":"
                    + " [{\"type\": \"weld\"}]}")
                .getBytes(UTF_8));
    assertEquals(null, checked.level());
    assertEquals(
        List.of("spawns[0].at", "spawns[1].at", "bodies[0].shape.radius"),
        checked.problems().stream().map(LevelException::field).toList());
  }

  /** One sees through a plain sensor; a wall of the same colour looks solid. */
  @Test
  void aSensorWithoutAColourDoesNotLookLikeAWall() throws Exception {
    String at = "{\"at\": [0, 0], " + BOX;
    String statics =
        String.join(
            "},\n",
            at,
            at + ", \"sensor\": true",
            at + ", \"sensor\": true, \"color\": \"#ffd166\"",
            at + ", \"sensor\": true, \"look\": \"lamp\"");
    Level level = parse(HEAD + "\"spawns\": [{\"at\": [0, 0]}], \"statics\": [" + statics + "}]}");
    assertEquals(
        List.of(
            Appearance.Look.WALL,
            Appearance.Look.PLAIN,
            Appearance.Look.WALL,
            Appearance.Look.LAMP),
        level.archetypes().stream().map(a -> new Archetype(0, a).appearance().look()).toList());
  }

  @Test
  void keepsTheFileForTheClients() throws Exception {
    Level level = Level.builtIn("arena");
    Level again = Level.parse("copy", level.source());
    assertArrayEquals(level.source(), again.source());
    assertEquals(level.contentHash(), again.contentHash());
    assertNotEquals(level.contentHash(), Level.builtIn("platformer").contentHash());
  }

  @Test
  void aFileOfTooManyValuesIsRefusedBeforeItFillsTheMemory() {
    for (String value : new String[] {"[],", "{},", "0,"}) {
      byte[] bytes = ("[" + value.repeat(Json.MAX_NODES) + "0]").getBytes(UTF_8);
      assertTrue(bytes.length < Level.MAX_BYTES);
      LevelException e = assertThrows(LevelException.class, () -> Level.parse("t.json", bytes));
      assertTrue(e.getMessage().contains("the file has more than 500000 values"), e.getMessage());
    }
    byte[] deep = "[".repeat(Json.MAX_DEPTH + 1).getBytes(UTF_8);
    assertThrows(LevelException.class, () -> Level.parse("t.json", deep));
  }

  @Test
  void theManualShowsALevelThatWorks() throws Exception {
    String manual = manual("games/LEVELS.md");
    int start = manual.indexOf("```json") + 7;
    Level level = parse(manual.substring(start, manual.indexOf("```", start)));
    assertEquals("Yard", level.name());
  }

  private static String manual(String name) throws IOException {
    Path here = Path.of("").toAbsolutePath();
    while (!Files.exists(here.resolve("docs").resolve(name))) {
      here = here.getParent();
    }
    return Files.readString(here.resolve("docs").resolve(name));
  }

  private static Level parse(String json) throws LevelException {
    return Level.parse("t.json", json.getBytes(UTF_8));
  }
}
