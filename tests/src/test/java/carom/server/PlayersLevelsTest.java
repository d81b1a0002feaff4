package carom.server;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.fixtures.Jvm;
import carom.net.protocol.ClientMessage;
import carom.net.protocol.PackedLevel;
import carom.net.protocol.Protocol;
import carom.net.protocol.ProtocolLimits;
import carom.net.protocol.ServerMessage;
import carom.net.protocol.ServerMessage.LevelOutcome;
import carom.server.account.MemoryAccounts;
import carom.server.command.Caller;
import carom.server.command.CommandRegistry;
import carom.server.command.UploadCommands;
import carom.server.config.ServerConfig;
import carom.server.match.MatchLibrary;
import carom.server.upload.Uploads;
import carom.sim.level.Level;
import carom.suite.Needs;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.InstantSource;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Goal: friends play a level that one of them has sent, and garbage costs its sender alone. Method:
 * a server in virtual time, whose check is the real process.
 */
@Needs("processes")
final class PlayersLevelsTest {
  private static final long PATIENCE_NS = 120_000_000_000L;

  @TempDir private Path folder;
  private Uploads uploads;
  private AccountRig rig;

  @BeforeEach
  void start() throws Exception {
    uploads = new Uploads(folder.resolve("uploads"), InstantSource.system(), () -> rig.nowNs);
    rig =
        new AccountRig(
            new MemoryAccounts(),
            null,
            folder,
            1_000_000_000L,
            ServerConfig.defaults().with(ServerConfig.PLAYERS_CHOOSE, List.of("cup")),
            "arena",
            uploads.library(MatchLibrary.INSTALLED),
            "cup",
            "other");
    rig.server.uploads(uploads);
  }

  @AfterEach
  void stop() {
    rig.close();
  }

  private static byte[] level(String name) throws Exception {
    Level arena = Level.builtIn("arena");
    return new String(arena.source(), StandardCharsets.UTF_8)
        .replace("\"" + arena.name() + "\"", "\"" + name + "\"")
        .getBytes(StandardCharsets.UTF_8);
  }

  private FakeClient offer(String token, int size, int packed) {
    FakeClient client = new FakeClient(rig.network.client().connect("", 0, 0));
    client.link.send(new ClientMessage.OfferLevel(Protocol.VERSION, size, packed, "Ann", token));
    rig.clients.add(client);
    steps(5);
    return client;
  }

  private void steps(int count) {
    for (int i = 0; i < count; i++) {
      rig.step();
      rig.work();
    }
  }

  /** Sends a level, and returns what the server says at last. */
  private ServerMessage.LevelAnswer send(String account, byte[] level) throws Exception {
    byte[] packed = PackedLevel.pack(level);
    FakeClient client = offer(AccountRig.token(account), level.length, packed.length);
    for (int at = 0; at < packed.length; at += ProtocolLimits.MAX_LEVEL_PIECE_BYTES) {
      int end = Math.min(packed.length, at + ProtocolLimits.MAX_LEVEL_PIECE_BYTES);
      client.link.send(new ClientMessage.LevelPiece(at, Arrays.copyOfRange(packed, at, end)));
    }
    long begin = System.nanoTime();
    while (answer(client).outcome() == LevelOutcome.UNDER_WAY) {
      steps(1);
      Thread.sleep(2);
      assertTrue(System.nanoTime() - begin < PATIENCE_NS, "no outcome");
    }
    steps(700); // until the account may send again
    return answer(client);
  }

  private static ServerMessage.LevelAnswer answer(FakeClient client) {
    ServerMessage.LevelAnswer last = null;
    for (ServerMessage message : client.messages) {
      last = message instanceof ServerMessage.LevelAnswer answer ? answer : last;
    }
    assertNotNull(last, client.messages + " " + client.refused);
    return last;
  }

  private ServerMessage.LevelList list(FakeClient client) {
    client.link.send(new ClientMessage.ListLevels());
    steps(60);
    ServerMessage.LevelList last = null;
    for (ServerMessage message : client.messages) {
      last = message instanceof ServerMessage.LevelList list ? list : last;
    }
    return last;
  }

  private String played(String room) {
    return rig.room(room).match().level().level().name();
  }

  private void choose(FakeClient client, String level) throws Exception {
    client.link.send(new ClientMessage.ChooseLevel(level));
    for (int i = 0; i < 200; i++) { // the match is built on a thread of its own
      steps(1);
      Thread.sleep(1);
    }
  }

