package carom.server.command;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.client.MessageListener;
import carom.client.bots.Bot;
import carom.client.link.ConnectionPhase;
import carom.fixtures.FieldGame;
import carom.game.Games;
import carom.net.transport.Impairment;
import carom.server.config.DataFolder;
import carom.server.config.EffectiveSetting;
import carom.server.config.EffectiveSettings;
import carom.server.config.ServerConfig;
import carom.server.metrics.Counter;
import carom.testkit.SimulatedClient;
import carom.testkit.Stepper;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.atomic.AtomicBoolean;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Goal: each command does what it says in a running server. Method: beside a room with bots. */
final class OperatorCommandsTest {
  @TempDir private Path folder;

  private final CommandRegistry registry = new CommandRegistry();
  private final AtomicBoolean stopped = new AtomicBoolean();
  private Stepper stepper;
  private SimulatedClient ann;

  @BeforeEach
  void play() {
    stepper = Stepper.of("arena");
    ann = stepper.join("Ann", Impairment.NONE, new Bot(Stepper.SEED));
    stepper.join("Bob B", Impairment.NONE, new Bot(Stepper.SEED + 1));
    stepper.run(1);
    DataFolder data = new DataFolder(folder);
    RoomCommands.add(registry, stepper.server().rooms(), data, null, SaveSource.NONE);
    EffectiveSetting seed = new EffectiveSetting(ServerConfig.SEED, List.of("7"), "command line");
    EffectiveSetting grace =
        new EffectiveSetting(ServerConfig.GRACE, List.of(), EffectiveSetting.DEFAULT);
    EffectiveSetting level =
        new EffectiveSetting(ServerConfig.LOG_LEVEL, List.of(), EffectiveSetting.DEFAULT);
    ServerCommands.add(
        registry,
        stepper.server()::status,
        () -> new EffectiveSettings(List.of(grace, level, seed)),
        List.of(data.recordings()),
        file -> "replayed " + file);
    RedirectCommands.add(
        registry,
        stepper.server().rooms(),
        stepper.server()::redirectVisitors,
        to -> to.server().startsWith("dead") ? "server=" + to.server() + " doesn't answer" : null,
        () -> stopped.set(true));
  }

  @AfterEach
  void end() {
    stepper.close();
  }

  @Test
  void nobodyIsSentToAServerThatDoesNotAnswer() {
    CommandRegistry.Answer answer = run("redirect dead.example.org:1");
    assertFalse(answer.ok());
    assertEquals("nobody is sent away: server=dead.example.org:1 doesn't answer", answer.text());
    assertFalse(run("stop --redirect dead.example.org:1").ok());
    assertFalse(stopped.get(), "the server goes on");
    assertEquals(2, stepper.server().rooms().get(0).seats().takenCount());
  }

  /** Runs a line beside the room, which goes on meanwhile. */
  private CommandRegistry.Answer run(String line) {
    CompletableFuture<CommandRegistry.Answer> answer =
        CompletableFuture.supplyAsync(() -> registry.run(line, Caller.CONSOLE));
    while (!answer.isDone()) {
      stepper.run(0.02);
      Thread.onSpinWait();
    }
    return answer.join();
  }

  private String ok(String line) {
    CommandRegistry.Answer answer = run(line);
    assertTrue(answer.ok(), answer.text());
    return answer.text();
  }

  private String fails(String line) {
    CommandRegistry.Answer answer = run(line);
    assertFalse(answer.ok(), answer.text());
    return answer.text();
  }

  @Test
  void showsPlayersRoomsAndStatus() {
    String[] players = ok("list").split("\n");
    assertEquals(3, players.length);
    assertTrue(players[1].matches("0 +Ann +1 .*playing.* \\d+ ms +\\d+\\.\\d %"), players[1]);
    assertTrue(players[2].matches("1 +Bob B +1 .*playing.*"), players[2]);
    assertTrue(ok("rooms").matches("(?s).*@1 +2/64 +arena +Corner Pocket +\\d+ +runs"));
    assertTrue(ok("status").contains("2 of 64 players"));
    assertTrue(fails("list @nowhere").contains("no room=nowhere; rooms are @1"));
  }

