package carom.tiled;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.fixtures.PlainGame;
import carom.physics.math.Transform;
import carom.sim.Role;
import carom.sim.SimulationHost;
import carom.sim.entity.HostEntity;
import carom.sim.level.Archetype;
import carom.sim.level.Archetypes;
import carom.sim.level.Level;
import carom.sim.level.LevelException;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Base64;
import java.util.List;
import java.util.Random;
import java.util.zip.DeflaterOutputStream;
import java.util.zip.GZIPOutputStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Maps of Tiled become levels. */
final class TiledImportTest {
  private static final String TILESET =
      """
      <tileset firstgid="1" name="t" tilewidth="16" tileheight="16" tilecount="4" columns="4">
       <tile id="0" type="solid"/>
       <tile id="1"><objectgroup><object x="0" y="16"><polygon points="0,0 16,-16 16,0"/></object></objectgroup></tile>
       <tile id="2" type="sensor"><properties><property name="name" value="lava"/></properties></tile>
       <tile id="3" type="oneWay"/>
      </tileset>
      """;

  @TempDir private Path folder;

  private static String map(int width, int height, String content) {
    return "<map orientation=\"orthogonal\" width=\""
        + width
        + "\" height=\""
        + height
        + "\" tilewidth=\"16\" tileheight=\"16\">"
        + content
        + "</map>";
  }

  private static String layer(int width, int height, String data) {
    return "<layer id=\"1\" name=\"ground\" width=\""
        + width
        + "\" height=\""
        + height
        + "\">"
        + data
        + "</layer>";
  }

  private TiledLevel read(String name, String text) throws Exception {
    Path file = Files.writeString(folder.resolve(name), text);
    return TiledImport.read(file, TiledOptions.NONE);
  }

  private static Path example() {
    Path here = Path.of("").toAbsolutePath();
    while (!Files.exists(here.resolve("docs/games/tiled/meadow.tmx"))) {
      here = here.getParent();
    }
    return here.resolve("docs/games/tiled/meadow.tmx");
  }

  private static boolean isInside(Level level, double x, double y) {
    Archetypes archetypes = new Archetypes();
    List<Archetype> all = new ArrayList<>();
    level.archetypes().forEach(def -> all.add(archetypes.add(def)));
    boolean inside = false;
    for (Level.Placement placed : level.statics()) {
      Transform at = new Transform(placed.x(), placed.y(), placed.angle());
      float px = at.localX((float) x, (float) y);
      float py = at.localY((float) x, (float) y);
      inside |=
          all.get(placed.archetype()).shapes().stream().anyMatch(s -> s.containsPoint(px, py));
    }
    return inside;
  }

  @Test
  void theExampleIsWhole() throws Exception {
    TiledLevel made = TiledImport.read(example(), TiledOptions.NONE);
    Level level = made.level();
    assertEquals(List.of(), made.skipped());
    assertEquals("Meadow", level.name());
    assertEquals(new Level.Bounds(0, 0, 48, 16), level.bounds());
    assertEquals(2, level.spawns("player").size());
    assertEquals(1, level.spawns("flag").size());
    assertEquals(2, level.triggers().size());
    assertEquals(List.of("spikes", "plate"), level.sensorNames());
    assertEquals(3, level.bodies().size());
    assertEquals(1, level.areas().size());
  }

