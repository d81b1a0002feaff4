package carom.server;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.game.Games;
import carom.net.protocol.ClientMessage;
import carom.net.protocol.Protocol;
import carom.net.protocol.ServerMessage;
import carom.replay.RecordingReader;
import carom.replay.Replay;
import carom.server.account.MemoryAccounts;
import carom.server.command.AccountCommands;
import carom.server.command.Caller;
import carom.server.command.CommandRegistry;
import carom.server.config.BotRule;
import carom.server.config.ServerConfig;
import carom.server.match.HandedInMatch;
import carom.server.session.Session;
import carom.sim.Role;
import carom.sim.SimulationHost;
import carom.sim.entity.Input;
import carom.sim.entity.Newcomer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Goal: accounts remember. Method: whole servers in virtual time, with a store in memory. */
final class AccountTest {
  private final MemoryAccounts store = new MemoryAccounts();

  @TempDir private Path folder;

  private AccountRig rig(String... rooms) throws Exception {
    return new AccountRig(store, null, folder, 1_000_000_000L, rooms);
  }

  private static void earn(AccountRig rig, FakeClient client, int ticks) {
    client.input.hold(Input.ACTION, true);
    for (int i = 0; i < ticks; i++) {
      rig.step();
    }
    client.input.hold(Input.ACTION, false);
    rig.settle();
  }

  private static void leave(AccountRig rig, FakeClient client) {
    client.link.send(new ClientMessage.Leave());
    rig.settle();
  }

  private int stored(String account) {
    return store.value(account, "earn", "coins");
  }

  @Test
  void anAccountKeepsItsCoinsFromStayToStayAndRunToRun() throws Exception {
    int first;
    try (AccountRig rig = rig("cup")) {
      FakeClient ann = rig.join("1", "cup");
      earn(rig, ann, 30);
      first = rig.coins("1", "cup");
      assertTrue(first >= 20, "coins=" + first);
      assertEquals(first, stored("1"));
      leave(rig, ann);
      assertNull(rig.session("1", "cup"));
      rig.join("1", "cup");
      assertEquals(first, rig.coins("1", "cup"));
      assertEquals("1", rig.session("1", "cup").player().account());
    }
    try (AccountRig rig = rig("cup")) {
      rig.join("1", "cup");
      assertEquals(first, rig.coins("1", "cup"));
      rig.join("2", "cup");
      assertEquals(0, rig.coins("2", "cup"));
    }
  }

  private static String give(AccountRig rig, String line) throws Exception {
    CommandRegistry commands = new CommandRegistry();
    AccountCommands.add(commands, rig.accounts, rig.server.rooms());
    Caller moderator = new Caller(carom.server.command.Role.MODERATOR, "chat", "Eve");
    CompletableFuture<String> answer =
        CompletableFuture.supplyAsync(() -> commands.run(line, moderator).text());
    while (!answer.isDone()) {
      rig.step();
      rig.work();
    }
    return answer.get();
  }

  @Test
  void anOperatorSeesAndForgetsAPlayerWhoIsAway() throws Exception {
    try (AccountRig rig = rig("cup")) {
      FakeClient ann = rig.join("1", "cup");
      earn(rig, ann, 30);
      leave(rig, ann);
      String shown = give(rig, "account p1");
      assertTrue(shown.contains("account=1 ") && shown.contains("earn: coins = "), shown);
      assertEquals("forgot account=1; 0 players removed", give(rig, "account forget P1"));
      assertEquals(0, stored("1"));
      assertEquals("nothing is kept of P1", give(rig, "account forget P1"));
      rig.join("1", "cup");
      assertEquals(0, rig.coins("1", "cup"));
    }
  }

