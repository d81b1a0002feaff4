package carom.server.web;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import carom.client.InputSource;
import carom.fixtures.CrouchGame;
import carom.fixtures.CrouchGame.Rule;
import carom.net.transport.Impairment;
import carom.server.config.ServerConfig;
import carom.sim.message.PlayerColour;
import carom.suite.Needs;
import carom.testkit.SimulatedClient;
import carom.testkit.Stepper;
import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/**
 * Goal: an operator sees and does on the page what it promises. Method: headless Chromium opens it,
 * clicks, types, and its pixels are looked at.
 */
@Needs("waits")
@Timeout(240)
final class BrowserTest {
  private static final int ENTER = 13;
  private static final int TAB = 9;

  @TempDir private Path folder;
  private Path program;

  @BeforeEach
  void findBrowser() {
    program = Chromium.find();
    if (program == null) {
      assertFalse(System.getenv("CI") != null, "CI has no Chromium: .ci/run installs it");
      System.err.println("SKIPPED: no Chromium here, so nobody looks at the page");
    }
    assumeTrue(program != null, "no Chromium");
  }

  private static BufferedImage canvas(Chromium browser) throws Exception {
    browser.evaluate("scrollTo(0, 0)");
    BufferedImage all = ImageIO.read(new ByteArrayInputStream(browser.screenshot()));
    String[] box =
        browser
            .evaluate(
                "(r => [r.x, r.y, r.width, r.height].map(Math.round).join(' '))"
                    + "(document.getElementById('scene').getBoundingClientRect())")
            .split(" ");
    int[] at = List.of(box).stream().mapToInt(Integer::parseInt).toArray();
    return all.getSubimage(
        at[0],
        at[1],
        Math.min(at[2], all.getWidth() - at[0]),
        Math.min(at[3], all.getHeight() - at[1]));
  }

  private static Set<Integer> colours(BufferedImage image) {
    Set<Integer> colours = new HashSet<>();
    for (int y = 0; y < image.getHeight(); y++) {
      for (int x = 0; x < image.getWidth(); x++) {
        colours.add(image.getRGB(x, y));
      }
    }
    return colours;
  }

  private static int rgb(Chromium browser, String variable) throws Exception {
    String hex =
        browser.evaluate(
            "getComputedStyle(document.documentElement).getPropertyValue('--" + variable + "')");
    return 0xff000000 | Integer.parseInt(hex.strip().substring(1), 16);
  }

  private static void login(Chromium browser) throws Exception {
    browser.await("document.querySelector('#state.live')");
    browser.click("document.getElementById('secret')");
    browser.type(PageRig.TOKEN);
    browser.press("Enter", ENTER);
    browser.await("document.body.classList.contains('is-admin')");
  }