  @Test
  void everyEncodingGivesTheSameLevel() throws Exception {
    for (long seed = 1; seed <= 20; seed++) {
      Random random = new Random(seed);
      int w = 1 + random.nextInt(20);
      int h = 1 + random.nextInt(20);
      int[] gids = new int[w * h];
      for (int i = 0; i < gids.length; i++) {
        gids[i] = random.nextInt(3) == 0 ? 0 : 1 + random.nextInt(4) | random.nextInt(8) << 29;
      }
      List<String> xml = new ArrayList<>();
      StringBuilder csv = new StringBuilder();
      StringBuilder tiles = new StringBuilder();
      for (int gid : gids) {
        csv.append(csv.length() == 0 ? "" : ",\n").append(Integer.toUnsignedString(gid));
        tiles.append("<tile gid=\"").append(Integer.toUnsignedString(gid)).append("\"/>");
      }
      xml.add("<data encoding=\"csv\">\n" + csv + "\n</data>");
      xml.add("<data>" + tiles + "</data>");
      for (String compression : List.of("", "zlib", "gzip")) {
        xml.add(
            "<data encoding=\"base64\" compression=\"%s\">%n  %s%n</data>"
                .formatted(compression, packed(gids, compression)));
      }
      String expected = null;
      for (String data : xml) {
        TiledLevel made = read("m.tmx", map(w, h, TILESET + layer(w, h, data)));
        String json = new String(made.level().source(), UTF_8);
        expected = expected == null ? json : expected;
        assertEquals(expected, json, "seed " + seed);
      }
      for (String data :
          List.of(
              "\"data\": [" + csv + "]",
              "\"encoding\": \"base64\", \"compression\": \"zlib\", \"data\": \""
                  + packed(gids, "zlib")
                  + "\"")) {
        Files.writeString(folder.resolve("t.tsx"), TILESET.replace(" firstgid=\"1\"", ""));
        String json =
            "{\"orientation\": \"orthogonal\", \"width\": "
                + w
                + ", \"height\": "
                + h
                + ", \"tilewidth\": 16, \"tileheight\": 16, \"tilesets\": [{\"firstgid\": 1,"
                + " \"source\": \"t.tsx\"}], \"layers\": [{\"id\": 1, \"name\": \"ground\","
                + " \"type\": \"tilelayer\", \"width\": "
                + w
                + ", \"height\": "
                + h
                + ", "
                + data
                + "}]}";
        assertEquals(expected, new String(read("m.tmj", json).level().source(), UTF_8));
      }
    }
  }

  private static String packed(int[] gids, String compression) throws IOException {
    ByteBuffer bytes = ByteBuffer.allocate(4 * gids.length).order(ByteOrder.LITTLE_ENDIAN);
    bytes.asIntBuffer().put(gids);
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    try (OutputStream packer =
        switch (compression) {
          case "zlib" -> new DeflaterOutputStream(out);
          case "gzip" -> new GZIPOutputStream(out);
          default -> out;
        }) {
      packer.write(bytes.array());
    }
    return Base64.getEncoder().encodeToString(out.toByteArray());
  }

  @Test
  void anInfiniteMapIsItsChunks() throws Exception {
    String chunks =
        "<data encoding=\"csv\"><chunk x=\"-2\" y=\"-1\" width=\"2\" height=\"2\">0,0,1,1</chunk>"
            + "<chunk x=\"0\" y=\"-1\" width=\"2\" height=\"2\">0,1,1,1</chunk></data>";
    Level level =
        read(
                "m.tmx",
                map(2, 2, TILESET + layer(2, 2, chunks)).replace("<map ", "<map infinite=\"1\" "))
            .level();
    assertEquals(new Level.Bounds(-2, -1, 2, 1), level.bounds());
    assertTrue(isInside(level, -1.5, -0.5));
    assertTrue(isInside(level, 1.5, 0.5));
    assertEquals(false, isInside(level, 0.5, 0.5));
  }

  @Test
  void flipsTurnTheShapesOfTiles() throws Exception {
    // The ramp of tile 2 rises to the right: its right and lower sides are solid.
    double[][] sides = {{0.85, 0.5}, {0.15, 0.5}, {0.5, 0.15}, {0.5, 0.85}};
    assertEquals("right low ", solid(0, sides));
    assertEquals("left low ", solid(1L << 31, sides));
    assertEquals("right high ", solid(1L << 30, sides));
    assertEquals("left high ", solid(3L << 30, sides));
    // Swapped and mirrored at the vertical axis: turned clockwise by a right angle.
    assertEquals("left low ", solid(5L << 29, sides));
  }

  private String solid(long flips, double[][] sides) throws Exception {
    String data = "<data encoding=\"csv\">" + (2 + flips) + "</data>";
    Level level = read("m.tmx", map(1, 1, TILESET + layer(1, 1, data))).level();
    StringBuilder found = new StringBuilder();
    String[] names = {"right ", "left ", "low ", "high "};
    for (int i = 0; i < sides.length; i++) {
      found.append(isInside(level, sides[i][0], sides[i][1]) ? names[i] : "");
    }
    return found.toString();
  }