  @Test
  void aPlayerWhoIsInIsForgottenAndBeginsAnew() throws Exception {
    try (AccountRig rig = rig("cup")) {
      FakeClient ann = rig.join("1", "cup");
      earn(rig, ann, 30);
      rig.join("2", "cup");
      assertEquals("forgot account=1; 1 player removed", give(rig, "account forget 1"));
      rig.settle();
      assertNull(rig.session("1", "cup"));
      assertNotNull(rig.session("2", "cup"));
      assertEquals(0, stored("1"), "the end of the stay writes nothing");
      FakeClient again = rig.join("1", "cup");
      assertEquals(0, rig.coins("1", "cup"));
      earn(rig, again, 30);
      assertEquals(rig.coins("1", "cup"), stored("1"));
      store.isDown = true;
      String answer = give(rig, "account forget 1");
      assertTrue(answer.contains("try again"), answer);
    }
  }

  @Test
  void playersGetToThoseWhoseAccountsHaveAsMuchOfTheSkill() throws Exception {
    ServerConfig bySkill =
        ServerConfig.defaults().with(ServerConfig.ROOM_RULE, ServerConfig.RoomRule.SKILL);
    HandedInMatch library = new HandedInMatch(EarnGame::new, EarnGame.level());
    try (AccountRig rig =
        new AccountRig(
            store, null, folder, 1_000_000_000L, bySkill, "earn", library, "cup", "den")) {
      rig.game = new EarnGame();
      FakeClient rich = rig.join("1", "cup");
      earn(rig, rich, 30);
      rig.join("2", "den");
      FakeClient away = rig.join("3", "den");
      earn(rig, away, 30);
      leave(rig, away);

      rig.hello("4", "", 0);
      rig.settle();
      assertNotNull(rig.session("4", "den"), "a new account begins with 0, as that of 2");
      FakeClient back = rig.hello("3", "", 0);
      rig.settle();
      assertNotNull(rig.session("3", "cup"), "it has earned as much as 1, who has it in the match");
      leave(rig, back);

      store.isDown = true;
      rig.hello("3", "", 0);
      rig.settle();
      assertNotNull(rig.session("3", "den"), "without the store, the fullest room");
    }
  }

  @Test
  void aClientIsToldTheBestWithItsOwnPlace() throws Exception {
    try (AccountRig rig = rig("cup")) {
      FakeClient ann = rig.join("1", "cup");
      earn(rig, ann, 30);
      FakeClient bob = rig.join("2", "cup");
      earn(rig, bob, 60);
      for (int i = 0; i < 3; i++) {
        ann.link.send(new ClientMessage.ListBest());
        rig.settle();
      }
      ServerMessage.BestLists told = null;
      for (ServerMessage message : ann.messages) {
        told = message instanceof ServerMessage.BestLists lists ? lists : told;
      }
      ServerMessage.BestList coins = told.lists().get(0);
      assertEquals("coins", coins.field());
      assertEquals(1, coins.own());
      assertEquals(
          List.of("P2", "P1"),
          coins.entries().stream().map(ServerMessage.BestEntry::name).toList());
      assertEquals(Integer.toString(rig.coins("2", "cup")), coins.entries().get(0).value());
      for (int i = 0; i < 60; i++) {
        ann.link.send(new ClientMessage.ListBest());
      }
      long before = count(ann);
      for (int i = 0; i < 60; i++) {
        rig.step();
      }
      assertTrue(count(ann) - before <= 2, "twice a second at most");
    }
  }

  private static long count(FakeClient client) {
    return client.messages.stream().filter(m -> m instanceof ServerMessage.BestLists).count();
  }

  @Test
  void metricsCountWhatTheStoreDoes() throws Exception {
    try (AccountRig rig = rig("cup")) {
      FakeClient ann = rig.join("1", "cup");
      earn(rig, ann, 30);
      assertEquals(1, figure(rig, "accounts.read"));
      double written = figure(rig, "accounts.written");
      assertTrue(written > 0);
      assertEquals(0, figure(rig, "accounts.store.down"));
      store.isDown = true;
      ann.input.hold(Input.ACTION, true);
      rig.settle();
      assertEquals(1, figure(rig, "accounts.store.down"));
      assertTrue(figure(rig, "accounts.waiting") > 0);
      assertTrue(figure(rig, "accounts.failed") > 0);
      store.isDown = false;
    }
  }

