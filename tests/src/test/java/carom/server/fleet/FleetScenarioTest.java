package carom.server.fleet;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.client.ClientConfig;
import carom.client.GameClient;
import carom.client.link.ConnectionPhase;
import carom.client.view.ClientView;
import carom.server.Backend;
import carom.server.access.JoinTokens;
import carom.server.config.ServerConfig.Durability;
import carom.server.room.Room;
import ch.qos.logback.classic.Level;
import ch.qos.logback.classic.Logger;
import ch.qos.logback.classic.spi.ILoggingEvent;
import ch.qos.logback.core.read.ListAppender;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.slf4j.LoggerFactory;

/**
 * Goal: three servers are one service. Method: a fleet in virtual time, with a directory that can
 * be cut off, servers that die and freeze, and real clients that all join at one server.
 */
class FleetScenarioTest {
  /** Players of three servers with two rooms for two each: one room stays empty. */
  private static final int PLAYERS = 9;

  @TempDir private Path folder;

  private static void requireAllPlay(FleetRig rig) {
    for (GameClient client : rig.clients) {
      assertEquals(ConnectionPhase.PLAYING, client.view().phase(), () -> client.view().message());
    }
  }

  /** Returns each client's seat, by its name. */
  private static Map<String, String> seats(FleetRig rig) {
    Map<String, String> seats = new HashMap<>();
    for (int i = 0; i < rig.clients.size(); i++) {
      GameClient client = rig.clients.get(i);
      seats.put("bot" + i, client.view().room() + "#" + client.view().playerId());
    }
    return seats;
  }

  private FleetRig threeServers() throws Exception {
    return threeServers(Durability.ASYNC, 0);
  }

  private FleetRig threeServers(Durability durability, long lagNs) throws Exception {
    FleetRig rig = new FleetRig(folder.resolve(durability.name()), 2);
    rig.durability = durability;
    rig.lagNs = lagNs;
    for (String name : List.of("a", "b", "c")) {
      rig.node(name, 2);
    }
    rig.run(1);
    for (int i = 0; i < PLAYERS; i++) {
      rig.client("bot" + i, "a");
      rig.run(0.1);
    }
    rig.run(3);
    return rig;
  }

  @Test
  void playersWhoJoinAtOneServerPlayWhereThereIsAPlace() throws Exception {
    try (FleetRig rig = threeServers()) {
      requireAllPlay(rig);
      Set<String> rooms = new HashSet<>();
      rig.clients.forEach(client -> rooms.add(client.view().room()));
      assertEquals(5, rooms.size(), () -> PLAYERS + " players in rooms of 2 are in " + rooms);
      assertEquals(PLAYERS, Set.copyOf(seats(rig).values()).size(), "nobody shares a seat");
      for (String room : List.of("1", "2", "3", "4", "5", "6")) {
        assertEquals(1, rig.owners(room).size(), "room " + room);
      }
    }
  }

  @Test
  void aRoomGoesOnBitForBitWhenItsServerIsKilled() throws Exception {
    try (FleetRig rig = threeServers()) {
      Map<String, String> seats = seats(rig);
      FleetRig.Node dying = rig.nodes.get("b");
      Map<String, Long> hashes = new HashMap<>();
      Map<String, Integer> ticks = new HashMap<>();
      for (Room room : dying.server.rooms()) {
        hashes.put(room.name(), room.simulation().stateHash());
        ticks.put(room.name(), room.tick());
      }
      assertEquals(2, hashes.size());
      dying.kill();
      Set<String> seen = new HashSet<>();
      for (int i = 0; i < 40; i++) {
        rig.nodes.values().stream()
            .filter(node -> !node.dead)
            .forEach(node -> node.member.turn(rig.now()));
        for (String room : hashes.keySet()) {
          for (FleetRig.Node node : rig.owners(room)) {
            if (seen.add(room)) {
              assertEquals(ticks.get(room), node.server.room(room).tick());
              assertEquals(hashes.get(room), node.room(room).simulation().stateHash(), room);
            }
          }
        }
        rig.run(0.005);
      }
      assertEquals(hashes.keySet(), seen);
      rig.run(1);
      requireAllPlay(rig);
      assertEquals(seats, seats(rig), "everybody is back in the own body");
    }
  }

