package carom.server.thin.web;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import carom.game.Games;
import carom.server.Backend;
import carom.server.Server;
import carom.server.account.AccountService;
import carom.server.account.AccountValues;
import carom.server.account.AccountWrite;
import carom.server.account.MemoryAccounts;
import carom.server.account.Stay;
import carom.server.config.RoomConfig;
import carom.server.config.ServerConfig;
import carom.server.match.MatchLibrary;
import carom.server.web.Chromium;
import carom.sim.SimulationHost;
import carom.sim.field.Schema;
import carom.sim.level.Level;
import carom.suite.Needs;
import java.net.InetAddress;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/**
 * Goal: a link is a game. Method: headless Chromium opens it, joins, plays each game that ships,
 * chats, changes the room, is loaded again and leaves; the page logs no error.
 */
@Needs("sockets, a browser")
@Timeout(240)
final class PlayPageTest {
  private static final int ENTER = 13;
  private static final int ESCAPE = 27;
  private static final List<String> GAMES = List.of("arena", "platformer", "rockets", "shooter");

  @TempDir private Path folder;

  private Path program;

  @BeforeEach
  void findBrowser() {
    program = Chromium.find();
    if (program == null) {
      assertFalse(System.getenv("CI") != null, "CI has no Chromium: .ci/run installs it");
      System.err.println("SKIPPED: no Chromium here, so nobody plays on the page");
    }
    assumeTrue(program != null, "no Chromium");
  }

  private static Server serve(PlayPort port) {
    ServerConfig config = ServerConfig.defaults().with(ServerConfig.STATUS_INTERVAL, 0);
    List<RoomConfig> rooms =
        GAMES.stream().map(game -> new RoomConfig(game, game, List.of(), 8, 1, Map.of())).toList();
    Server server = new Server(config, rooms, MatchLibrary.INSTALLED, port, System::nanoTime);
    server.start();
    return server;
  }

  private static String own(String value) {
    return "(({world}) => { const p = world.own && world.own.poses.at(-1); return p && "
        + value
        + "; })(caromPlay)";
  }

  /** Presses a key until the own body is elsewhere. */
  private static void moves(Chromium browser) throws Exception {
    browser.await(own("true"));
    String before = browser.evaluate(own("p[1].toFixed(2)"));
    String key = "new KeyboardEvent('key%s', {code: 'KeyD', key: 'd', bubbles: true})";
    browser.evaluate("dispatchEvent(" + String.format(Locale.ROOT, key, "down") + ")");
    browser.await(own("Math.abs(p[1] - " + before + ") > 1"));
    browser.evaluate("dispatchEvent(" + String.format(Locale.ROOT, key, "up") + ")");
  }

  /** Goal: the camera shows a zone that the look names, and another height, as the window does. */
  private static void showsZones(Chromium browser) throws Exception {
    String follow =
        "(p => { const {world, look, camera} = p; p.camera = {x: 0, y: 0, height: 20, placed:"
            + " false}; p.world = {match: {bounds: [-100, -50, 100, 50], zones: [{name: 'cave',"
            + " minX: 30, minY: -20, maxX: 34, maxY: 4, rgb: -1}]}}; p.look = {camera: {height: 16,"
            + " lead: 0, all: false, zones: ['cave'], condition: {}, otherHeight: 40}}; for (let i"
            + " = 0; i < 900; i++) p.follow([%d, 0, 0, 0, 0], [], %d, 1 / 60); const c = p.camera;"
            + " Object.assign(p, {world, look, camera}); return [c.height, c.x,"
            + " c.y].map(Math.round).join(' '); })(caromPlay.picture)";
    assertEquals("24 32 -8", browser.evaluate(String.format(Locale.ROOT, follow, 31, 0)));
    assertEquals("16 29 0", browser.evaluate(String.format(Locale.ROOT, follow, 29, 0)));
    assertEquals("40 29 0", browser.evaluate(String.format(Locale.ROOT, follow, 29, 1)));
  }

  /** Goal: the way to the pointer is the movement of a look that points at a place. */
  private static void pointsAtAPlace(Chromium browser) throws Exception {
    String pointed =
        "(c => { c.use([{kind: 'POINT', range: 20, bindings: [{name: 'at', keys: []}], mouse:"
            + " ['pointer'], pad: [], sticks: ['left']}]); c.mouse.aims = true; return c.read(() =>"
            + " [7, -5], [2, 5]).slice(1, 3).join(' '); })(caromPlay.controls)";
    assertEquals("0.25 -0.5", browser.evaluate(pointed));
  }