  @Test
  void friendsPlayWhatMostOfThemChooseUntilItIsRemoved() throws Exception {
    assertEquals(LevelOutcome.TAKEN, send("1", level("Anns Court")).outcome());
    FakeClient ann = rig.join("1", "cup");
    FakeClient bob = rig.join("2", "cup");
    rig.join("3", "cup");
    FakeClient eve = rig.join("4", "other");
    steps(60);
    ServerMessage.LevelList list = list(ann);
    assertTrue(list.mayChoose());
    assertEquals(
        List.of(new ServerMessage.LevelEntry("Anns Court", "arena", "Ann", 0, false)),
        list.levels());
    assertFalse(list(eve).mayChoose());
    choose(eve, "Anns Court");
    assertEquals("Corner Pocket", played("other"));
    choose(ann, "nothing of the kind");
    choose(ann, "Anns Court");
    choose(ann, "Anns Court");
    assertEquals("Corner Pocket", played("cup"), "one of three");
    assertEquals(1, list(bob).levels().get(0).votes());
    choose(bob, "anns court");
    assertEquals("Anns Court", played("cup"));
    assertEquals(0, list(bob).levels().get(0).votes(), "a new match, a new choice");
    CommandRegistry commands = new CommandRegistry();
    UploadCommands.add(commands, uploads);
    Caller moderator = new Caller(carom.server.command.Role.MODERATOR, "chat", "Eve");
    assertTrue(commands.run("levels", moderator).text().contains("uploads/Anns Court"));
    assertTrue(commands.run("levels remove \"Anns Court\"", moderator).ok());
    steps(60);
    assertEquals("Anns Court", played("cup"), "the match goes on");
    assertEquals(List.of(), list(ann).levels());
    choose(ann, "Anns Court");
    choose(bob, "Anns Court");
    assertEquals(2, rig.room("cup").match().number());
    rig.room("cup").simulation().matchOver();
    choose(ann, "");
    assertEquals("Corner Pocket", played("cup"), "its end is the end of the level here");
  }

  @Test
  void anOperatorNamesALevelOfAPlayerAtTheStart() throws Exception {
    assertEquals(LevelOutcome.TAKEN, send("1", level("Anns Court")).outcome());
    String hash = uploads.find("Anns Court").hash().substring(0, 12);
    String all =
        start(
            "--uploads",
            "--room=cup=arena,uploads/Anns Court",
            "--room=tug=uploads/" + hash + ":8");
    assertTrue(all.contains("room cup: arena, uploads/Anns Court, 64 places"), all);
    assertTrue(all.contains("room tug: uploads/" + hash + ", 8 places"), all);
    String missing = start("--uploads", "--levels=uploads/Ans Court");
    assertTrue(
        missing.contains("--levels=uploads/Ans Court: uploads/Ans Court: no player has sent"),
        missing);
    assertTrue(missing.contains("\"uploads/Anns Court\""), missing);
    String without = start("--level=uploads/Anns Court");
    assertTrue(without.contains("levels of players need --uploads"), without);
  }

  /** Starts a server on the folder until it is ready or fails, and returns what it logs. */
  private String start(String... flags) throws Exception {
    List<String> command =
        Jvm.command(
            ServerMain.class,
            "--data=" + folder,
            "--bind=127.0.0.1",
            "--tcp-port=0",
            "--udp-port=0",
            "--no-web",
            "--no-query",
            "--no-console");
    command.addAll(List.of(flags));
    Path log = folder.resolve("log.txt");
    Process server = new ProcessBuilder(command).redirectError(log.toFile()).start();
    try {
      server.inputReader().readLine(); // that it is ready, or nothing
      return Files.readString(log);
    } finally {
      server.destroyForcibly();
    }
  }

  @Test
  void garbageIsToldItsSenderAndHarmsNobody() throws Exception {
    FakeClient bob = rig.join("2", "cup");
    ServerMessage.LevelAnswer said =
        send("1", "{\"game\": \"arena\"".getBytes(StandardCharsets.UTF_8));
    assertEquals(LevelOutcome.NOT_TAKEN, said.outcome());
    assertTrue(said.text().startsWith("level:1:"), said.text());
    FakeClient nobody = offer("", 10, 10);
    assertNotNull(nobody.refused, "no token, no account");
    FakeClient gaps = offer(AccountRig.token("3"), 2_000, 2_000);
    gaps.link.send(new ClientMessage.LevelPiece(1_000, new byte[1_000]));
    steps(5);
    assertNotNull(gaps.refused);
    steps(700);
    FakeClient more = offer(AccountRig.token("4"), 10, 10);
    more.link.send(new ClientMessage.LevelPiece(0, new byte[11]));
    steps(5);
    assertNotNull(more.refused);
    FakeClient uninvited = new FakeClient(rig.network.client().connect("", 0, 0));
    uninvited.link.send(new ClientMessage.LevelPiece(0, new byte[11]));
    rig.clients.add(uninvited);
    steps(5);
    assertNotNull(uninvited.refused);
    assertNull(bob.goodbye);
    assertEquals(List.of(), uploads.levels());
  }

  @Test
  void aServerWithoutThemSaysSo() throws Exception {
    rig.server.uploads(null);
    FakeClient ann = offer(AccountRig.token("1"), 10, 10);
    assertEquals(LevelOutcome.NOT_TAKEN, answer(ann).outcome());
    assertTrue(answer(ann).text().contains("takes no levels"));
    FakeClient bob = rig.join("2", "cup");
    assertEquals(List.of(), list(bob).levels());
    choose(bob, "anything");
    assertNull(bob.goodbye);
    uploads.close();
  }
}