  @Test
  void aPartyMeetsWhicheverServersItsMembersComeToAndAlsoAfterADeath() throws Exception {
    try (FleetRig rig = new FleetRig(folder, 4)) {
      for (String name : List.of("a", "b", "c")) {
        rig.node(name, 2);
      }
      rig.run(1);
      rig.client("stranger", "b");
      rig.run(1);
      for (String server : List.of("a", "b", "c")) {
        rig.client("of" + server, server, "trio"); // at the same moment
      }
      rig.run(3);
      requireAllPlay(rig);
      String room = rig.clients.get(1).view().room();
      for (GameClient member : rig.clients.subList(1, 4)) {
        assertEquals(room, member.view().room());
      }
      assertNotEquals(room, rig.clients.get(0).view().room(), "it left places to friends");

      FleetRig.Node owner = rig.owners(room).get(0);
      owner.kill();
      rig.run(15); // longer than the directory keeps where the first one went
      requireAllPlay(rig);
      String alive = owner.name.equals("a") ? "b" : "a";
      GameClient fourth = rig.client("fourth", alive, "trio");
      rig.run(2);
      assertEquals(room, fourth.view().room());
      GameClient fifth = rig.client("fifth", alive, "trio");
      rig.run(2);
      String message = fifth.view().message();
      assertTrue(message.contains("Your party is in room " + room + "."), message);
    }
  }

  @Test
  void anAccountHasOneSeatInTheWholeFleet() throws Exception {
    try (FleetRig rig = new FleetRig(folder, 2)) {
      for (String name : List.of("a", "b")) {
        rig.node(name, 1).server.admit(Backend.rule(folder, 1));
      }
      rig.run(1);
      for (String room : List.of("1", "2")) { // at the same moment
        ClientConfig config =
            ClientConfig.of("twin" + room)
                .with(ClientConfig.ROOM, room)
                .with(ClientConfig.TOKEN, Backend.token("one"));
        rig.client(config, "a");
      }
      rig.run(4);
      GameClient first = rig.clients.get(0);
      GameClient second = rig.clients.get(1);
      boolean isFirst = first.view().phase() == ConnectionPhase.PLAYING;
      String refused = (isFirst ? second : first).view().message();
      assertTrue(refused.contains("plays here already"), refused);
      assertEquals(ConnectionPhase.PLAYING, (isFirst ? first : second).view().phase());
      (isFirst ? first : second).close();
      rig.run(3);
      ClientConfig again =
          ClientConfig.of("again")
              .with(ClientConfig.ROOM, isFirst ? "2" : "1")
              .with(ClientConfig.TOKEN, Backend.token("one"));
      GameClient third = rig.client(again, "b");
      rig.run(3);
      assertEquals(ConnectionPhase.PLAYING, third.view().phase(), () -> third.view().message());
    }
  }

  @Test
  void aTokenThatOthersMayHaveReadCountsOnceInTheWholeFleet() throws Exception {
    try (FleetRig rig = new FleetRig(folder, 2)) {
      for (String name : List.of("a", "b")) {
        rig.node(name, 1).server.admit(Backend.rule(folder));
      }
      rig.run(1);
      String token = Backend.token("one");
      assertTrue(rig.nodes.get("a").member.door().spend(JoinTokens.mark(token), 60, true).get());
      assertFalse(rig.nodes.get("b").member.door().spend(JoinTokens.mark(token), 60, true).get());
      GameClient thief = rig.client(ClientConfig.of("thief").with(ClientConfig.TOKEN, token), "b");
      GameClient other =
          rig.client(ClientConfig.of("other").with(ClientConfig.TOKEN, Backend.token("two")), "b");
      rig.run(3);
      assertTrue(thief.view().message().contains(JoinTokens.USED), thief.view().message());
      assertEquals(ConnectionPhase.PLAYING, other.view().phase());
    }
  }

