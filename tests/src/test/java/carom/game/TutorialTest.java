package carom.game;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.client.look.ViewSetup;
import carom.game.tag.TagGame;
import carom.game.tag.TagView;
import carom.sim.Role;
import carom.sim.SimulationHost;
import carom.sim.entity.HostPlayer;
import carom.sim.level.Level;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Goal: what {@code docs/games/GAMES.md} and {@code VIEW.md} show compiles and plays. */
class TutorialTest {
  private static final String SOURCES = "tests/src/test/java/carom/game/tag/";

  private static Path root() {
    Path here = Path.of("").toAbsolutePath();
    while (!Files.exists(here.resolve("docs/games/GAMES.md"))) {
      here = here.getParent();
    }
    return here;
  }

  private static String block(String language) throws IOException {
    return block("GAMES.md", language);
  }

  private static String block(String page, String language) throws IOException {
    String manual = Files.readString(root().resolve("docs/games").resolve(page));
    int start = manual.indexOf("```" + language + "\n") + language.length() + 4;
    return manual.substring(start, manual.indexOf("```", start));
  }

  @Test
  void theManualShowsTheCodeThatCompiles() throws IOException {
    Path sources = root().resolve(SOURCES);
    assertEquals(Files.readString(sources.resolve("TagGame.java")), block("java"));
    assertEquals(Files.readString(sources.resolve("TagView.java")), block("VIEW.md", "java"));
  }

  @Test
  void theViewOfTheManualDeclaresItsActions() {
    ViewSetup v = new ViewSetup();
    new TagView().setUp(v);
    assertEquals(3, v.actions().size());
  }

  @Test
  void theGameOfTheManualPlays() throws Exception {
    Level level = Level.parse("yard.json", block("json").getBytes(StandardCharsets.UTF_8));
    SimulationHost s = new SimulationHost(new TagGame(), level, 1, 60, Role.AUTHORITY);
    for (int i = 0; i < 6; i++) {
      s.join("bot " + i);
    }
    List<String> notices = new ArrayList<>();
    for (int tick = 0; tick < 1800; tick++) {
      Bots.wander(s, 2);
      s.step();
      s.outbox().drainNotices(notices::add);
    }
    assertTrue(notices.size() > 2, notices.toString());
    int points = 0;
    for (int id = 0; id < 6; id++) {
      HostPlayer p = s.player(id);
      points += p.score();
    }
    assertEquals(150, points, 8);
  }
}
