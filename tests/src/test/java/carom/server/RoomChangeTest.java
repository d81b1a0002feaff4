package carom.server;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.net.kryo.KryoClientTransport;
import carom.net.kryo.server.KryoServerTransport;
import carom.net.protocol.ClientMessage;
import carom.net.protocol.GoodbyeReason;
import carom.net.transport.Link;
import carom.server.command.Caller;
import carom.server.command.CommandRegistry;
import carom.server.command.Role;
import carom.server.command.RoomChangeCommands;
import carom.server.config.DataFolder;
import carom.server.config.RoomConfig;
import carom.server.config.ServerConfig;
import carom.server.match.MatchLibrary;
import carom.server.room.Room;
import carom.suite.Needs;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.locks.LockSupport;
import java.util.function.BooleanSupplier;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/**
 * Goal: rooms come, change and go while players play, and nothing is lost silently. Method: the
 * command against servers in virtual time, and against one with real sockets and threads.
 */
@Needs("sockets")
@Timeout(60)
final class RoomChangeTest {
  private static final Caller OPERATOR = new Caller(Role.OPERATOR, "page", "192.0.2.7");

  @TempDir private Path folder;

  private CommandRegistry registry(Server server) {
    CommandRegistry registry = new CommandRegistry();
    RoomChangeCommands.add(registry, server, server.rooms(), new DataFolder(folder), null);
    return registry;
  }

  private static CommandRegistry.Answer run(Rig rig, CommandRegistry registry, String line) {
    CompletableFuture<CommandRegistry.Answer> answer =
        CompletableFuture.supplyAsync(() -> registry.run(line, Caller.CONSOLE));
    while (!answer.isDone()) {
      rig.step();
      LockSupport.parkNanos(100_000);
    }
    rig.seconds(0.2);
    return answer.join();
  }

  private static Room room(Rig rig, String name) {
    return rig.server.rooms().stream().filter(r -> r.name().equals(name)).findFirst().orElse(null);
  }

  private static Room roomOf(Rig rig, FakeClient client) {
    for (Room room : rig.server.rooms()) {
      if (room.seats().switchesOf(client.welcome.sessionSecret()) >= 0) {
        return room;
      }
    }
    return null;
  }

  private static Rig rig(int rooms, int places) {
    ServerConfig config =
        ServerConfig.defaults()
            .with(ServerConfig.ROOMS, rooms)
            .with(ServerConfig.MAX_PLAYERS, places);
    return new Rig(config, () -> new TestGame(3));
  }

  @Test
  void anAddedRoomIsPlayedInAndARemovedOneSendsItsPlayersToTheOthers() {
    try (Rig rig = rig(1, 1)) {
      CommandRegistry registry = registry(rig.server);
      FakeClient ann = rig.join("Ann");
      String level = rig.room.settings().levels().get(0);
      assertEquals(
          "added room=cup levels=" + level + " players=2 info={skill=high}",
          run(rig, registry, "room add cup=" + level + ":2 skill=high").text());
      FakeClient bob = rig.join("Bob");
      FakeClient cid = rig.join("Cid");
      assertEquals("cup", roomOf(rig, bob).name());
      assertEquals(
          "removed room=1, moved players=0, dismissed players=1",
          run(rig, registry, "room remove @1 night is over").text());
      assertEquals(GoodbyeReason.ROOM_CLOSED, ann.goodbye.reason());
      assertEquals("night is over", ann.goodbye.text());
      assertEquals("cup", roomOf(rig, cid).name(), "others play on");

      run(rig, registry, "room add away=" + level + ":2");
      assertEquals(
          "removed room=cup, moved players=2, dismissed players=0",
          run(rig, registry, "room remove @cup").text());
      rig.seconds(1);
      assertEquals(room(rig, "away"), roomOf(rig, bob));
      assertNull(bob.goodbye);
      assertTrue(bob.ready && bob.decoder.hasAck(), "plays there");
      assertTrue(rig.server.rooms().get(0).session(0) != null, "in the room's own list");
    }
  }

  @Test
  void whatCanNotBeChangesNothing() {
    try (Rig rig = rig(2, 2000 / 2)) {
      CommandRegistry registry = registry(rig.server);
      String level = rig.room.settings().levels().get(0);
      Map<String, String> wrong =
          Map.of(
              "room add 1=" + level,
              "belongs to two rooms",
              "room add x=nowhere",
              "nowhere",
              "room add x",
              "has no \"=\"",
              "room add x=" + level + ":2000",
              "outside 1..1024",
              "room add x=" + level + " skill",
              "write KEY=VALUE",
              "room set @1 players 0",
              "outside 1..1024",
              "room set @1 players many",
              "no number",
              "room set @1 levels nowhere",
              "nowhere",
              "room remove",
              "no room is named",
              "room remove @3",
              "no room=3");
      for (Map.Entry<String, String> each : wrong.entrySet()) {
        CommandRegistry.Answer answer = run(rig, registry, each.getKey());
        assertFalse(answer.ok(), each.getKey());
        assertTrue(answer.text().contains(each.getValue()), each.getKey() + ": " + answer.text());
      }
      for (int i = 3; i <= 32; i++) {
        assertTrue(run(rig, registry, "room add r" + i + "=" + level + ":1000").ok());
      }
      CommandRegistry.Answer answer = run(rig, registry, "room set @r3 players 1024");
      assertTrue(answer.ok(), answer.text());
      answer = run(rig, registry, "room add r33=" + level + ":745");
      assertTrue(answer.text().contains("limit=32768"), answer.text());
      assertEquals(32, rig.server.rooms().size());
      assertEquals(1000, room(rig, "1").seats().count());
    }
    try (Rig rig = rig(1, 1)) {
      CommandRegistry.Answer last = run(rig, registry(rig.server), "room remove @1");
      assertTrue(last.text().contains("the last one that runs"), last.text());
      assertEquals(1, rig.server.rooms().size());
    }
  }