  /** Returns the ticks that clients saw and that never happened, after a server was killed. */
  private int ticksLost(Durability durability) throws Exception {
    try (FleetRig rig = threeServers(durability, 25_000_000)) {
      requireAllPlay(rig);
      rig.nodes.get("b").kill();
      rig.run(3);
      requireAllPlay(rig);
      return rig.clients.stream().mapToInt(client -> client.view().stats().ticksLost()).sum();
    }
  }

  @Test
  void withSyncNothingIsLostThatWasTold() throws Exception {
    assertNotEquals(0, ticksLost(Durability.ASYNC), "25 ms are under way");
    assertEquals(0, ticksLost(Durability.SYNC));
  }

  @Test
  void withoutFollowersARoomBeginsAnewAndMovesAllTheSame() throws Exception {
    try (FleetRig rig = threeServers(Durability.NONE, 0)) {
      requireAllPlay(rig);
      Map<String, String> seats = seats(rig);
      FleetRig.Node dying = rig.nodes.get("b");
      for (Room room : dying.server.rooms()) {
        assertTrue(!room.isFollowed());
      }
      rig.nodes.get("c").member.drain();
      rig.run(1);
      requireAllPlay(rig);
      assertEquals(seats, seats(rig));
      String room = dying.server.rooms().get(0).name();
      int tick = dying.server.rooms().get(0).tick();
      dying.kill();
      rig.run(4);
      assertTrue(rig.owners(room).get(0).server.room(room).tick() < tick);
    }
  }

  @Test
  void aFollowerThatHearsNothingStopsNoRoomAndIsReplaced() throws Exception {
    for (Durability durability : List.of(Durability.ASYNC, Durability.SYNC)) {
      try (FleetRig rig = threeServers(durability, 1_000_000)) {
        FleetRig.Node owner = rig.nodes.get("b");
        Map<String, Integer> ticks = new HashMap<>();
        owner.server.rooms().forEach(room -> ticks.put(room.name(), room.tick()));
        rig.nodes.get("a").stuck = true;
        rig.nodes.get("c").stuck = true;
        rig.run(6);
        for (Room room : owner.server.rooms()) {
          int passed = room.tick() - ticks.get(room.name());
          // a quarter of a second, once, is all that it may wait
          assertTrue(passed >= 5.7 * 60, () -> durability + ": ticks in 6 s = " + passed);
        }
        rig.nodes.get("a").stuck = false;
        rig.run(5);
        for (Room room : owner.server.rooms()) {
          assertTrue(room.isFollowed(), () -> durability + ": a hears again");
        }
        owner.kill();
        rig.run(3);
        for (String room : ticks.keySet()) {
          assertEquals("a", rig.owners(room).get(0).name, durability.name());
          assertTrue(rig.owners(room).get(0).server.room(room).tick() > ticks.get(room) + 300);
        }
        if (durability == Durability.SYNC) {
          int lost = rig.clients.stream().mapToInt(c -> c.view().stats().ticksLost()).sum();
          assertEquals(0, lost);
        }
      }
    }
  }

  @Test
  void playersWaitForARoomThatIsTakenOverSlowly() throws Exception {
    try (FleetRig rig = threeServers()) {
      Map<String, String> seats = seats(rig);
      rig.takeoverS = 2;
      rig.nodes.get("a").kill();
      rig.run(8);
      requireAllPlay(rig);
      assertEquals(seats, seats(rig));
    }
  }