  private static double figure(AccountRig rig, String name) {
    return rig.accounts.figures().stream()
        .filter(figure -> figure.name().equals(name))
        .mapToDouble(figure -> figure.value().getAsDouble())
        .sum();
  }

  @Test
  void thePlayerTakesThemToAnotherRoom() throws Exception {
    try (AccountRig rig = rig("cup", "jump")) {
      FakeClient ann = rig.join("1", "cup");
      for (int i = 0; i < 90; i++) {
        rig.step();
      }
      ann.input.hold(Input.ACTION, true);
      for (int i = 0; i < 20; i++) {
        rig.step();
      }
      ann.link.send(new ClientMessage.ChangeRoom("jump"));
      for (int i = 0; i < 120 && rig.session("1", "jump") == null; i++) {
        rig.step(); // the store hears nothing of it yet
      }
      assertNotNull(rig.session("1", "jump"));
      assertEquals(
          rig.paid("1", "cup") + rig.paid("1", "jump"), rig.coins("1", "jump"), "on the way");
      earn(rig, ann, 20);
      int all = rig.paid("1", "cup") + rig.paid("1", "jump");
      assertTrue(rig.paid("1", "cup") > 0 && rig.paid("1", "jump") > 0, "all=" + all);
      assertEquals(all, stored("1"));
    }
  }

  @Test
  void anAccountThatPlaysTwiceGainsWhereItJoinedLast() throws Exception {
    try (AccountRig rig = rig("cup", "jump")) {
      FakeClient first = rig.join("1", "cup");
      earn(rig, first, 20);
      int before = stored("1");
      FakeClient second = rig.join("1", "jump");
      assertEquals(before, rig.coins("1", "jump"), "it begins with what the first one has");
      earn(rig, first, 20);
      assertEquals(before, stored("1"));
      earn(rig, second, 10);
      assertEquals(before + rig.paid("1", "jump"), stored("1"));
      leave(rig, first);
      assertEquals(before + rig.paid("1", "jump"), stored("1"));
    }
  }

  @Test
  void aStoreThatIsDownCostsTheStayAndNothingThatWasThere() throws Exception {
    try (AccountRig rig = rig("cup")) {
      FakeClient ann = rig.join("1", "cup");
      earn(rig, ann, 30);
      leave(rig, ann);
      int before = stored("1");
      store.isDown = true;
      FakeClient again = rig.join("1", "cup");
      assertEquals(0, rig.coins("1", "cup"), "what it has isn't known");
      assertNull(rig.session("1", "cup").seat().stay());
      store.isDown = false;
      earn(rig, again, 30);
      leave(rig, again);
      assertEquals(before, stored("1"), "nothing is overwritten");
      rig.join("1", "cup");
      assertEquals(before, rig.coins("1", "cup"));
    }
  }

  @Test
  void aStrangerKeepsNothing() throws Exception {
    SimulationHost s = new SimulationHost(new EarnGame(), EarnGame.level(), 1, 60, Role.AUTHORITY);
    assertEquals("", s.join("Eve").account());
    SimulationHost client =
        new SimulationHost(new EarnGame(), EarnGame.level(), 1, 60, Role.PREDICTION);
    assertThrows(
        IllegalStateException.class, () -> client.mirror().join(0, "Eve").account(), "not told");
    assertEquals(7, s.join(3, new Newcomer("Ann", "1", new int[] {7}), 0, 0).get(EarnGame.COINS));
    assertThrows(
        IllegalArgumentException.class,
        () -> s.join(4, new Newcomer("Bob", "2", new int[] {7, 8}), 0, 0));
  }