  @Test
  void theRoomIsDrawnAndFollowedAndMoves() throws Exception {
    try (PageRig rig = new PageRig(folder, true);
        Chromium browser = Chromium.start(program, folder.resolve("profile"))) {
      browser.look(1200, 900, false);
      browser.open(rig.web.url());
      browser.await("window.caromScene && caromScene.now && caromScene.names.size === 2");
      BufferedImage first = canvas(browser);
      Set<Integer> colours = colours(first);
      assertTrue(colours.contains(rgb(browser, "ground")), "no ground in the picture");
      assertTrue(colours.contains(rgb(browser, "stage")), "no background in the picture");
      assertTrue(colours.size() > 20, "colours=" + colours.size());
      String dot =
          browser.evaluate(
              "(s => { s.fitted = false; s.camera.scale = 2; s.draw(); s.teams = new Map([[0, 1],"
                  + " [1, 2]]); const look = [...s.looks.values()].find(l => l.owner === 0), [x, y]"
                  + " = s.toScreen(...s.pose(look.slot)), r = devicePixelRatio; s.draw(); const g ="
                  + " s.canvas.getContext('2d'), at = dx => g.getImageData(Math.round((x + dx) *"
                  + " r), Math.round(y * r), 1, 1).data; const seen = [at(4), at(-4)].some(p =>"
                  + " p[0] > 2 * p[2]); s.fit(); return seen + ' ' + s.playerColour(0) + ' ' +"
                  + " s.playerColour(1); })(caromScene)");
      assertEquals(
          "true hsl(4 65% 52%) hsl(214 65% 52%)",
          dot, "a far player is a dot of its team's colour");
      browser.evaluate("caromScene.teams = new Map()");
      // The pixel of a player's body has the player's colour.
      String place =
          browser.evaluate(
              "(() => { const [id, slot] = [...caromScene.now.bodyOf][0]; caromScene.show.names ="
                  + " false; const p = caromScene.pose(slot); return caromScene.toScreen(p[0],"
                  + " p[1]).join(' ') + ' ' + id; })()");
      assertTrue(place.split(" ").length == 3, place);
      // Following puts the player in the middle and keeps it there while it moves.
      browser.click("document.querySelector('#players tbody tr .follow')");
      browser.await("caromScene.follow !== null");
      browser.await(
          "(p => p && Math.hypot(caromScene.camera.x - p[0], caromScene.camera.y - p[1])"
              + " < 0.5)(caromScene.pose(caromScene.now.bodyOf.get(caromScene.follow)))");
      BufferedImage followed = canvas(browser);
      int middle = followed.getRGB(followed.getWidth() / 2 - 3, followed.getHeight() / 2 - 3);
      assertFalse(middle == rgb(browser, "stage"), "nobody is in the middle");
      String tick = browser.evaluate("caromScene.now.tick");
      browser.await("caromScene.now.tick > " + tick + " + 60");
      // Overlays add their colours.
      for (String overlay : List.of("contacts", "cells", "sleeping", "priority")) {
        browser.click("document.getElementById('" + overlay + "')");
      }
      browser.await("caromScene.now.cells.length > 0 && caromScene.now.priorities.length > 0");
      assertNotEquals(colours, colours(canvas(browser)));
      // Zooming with the wheel, and back.
      browser.click("document.getElementById('fit')");
      browser.await("caromScene.follow === null");
      // A click on a body says what it is.
      String at =
          browser.evaluate(
              "(() => { const slot = caromScene.now.slot.find(s => caromScene.looks.get(s).type !=="
                  + " 'static' && !caromScene.now.awake[caromScene.now.index.get(s)]) ??"
                  + " caromScene.now.bodyOf.values().next().value; const p = caromScene.pose(slot);"
                  + " const r = caromScene.canvas.getBoundingClientRect(); const [x, y] ="
                  + " caromScene.toScreen(p[0], p[1]); return (r.x + x) + ' ' + (r.y + y); })()");
      browser.clickAt(Double.parseDouble(at.split(" ")[0]), Double.parseDouble(at.split(" ")[1]));
      browser.await("document.getElementById('body').innerText.includes('entity')");
      assertEquals(List.of(), browser.errors());
    }
  }

  @Test
  void bodiesThatBecomeOthersAndLinesOfAColourAreDrawnAsWhatTheyAre() throws Exception {
    // Goal: the page follows a body from archetype to archetype, and draws the colours of a chain.
    Stepper stepper = Stepper.of(CrouchGame.level(Rule.CRATES_CHANGE), ServerConfig.defaults());
    try (PageRig rig = new PageRig(stepper, folder, true);
        Chromium browser = Chromium.start(program, folder.resolve("profile"))) {
      browser.look(1200, 900, false);
      browser.open(rig.web.url());
      browser.await("window.caromScene && caromScene.now && caromScene.names.size === 2");
      browser.evaluate(
          "(() => { window.kinds = new Map(); setInterval(() => caromScene.looks.forEach((look,"
              + " slot) => { if (!kinds.has(slot)) kinds.set(slot, new Set());"
              + " kinds.get(slot).add(look.kind); }), 20); return ''; })()");
      Set<Integer> wanted =
          Set.of(
              0xffb08968, 0xff66ddff, 0xffcc88ee, 0xff2fbf4f, 0xffff4020); // three kinds, two lines
      Set<Integer> seen = new HashSet<>();
      for (int i = 0; i < 200 && !seen.containsAll(wanted); i++) {
        seen.addAll(colours(canvas(browser)));
      }
      Set<Integer> missing = new HashSet<>(wanted);
      missing.removeAll(seen);
      assertEquals(Set.of(), missing, "colours that are never drawn");
      browser.await(
          "[...kinds.values()].some(k => ['crate', 'ice', 'ghost', 'rock'].every(x => k.has(x)))");
      assertEquals(List.of(), browser.errors());
    }
  }