  @Test
  void aServerThatStopsLosesNothingAndNobodyComputesItsRoomsAgain() throws Exception {
    Logger log = (Logger) LoggerFactory.getLogger("carom.server.checkpoint.RoomResume");
    ListAppender<ILoggingEvent> lines = new ListAppender<>();
    try (FleetRig rig = threeServers()) {
      Map<String, String> seats = seats(rig);
      FleetRig.Node leaving = rig.nodes.get("a");
      lines.start();
      log.addAppender(lines);
      log.setLevel(Level.INFO);
      leaving.member.drain();
      rig.run(1);
      assertTrue(leaving.member.isDrained());
      requireAllPlay(rig);
      assertEquals(seats, seats(rig));
      assertTrue(leaving.server.rooms().isEmpty());
    } finally {
      log.setLevel(null);
      log.detachAppender(lines);
    }
    assertFalse(lines.list.isEmpty());
    for (ILoggingEvent line : lines.list) {
      assertTrue(
          line.getFormattedMessage().matches(".* tick=(\\d+) checkpoint=\\1 inputs=0 .*"),
          line.getFormattedMessage());
    }
  }

  @Test
  void aServerThatWasDrainedTakesRoomsAgain() throws Exception {
    try (FleetRig rig = threeServers()) {
      FleetRig.Node node = rig.nodes.get("a");
      node.member.run(List.of("drain"));
      rig.run(1);
      assertTrue(node.server.rooms().isEmpty());
      node.member.run(List.of("undrain", "a"));
      rig.run(1);
      rig.nodes.get("b").member.run(List.of("drain"));
      rig.nodes.get("c").member.run(List.of("drain"));
      rig.run(3);
      assertFalse(node.server.rooms().isEmpty());
      requireAllPlay(rig);
      assertThrows(
          IllegalArgumentException.class, () -> node.member.run(List.of("undrain", "a", "b")));
    }
  }

  /**
   * Wherever a room goes, the server there can speak to its players at once: they stand by there
   * before the room comes. Words between servers take as long as on the way to another town.
   */
  @Test
  void roomsThatMoveAnywhereLeaveNobodyInSilence() throws Exception {
    Random random = FleetRig.draws();
    try (FleetRig rig = threeServers(Durability.ASYNC, 10_000_000)) {
      Map<String, String> seats = seats(rig);
      long[] snapshots = new long[PLAYERS];
      int[] silent = new int[PLAYERS];
      for (int i = 0; i < 12; i++) {
        List<String> rooms = List.copyOf(rig.rooms());
        String room = rooms.get(random.nextInt(rooms.size()));
        List<FleetRig.Node> servers = new ArrayList<>(rig.nodes.values());
        FleetRig.Node owner = rig.owners(room).get(0);
        servers.remove(owner);
        String to = servers.get(random.nextInt(2)).name;
        owner.member.run(List.of("move", room, to));
        for (int slice = 0; slice < 800; slice++) {
          rig.run(0.005);
          for (int j = 0; j < PLAYERS; j++) {
            ClientView view = rig.clients.get(j).view();
            assertTrue(view.entityCount() > 0 && !view.players().isEmpty(), "the picture stays");
            long count = view.stats().snapshots();
            silent[j] = count == snapshots[j] ? silent[j] + 1 : 0;
            snapshots[j] = count;
            assertTrue(
                silent[j] < 30,
                "150 ms without a snapshot: bot" + j + ", room " + room + " to " + to);
          }
        }
        assertEquals(to, rig.owners(room).get(0).name);
        requireAllPlay(rig);
      }
      assertEquals(seats, seats(rig));
    }
  }

