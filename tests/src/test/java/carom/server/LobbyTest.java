package carom.server;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.net.protocol.ClientMessage;
import carom.net.protocol.GoodbyeReason;
import carom.net.protocol.Protocol;
import carom.net.protocol.RefusalReason;
import carom.net.protocol.ServerMessage;
import carom.server.access.EntryRule;
import carom.server.config.ServerConfig;
import carom.server.metrics.Counter;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

class LobbyTest {
  private Rig rig =
      new Rig(ServerConfig.defaults().with(ServerConfig.MAX_PLAYERS, 2), new TestGame(3));

  @AfterEach
  void close() {
    rig.close();
  }

  @Test
  void welcomeTellsEverythingAndTheLevelArrivesWhole() {
    FakeClient client = rig.join("Ann");
    assertEquals(0, client.welcome.playerId());
    assertEquals(60, client.welcome.tickRate());
    assertEquals("test", client.welcome.game());
    assertEquals("test", client.welcome.levelName());
    assertEquals(TestGame.level().contentHash(), client.welcome.levelHash());
    assertNotEquals(0, client.welcome.sessionSecret());
    assertArrayEquals(TestGame.level().source(), client.level);
    assertTrue(client.level.length > 2 * 4_096, "loads in several chunks");
    assertEquals("Ann", client.roster.entries().get(0).name());
  }

  @Test
  void clientThatHasTheLevelMaySkipIt() {
    FakeClient client = rig.connect().hello("Ann");
    client.loads = false;
    rig.steps(2);
    client.link.send(
        new ClientMessage.Ready(client.welcome.epoch(), client.welcome.declarationsDigest()));
    rig.steps(3);
    assertTrue(client.decoder.hasAck());
  }

  @Test
  void aBanReachesAPlayerWhoLoadsTheLevel() {
    FakeClient client = rig.connect().hello("Ann");
    client.loads = false;
    rig.steps(2);
    assertNotNull(client.welcome);
    rig.server.admit(
        (name, account, remote) -> new EntryRule.Refusal(RefusalReason.BANNED, "for " + name));
    client.link.send(
        new ClientMessage.Ready(client.welcome.epoch(), client.welcome.declarationsDigest()));
    rig.steps(3);
    assertEquals(RefusalReason.BANNED, client.refused.reason());
    assertEquals("for Ann", client.refused.text());
    assertEquals(0, rig.room.seats().takenCount());
  }

  @Test
  void aClientWhoseGameHasOtherFieldsIsRefused() {
    FakeClient client = rig.connect().hello("Ann");
    client.loads = false;
    rig.steps(2);
    client.link.send(
        new ClientMessage.Ready(client.welcome.epoch(), client.welcome.declarationsDigest() + 1));
    rig.steps(3);
    assertEquals(RefusalReason.GAME_VERSION, client.refused.reason());
  }

  @Test
  void otherProtocolVersionIsRefusedWithBothNumbers() {
    FakeClient client = rig.connect();
    client.link.send(new ClientMessage.Hello(9_999, Protocol.physicsDigest(), "Ann", 0));
    rig.steps(3);
    assertEquals(RefusalReason.PROTOCOL_VERSION, client.refused.reason());
    assertTrue(client.refused.text().contains("9999"), client.refused.text());
    assertTrue(client.refused.text().contains("" + Protocol.VERSION), client.refused.text());
  }

  @Test
  void otherPhysicsIsRefused() {
    FakeClient client = rig.connect();
    client.link.send(new ClientMessage.Hello(Protocol.VERSION, 1, "Ann", 0));
    rig.steps(3);
    assertEquals(RefusalReason.PHYSICS_VERSION, client.refused.reason());
  }

  @Test
  void aPartyWithAnUntidyNameIsRefused() {
    FakeClient client = rig.connect();
    client.link.send(
        new ClientMessage.Hello(
            Protocol.VERSION, Protocol.physicsDigest(), "Ann", 0, "", "", "no\nway", ""));
    rig.steps(3);
    assertEquals(RefusalReason.BAD_REQUEST, client.refused.reason());
    assertTrue(client.refused.text().contains("party="), client.refused.text());
  }

