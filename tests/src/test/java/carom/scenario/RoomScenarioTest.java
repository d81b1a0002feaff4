package carom.scenario;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.client.ClientConfig;
import carom.client.MessageListener;
import carom.client.link.ConnectionPhase;
import carom.client.link.RoomBrowser;
import carom.client.link.ServerAddress;
import carom.net.protocol.ServerMessage.RoomEntry;
import carom.net.transport.Impairment;
import carom.replay.RecordingReader;
import carom.replay.Replay;
import carom.server.config.RoomConfig;
import carom.server.config.ServerConfig;
import carom.server.match.MatchLibrary;
import carom.server.metrics.Counter;
import carom.suite.Needs;
import carom.testkit.Scripts;
import carom.testkit.SimulatedClient;
import carom.testkit.Stepper;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.function.Supplier;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Goal: players find the room they want, go to another one without a new link, and are told in
 * words why not.
 */
class RoomScenarioTest {
  private static final Impairment BAD = Impairment.NONE.withLatency(75, 0).withLoss(2);

  private static RoomConfig room(String name, int places, String... levels) {
    return new RoomConfig(name, "", List.of(levels), places, 1, Map.of("skill", "any"));
  }

  private static Stepper stepper(RoomConfig... rooms) {
    return Stepper.ofRooms(ServerConfig.defaults(), MatchLibrary.INSTALLED, rooms);
  }

  private static SimulatedClient add(Stepper stepper, String name, String room, String game) {
    return add(stepper, name, room, game, "");
  }

  private static SimulatedClient add(
      Stepper stepper, String name, String room, String game, String party) {
    return stepper.add(
        ClientConfig.of(name)
            .withServer("localhost", stepper.tcpPort(), stepper.udpPort())
            .with(ClientConfig.ROOM, room)
            .with(ClientConfig.GAME, game)
            .with(ClientConfig.PARTY, party),
        BAD,
        Scripts.wander(name.hashCode()));
  }

  private static SimulatedClient join(Stepper stepper, String name, String room, String game) {
    SimulatedClient client = add(stepper, name, room, game);
    stepper.awaitPlaying(client);
    return client;
  }

  private static String refusal(Stepper stepper, SimulatedClient client) {
    stepper.runUntil("is refused", () -> client.view().phase() == ConnectionPhase.ENDED, 8);
    return client.view().message();
  }

  private static SimulatedClient friend(Stepper stepper, String name, String party) {
    SimulatedClient client = add(stepper, name, "", "", party);
    stepper.awaitPlaying(client);
    return client;
  }

  @Test
  void aPartyStaysTogetherAndNothingOfItIsLeftBehind() {
    try (Stepper stepper = stepper(room("duel", 2, "arena"), room("cup", 5, "arena"))) {
      join(stepper, "Xu", "duel", "");
      SimulatedClient ann = friend(stepper, "Ann", "Trio");
      assertEquals("cup", ann.view().room(), "the fuller room has no place for friends");
      assertEquals("duel", join(stepper, "Yan", "", "").view().room(), "strangers fill it up");
      List<SimulatedClient> trio =
          List.of(ann, friend(stepper, "Ben", "trio"), friend(stepper, "Cai", "TRIO"));
      for (SimulatedClient member : trio) {
        assertEquals("cup", member.view().room());
      }
      join(stepper, "Dee", "cup", "");
      join(stepper, "Eli", "cup", "");
      String full = refusal(stepper, add(stepper, "Fay", "", "", "trio"));
      assertTrue(full.contains("Your party is in room cup. All 5 places are taken."), full);
      assertTrue(full.contains("duel 2/2"), full);

      trio.forEach(SimulatedClient::leave);
      stepper.run(1);
      stepper.server().addRoom(room("third", 8, "arena"));
      SimulatedClient gil = add(stepper, "Gil", "third", "", "trio");
      stepper.awaitPlaying(gil);
      assertEquals("third", friend(stepper, "Hal", "trio").view().room());
    }
  }

