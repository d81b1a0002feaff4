package carom.client.look;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.client.app.LookCommand;
import carom.client.look.rockets.RocketsView;
import carom.client.look.shooter.ShooterView;
import carom.game.GameJars;
import carom.game.playground.PlaygroundFields;
import carom.game.shooter.ShooterFields;
import carom.text.Json;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.net.URI;
import java.nio.file.FileSystem;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Stream;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import picocli.CommandLine;

/** Goal: a view is data for painters that can't load it. Method: views are written and read. */
final class LookFolderTest {
  @TempDir private Path folder;

  /** A view that does what it is told. */
  private record Told(java.util.function.Consumer<ViewSetup> does) implements GameView {
    @Override
    public String game() {
      return "told";
    }

    @Override
    public void setUp(ViewSetup v) {
      does.accept(v);
    }
  }

  private Json write(GameView view) throws Exception {
    LookFolder.write(view, folder);
    Path file = folder.resolve(GameJars.LOOKS).resolve(view.game()).resolve("look.json");
    return Json.parse(Files.readAllBytes(file));
  }

  @Test
  void eachFileOfTheViewsThatShipIsThereUnderTheNameThatTheDataHas() throws Exception {
    for (GameView view : new GameView[] {new ShooterView(), new RocketsView()}) {
      Set<String> named = new HashSet<>();
      collect(write(view), named);
      named.removeIf(text -> !text.matches(".*\\.(png|wav|ogg)"));
      Path place = folder.resolve(GameJars.LOOKS).resolve(view.game());
      try (Stream<Path> files = Files.list(place)) {
        Set<String> there = new HashSet<>(files.map(f -> f.getFileName().toString()).toList());
        assertTrue(there.remove("look.json"));
        assertEquals(there, named, view.game());
        assertTrue(there.size() > 10, view.game());
      }
    }
  }

  private static void collect(Json node, Set<String> texts) {
    texts.add(node.text);
    node.items.forEach(item -> collect(item, texts));
    node.fields.values().forEach(value -> collect(value, texts));
  }

  @Test
  void whatAViewDeclaresIsInTheData() throws Exception {
    String smoke = "/carom/client/look/rockets/smoke.png";
    Json look =
        write(
            new Told(
                v -> {
                  v.actions(Action.button("jump", 1).key("W").mouse("left").pad("A"));
                  v.sprite("crate", smoke).size(2, 1).at(0.5f, 0).frames(4).by(ShooterFields.COVER);
                  v.sprite("crate", "/carom/client/look/shooter/gun.png").perMetre(2).upright();
                  v.sprite("gun", "/carom/client/look/rockets/gun.png").tint(0x102030);
                  v.background(smoke).height(12).parallax(0.25f).standsAt(-3);
                  v.event(
                      "boom",
                      SlowMotion.last(1),
                      Particles.burst(30).speed(2, 5).glow(),
                      Shake.by(0.5f));
                  v.trail("rocket", Particles.stream(40).picture(smoke));
                  v.camera().height(18).lead(0.5f).zone("cave").whileSet(ShooterFields.COVER, 30);
                  v.hud(HudItem.bar("damage", ShooterFields.DAMAGE).colour(0xff0000));
                  v.hud(HudItem.word("star", PlaygroundFields.KEEPER));
                  v.hud(HudItem.number("hits", ShooterFields.DAMAGE).scale(0.01f).decimals(2));
                  v.minimap(HudItem.Place.TOP_LEFT, "rocket", "crate");
                }));
    Json jump = look.fields.get("actions").items.get(0);
    assertEquals("1", jump.fields.get("button").text);
    assertEquals(
        "W", jump.fields.get("bindings").items.get(0).fields.get("keys").items.get(0).text);
    Map<String, Json> crate = look.fields.get("sprites").items.get(0).fields;
    assertEquals(
        "crate smoke.png 2 0.5 4", texts(crate, "archetype", "file", "width", "x", "frames"));
    assertEquals("entity cover RATIO", texts(crate.get("by").fields, "scope", "field", "type"));
    assertEquals(
        "2-gun.png gun.png",
        look.fields.get("sprites").items.get(1).fields.get("file").text
            + " "
            + look.fields.get("sprites").items.get(2).fields.get("file").text,
        "two files of one name");
    assertEquals(
        "12 0.25 -3",
        texts(look.fields.get("backgrounds").items.get(0).fields, "height", "parallax", "bottom"));
    Json boom = look.fields.get("events").fields.get("boom");
    assertEquals("PARTICLES 30", texts(boom.items.get(0).fields, "kind", "count"));
    assertEquals("SHAKE 0.5", texts(boom.items.get(1).fields, "kind", "metres"));
    assertEquals(2, boom.items.size(), "a page shows nothing in slow motion");
    assertEquals(
        "40 smoke.png",
        texts(look.fields.get("trails").fields.get("rocket").fields, "count", "picture"));
    Map<String, Json> camera = look.fields.get("camera").fields;
    assertEquals("18 0.5 30", texts(camera, "height", "lead", "otherHeight"));
    assertEquals("cave", camera.get("zones").items.get(0).text);
    assertEquals("cover", camera.get("condition").fields.get("field").text);
    assertEquals("BAR damage", texts(look.fields.get("hud").items.get(0).fields, "kind", "label"));
    Map<String, Json> star = look.fields.get("hud").items.get(1).fields;
    assertEquals("WORD star", texts(star, "kind", "label"));
    assertEquals(
        "match keeper REFERENCE", texts(star.get("value").fields, "scope", "field", "type"));
    assertEquals("0.01 2", texts(look.fields.get("hud").items.get(2).fields, "scale", "decimals"));
    assertEquals(null, look.fields.get("hud").items.get(0).fields.get("decimals"));
    assertEquals(
        List.of("crate", "rocket"),
        look.fields.get("marks").items.stream().map(mark -> mark.text).toList());
  }