  @Test
  void everyGameIsPlayedByALink() throws Exception {
    PlayPort port =
        new PlayPort(PlayPort.Settings.plain(List.of(InetAddress.getLoopbackAddress()), 0, 8));
    try (Server server = serve(port);
        Chromium browser = Chromium.start(program, folder.resolve("profile"))) {
      browser.look(1280, 720, true);
      browser.open(port.url() + "#room=arena");
      browser.await("document.querySelectorAll('#rooms li').length === " + GAMES.size());
      browser.evaluate("document.getElementById('name').value = 'Zoë <b>'");
      browser.click("document.getElementById('go')");
      for (String game : GAMES) {
        if (!game.equals("arena")) {
          browser.press("Escape", ESCAPE);
          browser.await("!document.getElementById('menu').hidden");
          browser.click(
              "[...document.querySelectorAll('#rooms button')]"
                  + ".find(b => b.textContent.startsWith('"
                  + game
                  + "'))");
        }
        browser.await("caromPlay.world.match && caromPlay.world.match.game === '" + game + "'");
        browser.await("document.getElementById('menu').hidden");
        browser.await("document.querySelector('#scores .own')");
        assertTrue(
            browser.evaluate("document.querySelector('#scores .own').textContent").contains("<b>"));
        moves(browser);
        assertEquals("true", browser.evaluate("!!caromPlay.picture.look"), "the view of " + game);
      }
      showsZones(browser);
      String kind = "caromPlay.picture.kinds[caromPlay.world.own.archetype].name";
      browser.await("caromPlay.picture.look.spritesOf(" + kind + ")");
      assertEquals(
          "jump drop fire",
          browser.evaluate(
              "[...document.querySelectorAll('#buttons button')].map(b => b.textContent).join('"
                  + " ')"));
      browser.evaluate( // a tap shorter than a picture
          "['down', 'up'].forEach(way => document.querySelector('#buttons"
              + " :last-child').dispatchEvent(new PointerEvent('pointer' + way)))");
      browser.await("caromPlay.picture.sparks.all.length > 0"); // of the shot
      browser.press("Enter", ENTER);
      browser.type("hello <i>all</i>");
      browser.press("Enter", ENTER);
      browser.await("document.getElementById('lines').innerText.includes('hello <i>all</i>')");
      String id = browser.evaluate("caromPlay.world.match.player");
      browser.reload();
      browser.await("window.caromPlay && caromPlay.world.match");
      assertEquals(id, browser.evaluate("caromPlay.world.match.player"), "the same seat");
      moves(browser);
      browser.evaluate("(() => { (window.before = caromPlay.link.socket).close(); })()");
      browser.await(
          "caromPlay.link.isOpen() && caromPlay.link.socket !== before && caromPlay.link.seen >="
              + " 0");
      pointsAtAPlace(browser);
      browser.press("Escape", ESCAPE);
      browser.await("!document.getElementById('menu').hidden");
      browser.click("document.getElementById('leave')");
      browser.await("!document.getElementById('join').hidden");
      for (int i = 0; server.rooms().stream().anyMatch(r -> r.seats().takenCount() > 0); i++) {
        assertTrue(i < 1_000, "the seat is still taken");
        Thread.sleep(10);
      }
      assertEquals(List.of(), browser.errors());
    }
  }