  @Test
  void playersAreToldTheLinkForBrowsersOfTheirRoom() {
    ServerConfig config =
        ServerConfig.defaults()
            .with(ServerConfig.PLAY_PORT, 8080)
            .with(ServerConfig.TLS_CERT, Path.of("some.pem"));
    try (Stepper stepper =
        Stepper.ofRooms(
            config, MatchLibrary.INSTALLED, room("cup", 4, "arena"), room("b_2", 4, "arena"))) {
      SimulatedClient client = add(stepper, "Ann", "cup", "");
      stepper.awaitPlaying(client);
      assertEquals("https://localhost:8080/play#room=cup", client.view().playLink());
      client.game().changeRoom("b_2");
      stepper.runUntil("is in b_2", () -> client.view().room().equals("b_2"), 10);
      assertEquals("https://localhost:8080/play#room=b_2", client.view().playLink());
    }
    try (Stepper stepper = stepper(room("cup", 4, "arena"))) {
      SimulatedClient client = add(stepper, "Ann", "cup", "");
      stepper.awaitPlaying(client);
      assertEquals("", client.view().playLink());
    }
  }

  @Test
  void playersOfOneProcessPlayDifferentGamesInRoomsOfTheirChoice() {
    try (Stepper stepper = stepper(room("cup", 8, "arena"), room("jump", 8, "platformer"))) {
      SimulatedClient ann = join(stepper, "Ann", "jump", "");
      SimulatedClient bob = join(stepper, "Bob", "cup", "");
      SimulatedClient matched = join(stepper, "Cid", "", "arena");
      SimulatedClient noSuchGame = join(stepper, "Dee", "", "chess");
      stepper.run(2);
      assertEquals("platformer", ann.view().game());
      assertEquals("jump", ann.view().room());
      assertEquals("arena", bob.view().game());
      assertEquals("cup", matched.view().room(), "the room that plays the requested game");
      assertEquals("cup", noSuchGame.view().room(), "the fullest, if no room plays the game");
      assertTrue(ann.compared() > 50 && bob.compared() > 50, stepper.describe());
    }
  }

  @Test
  void aFullRoomAndAnUnknownOneAreRefusedInWordsThatNameTheRooms() {
    try (Stepper stepper = stepper(room("cup", 1, "arena"), room("jump", 4, "platformer"))) {
      join(stepper, "Ann", "cup", "");
      String full = refusal(stepper, add(stepper, "Bob", "cup", ""));
      assertTrue(full.contains("The room is full."), full);
      assertTrue(full.contains("Rooms: cup 1/1, jump 0/4."), full);
      String unknown = refusal(stepper, add(stepper, "Cid", "cupp", ""));
      assertTrue(unknown.contains("The server has no such room."), unknown);
      assertTrue(unknown.contains("Rooms: cup 1/1, jump 0/4."), unknown);
    }
  }

  @Test
  void theListIsToldBeforeAndWhilePlaying() {
    RoomConfig[] rooms =
        IntStream.range(0, 20)
            .mapToObj(i -> room("room" + i, 1 + i, i % 2 == 0 ? "arena" : "platformer"))
            .toArray(RoomConfig[]::new);
    try (Stepper stepper = stepper(rooms)) {
      SimulatedClient ann = join(stepper, "Ann", "room3", "");
      RoomBrowser browser =
          new RoomBrowser(
              new ServerAddress("localhost", stepper.tcpPort(), stepper.udpPort()),
              stepper.transport());
      stepper.runUntil(
          "the list is here",
          () -> {
            browser.update(stepper.nowNs());
            return browser.isDone();
          },
          3);
      assertEquals("", browser.problem());
      ann.game().listRooms();
      stepper.runUntil("the list is here", () -> !ann.view().rooms().isEmpty(), 3);
      for (List<RoomEntry> list : List.of(browser.rooms(), ann.view().rooms())) {
        assertEquals(20, list.size());
        assertEquals(
            new RoomEntry(
                "room3", "platformer", "Windmill Gap", "playing", 1, 4, 0, Map.of("skill", "any")),
            list.get(3));
        assertEquals(0, list.get(4).players());
        assertEquals("warm-up", list.get(4).phase());
      }
      stepper.run(1);
      assertEquals(0, stepper.count(Counter.SESSIONS_EXPELLED));
    }
  }