  @Test
  void blankNameIsRefusedAndSurroundingSpaceIsCut() {
    FakeClient blank = rig.connect().hello("  ");
    FakeClient spaced = rig.connect().hello("  Ann ");
    rig.steps(10);
    assertEquals(RefusalReason.NAME_INVALID, blank.refused.reason());
    assertEquals("Ann", spaced.roster.entries().get(0).name());
  }

  @Test
  void fullServerSaysHowManyPlacesThereAreAndLetsTheNextInWhenOneLeaves() {
    FakeClient first = rig.join("a");
    rig.join("b");
    FakeClient third = rig.connect().hello("c");
    rig.steps(3);
    assertEquals(RefusalReason.SERVER_FULL, third.refused.reason());
    assertTrue(third.refused.text().contains("2"), third.refused.text());
    first.link.send(new ClientMessage.Leave());
    rig.steps(3);
    assertEquals(0, rig.join("d").welcome.playerId());
  }

  @Test
  void theSeatOfThePlayerWhoLostTheConnectionFirstGoesToANewcomerOfAFullServer() {
    FakeClient first = rig.join("a");
    FakeClient second = rig.join("b");
    first.link.close("gone");
    rig.seconds(1);
    second.link.close("gone");
    rig.seconds(8.5);
    FakeClient tooSoon = rig.connect().hello("c");
    rig.seconds(.2);
    assertEquals(
        RefusalReason.SERVER_FULL, tooSoon.refused.reason(), "a lost player has 10 s to return");
    rig.seconds(.5);
    FakeClient third = rig.join("c");
    assertEquals(first.welcome.playerId(), third.welcome.playerId());
    rig.seconds(1);
    assertEquals(1, rig.count(Counter.PLAYERS));
    assertEquals(1, rig.count(Counter.PLAYERS_IN_GRACE));
    FakeClient back = rig.join("b", second.welcome.sessionSecret());
    assertEquals(second.welcome.playerId(), back.welcome.playerId(), "the other one is waited for");
  }

  /** Goal: a crowd that drops doesn't keep its seats for as long as a lost player would. */
  @Test
  void aCrowdThatLosesItsConnectionsGivesWayAtOnce() {
    rig.close();
    rig = new Rig(ServerConfig.defaults().with(ServerConfig.MAX_PLAYERS, 4), new TestGame(3));
    FakeClient alone = rig.joinFrom("198.51.100.1", "alone");
    List<FakeClient> crowd = new ArrayList<>();
    for (int i = 1; i <= 3; i++) {
      crowd.add(rig.joinFrom("192.0.2." + i, "crowd" + i));
    }
    alone.link.close("gone");
    crowd.forEach(client -> client.link.close("gone"));
    rig.seconds(1);
    assertEquals(4, rig.count(Counter.PLAYERS_IN_GRACE));
    FakeClient newcomer = rig.joinFrom("203.0.113.1", "newcomer");
    assertEquals(crowd.get(2).welcome.playerId(), newcomer.welcome.playerId(), "the newest");
    FakeClient second = rig.connectFrom("203.0.114.1").hello("second");
    rig.steps(10);
    assertEquals(RefusalReason.SERVER_FULL, second.refused.reason(), "two seats are no crowd");
  }

  /** Goal: who comes back again and again without an end keeps one seat, not the whole room. */
  @Test
  void aStalledReturnSwitchesOffNoSharesOfNetworks() {
    rig.close();
    rig = new Rig(ServerConfig.defaults().with(ServerConfig.MAX_PLAYERS, 4), new TestGame(3));
    for (int i = 1; i <= 3; i++) {
      rig.joinFrom("192.0.2." + i, "crowd" + i);
    }
    FakeClient lost = rig.joinFrom("198.51.100.1", "lost");
    lost.link.close("gone");
    rig.seconds(2);
    FakeClient stalled =
        rig.connectFrom("198.51.100.1").hello("lost", lost.welcome.sessionSecret());
    stalled.loads = false;
    rig.steps(10);
    assertNotNull(stalled.welcome);
    rig.joinFrom("203.0.113.1", "newcomer");
    assertEquals(1, rig.count(Counter.PLAYERS_IN_GRACE), "the stalled one keeps its seat");
  }