  @Test
  void helpAndStatusBreakBetweenWordsOnATerminalOf80() {
    for (String line : (ok("help") + "\n" + ok("status")).split("\n")) {
      assertTrue(line.length() < 80, line);
    }
    assertTrue(ok("help").contains("\nlist [@ROOM]              Shows the players.\n"), ok("help"));
  }

  @Test
  void saysALineThatEveryPlayerHears() {
    List<String> heard = new ArrayList<>();
    ann.game()
        .messages(
            new MessageListener() {
              @Override
              public void said(int player, boolean team, String text) {
                heard.add(player + " " + text);
              }
            });
    assertEquals("said to 2 players", ok("say @1 five minutes left"));
    stepper.run(0.5);
    assertEquals(List.of("-1 five minutes left"), heard);
    assertTrue(fails("say " + "x".repeat(121)).contains("allowed are 1..120"));
  }

  @Test
  void kicksByNameByIdAndTellsWhy() {
    assertTrue(fails("kick Anm").contains("did you mean \"Ann\"?"));
    assertTrue(ok("kick ann too loud").contains("removed player=0 name=Ann"));
    stepper.run(0.5);
    assertFalse(ok("list").contains("Ann"));
    assertTrue(ok("kick 1").contains("Bob B"));
    assertEquals("nobody plays", ok("list"));
  }

  @Test
  void changesLevelAndGame() throws Exception {
    FieldGame.register();
    assertTrue(ok("level commons").contains("playing game=arena level=Commons"));
    assertTrue(ok("game platformer").contains("playing game=platformer"));
    String nowhere = ok("level nowhere");
    assertTrue(nowhere.startsWith("not changed: "), nowhere);
    assertTrue(nowhere.contains("levels here are arena, "), nowhere);
    assertFalse(nowhere.contains("fields"), "that game's level isn't in the program: " + nowhere);
    String near = ok("level comons");
    assertTrue(near.endsWith("did you mean \"commons\"?"), near);
    String unknown = ok("game platfromer");
    assertTrue(unknown.contains("did you mean \"platformer\"?"), unknown);
    // What comes behind it is about a folder of games, if other tests have opened one.
    var why = assertThrows(IllegalArgumentException.class, () -> Games.create("platfromer"));
    assertTrue(unknown.endsWith(why.getMessage()), unknown);
    assertTrue(ok("rooms").contains("platformer"));
  }

  @Test
  void savesAMatchAndGoesOnWithItWithThePlayersWhoAreHere() throws Exception {
    stepper.run(1);
    int before = stepper.room().simulation().tick();
    assertTrue(ok("save evening").startsWith("saved room=1 to " + folder.resolve("saves")));
    assertEquals(List.of("evening"), registry.complete(List.of("load"), Caller.CONSOLE));
    int saved = stepper.room().simulation().tick();
    float x = stepper.room().simulation().player(0).entity().body().x();
    ok("kick \"Bob B\"");
    stepper.run(3);
    long askedNs = stepper.nowNs();
    assertTrue(ok("load evening").contains("playing game=arena level=Corner Pocket"));
    // The room goes on while the disk writes and reads.
    long since = (stepper.nowNs() - askedNs) * 60 / 1_000_000_000 + 1;
    int loaded = stepper.room().simulation().tick();
    assertTrue(
        loaded >= before && loaded <= saved + since,
        () -> before + " to " + saved + " + " + since + ", loaded " + loaded);
    assertNotNull(stepper.room().simulation().player(0).entity(), "Ann has her body");
    assertNull(stepper.room().simulation().player(1), "Bob is gone");
    assertTrue(Math.abs(stepper.room().simulation().player(0).entity().body().x() - x) < 20);
    stepper.run(1);
    assertTrue(ok("list").contains("playing"), ok("list"));
    long compared = ann.compared();
    stepper.run(2);
    assertTrue(ann.compared() > compared, "she plays and predicts on");
    String missing = ok("load evenin");
    assertTrue(missing.startsWith("not loaded: there is no file "), missing);
    assertTrue(missing.endsWith("; did you mean \"evening\"?; saved are evening"), missing);
    assertTrue(fails("load ../x").contains("other characters"));
    Path file = folder.resolve("saves/evening.carom-save");
    byte[] bytes = Files.readAllBytes(file);
    bytes[bytes.length / 2] ^= 1;
    Files.write(file, bytes);
    assertTrue(ok("load evening").contains("torn or damaged"));
  }