  @Test
  void aFloodOfRequestsForTheListIsAnsweredTwiceASecond() {
    try (Stepper stepper = stepper(room("cup", 8, "arena"), room("jump", 8, "platformer"))) {
      SimulatedClient ann = join(stepper, "Ann", "cup", "");
      int[] answers = {0};
      List<RoomEntry> last = ann.view().rooms();
      long endNs = stepper.nowNs() + 3_000_000_000L;
      while (stepper.nowNs() < endNs) {
        ann.game().listRooms();
        stepper.step();
        List<RoomEntry> now = ann.view().rooms();
        answers[0] += now == last ? 0 : 1;
        last = now;
      }
      assertTrue(answers[0] >= 4 && answers[0] <= 7, "answers=" + answers[0]);
    }
  }

  @Test
  void aPlayerGoesToAnotherRoomAndBackOverTheSameLinkAndBothRecordingsReplay(@TempDir Path folder)
      throws Exception {
    List<Path> files;
    try (Stepper stepper = stepper(room("cup", 8, "arena"), room("jump", 2, "platformer"))) {
      files = stepper.server().record(folder);
      SimulatedClient ann = join(stepper, "Ann", "cup", "");
      SimulatedClient bob = join(stepper, "Bob", "cup", "");
      stepper.run(2);
      for (String name : List.of("jump", "cup")) {
        long compared = ann.compared();
        ann.game().changeRoom(name);
        stepper.runUntil(
            "plays in " + name,
            () ->
                ann.view().room().equals(name)
                    && ann.view().phase() == ConnectionPhase.PLAYING
                    && ann.view().own() != null,
            4);
        stepper.run(2);
        assertTrue(ann.compared() > compared + 50, stepper.describe());
        assertEquals(
            name.equals("cup") ? 2 : 1, ann.view().players().size(), "the roster of " + name);
      }
      assertEquals(0, ann.stats().reconnects());
      assertEquals(0, bob.stats().reconnects());
      assertEquals(0, stepper.room("jump").seats().takenCount());
      assertEquals(2, stepper.room("cup").seats().takenCount());
      assertEquals(0, stepper.count(Counter.LINKS_LOST));
    }
    assertEquals(2, files.size());
    for (Path file : files) {
      replays(file);
    }
  }

  private static void replays(Path file) throws Exception {
    try (RecordingReader reader = RecordingReader.open(file)) {
      Replay replay = new Replay(reader);
      int ticks = 0;
      while (replay.step() == Replay.Progress.TICK) {
        ticks++;
      }
      assertNull(replay.divergence(), file::toString);
      assertTrue(ticks > 60, file + " ticks=" + ticks);
    }
  }

  @Test
  void whoCanNotGoStaysAndIsToldWhy() {
    try (Stepper stepper = stepper(room("cup", 8, "arena"), room("jump", 1, "platformer"))) {
      join(stepper, "Ann", "jump", "");
      SimulatedClient bob = join(stepper, "Bob", "cup", "");
      stepper.run(1);
      bob.game().changeRoom("jump");
      awaitNotice(stepper, bob, "Room jump is full. Rooms: cup 1/8, jump 1/1.");
      bob.game().changeRoom("nowhere");
      awaitNotice(stepper, bob, "There is no such room. Rooms: cup 1/8, jump 1/1.");
      bob.game().changeRoom("cup");
      awaitNotice(stepper, bob, "You are in room cup already.");
      assertEquals("cup", bob.view().room());
      assertEquals(ConnectionPhase.PLAYING, bob.view().phase());
    }
  }

  private static void awaitNotice(Stepper stepper, SimulatedClient client, String text) {
    stepper.runUntil(
        "is told: " + text,
        () -> client.view().notices().stream().anyMatch(notice -> notice.text().equals(text)),
        3);
  }