  /** Goal: loaders that stall, each from an address of its own, don't keep players out. */
  @Test
  void whoStallsWhileLoadingGivesWayToANewcomerOfAFullServer() {
    rig.close();
    rig = new Rig(ServerConfig.defaults().with(ServerConfig.MAX_PLAYERS, 4), new TestGame(3));
    List<FakeClient> stalled = new ArrayList<>();
    for (int i = 1; i <= 4; i++) {
      FakeClient client = rig.connectFrom("192.0.2." + i).hello("stalls" + i);
      client.loads = false;
      stalled.add(client);
    }
    rig.seconds(1);
    FakeClient early = rig.connectFrom("203.0.113.1").hello("early");
    rig.seconds(0.5);
    assertEquals(RefusalReason.SERVER_FULL, early.refused.reason(), "they may be slow");
    rig.seconds(1);
    rig.joinFrom("203.0.113.1", "newcomer");
    assertEquals(RefusalReason.TOO_SLOW, stalled.get(0).refused.reason());
    assertEquals(3, stalled.stream().filter(client -> client.refused == null).count());
  }

  /** Goal: a network gets no more of the lobby by loading slowly from many addresses. */
  @Test
  void aNetworkThatLoadsInManySeatsGivesOneUp() {
    rig.close();
    rig = new Rig(ServerConfig.defaults().with(ServerConfig.MAX_PLAYERS, 12), new TestGame(3));
    List<FakeClient> slow = new ArrayList<>();
    for (int i = 1; i <= 12; i++) {
      FakeClient client = rig.connectFrom("192.0.2." + i).hello("slow" + i);
      client.loads = false;
      slow.add(client);
    }
    rig.steps(5);
    rig.joinFrom("203.0.113.1", "newcomer");
    assertEquals(RefusalReason.TOO_SLOW, slow.get(0).refused.reason());
    assertEquals(11, slow.stream().filter(client -> client.refused == null).count());
  }

  @Test
  void anIdlePlayerGivesWayToANewcomerOfAFullServerAndOnlyThen() {
    rig.close();
    rig =
        new Rig(
            ServerConfig.defaults()
                .with(ServerConfig.MAX_PLAYERS, 2)
                .with(ServerConfig.IDLE_KICK, 10),
            new TestGame(3));
    FakeClient idle = rig.join("idle");
    FakeClient busy = rig.join("busy");
    FakeClient tooSoon = rig.connect().hello("early");
    rig.steps(3);
    assertEquals(RefusalReason.SERVER_FULL, tooSoon.refused.reason());
    for (int second = 0; second < 30; second++) {
      busy.input.move(second % 2, 0);
      rig.seconds(1);
    }
    assertEquals(2, rig.count(Counter.PLAYERS), "nobody else wanted to play");
    assertEquals(1, rig.count(Counter.PLAYERS_IDLE));
    FakeClient newcomer = rig.join("newcomer");
    assertEquals(idle.welcome.playerId(), newcomer.welcome.playerId());
    assertEquals(GoodbyeReason.IDLE, idle.goodbye.reason());
    assertNull(busy.goodbye);
  }

  private static List<Integer> goneOf(List<FakeClient> clients) {
    return IntStream.range(0, clients.size())
        .filter(i -> clients.get(i).goodbye != null)
        .boxed()
        .toList();
  }