  @Test
  void thereAreSoManyRoomsAtMost() {
    try (Rig rig = rig(ServerConfig.MAX_ROOMS, 1)) {
      String level = rig.room.settings().levels().get(0);
      CommandRegistry registry = registry(rig.server);
      String full = run(rig, registry, "room add x=" + level).text();
      assertEquals("nothing has changed: rooms=512 is the limit; remove one before", full);
      assertTrue(run(rig, registry, "room remove @7").ok());
      assertTrue(run(rig, registry, "room add x=" + level).ok());
      assertEquals(513, room(rig, "x").number(), "no number is used twice");
    }
  }

  @Test
  void operatorsNameLevelsOfTheDataFolderAndNoOtherFiles() throws Exception {
    Path file = Files.writeString(folder.resolve("secret"), "token");
    try (Rig rig = rig(1, 1)) {
      CommandRegistry.Answer answer = registry(rig.server).run("room add x=" + file, OPERATOR);
      assertFalse(answer.ok());
      assertTrue(answer.text().contains("only the server's console names files"), answer.text());
    }
  }

  @Test
  void fewerSeatsSendNobodyAwayAndMoreSeatsTakeNewcomers() {
    try (Rig rig = rig(1, 2)) {
      CommandRegistry registry = registry(rig.server);
      FakeClient ann = rig.join("Ann");
      rig.join("Bob");
      run(rig, registry, "room set @1 players 1");
      FakeClient cid = rig.connect().hello("Cid");
      rig.seconds(0.5);
      assertNotNull(cid.refused);
      assertNull(ann.goodbye);
      run(rig, registry, "room set @1 players 20");
      for (int i = 0; i < 18; i++) {
        rig.join("p" + i);
      }
      assertEquals(20, rig.room.seats().takenCount());
    }
  }

  /** The kind: whatever is added, removed and changed, each client plays or has been told. */
  @Test
  void eachPlayerPlaysOrHasBeenToldWhateverIsChanged() {
    long seed = System.nanoTime();
    Random random = new Random(seed);
    try (Rig rig = rig(2, 3)) {
      CommandRegistry registry = registry(rig.server);
      String level = rig.room.settings().levels().get(0);
      List<FakeClient> clients = new ArrayList<>();
      for (int step = 0; step < 40; step++) {
        List<Room> rooms = rig.server.rooms();
        Room any = rooms.get(random.nextInt(rooms.size()));
        switch (random.nextInt(6)) {
          case 0 ->
              run(rig, registry, "room add r" + step + "=" + level + ":" + (1 + random.nextInt(4)));
          case 1 -> run(rig, registry, "room remove @" + any.name());
          case 2 ->
              run(rig, registry, "room set @" + any.name() + " players " + (1 + random.nextInt(5)));
          case 3 -> {
            if (!clients.isEmpty()) {
              FakeClient leaver = clients.remove(random.nextInt(clients.size()));
              leaver.link.send(new ClientMessage.Leave());
            }
          }
          default -> {
            FakeClient client = rig.connect().hello("p" + step);
            clients.add(client);
          }
        }
        rig.steps(random.nextInt(20));
      }
      rig.seconds(4);
      int playing = 0;
      for (FakeClient client : clients) {
        boolean told = client.refused != null || client.goodbye != null;
        boolean plays = !told && client.welcome != null && roomOf(rig, client) != null;
        assertTrue(told || plays, "neither plays nor was told, seed=" + seed);
        playing += plays ? 1 : 0;
      }
      int seats = rig.server.rooms().stream().mapToInt(r -> r.seats().takenCount()).sum();
      assertEquals(playing, seats, "seats without players, seed=" + seed);
    }
  }

  @Test
  void realClientsGoOnInAnotherRoomWhenTheirsIsRemoved() throws Exception {
    ServerConfig config = ServerConfig.defaults().with(ServerConfig.STATUS_INTERVAL, 0);
    List<RoomConfig> rooms = List.of(new RoomConfig("cup", "arena", List.of(), 4, 1, Map.of()));
    KryoServerTransport transport = new KryoServerTransport(0, 0);
    try (Server server =
            new Server(config, rooms, MatchLibrary.INSTALLED, transport, System::nanoTime);
        KryoClientTransport clients = new KryoClientTransport()) {
      server.start();
      CommandRegistry registry = registry(server);
      FakeClient ann =
          new FakeClient(clients.connect("127.0.0.1", server.tcpPort(), server.udpPort()));
      await(server, ann, () -> ann.link.state() == Link.State.OPEN);
      ann.hello("Ann");
      await(server, ann, () -> ann.decoder != null && ann.decoder.hasAck());
      int epoch = ann.welcome.epoch();
      String answer = registry.run("room add jump=platformer:1", OPERATOR).text();
      assertEquals("added room=jump levels=platformer players=1", answer);
      answer = registry.run("room remove @cup", OPERATOR).text();
      assertEquals("removed room=cup, moved players=1, dismissed players=0", answer);
      await(server, ann, () -> ann.welcome.epoch() != epoch && ann.decoder.hasAck());
      assertEquals("platformer", ann.welcome.game());
      assertEquals("Ann", server.rooms().get(0).operator().players().get(0).name());
    }
  }

  private static void await(Server server, FakeClient client, BooleanSupplier condition)
      throws InterruptedException {
    long endNs = System.nanoTime() + 20_000_000_000L;
    while (!condition.getAsBoolean()) {
      assertTrue(System.nanoTime() - endNs < 0, "waited for 20 s: " + client.messages);
      client.step(server.rooms().get(0).tick());
      Thread.sleep(5);
    }
  }
}