  private static String texts(Map<String, Json> fields, String... names) {
    return String.join(" ", Stream.of(names).map(name -> fields.get(name).text).toList());
  }

  @Test
  void aViewThatFailsOrLacksAFileWritesNothingAndSaysWhy() {
    Told thrower = new Told(v -> v.camera().height(Float.NaN));
    IllegalArgumentException thrown =
        assertThrows(IllegalArgumentException.class, () -> LookFolder.write(thrower, folder));
    assertTrue(thrown.getMessage().contains("camera's height=NaN"), thrown.getMessage());
    Told missing = new Told(v -> v.sprite("crate", "nowhere.png"));
    IOException lacks = assertThrows(IOException.class, () -> LookFolder.write(missing, folder));
    assertEquals("nowhere.png isn't in the game's jar", lacks.getMessage());
    assertTrue(Files.notExists(folder.resolve(GameJars.LOOKS)));
  }

  @Test
  void theCommandWritesIntoTheJarOfAGame() throws Exception {
    Path source = folder.resolve("HillView.java");
    Files.writeString(
        source,
        """
        public class HillView implements carom.client.look.GameView {
          public String game() { return "hill"; }
          public void setUp(carom.client.look.ViewSetup v) { v.sprite("cart", "cart.png"); }
        }
        """);
    assertEquals(
        0,
        ToolProvider.getSystemJavaCompiler()
            .run(null, null, null, "-d", folder.toString(), source.toString()));
    Path jar = folder.resolve("game.jar");
    try (FileSystem zip =
        FileSystems.newFileSystem(URI.create("jar:" + jar.toUri()), Map.of("create", "true"))) {
      Files.createDirectories(zip.getPath("META-INF/services"));
      Files.writeString(zip.getPath("META-INF/services", GameView.class.getName()), "HillView");
      Files.copy(folder.resolve("HillView.class"), zip.getPath("HillView.class"));
    }
    assertEquals(2, run(jar.toString()));
    assertTrue(said.toString().contains("cart.png isn't in the game's jar"), said.toString());
    try (FileSystem zip = FileSystems.newFileSystem(jar)) {
      Files.write(zip.getPath("cart.png"), new byte[] {1, 2, 3});
    }
    assertEquals(0, run(jar.toString()), said.toString());
    try (FileSystem zip = FileSystems.newFileSystem(jar)) {
      assertArrayEquals(
          new byte[] {1, 2, 3}, Files.readAllBytes(zip.getPath("carom/looks/hill/cart.png")));
      assertTrue(Files.exists(zip.getPath("carom/looks/hill/look.json")));
    }
    assertEquals(2, run());
    assertTrue(said.toString().contains("name a jar"), said.toString());
    assertEquals(0, run("--out", folder.resolve("all").toString()));
    assertTrue(Files.exists(folder.resolve("all/carom/looks/shooter/look.json")));
  }

  private final StringWriter said = new StringWriter();

  private int run(String... args) {
    said.getBuffer().setLength(0);
    PrintWriter out = new PrintWriter(said, true);
    return new CommandLine(new LookCommand()).setOut(out).setErr(out).execute(args);
  }
}