  @Test
  void aClientThatStandsByTooLateIsSentAfterItsRoom() throws Exception {
    try (FleetRig rig = threeServers()) {
      Map<String, String> seats = seats(rig);
      FleetRig.Node owner = rig.nodes.get("a");
      Room room = owner.server.rooms().get(0);
      long players = seats.values().stream().filter(s -> s.startsWith(room.name() + "#")).count();
      assertTrue(players > 0, seats::toString);
      long before = rig.clients.stream().mapToInt(c -> c.view().stats().redirects()).sum();
      String line =
          owner
              .member
              .run(List.of("rooms"))
              .lines()
              .filter(one -> one.startsWith(room.name() + " "))
              .findFirst()
              .orElseThrow();
      String to = line.strip().endsWith(" b") ? "c" : "b"; // not its follower
      rig.unreachable.addAll(List.of("b", "c"));
      owner.member.run(List.of("move", room.name(), to));
      int slices = 0;
      while (owner.server.room(room.name()) != null) {
        rig.run(0.005);
        if (++slices == 980) {
          rig.unreachable.clear(); // too late for the next try to stand by
        }
        assertTrue(slices < 1_400, "the room stays");
      }
      assertTrue(slices > 980, "it waited for them");
      rig.run(0.3);
      assertEquals(to, rig.owners(room.name()).get(0).name);
      requireAllPlay(rig);
      assertEquals(seats, seats(rig));
      long after = rig.clients.stream().mapToInt(c -> c.view().stats().redirects()).sum();
      assertEquals(before + players, after, "the owner told them where it is");
    }
  }

  @Test
  void aRoomWithoutPlayersKeepsItsWorldWhereverItGoes() throws Exception {
    try (FleetRig rig = new FleetRig(folder, 4)) {
      FleetRig.Node node = rig.node("a", 1);
      rig.node("b", 0);
      GameClient client = rig.client("bot", "a");
      rig.run(2);
      client.close();
      rig.clients.clear();
      rig.run(1);
      Room room = node.server.rooms().get(0);
      int tick = room.tick();
      assertTrue(room.isPaused() && tick > 60, () -> "tick=" + tick);
      node.member.drain();
      rig.run(1);
      FleetRig.Node other = rig.owners(room.name()).get(0);
      assertEquals("b", other.name);
      assertEquals(tick + 1, other.server.room(room.name()).tick(), "it looks around once");
      rig.node("c", 0);
      rig.run(1);
      other.kill();
      rig.run(1);
      FleetRig.Node last = rig.owners(room.name()).get(0);
      assertEquals("c", last.name);
      assertEquals(tick + 2, last.server.room(room.name()).tick());
    }
  }

  @Test
  void aRoomGoesOnIfTheWordIsLostByWhichItIsHandedOver() throws Exception {
    try (FleetRig rig = threeServers()) {
      Map<String, String> seats = seats(rig);
      FleetRig.Node leaving = rig.nodes.get("b");
      List<String> rooms = leaving.server.rooms().stream().map(Room::name).toList();
      leaving.mumbles = true;
      rooms.forEach(room -> leaving.member.run(List.of("move", room)));
      rig.run(3);
      for (String room : rooms) {
        assertEquals(1, rig.owners(room).size(), room);
        assertNotEquals("b", rig.owners(room).get(0).name);
      }
      requireAllPlay(rig);
      assertEquals(seats, seats(rig), "its follower goes on with it, and nobody begins it anew");
    }
  }

  @Test
  void aRoomMovesWithItsStateThoughNobodyPlays() throws Exception {
    try (FleetRig rig = new FleetRig(folder, 4)) {
      FleetRig.Node a = rig.node("a", 1);
      FleetRig.Node b = rig.node("b", 0);
      rig.run(3);
      int tick = a.server.rooms().get(0).tick();
      assertEquals("a: ", b.member.run(List.of("move", "1", "b")).substring(0, 3), "a is told");
      rig.run(2);
      assertTrue(b.server.room("1").tick() > tick, "it goes on, and doesn't begin anew");
    }
  }

  @Test
  void aClaimWhoseAnswerWasLostIsGivenUp() throws Exception {
    try (FleetRig rig = new FleetRig(folder, 4)) {
      FleetRig.Node node = rig.node("a", 1);
      rig.run(1);
      String claim =
          RoomRecord.claimed(node.member.number(), node.server.rooms().get(0).settings()).toJson();
      node.door.create(RoomRecord.key("9"), claim.replace("\"1\"", "\"9\""), node.member.number());
      rig.run(2);
      assertNotNull(node.door.get(RoomRecord.key("9")), "perhaps it is about to be built");
      rig.run(5);
      assertEquals(null, node.door.get(RoomRecord.key("9")));
      assertNotNull(node.door.get(RoomRecord.key("1")));
    }
  }