  @Test
  void aBodySlidesOverTilesAsOverOneBox() throws Exception {
    int w = 60;
    String data = "<data encoding=\"csv\">" + "0,".repeat(w) + "1,".repeat(2 * w - 1) + "1</data>";
    String body =
        "<objectgroup id=\"2\" name=\"o\"><object id=\"1\" name=\"box\" type=\"body\" x=\"16\""
            + " y=\"0\" width=\"16\" height=\"16\"><properties><property name=\"friction\""
            + " type=\"float\" value=\"0\"/></properties></object></objectgroup>";
    String floor =
        "<objectgroup id=\"3\" name=\"f\"><object id=\"2\" x=\"0\" y=\"16\" width=\"960\""
            + " height=\"32\"/></objectgroup>";
    Level tiles = read("a.tmx", map(w, 3, TILESET + layer(w, 3, data) + body)).level();
    Level box = read("b.tmx", map(w, 3, floor + body)).level();
    SimulationHost a = simulation(tiles);
    SimulationHost b = simulation(box);
    a.entity(0).setVelocity(12, 0);
    b.entity(0).setVelocity(12, 0);
    for (int tick = 0; tick < 240; tick++) {
      a.step();
      b.step();
      HostEntity one = a.entity(0);
      HostEntity other = b.entity(0);
      assertEquals(other.x(), one.x(), 1e-3f, "tick " + tick);
      assertEquals(other.y(), one.y(), 2e-3f, "tick " + tick);
      assertEquals(12, one.velocityX(), 1e-2f, "tick " + tick);
      assertEquals(0, one.angle(), 1e-3f, "tick " + tick);
    }
    assertTrue(a.entity(0).x() > 45);
  }

  private static SimulationHost simulation(Level level) {
    PlainGame game = new PlainGame("platformer", "platformer");
    return new SimulationHost(game, level, 1, 60, Role.AUTHORITY);
  }

  @Test
  void namesWhatItCannotRead() throws Exception {
    String objects =
        "<objectgroup id=\"2\" name=\"things\"><object id=\"1\" type=\"dragon\" x=\"8\""
            + " y=\"8\"><point/></object><object id=\"2\" name=\"sign\" x=\"8\" y=\"8\" width=\"8\""
            + " height=\"8\"><text>hi</text></object><object id=\"3\" name=\"far\" x=\"800\""
            + " y=\"8\"><point/></object><object id=\"4\" name=\"crate\" type=\"body\" x=\"0\""
            + " y=\"0\" width=\"8\" height=\"8\"><properties><property name=\"tag\" type=\"int\""
            + " value=\"-3\"/><property name=\"hp\" type=\"int\""
            + " value=\"3\"/></properties></object><object id=\"5\" type=\"body\" x=\"0\""
            + " y=\"0\"><polyline points=\"0,0 8,8\"/></object><object id=\"6\" template=\"a.tx\""
            + " x=\"0\" y=\"0\"/></objectgroup><imagelayer id=\"3\" name=\"sky\"/>";
    TiledLevel made = read("m.tmx", map(2, 2, objects));
    assertEquals(1, made.level().bodies().size());
    List<String> begins =
        List.of(
            "layer \"things\", object 1: class \"dragon\" isn't known; known are",
            "layer \"things\", object 2 \"sign\": texts have no place in a level",
            "layer \"things\", object 4 \"crate\": properties that a level has no use for: hp",
            "layer \"things\", object 6: templates aren't read",
            "layer \"sky\": pictures have no place in a level",
            "layer \"things\", object 4 \"crate\": property tag=-3 must be in 0..65535",
            "layer \"things\", object 3 \"far\": at=[50.0, 1.5] must lie inside the level's bounds",
            "layer \"things\", object 5: shape.type is a line without mass");
    List<String> skipped = new ArrayList<>(made.skipped());
    for (String begin : begins) {
      assertTrue(skipped.removeIf(s -> s.startsWith(begin)), begin + " in " + made.skipped());
    }
    assertEquals(List.of(), skipped);
  }