  @Test
  void aLinkLostAfterTheMoveIsResumedInTheNewRoom() {
    try (Stepper stepper = stepper(room("cup", 8, "arena"), room("jump", 8, "platformer"))) {
      SimulatedClient ann = join(stepper, "Ann", "cup", "");
      stepper.run(1.5);
      ann.game().changeRoom("jump");
      stepper.runUntil("is welcome", () -> ann.view().room().equals("jump"), 4);
      ann.cut();
      stepper.runUntil(
          "is back",
          () ->
              ann.stats().reconnects() == 1
                  && ann.view().phase() == ConnectionPhase.PLAYING
                  && ann.view().own() != null,
          10);
      assertEquals("jump", ann.view().room());
      assertEquals(1, stepper.room("jump").counters().get(Counter.RESUMES));
      assertEquals(0, stepper.room("cup").seats().takenCount());
      assertNotNull(stepper.room("jump").simulation().player(ann.view().playerId()));
    }
  }

  @Test
  void whoIsMutedStaysSoInTheNextRoomAndInTheNextMatch() {
    // Goal: an operator mutes a player, not a seat. Method: a muted player writes in another room,
    // in its next match, and after an operator of that room has lifted it.
    try (Stepper stepper =
        stepper(room("cup", 8, "arena"), room("jump", 8, "platformer", "sluice"))) {
      SimulatedClient ann = join(stepper, "Ann", "cup", "");
      SimulatedClient bob = join(stepper, "Bob", "jump", "");
      List<String> heard = new ArrayList<>();
      bob.game().messages(listener(heard));
      stepper.run(1.2);
      ask(stepper, () -> stepper.room("cup").operator().mute("Ann", true));
      ann.game().changeRoom("jump");
      stepper.runUntil("is there", () -> plays(ann, "jump"), 5);
      say(stepper, ann, "in the next room");
      stepper.room("jump").simulation().matchOver();
      stepper.runUntil("another level", () -> ann.view().level().name().equals("The Sluice"), 5);
      stepper.runUntil("is there", () -> plays(ann, "jump"), 5);
      say(stepper, ann, "in the next match");
      assertEquals(List.of(), heard);
      ask(stepper, () -> stepper.room("jump").operator().mute("Ann", false));
      say(stepper, ann, "heard");
      assertEquals(List.of("heard"), heard);
    }
  }

  private static MessageListener listener(List<String> heard) {
    return new MessageListener() {
      @Override
      public void said(int player, boolean team, String text) {
        heard.add(text);
      }
    };
  }

  private static boolean plays(SimulatedClient client, String room) {
    return client.view().room().equals(room)
        && client.view().phase() == ConnectionPhase.PLAYING
        && client.view().own() != null;
  }

  private static void say(Stepper stepper, SimulatedClient client, String text) {
    client.game().chat(text);
    stepper.run(1);
  }

  private static void ask(Stepper stepper, Supplier<String> question) {
    CompletableFuture<String> answer = CompletableFuture.supplyAsync(question);
    while (!answer.isDone()) {
      stepper.step();
    }
    assertTrue(answer.join().contains("muted Ann"), answer.join());
  }

  @Needs("sockets")
  @Test
  void roomsAreChangedOverRealSocketsToo(@TempDir Path folder) throws Exception {
    try (Stepper stepper =
        Stepper.ofRoomsOverSockets(
            ServerConfig.defaults(),
            MatchLibrary.INSTALLED,
            room("cup", 8, "arena"),
            room("jump", 8, "platformer"))) {
      stepper.server().record(folder);
      SimulatedClient ann =
          stepper.add(
              ClientConfig.of("Ann")
                  .withServer("localhost", stepper.tcpPort(), stepper.udpPort())
                  .with(ClientConfig.ROOM, "cup"),
              Impairment.NONE,
              Scripts.wander(1));
      stepper.awaitPlaying(ann);
      stepper.run(1.2);
      ann.game().changeRoom("jump");
      stepper.runUntil(
          "plays in jump",
          () ->
              ann.view().room().equals("jump")
                  && ann.view().phase() == ConnectionPhase.PLAYING
                  && ann.view().own() != null,
          5);
      stepper.run(1.5);
      assertEquals("platformer", ann.view().game());
      assertEquals(0, ann.stats().reconnects());
    }
    try (Stream<Path> files = Files.list(folder)) {
      for (Path file : files.toList()) {
        replays(file);
      }
    }
  }
}
