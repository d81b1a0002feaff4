package carom.server.level;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.server.CaromMain;
import carom.sim.level.Level;
import java.awt.image.BufferedImage;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** {@code carom level} says what is wrong with a level, and draws it. */
final class LevelCommandTest {
  private static final String HEAD =
      "{\"name\": \"t\", \"game\": \"platformer\", \"gravity\": [0, -10],\n"
          + "\"bounds\": {\"min\": [-10, -10], \"max\": [10, 10]},\n"
          + "\"spawns\": [{\"at\": [0, 2]}, {\"name\": \"flag\", \"at\": [5, 2]}],\n";
  private static final String FLOOR =
      "{\"name\": \"floor\", \"at\": [0, 0], \"shape\": {\"type\": \"box\", \"width\": 18,"
          + " \"height\": 1}}";

  @TempDir private Path folder;

  private static LevelCheck check(String rest) {
    return LevelCheck.of("t.json", (HEAD + rest + "}").getBytes(UTF_8));
  }

  @Test
  void levelsThatShipHaveNeitherProblemsNorWarnings() throws Exception {
    for (String name :
        List.of(
            "arena",
            "rink",
            "platformer",
            "rockets",
            "orbit",
            "commons",
            "lagoon",
            "sluice",
            "shooter",
            "cars",
            "quarry",
            "ruins",
            "harbour",
            "sandbox",
            "towers")) {
      LevelCheck check = LevelCheck.of(name, Level.builtIn(name).source());
      assertEquals(List.of(), check.problems());
      assertEquals(List.of(), check.warnings());
    }
  }

  @Test
  void saysAllThatIsWrongWithPlaceValueAndLimit() {
    LevelCheck check =
        check(
            "\"statics\": ["
                + FLOOR
                + ", {\"at\": [0, 0], \"shape\": {\"type\": \"circle\", \"radius\": 0}}],\n"
                + "\"bodies\": [{\"at\": [0], \"shape\": {\"type\": \"circle\", \"radius\": 1}}]");
    assertEquals(
        List.of(
            "t.json:4:151: statics[1].shape.radius=0 must be in 0.05..2000",
            "t.json:5:19: bodies[0].at has 1 numbers, needs 2: [x, y]"),
        check.problems());
  }

  @Test
  void saysWhatTheGameLacks() {
    assertTrue(
        LevelCheck.of(
                "t.json",
                HEAD.replace("platformer", "chess").concat("\"zones\": []}").getBytes(UTF_8))
            .problems()
            .get(0)
            .startsWith("t.json: game=\"chess\" is unknown"));
    List<String> problems =
        check(
                "\"triggers\": [{\"when\": {\"timer\": 1}, \"do\": {\"spawn\": \"dragon\", \"at\":"
                    + " [0, 0]}}]")
            .problems();
    assertEquals(1, problems.size());
    assertTrue(problems.get(0).startsWith("t.json:4:"), problems.get(0));
    assertTrue(problems.get(0).contains("dragon"), problems.get(0));
  }

  @Test
  void warnsOfWhatIsSurelyNotMeant() {
    String crate = "\"shape\": {\"type\": \"box\", \"width\": 1, \"height\": 1}";
    LevelCheck check =
        check(
            "\"statics\": ["
                + FLOOR
                + ",\n{\"name\": \"far\", \"sensor\": true, \"at\": [50, 0], "
                + crate
                + "}],\n\"bodies\": [\n{\"at\": [3, 0.6], "
                + crate
                + "},\n{\"at\": [9.7, -9], "
                + crate
                + "},\n{\"at\": [-30, 0], "
                + crate
                + "}],\n"
                + "\"triggers\": [\n"
                + "{\"when\": {\"enter\": \"far\"}, \"do\": {\"notice\": \"x\"}},\n"
                + "{\"when\": {\"timer\": 1}, \"enabled\": false, \"name\": \"never\", \"do\":"
                + " {\"notice\": \"x\"}}]");
    assertEquals(List.of(), check.problems());
    assertEquals(5, check.warnings().size(), check.warnings().toString());
    List<String> ends =
        List.of(
            "triggers[0].when: sensor \"far\" lies outside the bounds",
            "triggers[1].enabled=false, and no trigger enables \"never\"",
            "bodies[0] at [3.000, 0.6000] is more than 0.05 m inside statics[0] (\"floor\")",
            "bodies[2] begins at [-30.00, 0.000], outside the bounds",
            "bodies[1] at [9.700, -9.000] is out of the bounds");
    for (int i = 0; i < ends.size(); i++) {
      assertTrue(check.warnings().get(i).contains(ends.get(i)), check.warnings().get(i));
      assertTrue(check.warnings().get(i).matches("t\\.json:\\d+:\\d+: .*"));
    }
  }

  @Test
  void warnsOfSpawnPointsInWalls() {
    LevelCheck check = check("\"statics\": [" + FLOOR.replace("[0, 0]", "[0, 2]") + "]");
    assertEquals(
        List.of(
            "t.json:3:12: spawns[0].at=[0.000, 2.000] is inside statics[0] (\"floor\"); move it"
                + " out",
            "t.json:3:28: spawns[1].at=[5.000, 2.000] is inside statics[0] (\"floor\"); move it"
                + " out"),
        check.warnings());
  }

  @Test
  void theCommandsEndWithTheirCodes() throws Exception {
    Path good = Files.write(folder.resolve("good.json"), Level.builtIn("platformer").source());
    Path bad = Files.writeString(folder.resolve("bad.json"), "{}");
    Path warned = folder.resolve("warned.json");
    Files.writeString(warned, HEAD + "\"statics\": [" + FLOOR.replace("[0, 0]", "[0, 2]") + "]}");
    assertEquals(0, run("check", good.toString()));
    assertEquals(1, run("check", good.toString(), bad.toString()));
    assertEquals(0, run("check", warned.toString()));
    assertEquals(1, run("check", "--strict", warned.toString()));
    assertEquals(2, run("check", folder.resolve("none.json").toString()));
    assertEquals(2, run("render", bad.toString(), "--out", "x.png"));
    assertEquals(2, run("render", good.toString(), "--out", "x.png", "--size", "7x7"));
    Path picture = folder.resolve("level.png");
    assertEquals(
        0, run("render", good.toString(), "--out", picture.toString(), "--size", "640x360"));
    BufferedImage image = ImageIO.read(picture.toFile());
    assertEquals(640, image.getWidth());
    assertEquals(360, image.getHeight());
    int[] pixels = image.getRGB(0, 0, 640, 360, null, 0, 640);
    assertTrue(Arrays.stream(pixels).distinct().count() > 20);
  }

  private static int run(String... args) {
    StringWriter text = new StringWriter();
    PrintWriter out = new PrintWriter(text);
    String[] all = new String[args.length + 1];
    all[0] = "level";
    System.arraycopy(args, 0, all, 1, args.length);
    return CaromMain.run(out, out, all);
  }
}