  @Test
  void objectsBecomeWhatTheirClassesSay() throws Exception {
    String objects =
        "<objectgroup id=\"2\" name=\"o\" offsetx=\"16\"><object id=\"1\" type=\"body\" x=\"32\""
            + " y=\"32\" width=\"32\" height=\"16\" rotation=\"90\"/><object id=\"2\""
            + " type=\"kinematic\" x=\"0\" y=\"0\" width=\"16\""
            + " height=\"16\"><ellipse/></object><object id=\"3\" type=\"zone\" name=\"goal\""
            + " x=\"0\" y=\"0\" width=\"16\" height=\"32\"/><object id=\"4\" type=\"revolute\""
            + " x=\"32\" y=\"32\"><point/><properties><property name=\"a\" type=\"object\""
            + " value=\"2\"/><property name=\"b\" type=\"object\""
            + " value=\"1\"/></properties></object><object id=\"5\" type=\"wind\" x=\"0\" y=\"0\""
            + " width=\"16\" height=\"16\"><properties><property name=\"velocity\" value=\"[3,"
            + " 0]\"/></properties></object><object id=\"6\" type=\"body\" gid=\"2\" x=\"16\""
            + " y=\"96\" width=\"32\" height=\"32\"/></objectgroup>";
    TiledLevel made = read("m.tmx", map(8, 8, TILESET + objects));
    assertEquals(List.of(), made.skipped());
    Level level = made.level();
    assertEquals(3, level.bodies().size());
    Level.Placement turned = level.bodies().get(0);
    assertEquals(
        1 + 2 - 0.5f, turned.x(), 1e-5f); // its corner is at (3, 6), it hangs down from there
    assertEquals(8 - 2 - 1, turned.y(), 1e-5f);
    assertEquals(-Math.PI / 2, turned.angle(), 1e-5f);
    assertEquals(new Level.Zone("goal", 1, 6, 2, 8, 0, -1), level.zones().get(0));
    assertEquals(1, level.joints().size());
    assertEquals(1, level.joints().get(0).a());
    assertEquals(0, level.joints().get(0).b());
    assertEquals(1, level.areas().size());
    assertEquals(3, level.bodies().get(2).x(), 1e-5f);
    assertEquals(3, level.bodies().get(2).y(), 1e-5f);
  }

  @Test
  void refusesBombsAndForeignFiles() throws Exception {
    String entity =
        "<!DOCTYPE map [<!ENTITY a SYSTEM \"file:///etc/hostname\">]>" + map(1, 1, "&a;");
    assertRefused(entity, "document type");
    assertRefused("<map>".repeat(60), "levels of elements");
    assertRefused(map(1, 1, "<group>".repeat(20) + "</group>".repeat(20)), "nested more than");
    assertRefused(map(2000000, 3000000, ""), "width=");
    assertRefused(
        map(9, 9, layer(900000, 900000, "<data encoding=\"csv\">1</data>")),
        "the limit is 4194304");
    String bomb = packed(new int[1 << 20], "zlib");
    assertRefused(
        map(
            1,
            1,
            layer(1, 1, "<data encoding=\"base64\" compression=\"zlib\">" + bomb + "</data>")),
        "must have width x height = 1");
    assertRefused(
        map(1, 1, layer(1, 1, "<data encoding=\"base64\" compression=\"zstd\">AAAA</data>")),
        "layer \"ground\" compression=zstd isn't read");
    assertRefused(map(1, 1, "<tileset firstgid=\"1\" source=\"/etc/passwd\"/>"), "must be a .tsx");
    assertRefused(map(1, 1, "").replace("orthogonal", "isometric"), "isn't read");
  }

  private void assertRefused(String text, String why) {
    LevelException e = assertThrows(LevelException.class, () -> read("m.tmx", text));
    assertTrue(e.getMessage().startsWith("m.tmx"), e.getMessage());
    assertTrue(e.getMessage().contains(why), e.getMessage());
  }

  @Test
  void damagedFilesAreRefusedOrReadButNeverFail() throws Exception {
    byte[] good = Files.readAllBytes(example());
    Files.copy(example().resolveSibling("ground.tsx"), folder.resolve("ground.tsx"));
    Path file = folder.resolve("m.tmx");
    Random random = new Random(42);
    for (int i = 0; i < 400; i++) {
      byte[] bad = good.clone();
      for (int n = 1 + random.nextInt(4); n > 0; n--) {
        int at = random.nextInt(bad.length);
        bad[at] =
            random.nextInt(3) == 0
                ? (byte) random.nextInt(256)
                : (byte) "09-<>\"/,.= {[".charAt(random.nextInt(13));
      }
      Files.write(
          file, random.nextInt(10) == 0 ? Arrays.copyOf(bad, random.nextInt(bad.length)) : bad);
      try {
        TiledImport.read(file, TiledOptions.NONE);
      } catch (LevelException e) {
        assertTrue(e.getMessage().length() < 2_000, e.getMessage());
      }
    }
  }

  @Test
  void theSameMapGivesTheSameBytes() throws Exception {
    assertArrayEquals(TiledImport.load(example()).source(), TiledImport.load(example()).source());
  }
}