  @Test
  void aReplayAsksNoStore() throws Exception {
    Path file = folder.resolve("cup.carom");
    int coins;
    try (AccountRig rig = rig("cup")) {
      FakeClient ann = rig.join("1", "cup");
      earn(rig, ann, 25);
      leave(rig, ann);
    }
    try (AccountRig rig = rig("cup")) {
      rig.server.record(file);
      FakeClient ann = rig.join("1", "cup");
      earn(rig, ann, 25);
      coins = rig.coins("1", "cup");
    }
    assertTrue(Files.exists(file) && coins > 25, "coins=" + coins);
    Games.add(EarnGame::new);
    try (RecordingReader reader = RecordingReader.open(file)) {
      Replay replay = new Replay(reader);
      int most = 0;
      while (replay.step() == Replay.Progress.TICK) {
        assertNull(replay.divergence());
        if (replay.simulation().player(0) != null) {
          most = replay.simulation().player(0).get(EarnGame.COINS);
          assertEquals("1", replay.simulation().player(0).account());
        }
      }
      assertEquals(coins, most);
    }
  }

  @Test
  void whatABotEarnsInTheSeatOfAPlayerIsNotThePlayers() throws Exception {
    Path file = folder.resolve("bots.carom");
    int kept;
    int ticks; // played, all of which a replay must have alike
    try (AccountRig rig =
        new AccountRig(
            store,
            null,
            folder,
            1_000_000_000L,
            ServerConfig.defaults().with(ServerConfig.BOTS, List.of(BotRule.parse("2"))),
            "earn",
            new HandedInMatch(EarnGame::new, EarnGame.level()),
            "cup")) {
      rig.game = new EarnGame();
      List<String> tokens = new ArrayList<>();
      rig.server.bots((token, strength) -> tokens.add(token));
      rig.server.record(file);
      FakeClient ann = rig.join("1", "cup");
      rig.join("2", "cup");
      earn(rig, ann, 30);
      Session seat = rig.session("1", "cup");
      kept = rig.coins("1", "cup");
      ann.link.close("cut");
      rig.settle();
      FakeClient bot = bot(rig, tokens);
      assertTrue(seat.isStandIn());
      earn(rig, bot, 40);
      assertTrue(rig.coins("1", "cup") > kept + 20, "the bot plays with what is there");
      assertEquals(kept, stored("1"));
      FakeClient again = rig.hello("1", "cup", ann.welcome.sessionSecret());
      rig.settle();
      assertFalse(seat.isBot());
      assertEquals(kept, rig.coins("1", "cup"));
      assertEquals(0, bot.welcome.sessionSecret(), "a bot can't come back");
      earn(rig, again, 10);
      int more = rig.coins("1", "cup");
      assertTrue(more > kept, "coins=" + more);
      assertEquals(more, stored("1"));
      leave(rig, again);
      bot = bot(rig, tokens);
      assertTrue(seat.isBot() && seat.seat().isBots());
      earn(rig, bot, 40);
      assertEquals(more, stored("1"));
      assertEquals("", seat.seat().account());
      ticks = rig.room("cup").simulation().tick();
    }
    Games.add(EarnGame::new);
    try (RecordingReader reader = RecordingReader.open(file)) {
      Replay replay = new Replay(reader);
      while (replay.step() == Replay.Progress.TICK) {
        assertNull(replay.divergence());
      }
      assertTrue(replay.equalTicks() >= ticks, "ticks=" + ticks + " of " + replay.equalTicks());
    }
  }

  /** Lets a bot to the seat that was offered last. */
  private static FakeClient bot(AccountRig rig, List<String> tokens) {
    for (int i = 0; i < 300 && tokens.isEmpty(); i++) {
      rig.step();
    }
    FakeClient bot = new FakeClient(rig.network.client().connect("", 0, 0));
    bot.game = rig.game;
    bot.link.send(
        new ClientMessage.Hello(
            Protocol.VERSION,
            Protocol.physicsDigest(),
            "bot",
            0,
            "",
            "",
            "",
            tokens.get(tokens.size() - 1)));
    tokens.clear();
    rig.clients.add(bot);
    rig.settle();
    return bot;
  }
}