  @Test
  void theColourThatAPlayerChoseIsDrawn() throws Exception {
    Stepper stepper = Stepper.of("platformer");
    SimulatedClient vi = stepper.join("Vi", Impairment.NONE, InputSource.IDLE);
    vi.game().colour(PlayerColour.VIOLET);
    int violet = 0xff000000 | PlayerColour.VIOLET.rgb();
    try (PageRig rig = new PageRig(stepper, folder, true);
        Chromium browser = Chromium.start(program, folder.resolve("profile"))) {
      browser.look(1200, 900, false);
      browser.open(rig.web.url());
      browser.await("window.caromScene && caromScene.now && caromScene.chosen.has(0)");
      browser.click("document.querySelector('#players tbody tr .follow')");
      browser.await("caromScene.follow === 0");
      assertEquals(
          "rgb(155, 107, 255)",
          browser.evaluate(
              "getComputedStyle(document.querySelector('#players tbody td'),"
                  + " '::before').backgroundColor"));
      browser.evaluate("caromScene.show.names = false");
      int body = count(canvas(browser), violet);
      assertTrue(body > 100, "pixels of the body: " + body);
      browser.evaluate("caromScene.playerColour = () => '#000000'"); // a dot alone would stay
      assertEquals(0, count(canvas(browser), violet));
      // In a team the body has the team's colour, and a rim of its own.
      browser.evaluate("delete caromScene.playerColour");
      browser.await(
          "(s => { s.teams = new Map([[0, 1]]); s.draw(); const r = devicePixelRatio, g ="
              + " s.canvas.getContext('2d'), p = s.pose(s.now.bodyOf.get(0)), [x, y] ="
              + " s.toScreen(p[0], p[1]); const seen = g.getImageData(Math.round((x - 40) * r),"
              + " Math.round((y - 40) * r), 80 * r, 80 * r).data; let rim = 0; for (let i = 0; i <"
              + " seen.length; i += 4) if (seen[i] === 155 && seen[i + 1] === 107 && seen[i + 2]"
              + " === 255) rim++; return s.playerColour(0) === 'hsl(4 65% 52%)' && rim > 10;"
              + " })(caromScene)");
      assertEquals(List.of(), browser.errors());
    }
  }

  private static int count(BufferedImage image, int rgb) {
    int count = 0;
    for (int y = 0; y < image.getHeight(); y++) {
      for (int x = 0; x < image.getWidth(); x++) {
        count += image.getRGB(x, y) == rgb ? 1 : 0;
      }
    }
    return count;
  }