  @Test
  void ofAFullRoomTheNewestOfANetworkAboveItsShareGivesWayUntilAllHoldEqually() {
    rig.close();
    rig = new Rig(ServerConfig.defaults().with(ServerConfig.MAX_PLAYERS, 6), new TestGame(3));
    for (int i = 0; i < 6; i++) {
      rig.joinFrom("192.0.2.66", "bot" + i);
    }
    List<FakeClient> bots = List.copyOf(rig.clients);
    FakeClient ann = rig.joinFrom("198.51.100.1", "ann");
    assertEquals(List.of(5), goneOf(bots));
    assertEquals(GoodbyeReason.CROWDED, bots.get(5).goodbye.reason());
    FakeClient ben = rig.joinFrom("198.51.100.2", "ben");
    FakeClient cleo = rig.joinFrom("203.0.113.1", "cleo");
    FakeClient dan = rig.joinFrom("203.0.113.2", "dan");
    assertEquals(List.of(2, 3, 4, 5), goneOf(bots), "two places each");
    for (String address : List.of("192.0.2.66", "198.51.100.3", "203.0.113.3", "203.0.114.1")) {
      FakeClient refused = rig.connectFrom(address).hello("more");
      rig.steps(3);
      assertEquals(RefusalReason.SERVER_FULL, refused.refused.reason(), address);
    }
    assertEquals(List.of(), goneOf(List.of(ann, ben, cleo, dan)));
  }

  @Test
  void aWholeSchoolPlaysAndKeepsItsShareHoweverManyNetworksCome() {
    rig.close();
    rig =
        new Rig(
            ServerConfig.defaults()
                .with(ServerConfig.MAX_PLAYERS, 16)
                .with(ServerConfig.NETWORK_SHARE, 25),
            new TestGame(3));
    for (int i = 0; i < 16; i++) {
      rig.joinFrom("192.0.2.9", "pupil" + i);
    }
    List<FakeClient> school = List.copyOf(rig.clients);
    assertEquals(List.of(), goneOf(school));
    for (int i = 0; i < 20; i++) {
      rig.connectFrom("198.51." + i + ".1").hello("stranger" + i);
      rig.seconds(1);
    }
    assertEquals(12, goneOf(school).size(), "a quarter of 16 places stays");
    assertEquals(List.of(), goneOf(school.subList(0, 4)), "the first to come");
    assertEquals(List.of(), goneOf(rig.clients.subList(16, 28)), "strangers keep what they got");
  }

  @Test
  void inANetworkTheBusiestAddressGivesWayAlsoToItsNeighbour() {
    rig.close();
    rig = new Rig(ServerConfig.defaults().with(ServerConfig.MAX_PLAYERS, 4), new TestGame(3));
    rig.joinFrom("192.0.2.66", "bot1");
    rig.joinFrom("192.0.2.66", "bot2");
    rig.joinFrom("192.0.2.66", "bot3");
    rig.joinFrom("192.0.2.7", "neighbour");
    List<FakeClient> clients = List.copyOf(rig.clients);
    rig.joinFrom("192.0.2.8", "another");
    assertEquals(List.of(2), goneOf(clients), "not the newest of the network");
  }

  @Test
  void theSeatThatANetworkGivesUpIsKeptForTheOneWhoAsked() {
    rig.close();
    rig = new Rig(ServerConfig.defaults().with(ServerConfig.MAX_PLAYERS, 6), new TestGame(3));
    for (int i = 0; i < 6; i++) {
      rig.joinFrom("192.0.2.66", "bot" + i);
    }
    FakeClient ann = rig.connectFrom("198.51.100.1").hello("ann");
    for (int i = 0; i < 30 && !ann.ready; i++) {
      rig.connectFrom("192.0.2.66").hello("again" + i);
      rig.step();
    }
    assertTrue(ann.ready, "" + ann.refused);
    assertEquals(1, goneOf(rig.clients.subList(0, 6)).size(), "one seat was enough");
  }

  @Test
  void withAShareOfAllNobodyGivesWay() {
    rig.close();
    rig =
        new Rig(
            ServerConfig.defaults()
                .with(ServerConfig.MAX_PLAYERS, 3)
                .with(ServerConfig.NETWORK_SHARE, 100),
            new TestGame(3));
    for (int i = 0; i < 3; i++) {
      rig.joinFrom("192.0.2.66", "bot" + i);
    }
    FakeClient ann = rig.connectFrom("198.51.100.1").hello("ann");
    rig.seconds(1);
    assertEquals(RefusalReason.SERVER_FULL, ann.refused.reason());
  }