  @Test
  void aServerThatOthersFalselyTakeForDeadCostsNobodyAnything() throws Exception {
    try (FleetRig rig = threeServers()) {
      Map<String, String> seats = seats(rig);
      FleetRig.Node innocent = rig.nodes.get("c");
      Set<String> rooms = new HashSet<>();
      innocent.server.rooms().forEach(room -> rooms.add(room.name()));
      innocent.slander();
      for (int i = 0; i < 400; i++) {
        rig.run(0.005);
        for (String room : rooms) {
          assertTrue(rig.owners(room).size() <= 1, room);
        }
      }
      for (String room : rooms) {
        assertEquals(1, rig.owners(room).size(), room);
      }
      requireAllPlay(rig);
      assertEquals(seats, seats(rig));
      assertEquals(0, rig.clients.stream().mapToInt(c -> c.view().stats().ticksLost()).sum());
    }
  }

  @Test
  void roomsGoOnWhereTheyAreAfterADirectoryThatWasAwayForAll() throws Exception {
    Random random = FleetRig.draws();
    try (FleetRig rig = threeServers()) {
      Map<String, String> seats = seats(rig);
      Map<String, Long> ticks = new HashMap<>();
      for (String room : rig.rooms()) {
        ticks.put(room, (long) rig.owners(room).get(0).room(room).tick());
      }
      List<FleetRig.Node> order = new ArrayList<>(rig.nodes.values());
      Collections.shuffle(order, random);
      order.forEach(node -> node.door.away(true));
      rig.run(2.5 + 3 * random.nextDouble());
      for (FleetRig.Node node : order) { // each hears at another time that it is back
        node.door.away(false);
        rig.run(1.5 * random.nextDouble());
      }
      rig.run(12);
      for (Map.Entry<String, Long> room : ticks.entrySet()) {
        assertEquals(1, rig.owners(room.getKey()).size(), room.getKey());
        long tick = rig.owners(room.getKey()).get(0).room(room.getKey()).tick();
        assertTrue(tick >= room.getValue(), room + " began anew: tick=" + tick);
      }
      requireAllPlay(rig);
      assertEquals(seats, seats(rig));
    }
  }

  @Test
  void serversThatAreStartedAgainAddNoRooms() throws Exception {
    Random random = FleetRig.draws();
    try (FleetRig rig = new FleetRig(folder, 4)) {
      int servers = 1 + random.nextInt(3);
      for (String name : List.of("a", "b", "c").subList(0, servers)) {
        rig.node(name, 2);
      }
      rig.run(2);
      List<String> done = new ArrayList<>();
      for (int i = 0; i < 8; i++) {
        List<String> names = new ArrayList<>(rig.nodes.keySet());
        String name = names.get(random.nextInt(names.size()));
        FleetRig.Node old = rig.nodes.get(name);
        switch (random.nextInt(3)) {
          case 0 -> { // an update
            done.add(name + " stops");
            old.leave();
            rig.run(random.nextDouble());
            rig.node(name, 2);
          }
          case 1 -> { // an accident, perhaps before its lease is over
            done.add(name + " is killed");
            old.kill();
            rig.run(3 * random.nextDouble());
            rig.node(name, 2);
          }
          default -> { // an update in which the new one comes before the old one goes
            done.add(name + " is replaced");
            rig.node("new" + i, 2);
            rig.run(random.nextDouble());
            old.leave();
            rig.nodes.remove(name);
          }
        }
        rig.run(12);
        Set<String> rooms = rig.rooms();
        for (String room : rooms) {
          assertEquals(1, rig.owners(room).size(), done + ": " + room);
        }
        int count = rooms.size();
        int most = 2 * servers + (done.toString().contains("replaced") ? 2 : 0);
        assertTrue(count >= 2 * servers && count <= most, done + ": " + rooms);
      }
    }
  }