  @Test
  void recordsIntoTheDataFolder() throws Exception {
    assertTrue(ok("record").contains("recording to " + folder.resolve("recordings")));
    stepper.run(0.5);
    assertTrue(ok("record stop").contains("recorded to "));
    try (var files = Files.list(folder.resolve("recordings"))) {
      Path file = files.findFirst().orElseThrow();
      assertEquals("replayed " + file, ok("replay " + file));
      assertEquals(List.of(file.toString()), registry.complete(List.of("replay"), Caller.CONSOLE));
    }
  }

  @Test
  void explainsAndShowsFieldsAndSettings() {
    String why = ok("why Ann 0");
    assertTrue(why.matches("(?s)Entity 0 .* Ann.* \\([A-Z_]+\\)\\..*"), why);
    assertTrue(
        why.matches("(?s).*\nsent +\\d+ +last tick at which it was sent, \\d+ ticks? ago\n.*"),
        why);
    assertTrue(why.lines().allMatch(line -> line.length() < 80), why);
    String nothing = ok("why Ann 400");
    assertTrue(
        nothing.startsWith("There is no entity 400, and Ann's client shows none (FREE)."), nothing);
    assertTrue(nothing.contains("it was never sent"), nothing);
    assertTrue(fails("why Ann x").contains("ENTITY=x is no number"));
    assertTrue(ok("fields").contains("match."));
    assertTrue(ok("fields").lines().allMatch(line -> line.matches("match\\.\\S+=[^=]*")));
    assertTrue(ok("fields player 0").contains("player"));
    assertTrue(ok("config").matches("(?s).*seed +7 +command line"));
    assertTrue(ok("config seed").contains("from: command line"));
    assertTrue(ok("config seed").contains("CAROM_SEED"));
    assertTrue(ok("config").matches("(?s).*grace +30 s +default.*"), ok("config"));
    assertTrue(ok("config grace").startsWith("grace = 30 s\n  from: default\n  default: 30 s\n"));
    assertTrue(ok("config grace").endsWith("it holds from the next start"));
    assertTrue(ok("config log-level").endsWith("it holds from the command 'reload' or 'set' on"));
    assertTrue(fails("config sead").contains("did you mean \"seed\"?"));
  }

  @Test
  void sendsPlayersToAnotherServer() {
    assertTrue(fails("redirect nowhere").contains("must be HOST:PORT"));
    assertTrue(fails("redirect x:70000").contains("must be HOST:PORT"));
    assertTrue(fails("redirect x:1#short").contains("must be HOST:PORT"));
    assertTrue(fails("stop now").contains("isn't --redirect"));
    assertFalse(stopped.get());
    assertEquals(2, stepper.count(Counter.JOINS));
    assertEquals("sent players=1 to [::1]:9", ok("redirect [::1]:9 Ann"));
    stepper.run(1);
    // In memory all addresses are this server's.
    assertEquals(3, stepper.count(Counter.JOINS));
    assertEquals(0, stepper.count(Counter.RESUMES));
    assertEquals(ConnectionPhase.PLAYING, ann.view().phase());
    assertEquals("sent players=2 to localhost:1, stopping", ok("stop --redirect localhost:1"));
    assertTrue(stopped.get());
  }

  @Test
  void stopsTheServer() {
    assertEquals("stopping", ok("stop"));
    assertTrue(stopped.get());
  }
}