  @Test
  void linksThatSayNothingDoNotKeepPlayersOut() {
    for (int i = 0; i < 500; i++) {
      rig.connect();
    }
    rig.step();
    assertTrue(rig.server.visitorCount() < 100, "visitors=" + rig.server.visitorCount());
    rig.join("Ann");
  }

  @Test
  void aLinkThatClosesWhileItEntersIsNoticedAtOnce() {
    FakeClient client = rig.connect().hello("a");
    client.loads = false;
    rig.steps(2);
    client.link.send(
        new ClientMessage.Ready(client.welcome.epoch(), client.welcome.declarationsDigest()));
    client.link.close("gone");
    rig.seconds(0.5);
    assertEquals(0, rig.count(Counter.PLAYERS), "not after five seconds of silence");
    assertEquals(rig.count(Counter.JOINS), rig.count(Counter.LINKS_LOST));
  }

  @Test
  void placesPromisedButNotTakenLeaveRoomForOthers() {
    rig.close();
    rig = new Rig(ServerConfig.defaults().with(ServerConfig.MAX_PLAYERS, 64), new TestGame(3));
    for (int i = 0; i < 64; i++) {
      rig.connect().hello("hog").loads = false;
    }
    rig.seconds(1);
    int held = rig.room.seats().takenCount();
    assertTrue(held >= 8 && held <= 32, "held=" + held);
    rig.seconds(5);
    long refused = rig.clients.stream().filter(c -> c.refused != null).count();
    assertEquals(64 - held, refused, "the rest is told, and not kept waiting");
  }

  @Test
  void whoComesAndGoesInALoopIsSlowedDown() {
    FakeClient client = rig.join("a");
    long secret = client.welcome.sessionSecret();
    FakeClient bystander = rig.join("b");
    long end = rig.nowNs + 8_000_000_000L;
    while (rig.nowNs < end) {
      client.link.close("loop");
      client = rig.connect().hello("a", secret);
      for (int i = 0; i < 180 && !client.ready && !client.closed; i++) {
        rig.step();
      }
    }
    assertTrue(rig.count(Counter.RESUMES) <= 7, "resumes=" + rig.count(Counter.RESUMES));
    assertFalse(bystander.closed);
  }

  @Test
  void secondPlayerOfThatNameGetsANumber() {
    rig.join("Ann");
    FakeClient second = rig.join("Ann");
    rig.seconds(1);
    assertEquals("Ann (2)", second.roster.entries().get(1).name());
  }

  @Test
  void silentLinkIsRefusedAtTheDeadlineAndThenClosed() {
    FakeClient client = rig.connect();
    rig.seconds(4.9);
    assertNull(client.refused);
    rig.seconds(0.3);
    assertEquals(RefusalReason.TOO_SLOW, client.refused.reason());
    rig.seconds(1.1);
    assertTrue(client.closed);
    assertEquals(0, rig.server.visitorCount());
  }

  @Test
  void playerWhoNeverLoadsLosesTheSeat() {
    FakeClient client = rig.connect().hello("Ann");
    client.loads = false;
    rig.seconds(1);
    assertEquals(1, rig.room.seats().takenCount());
    rig.seconds(20);
    assertEquals(RefusalReason.TOO_SLOW, client.refused.reason());
    assertEquals(0, rig.room.seats().takenCount());
  }

  @Test
  void linkThatClosesWhileLoadingFreesItsSeat() {
    FakeClient client = rig.connect().hello("Ann");
    client.loads = false;
    rig.steps(2);
    client.link.close("gone");
    rig.steps(2);
    assertEquals(0, rig.room.seats().takenCount());
    assertEquals(0, rig.server.visitorCount());
  }