  @Test
  void serversOfOtherGamesBeginTheirOwnRooms() throws Exception {
    try (FleetRig rig = new FleetRig(folder, 4)) {
      rig.node("a", 2);
      rig.run(1);
      rig.level = "platformer";
      rig.node("b", 3);
      rig.run(1);
      assertEquals(5, rig.rooms().size());
      rig.nodes.get("b").leave();
      rig.node("b", 3);
      rig.run(3);
      assertEquals(5, rig.rooms().size());
    }
  }

  @Test
  void serversLeaveUntilOneIsLeft() throws Exception {
    Random random = FleetRig.draws();
    for (int draw = 0; draw < 3; draw++) {
      try (FleetRig rig = new FleetRig(folder.resolve("draw" + draw), 4)) {
        List<FleetRig.Node> servers = new ArrayList<>();
        for (String name : List.of("a", "b", "c", "d").subList(0, 2 + random.nextInt(3))) {
          servers.add(rig.node(name, 1 + random.nextInt(3)));
        }
        rig.run(1);
        int players = random.nextInt(6);
        for (int i = 0; i < players; i++) {
          rig.client("bot" + i, servers.get(random.nextInt(servers.size())).name);
          rig.run(0.2);
        }
        rig.run(2);
        while (servers.size() > 1) {
          FleetRig.Node leaving = servers.remove(random.nextInt(servers.size()));
          leaving.member.drain();
          double seconds = 0;
          while (!leaving.member.isDrained()) {
            rig.run(0.05);
            seconds += 0.05;
            assertTrue(seconds < 4, leaving.name + " doesn't leave " + servers.size() + " others");
          }
          leaving.leave();
          rig.run(2.5 * random.nextDouble());
        }
        rig.run(1);
        requireAllPlay(rig);
        assertEquals(rig.rooms().size(), servers.get(0).server.rooms().size());
      }
    }
  }

  @Test
  void aServerHasTheTimeThatItsRoomsNeedToGo() throws Exception {
    try (FleetRig rig = new FleetRig(folder, 1)) {
      FleetRig.Node leaving = rig.node("a", 8);
      rig.node("b", 0);
      rig.run(1);
      for (int i = 0; i < 8; i++) {
        rig.client("bot" + i, "a");
        rig.run(0.2);
      }
      rig.run(2);
      Map<String, String> seats = seats(rig);
      rig.takeoverS = 0.9;
      long beganNs = rig.now();
      leaving.member.drain();
      while (!leaving.member.isDrained()) {
        rig.run(0.05);
        assertTrue(leaving.member.stillNs() < 3e9, "it stands still");
        assertTrue(rig.now() - beganNs < 30e9, "it never leaves");
      }
      assertTrue(rig.now() - beganNs > 5e9, "longer than any room may take");
      rig.takeoverS = 0;
      rig.run(1);
      requireAllPlay(rig);
      assertEquals(seats, seats(rig));
    }
  }

  @Test
  void aServerThatIsAloneStopsAtOnce() throws Exception {
    try (FleetRig rig = new FleetRig(folder, 4)) {
      FleetRig.Node node = rig.node("a", 1);
      rig.run(1);
      node.member.drain();
      assertTrue(node.member.isDrained(), "nobody could take its rooms");
    }
  }

  @Test
  void aFrozenServerOwnsNothingWhenItThaws() throws Exception {
    try (FleetRig rig = threeServers()) {
      FleetRig.Node frozen = rig.nodes.get("c");
      List<Room> rooms = List.copyOf(frozen.server.rooms());
      assertNotEquals(0, rooms.size());
      frozen.frozen = true;
      rig.run(5);
      for (Room room : rooms) {
        assertTrue(!room.ownership().holds(), "its lease is over by its own clock");
        assertEquals(1, rig.owners(room.name()).size());
      }
      frozen.frozen = false;
      for (int i = 0; i < 400; i++) {
        rig.run(0.005);
        for (Room room : rooms) {
          assertEquals(1, rig.owners(room.name()).size());
        }
      }
      rig.run(8);
      requireAllPlay(rig);
    }
  }
}
