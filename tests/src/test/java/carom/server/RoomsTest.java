package carom.server;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.net.kryo.KryoMessageCodec;
import carom.net.protocol.ClientMessage;
import carom.net.protocol.GoodbyeReason;
import carom.net.protocol.RefusalReason;
import carom.net.protocol.SessionState;
import carom.net.transport.InProcessNetwork;
import carom.server.config.ServerConfig;
import carom.server.metrics.Counter;
import carom.server.room.Room;
import carom.server.session.Session;
import carom.sim.entity.HostEntity;
import carom.sim.entity.Input;
import carom.suite.Needs;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Goal: a lobby assigns players to several rooms, and nothing leaks from room to room. */
@Needs("sockets")
class RoomsTest {
  private static final ServerConfig CONFIG = ServerConfig.defaults().with(ServerConfig.SEED, 5);

  private static Rig rig(int rooms, int places) {
    return new Rig(
        CONFIG.with(ServerConfig.MAX_PLAYERS, places).with(ServerConfig.ROOMS, rooms),
        () -> new TestGame(3));
  }

  /** The number of the room that holds a client's session; 0 when none does. */
  private static int roomOf(Rig rig, FakeClient client) {
    for (Room room : rig.server.rooms()) {
      Session session = room.session(client.welcome.playerId());
      if (session != null && session.seat().secret() == client.welcome.sessionSecret()) {
        return room.number();
      }
    }
    return 0;
  }

  @Test
  void newcomersGetCompanyAndTheLastOneIsRefused() {
    try (Rig rig = rig(3, 2)) {
      List<FakeClient> players = new ArrayList<>();
      for (int i = 0; i < 6; i++) {
        players.add(rig.join("p" + i));
        assertEquals(1 + i / 2, roomOf(rig, players.get(i)), "player " + i);
        assertEquals(i % 2, players.get(i).welcome.playerId());
      }
      FakeClient seventh = rig.connect().hello("late");
      rig.steps(3);
      assertEquals(RefusalReason.SERVER_FULL, seventh.refused.reason());
      assertTrue(seventh.refused.text().contains("6"), seventh.refused.text());
      players.get(2).link.send(new ClientMessage.Leave());
      rig.steps(3);
      assertEquals(2, roomOf(rig, rig.join("next")));
    }
  }

  @Test
  void fullestRoomWithAPlaceIsTakenEvenWhenItIsNotTheFirst() {
    try (Rig rig = rig(2, 3)) {
      FakeClient a = rig.join("a");
      FakeClient b = rig.join("b");
      rig.join("c");
      rig.join("d");
      rig.join("e");
      a.link.send(new ClientMessage.Leave());
      b.link.send(new ClientMessage.Leave());
      rig.steps(3);
      assertEquals(2, roomOf(rig, rig.join("f")));
      assertEquals(1, roomOf(rig, rig.join("g")));
    }
  }

  @Test
  void eachRoomHasItsOwnSeedGameAndNames() {
    try (Rig rig = rig(2, 1)) {
      FakeClient a = rig.join("Ann");
      FakeClient b = rig.join("Ann");
      rig.seconds(1);
      assertEquals(5, a.welcome.seed());
      assertEquals(6, b.welcome.seed());
      assertEquals("Ann", b.roster.entries().get(0).name());
      assertEquals(1, b.roster.entries().size());
      assertEquals(1, rig.games.get(0).joins);
      assertEquals(1, rig.games.get(1).joins);
    }
  }

  @Test
  void returningPlayerGetsIntoTheRoomThatHoldsTheBody() {
    try (Rig rig = rig(2, 2)) {
      FakeClient first = rig.join("a");
      rig.join("b");
      FakeClient lost = rig.join("Cleo");
      HostEntity body = rig.server.rooms().get(1).simulation().player(0).entity();
      first.link.send(new ClientMessage.Leave()); // room 1 would be the fullest with a place
      lost.link.close("cable pulled");
      rig.steps(5);
      assertEquals(SessionState.GRACE, rig.server.rooms().get(1).session(0).state());
      FakeClient back = rig.join("Cleo", lost.welcome.sessionSecret());
      assertEquals(2, roomOf(rig, back));
      assertSame(body, rig.server.rooms().get(1).simulation().player(0).entity());
      assertEquals(1, rig.server.rooms().get(1).counters().get(Counter.RESUMES));
      assertEquals(0, rig.room.counters().get(Counter.RESUMES));
    }
  }

  @Test
  void inputAndScoreShowInTheirOwnRoomOnly() {
    try (Rig rig = rig(2, 1)) {
      FakeClient a = rig.join("a");
      FakeClient b = rig.join("b");
      float ax = a.own.x();
      float bx = b.own.x();
      int told = b.notices().size();
      a.input.move(1, 0).hold(Input.ACTION, true);
      rig.seconds(1);
      rig.join("Cleo", a.welcome.sessionSecret()); // and a notice
      assertTrue(a.own.x() > ax + 3, "x=" + a.own.x());
      assertEquals(bx, b.own.x());
      assertTrue(a.roster.entries().get(0).score() > 20);
      assertEquals(0, b.roster.entries().get(0).score());
      assertEquals(told, b.notices().size(), b.notices()::toString);
    }
  }

