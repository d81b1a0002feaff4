package carom.sim.level;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.physics.Body;
import carom.physics.BodyDef;
import carom.physics.BodyType;
import carom.physics.Material;
import carom.physics.World;
import carom.physics.WorldDef;
import carom.physics.geometry.Box;
import carom.sim.SchemaChecker;
import carom.text.Json;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.IntFunction;
import org.junit.jupiter.api.Test;

/** Long chains and chains of several colours in level files. */
class LevelChainTest {
  private static String file(String more) {
    return "{\"name\": \"t\", \"game\": \"arena\", \"gravity\": [0, -10],\n"
        + "\"bounds\": {\"min\": [-10, -10], \"max\": [10, 10]},\n"
        + more
        + "}";
  }

  private static String chain(int points, IntFunction<float[]> at, String more) {
    StringBuilder list = new StringBuilder();
    for (int i = 0; i < points; i++) {
      float[] p = at.apply(i);
      list.append(i == 0 ? "" : ",").append(String.format(Locale.ROOT, "[%.3f,%.3f]", p[0], p[1]));
    }
    return "{\"at\": [0, 0], \"shape\": {\"type\": \"chain\", \"points\": ["
        + list
        + "]"
        + more
        + "}}";
  }

  private static Level parse(String more) throws Exception {
    byte[] bytes = file(more).getBytes(UTF_8);
    assertEquals("", SchemaChecker.levels().check(Json.parse(bytes)));
    return Level.parse("t.json", bytes);
  }

  private static String refused(String more) {
    byte[] bytes = file(more).getBytes(UTF_8);
    return assertThrows(LevelException.class, () -> Level.parse("t.json", bytes)).getMessage();
  }

  private static float[] flat(int i) {
    return new float[] {0.05f * i - 100, 0};
  }

  @Test
  void aLongChainIsSeveralBodiesOverWhoseJointsABoxSlides() throws Exception {
    Level level = parse("\"statics\": [" + chain(4_001, LevelChainTest::flat, "") + "]");
    assertEquals(4, level.archetypes().size());
    assertEquals(4, level.statics().size());
    World<Object> world = new World<>(new WorldDef());
    for (Level.Placement p : level.statics()) {
      Archetype kind = new Archetype(p.archetype(), level.archetypes().get(p.archetype()));
      assertEquals(1_000, kind.shapes().get(0).parts().size());
      world.createBody(kind.body(p.x(), p.y(), p.angle()), null);
    }
    Body<Object> box =
        world.createBody(
            new BodyDef(BodyType.DYNAMIC)
                .shape(new Box(0.5f, 0.5f), new Material(1, 0, 0))
                .position(-99, 0.5f)
                .velocity(10, 0),
            null);
    for (int tick = 0; tick < 60 * 18; tick++) {
      world.step(1 / 60f);
      assertEquals(10, box.velocityX(), 0.01f, "x=" + box.x());
      assertEquals(0, box.velocityY(), 0.1f, "x=" + box.x());
    }
    assertTrue(box.x() > 75, "x=" + box.x());
  }

  @Test
  void theLargestChainIsReadAndOnePointMoreIsRefused() throws Exception {
    IntFunction<float[]> hills = i -> new float[] {0.06f * i - 1_966, i % 2 * 0.05f};
    Level level = parse("\"statics\": [" + chain(65_536, hills, "") + "]");
    assertEquals(66, level.statics().size());
    String text = refused("\"statics\": [" + chain(65_537, hills, "") + "]");
    assertTrue(text.contains("statics[0].shape.points has 65537 items, the limit is 65536"), text);
    text = refused("\"statics\": [" + chain(65_536, hills, ", \"loop\": true") + "]");
    assertTrue(text.contains("lie side by side") || text.contains("crosses"), text);
  }

  @Test
  void aFanOfLongStrokesIsRefusedBeforeItCostsMinutes() {
    // Goal: looking for crossings has an end. Method: 65,535 strokes whose boxes all overlap.
    IntFunction<float[]> fan =
        i -> new float[] {i % 2 == 0 ? -1_900 : 1_900, 0.05f * i - 1_700 + i % 2 * 50};
    String text = refused("\"statics\": [" + chain(65_536, fan, "") + "]");
    assertTrue(
        text.contains(
            "statics[0].shape: chain segments=65535 lie side by side too often; make it several"
                + " chains"),
        text);
  }

  @Test
  void eachColourOfAChainIsABodyOfItsOwn() throws Exception {
    String materials =
        "\"materials\": {\"grass\": {\"color\": \"#00ff00\"}, \"ice\": {\"friction\": 0, \"color\":"
            + " \"#aaccff\"}, \"mud\": {\"friction\": 1, \"color\": \"#00ff00\"}},";
    String more = ", \"materials\": [\"grass\", \"ice\", \"mud\", \"ice\", {}]";
    Level level = parse(materials + "\"statics\": [" + chain(6, LevelChainTest::flat, more) + "]");
    List<String> kinds = new ArrayList<>();
    for (Level.Placement p : level.statics()) {
      Archetype kind = new Archetype(p.archetype(), level.archetypes().get(p.archetype()));
      kinds.add(Integer.toHexString(kind.appearance().rgb()) + " " + kind.shapes().size());
    }
    assertEquals(List.of("ff00 2", "aaccff 2", "3d5a80 1"), kinds);
    String box = "\"shape\": {\"type\": \"box\", \"width\": 1, \"height\": 1}";
    level =
        parse(
            materials
                + "\"statics\": [{\"at\": [0, 0], \"material\": \"ice\", "
                + box
                + "}, {\"at\": [0, 0], \"material\": \"ice\", \"color\": \"#123456\", "
                + box
                + "}]");
    assertEquals(0xaaccff, new Archetype(0, level.archetypes().get(0)).appearance().rgb());
    assertEquals(0x123456, new Archetype(1, level.archetypes().get(1)).appearance().rgb());
  }

  @Test
  void whatMovesIsOneBody() {
    String kinematic = "\"type\": \"kinematic\", \"at\"";
    String item = chain(1_100, LevelChainTest::flat, "").replaceFirst("\"at\"", kinematic);
    String text = refused("\"bodies\": [" + item + "]");
    assertTrue(
        text.contains(
            "bodies[0].shape needs 2 bodies, because a body takes 1024 lines of one color"),
        text);
  }

  @Test
  void coloursAreNoWayToMoreKindsOfBodiesThanThereIsRoomFor() {
    StringBuilder colours = new StringBuilder(", \"materials\": [");
    for (int i = 0; i < 4_000; i++) {
      colours.append(i == 0 ? "" : ",");
      colours.append(String.format(Locale.ROOT, "{\"color\": \"#%06x\"}", i));
    }
    String item = chain(4_001, LevelChainTest::flat, colours + "]");
    String text = refused("\"statics\": [" + item + "]");
    assertTrue(
        text.contains(
            "statics[0].shape brings the number of kinds of bodies to 4000, beyond the limit of"
                + " 3072; use fewer colors along the chain"),
        text);
  }
}
