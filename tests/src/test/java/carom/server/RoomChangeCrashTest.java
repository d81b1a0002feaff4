package carom.server;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.net.kryo.KryoMessageCodec;
import carom.net.protocol.ClientMessage;
import carom.net.protocol.SessionState;
import carom.net.transport.InProcessNetwork;
import carom.replay.RecordingReader;
import carom.replay.Replay;
import carom.server.checkpoint.SlotDisk;
import carom.server.config.RoomConfig;
import carom.server.match.MatchLibrary;
import carom.server.room.Room;
import carom.server.session.Session;
import carom.sim.SimulationHost;
import carom.sim.entity.HostPlayer;
import carom.testkit.Folders;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/**
 * Goal: wherever a crash falls while players come, go and change rooms, each has exactly one seat:
 * in the room whose log has its arrival last, or else in the room that it left. Method: two rooms
 * in virtual time; the folder is copied after every single step of writing, and a server begins
 * from each copy. Who plays where then, the logs alone tell, by replaying them.
 */
@Timeout(300)
class RoomChangeCrashTest {
  private static final List<String> ROOMS = List.of("cup", "jump");
  private static final List<RoomConfig> CONFIGS =
      List.of(
          new RoomConfig("cup", "", List.of("arena"), 4, 7, Map.of()),
          new RoomConfig("jump", "", List.of("platformer"), 4, 8, Map.of()));
  private static final int TICKS = Integer.getInteger("carom.crashes.ticks", 240);

  @TempDir Path folder;

  /** A server of two rooms in virtual time, whose disk says when it has taken a step. */
  private static final class Running implements AutoCloseable {
    final InProcessNetwork network = new InProcessNetwork(new KryoMessageCodec());
    final Server server;
    final SlotDisk disk;
    final List<FakeClient> clients = new ArrayList<>();
    long nowNs = 1_000_000_000L;

    Running(Path folder, Runnable afterStep) throws IOException {
      disk =
          new SlotDisk(
              task -> {
                task.run();
                afterStep.run();
              });
      server =
          new Server(
              KeptServer.CONFIG, CONFIGS, MatchLibrary.INSTALLED, network.server(), () -> nowNs);
      for (Room room : server.rooms()) {
        room.checkpoint(disk, folder.resolve(room.name()), 1);
      }
      server.rooms().forEach(room -> room.reconcile(server.rooms()));
    }

    void step() {
      nowNs += KeptServer.TICK_NS;
      for (FakeClient client : clients) {
        client.step(client.welcome == null ? 0 : room(client.welcome.room()).tick());
      }
      server.tick(nowNs);
    }

    Room room(String name) {
      return server.rooms().get(ROOMS.indexOf(name));
    }

    FakeClient hello(String name, long secret) {
      FakeClient client = new FakeClient(network.client().connect("", 0, 0)).hello(name, secret);
      clients.add(client);
      return client;
    }

    FakeClient join(String name, long secret) {
      FakeClient client = hello(name, secret);
      for (int i = 0; i < 120 && (client.decoder == null || !client.decoder.hasAck()); i++) {
        step();
      }
      assertTrue(client.decoder != null && client.decoder.hasAck(), () -> "" + client.messages);
      return client;
    }

    @Override
    public void close() {
      server.close();
      disk.close();
    }
  }

  /** A copy of the folder, who had left for good by then, and who played in which room. */
  private record Crash(Path copy, Set<String> left, Map<String, String> live) {}

  private final List<Crash> crashes = new ArrayList<>();
  private final Set<String> left = new TreeSet<>();
  private Path kept;

  /** The server whose folder is copied, or null. */
  private Running copied;

  private void copy() {
    if (copied == null) {
      return;
    }
    Map<String, String> live = new LinkedHashMap<>();
    for (Room room : copied.server.rooms()) {
      names(room.simulation()).forEach(name -> live.put(name, room.name()));
    }
    try {
      Path copy = folder.resolve("crash" + crashes.size());
      crashes.add(new Crash(Folders.copy(kept, copy), new TreeSet<>(left), live));
    } catch (IOException e) {
      throw new AssertionError(e);
    }
  }