  @Test
  void roomWhoseGameFailsIsLeftOutAndTheOthersGoOn() {
    try (Rig rig = rig(2, 2)) {
      FakeClient a = rig.join("a");
      rig.join("a2");
      FakeClient b = rig.join("b");
      rig.games.get(0).failEvery = 1;
      rig.seconds(2);
      assertEquals(GoodbyeReason.SERVER_ERROR, a.goodbye.reason());
      assertTrue(rig.room.hasFailed());
      assertFalse(rig.server.hasFailed());
      Room second = rig.server.rooms().get(1);
      assertNull(b.goodbye);
      assertEquals(0, b.undecodable);
      assertEquals(second.tick(), b.decoder.newestTick(), 1);
      assertEquals(0, second.counters().get(Counter.GAME_FAILURES));
      // The secret of a lost room is worth a place like any other's.
      FakeClient back = rig.join("a", a.welcome.sessionSecret());
      assertEquals(2, roomOf(rig, back));
      FakeClient tooMany = rig.connect().hello("c");
      rig.steps(3);
      assertEquals(RefusalReason.SERVER_FULL, tooMany.refused.reason());
      List<String> status = rig.server.status();
      assertTrue(status.get(0).startsWith("room 1: failed at tick "), status::toString);

      rig.games.get(1).failEvery = 1;
      rig.seconds(2);
      assertEquals(GoodbyeReason.SERVER_ERROR, b.goodbye.reason());
      assertTrue(rig.server.hasFailed());
    }
  }

  @Test
  void twentyClientsInFourRoomsSeeTheirOwnRoomExactly() {
    long seed = Long.getLong("carom.seed", 3);
    Random random = new Random(seed);
    try (Rig rig = rig(4, 5)) {
      for (int i = 0; i < 20; i++) {
        rig.join("p" + i);
      }
      for (int step = 0; step < 300; step++) {
        for (FakeClient client : rig.clients) {
          if (random.nextInt(10) == 0) {
            client.input.move(random.nextInt(3) - 1, random.nextInt(3) - 1);
          }
        }
        rig.step();
        if (step > 60) {
          for (int i = 0; i < 20; i++) {
            Room room = rig.server.rooms().get(i / 5);
            String about = "seed=" + seed + " step=" + step + " client=" + i;
            RoomTest.assertSees(room, rig.clients.get(i), 3 + 5, about);
          }
        }
      }
      assertEquals(20, rig.count(Counter.PLAYERS));
      for (Room room : rig.server.rooms()) {
        assertEquals(5, room.counters().get(Counter.PLAYERS));
      }
    }
  }

  @Test
  void statusHasOneLineForEachRoomAndOneAboutAll() {
    try (Rig rig = rig(2, 1)) {
      rig.join("a");
      rig.join("b");
      rig.seconds(2);
      List<String> status = rig.server.status();
      assertEquals(3, status.size(), status::toString);
      assertTrue(status.get(0).startsWith("room 1: 1 of 1 players, tick "), status::toString);
      assertTrue(status.get(1).startsWith("room 2: 1 of 1 players, tick "), status::toString);
      assertTrue(status.get(2).startsWith("all 2 rooms: 2 of 2 players, late "), status::toString);
    }
  }

  @Test
  @Timeout(30)
  void roomsShareThreadsFailAloneAndEndTogether() throws Exception {
    InProcessNetwork network = new InProcessNetwork(new KryoMessageCodec());
    List<TestGame> games = new ArrayList<>();
    ServerConfig config =
        CONFIG
            .with(ServerConfig.MAX_PLAYERS, 2)
            .with(ServerConfig.ROOMS, 3)
            .with(ServerConfig.ROOM_THREADS, 2);
    Server server =
        new Server(
            config,
            () -> {
              games.add(new TestGame(3));
              return games.get(games.size() - 1);
            },
            TestGame.level(),
            network.server(),
            System::nanoTime);
    server.start();
    List<FakeClient> clients = new ArrayList<>();
    for (int i = 0; i < 6; i++) {
      clients.add(new FakeClient(network.client().connect("", 0, 0)).hello("p" + i));
    }
    stepUntil(server, clients, () -> server.count(Counter.PLAYERS) == 6);
    List<String> shared = new ArrayList<>();
    for (int i = 1; i <= 2; i++) {
      shared.add("carom-rooms-" + i);
    }
    assertEquals(shared, threads("carom-rooms"));
    assertEquals(List.of("carom-lobby"), threads("carom-lobby"));

    games.get(0).failEvery = 1;
    stepUntil(server, clients, () -> clients.stream().anyMatch(c -> c.goodbye != null));
    stepUntil(server, clients, () -> server.rooms().get(0).hasFailed());
    assertEquals(shared, threads("carom-rooms"));
    assertFalse(server.hasFailed());
    assertEquals(4, server.count(Counter.PLAYERS));

    long beginNs = System.nanoTime();
    Thread closer = new Thread(server::close);
    closer.start();
    while (closer.isAlive()) {
      step(server, clients);
    }
    long tookMs = TimeUnit.NANOSECONDS.toMillis(System.nanoTime() - beginNs);
    step(server, clients);
    assertTrue(tookMs < 2_000, "tookMs=" + tookMs);
    stepUntil(server, clients, () -> threads("carom-").isEmpty());
    int stopped = 0;
    for (FakeClient client : clients) {
      assertNotNull(client.goodbye);
      stopped += client.goodbye.reason() == GoodbyeReason.SERVER_STOPPING ? 1 : 0;
    }
    assertEquals(4, stopped);
    server.awaitStop();
    assertFalse(server.hasFailed());
  }

  private static void stepUntil(Server server, List<FakeClient> clients, BooleanSupplier done)
      throws InterruptedException {
    while (!done.getAsBoolean()) {
      step(server, clients);
    }
  }

  private static void step(Server server, List<FakeClient> clients) throws InterruptedException {
    int tick = server.rooms().get(2).tick();
    clients.forEach(client -> client.step(tick));
    Thread.sleep(4);
  }

  /** The names of threads that begin so, sorted. */
  private static List<String> threads(String begin) {
    return Thread.getAllStackTraces().keySet().stream()
        .map(Thread::getName)
        .filter(name -> name.startsWith(begin))
        .sorted()
        .toList();
  }
}