  @Test
  void theLinkIsAQrCodeAndGlassHasSticks() throws Exception {
    PlayPort port =
        new PlayPort(PlayPort.Settings.plain(List.of(InetAddress.getLoopbackAddress()), 0, 8));
    try (Server server = serve(port);
        Chromium browser = Chromium.start(program, folder.resolve("profile"))) {
      browser.look(390, 844, true);
      browser.open(port.url() + "#room=arena");
      browser.await("window.caromPlay && document.getElementById('code').width > 0");
      // Finder patterns: a dark middle, a light ring, a dark ring, in three corners.
      String row =
          browser.evaluate(
              "(() => { const c = document.getElementById('code'), g = c.getContext('2d'), n ="
                  + " c.width / 4, at = (x, y) => g.getImageData(4 * x + 2, 4 * y + 2, 1, 1)"
                  + ".data[0] < 128 ? 1 : 0; return [4, n - 11].map(x => Array.from({length: 7},"
                  + " (_, i) => at(x + i, 7)).join('')).join(' '); })()");
      assertEquals("1011101 1011101", row);
      browser.await("document.querySelectorAll('#rooms li').length === " + GAMES.size());
      browser.click("document.getElementById('go')");
      browser.await("caromPlay.world.own");
      browser.evaluate("document.getElementById('glass').hidden = false");
      String before = browser.evaluate(own("p[1].toFixed(2)"));
      String event =
          "(t => { const e = document.getElementById('moveStick'), r = e.getBoundingClientRect();"
              + " e.setPointerCapture = () => {}; e.dispatchEvent(new PointerEvent('pointer' + t,"
              + " {pointerId: 7, pointerType: 'touch', clientX: r.x + r.width, clientY: r.y +"
              + " r.height / 2})); })";
      browser.evaluate(event + "('down')");
      browser.await(own("Math.abs(p[1] - " + before + ") > 1"));
      browser.evaluate(event + "('up')");
      assertEquals(1, server.rooms().get(0).seats().takenCount());
      assertEquals(List.of(), browser.errors());
    }
  }

  private static AccountService accounts() throws Exception {
    MemoryAccounts store = new MemoryAccounts();
    Schema schema = SimulationHost.schemaOf(Games.create("arena"), Level.builtIn("arena"));
    String[] names = {"Ann <b>", "Bob", "Cleo"};
    for (int i = 0; i < names.length; i++) {
      AccountValues values =
          AccountValues.NONE.with("arena", schema, new int[] {3 - i, 10 + i, 1_500});
      store.write(
          AccountWrite.of(
              new Stay(String.valueOf(i), 1, values),
              names[i],
              "arena",
              new AccountWrite.Place("arena", 1, 1),
              true,
              true));
    }
    AccountService service = new AccountService(store, System::nanoTime);
    service.start();
    return service;
  }

  @Test
  void theMenuHasTheBestWithTheOwnPlace() throws Exception {
    PlayPort port =
        new PlayPort(PlayPort.Settings.plain(List.of(InetAddress.getLoopbackAddress()), 0, 8));
    try (Server server = serve(port);
        Chromium browser = Chromium.start(program, folder.resolve("profile"))) {
      server.accounts(accounts());
      server.admit(Backend.rule(folder));
      browser.look(1280, 720, true);
      browser.open(port.url() + "#room=arena&token=" + Backend.token("1"));
      browser.await("document.querySelectorAll('#rooms li').length === " + GAMES.size());
      browser.evaluate("document.getElementById('name').value = 'Bob'");
      browser.click("document.getElementById('go')");
      browser.await("caromPlay.world.own");
      browser.press("Escape", ESCAPE);
      browser.await("!document.getElementById('menu').hidden");
      browser.click("document.getElementById('best')");
      browser.await("document.querySelectorAll('#bestPage li').length === 6");
      assertEquals(
          "wins: 3Ann <b>, 2Bob  (you), 1Cleo; scored: 12Cleo, 11Bob  (you), 10Ann <b>",
          browser.evaluate(
              "[...document.querySelectorAll('#bestPage div h2')].map(h => h.textContent + ': ' +"
                  + " [...h.nextSibling.children].map(li => li.textContent).join(', ')).join(';"
                  + " ')"));
      assertEquals(
          "2Bob  (you),11Bob  (you)",
          browser.evaluate(
              "[...document.querySelectorAll('#bestPage .own')].map(li => li.textContent).join()"));
      browser.click("document.getElementById('bestBack')");
      browser.await("!document.getElementById('stay').hidden");
      browser.click("[...document.querySelectorAll('#rooms button')][1]"); // platformer
      browser.await("caromPlay.world.match.game === 'platformer'");
      browser.press("Escape", ESCAPE);
      browser.await("!document.getElementById('menu').hidden");
      browser.click("document.getElementById('best')");
      browser.await("document.getElementById('bestPage').innerText.includes('Nobody is listed')");
      assertEquals(List.of(), browser.errors());
    }
  }
}