  @Test
  void whereverACrashFallsAPlayerWhoChangesRoomsHasOneSeat() throws Exception {
    long seed = Long.getLong("carom.seed", System.nanoTime());
    System.out.println("crashes while rooms are changed: seed=" + seed);
    Random random = new Random(seed);
    kept = folder.resolve("kept");
    Map<String, FakeClient> players = new LinkedHashMap<>();
    try (Running running = new Running(kept, this::copy)) {
      for (String name : List.of("Ann", "Bob", "Cid", "Dan")) {
        players.put(name, running.join(name, 0));
      }
      for (int i = 0; i < 20; i++) {
        running.step();
      }
      copied = running;
      boolean hasLeft = false;
      for (int tick = 0; tick < TICKS; tick++) {
        for (FakeClient player : players.values()) {
          player.input.move(random.nextInt(3) - 1, random.nextInt(3) - 1);
          if (!player.closed && random.nextInt(90) == 0) {
            String other = ROOMS.get(1 - ROOMS.indexOf(player.welcome.room()));
            player.link.send(new ClientMessage.ChangeRoom(other));
          }
        }
        if (tick == TICKS / 2) {
          running.hello("Eve", 0);
        }
        if (!hasLeft && tick > TICKS / 3) {
          hasLeft = true;
          players.get("Dan").link.send(new ClientMessage.Leave());
          left.add("Dan");
        }
        running.step();
      }
      copied = null;
    }
    Set<String> seen = new TreeSet<>();
    for (Crash crash : crashes) {
      check(crash, players, seen, "crash=" + crashes.indexOf(crash) + " seed=" + seed);
    }
    System.out.println("crashes=" + crashes.size() + " kinds=" + seen);
    assertTrue(seen.contains("one log") && seen.size() > 1, () -> seen + " seed=" + seed);
  }

  /** Starts a server from a copy, and compares its seats with the logs. */
  private void check(Crash crash, Map<String, FakeClient> players, Set<String> seen, String what)
      throws Exception {
    Map<String, Set<String>> logged = new LinkedHashMap<>();
    for (String room : ROOMS) {
      logged.put(room, loggedPlayers(crash.copy().resolve(room)));
    }
    try (Running running = new Running(crash.copy(), () -> {})) {
      running.step();
      running.step(); // the first one only tells the time
      Map<String, List<String>> seats = new LinkedHashMap<>();
      for (Room room : running.server.rooms()) {
        for (int id = 0; id < room.seats().count(); id++) {
          Session session = room.session(id);
          if (session != null) {
            assertEquals(SessionState.GRACE, session.state(), what);
            seats
                .computeIfAbsent(session.seat().wantedName(), n -> new ArrayList<>())
                .add(room.name());
          }
        }
        assertEquals(
            names(room.simulation()),
            seats.entrySet().stream()
                .filter(e -> e.getValue().contains(room.name()))
                .map(Map.Entry::getKey)
                .collect(Collectors.toCollection(TreeSet::new)),
            what + ": a player without a seat");
      }
      for (Map.Entry<String, FakeClient> one : players.entrySet()) {
        String name = one.getKey();
        long secret = one.getValue().welcome.sessionSecret();
        List<String> in = ROOMS.stream().filter(room -> logged.get(room).contains(name)).toList();
        List<String> has = seats.getOrDefault(name, List.of());
        List<String> reserved =
            running.server.rooms().stream()
                .filter(
                    r -> r.seats().reserved().stream().anyMatch(seat -> seat.secret() == secret))
                .map(Room::name)
                .toList();
        String told = what + ": " + name + " of " + in + " sits in " + has + ", " + reserved;
        seen.add(in.isEmpty() ? "no log" : in.size() == 1 ? "one log" : "both logs");
        if (crash.left().contains(name) && in.isEmpty()) {
          assertEquals(List.of(), has, told);
          continue;
        }
        assertEquals(1, has.size() + reserved.size(), told);
        if (in.size() == 1) {
          assertEquals(in, has, told);
        } else if (in.size() == 2) {
          assertEquals(List.of(crash.live().get(name)), has, told);
        } else {
          assertEquals(1, reserved.size(), told);
        }
        String where = has.isEmpty() ? reserved.get(0) : has.get(0);
        if (in.size() != 1 || crashes.indexOf(crash) % 8 == 0) {
          FakeClient back = running.join(name, secret);
          assertEquals(where, back.welcome.room(), told);
          assertEquals(secret, back.welcome.sessionSecret(), told);
        }
      }
    }
    Folders.delete(crash.copy());
  }

  private static Set<String> names(SimulationHost s) {
    Set<String> names = new TreeSet<>();
    for (int id = 0; id < s.playerCapacity(); id++) {
      HostPlayer player = s.participant(id);
      if (player != null) {
        names.add(player.name());
      }
    }
    return names;
  }

  /** Returns who plays at the end of the newest log that has seats. */
  private static Set<String> loggedPlayers(Path room) throws IOException {
    int newest;
    try (Stream<Path> files = Files.list(room)) {
      newest =
          files
              .map(file -> file.getFileName().toString())
              .filter(name -> name.endsWith(".seats"))
              .mapToInt(name -> Integer.parseInt(name.replace(".seats", "")))
              .max()
              .getAsInt();
    }
    try (RecordingReader reader = RecordingReader.open(room.resolve(newest + ".log"))) {
      Replay replay = new Replay(reader);
      while (replay.step() == Replay.Progress.TICK) {
        assertEquals(null, replay.divergence());
      }
      return names(replay.simulation());
    }
  }
}