  @Test
  void anOperatorReadsTypesKicksAndBans() throws Exception {
    try (PageRig rig = new PageRig(folder, true);
        Chromium browser = Chromium.start(program, folder.resolve("profile"))) {
      Files.createDirectories(folder.resolve("recordings"));
      Files.writeString(folder.resolve("recordings/evening.carom"), "game");
      browser.look(1200, 900, false);
      browser.open(rig.web.url());
      browser.await("window.caromScene && caromScene.names.size === 2");
      String shown = "[...document.querySelectorAll('#players tbody tr td:first-child')]";
      assertEquals(
          "Ann|" + PageRig.HOSTILE, browser.evaluate(shown + ".map(e => e.textContent).join('|')"));
      assertEquals("0", browser.evaluate("document.querySelectorAll('#players img').length"));
      assertEquals("0", browser.evaluate("document.querySelectorAll('#players .danger').length"));
      login(browser);
      browser.await("document.querySelectorAll('#players .danger').length === 4");
      browser.await("document.getElementById('recordings').innerText.includes('evening.carom')");
      browser.await("document.getElementById('recordings').innerText.includes('1 kB')");
      // The log, with hostile text.
      rig.logging.getLogger("test").warn("a line with <b>markup</b> \u202e\u001b[31m");
      browser.await(
          "document.getElementById('log').textContent.includes("
              + "'a line with <b>markup</b> U+202EU+001B[31m')");
      // The console: completion, a command, an answer.
      browser.click("document.getElementById('line')");
      browser.type("kic");
      browser.press("Tab", TAB);
      browser.await("document.getElementById('line').value === 'kick '");
      browser.press("Tab", TAB);
      browser.await("document.getElementById('words').textContent.includes('Ann')");
      browser.evaluate("document.getElementById('line').value = ''");
      browser.type("rooms");
      browser.press("Enter", ENTER);
      browser.await("document.getElementById('output').textContent.includes('Corner Pocket')");
      // A kick, with a reason that names another room.
      browser.click(
          "[...document.querySelectorAll('#players tbody tr')][1].querySelectorAll('.danger')[0]");
      browser.await("document.getElementById('sure').open");
      browser.click("document.getElementById('sure-reason')");
      browser.type("go \"@nowhere\"");
      browser.click("document.getElementById('sure-ok')");
      browser.await("document.getElementById('output').textContent.includes('removed player=')");
      browser.await(
          "document.querySelectorAll('#players tbody tr').length === 1 && "
              + shown
              + "[0]"
              + ".textContent === 'Ann'");
      // A ban.
      browser.click("document.querySelectorAll('#players .danger')[1]");
      browser.await("document.getElementById('sure').open");
      browser.click("document.getElementById('sure-ok')");
      browser.await("document.getElementById('output').textContent.includes('banned name')");
      browser.await("document.getElementById('players').innerText.includes('Nobody plays')");
      assertTrue(Files.readString(folder.resolve("bans.txt")).contains("name \"Ann\" until "));
      assertEquals(List.of(), browser.errors());
    }
  }

  @Test
  void narrowWindowsAndDarkOnesShowEverything() throws Exception {
    try (PageRig rig = new PageRig(folder, true);
        Chromium browser = Chromium.start(program, folder.resolve("profile"))) {
      browser.look(400, 800, true);
      browser.open(rig.web.url());
      login(browser);
      browser.await("caromScene.now && caromScene.names.size === 2");
      assertEquals(
          "true",
          browser.evaluate("document.documentElement.scrollWidth <= innerWidth"),
          "the page is wider than the window");
      int dark = rgb(browser, "back");
      browser.look(400, 800, false);
      assertNotEquals(dark, rgb(browser, "back"));
      assertEquals("true", browser.evaluate("document.querySelectorAll('.chart').length >= 6"));
      browser.await("[...document.querySelectorAll('.legend b')].every(e => e.textContent)");
      assertEquals(
          Files.exists(Path.of("/proc/self/status")) + " true",
          browser.evaluate(
              "(t => { const [resident, heap] = ['resident', 'heap'].map(n =>"
                  + " parseFloat(t.split(n)[1])); return (resident > heap) + ' ' + (heap > 0);"
                  + " })([...document.querySelectorAll('.chart')].find(c =>"
                  + " c.querySelector('h3').textContent.startsWith('Memory')).innerText)"),
          "the process takes more memory than its heap has objects");
      assertEquals(List.of(), browser.errors());
    }
  }
}