  @Test
  void wrongMessageInWrongStateIsRefused() {
    FakeClient early = rig.connect();
    early.link.send(new ClientMessage.Ready(0, 0));
    FakeClient twice = rig.connect().hello("Ann");
    twice.loads = false;
    twice.hello("Ann");
    FakeClient outside = rig.connect().hello("Ben");
    outside.loads = false;
    rig.steps(2);
    outside.link.send(new ClientMessage.LevelRequest(outside.welcome.epoch(), 1_000_000));
    rig.steps(3);
    assertEquals(RefusalReason.BAD_REQUEST, early.refused.reason());
    assertEquals(RefusalReason.BAD_REQUEST, twice.refused.reason());
    assertEquals(RefusalReason.BAD_REQUEST, outside.refused.reason());
    assertEquals(0, rig.room.seats().takenCount());
  }

  @Test
  void aRedirectAlsoSendsThoseWhoWaitOrLoadAndTheirPlacesAreFree() {
    ServerMessage.Redirect to = new ServerMessage.Redirect("b.example.org:1", "", "", "");
    FakeClient loading = rig.connect().hello("Ann");
    loading.loads = false;
    FakeClient silent = rig.connect();
    rig.steps(2);
    assertEquals(1, rig.room.seats().takenCount());
    rig.server.redirectVisitors(to);
    rig.steps(2);
    assertEquals(to, loading.messages.get(loading.messages.size() - 1));
    assertEquals(List.of(), silent.messages, "it may be a list of servers that asks for rooms");
    assertEquals(0, rig.room.seats().takenCount());
    FakeClient later = rig.join("Ben");
    assertTrue(later.ready, "a redirect is done once");
    rig.seconds(1.5);
    assertTrue(loading.closed);
  }

  @Test
  void aTicketOfAFleetMeansNothingToAServerThatIsInNone() {
    FakeClient client = rig.connect();
    client.link.send(
        new ClientMessage.Hello(
            Protocol.VERSION, Protocol.physicsDigest(), "Ann", 0, "", "", "", "ticket.x"));
    rig.steps(2);
    assertNull(client.refused);
    assertNotNull(client.welcome, "it is a join token that nobody demands");
    assertTrue(rig.join("Ben").ready);
  }

  @Test
  void aServerThatStopsWithARedirectSendsThoseWhoLoad() {
    ServerMessage.Redirect to = new ServerMessage.Redirect("b.example.org:1", "", "", "");
    FakeClient loading = rig.connect().hello("Ann");
    loading.loads = false;
    rig.steps(2);
    rig.server.redirectVisitors(to);
    rig.server.close();
    loading.step(0);
    assertEquals(to, loading.messages.get(loading.messages.size() - 1));
    assertNull(loading.goodbye);
    assertNull(loading.refused);
  }

  @Test
  void levelCannotBePulledForEver() {
    FakeClient client = rig.connect().hello("Ann");
    client.loads = false;
    rig.steps(2);
    for (int i = 0; i < 20; i++) {
      client.link.send(new ClientMessage.LevelRequest(client.welcome.epoch(), 1));
    }
    rig.steps(3);
    assertEquals(RefusalReason.BAD_REQUEST, client.refused.reason());
    assertTrue(client.messages.size() < 12, "messages=" + client.messages.size());
  }

  @Test
  void unknownSecretJoinsAsANewPlayer() {
    FakeClient client = rig.join("Ann", 123_456_789L);
    assertNotEquals(123_456_789L, client.welcome.sessionSecret());
  }

  @Test
  void visitorsAreToldWhenTheServerStops() {
    FakeClient silent = rig.connect();
    FakeClient loading = rig.connect().hello("Ann");
    loading.loads = false;
    rig.steps(2);
    rig.server.close();
    silent.step(0);
    loading.step(0);
    assertEquals(RefusalReason.SHUTTING_DOWN, silent.refused.reason());
    assertNotNull(loading.goodbye);
    assertFalse(loading.ready);
    assertTrue(silent.closed && loading.closed);
  }

  @Test
  void crowdOfSilentLinksDoesNotKeepAPlayerOut() {
    for (int i = 0; i < 200; i++) {
      rig.connect();
    }
    rig.seconds(8);
    assertEquals(0, rig.server.visitorCount());
    rig.join("Ann");
  }
}
