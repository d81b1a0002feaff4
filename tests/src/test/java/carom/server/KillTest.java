package carom.server;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.client.ClientConfig;
import carom.client.GameClient;
import carom.client.PredictionMode;
import carom.client.bots.Bot;
import carom.client.link.ConnectionPhase;
import carom.fixtures.Jvm;
import carom.net.kryo.KryoClientTransport;
import carom.net.transport.ClientTransport;
import carom.replay.RecordingReader;
import carom.suite.Needs;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Random;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Goal: a server process that is killed goes on, and players come back by themselves to their
 * bodies; so does one that is stopped for a while. Method: a real process, {@code kill -9} at
 * random moments, {@code kill -STOP}, clients over sockets. How often the server is killed is
 * {@code -Dcarom.kills=N}, 5 without.
 */
@Needs("processes")
class KillTest {
  private static final int KILLS = Integer.getInteger("carom.kills", 5);
  private static final int PLAYERS = 3;
  private static final int TICK_RATE = 60;

  /** How long a process is stopped, s: longer than either side waits for the other. */
  private static final int STOPPED_S = 16;

  private static final Pattern READY = Pattern.compile("ready tcp=(\\d+) udp=(\\d+)");
  private static final Pattern RESUMED =
      Pattern.compile(
          "resumed room=1 tick=(\\d+) checkpoint=(\\d+) inputs=(\\d+) players=(\\d+) hash=(\\w+)");

  @TempDir Path folder;
  private Process server;
  private final List<GameClient> clients = new ArrayList<>();
  private ClientTransport transport;
  private int tcpPort;
  private int udpPort;
  private int starts;

  @AfterEach
  void end() {
    clients.forEach(GameClient::close);
    if (transport != null) {
      transport.close();
    }
    if (server != null) {
      server.destroyForcibly();
    }
  }

  private Path log() {
    return folder.resolve("err" + starts);
  }

  /** Starts the server and returns the milliseconds until players could join. */
  private long start() throws Exception {
    starts++;
    List<String> command = Jvm.command(ServerMain.class);
    command.addAll(List.of("--data", folder.resolve("data").toString(), "--checkpoint", "1s"));
    command.addAll(List.of("--tcp-port", "" + tcpPort, "--udp-port", "" + udpPort));
    command.addAll(List.of("--no-web", "--bind", "127.0.0.1", "--grace", "600", "--log-keep", "0"));
    long beganNs = System.nanoTime();
    server = new ProcessBuilder(command).redirectError(log().toFile()).start();
    server.getOutputStream().close();
    BufferedReader out =
        new BufferedReader(new InputStreamReader(server.getInputStream(), StandardCharsets.UTF_8));
    Matcher ready = READY.matcher(String.valueOf(out.readLine()));
    assertTrue(ready.matches(), () -> read(log()));
    tcpPort = Integer.parseInt(ready.group(1)); // the next start keeps them
    udpPort = Integer.parseInt(ready.group(2));
    return TimeUnit.NANOSECONDS.toMillis(System.nanoTime() - beganNs);
  }

  private static String read(Path file) {
    try {
      return Files.readString(file);
    } catch (IOException e) {
      return e.toString();
    }
  }

  private void update() throws InterruptedException {
    clients.forEach(client -> client.update(System.nanoTime()));
    Thread.sleep(8);
  }

  private void updateUntil(String what, BooleanSupplier done) throws Exception {
    long endNs = System.nanoTime() + TimeUnit.SECONDS.toNanos(60);
    while (!done.getAsBoolean()) {
      assertTrue(System.nanoTime() < endNs, () -> what + " isn't so after 60 s\n" + read(log()));
      update();
    }
  }

  /** Returns the settings of a player. One predicts; the others needn't to come back. */
  private ClientConfig config(int player) {
    return ClientConfig.of("p" + player)
        .withServer("127.0.0.1", tcpPort, udpPort)
        .with(ClientConfig.PREDICTION, player == 0 ? PredictionMode.ISLAND : PredictionMode.NONE);
  }

  private boolean allPlay() {
    return clients.stream()
        .allMatch(
            client ->
                client.view().phase() == ConnectionPhase.PLAYING && client.view().own() != null);
  }

  @Test
  void afterAKillTheServerGoesOnFromAProvenTickAndPlayersAreBackInTheirBodies() throws Exception {
    long seed = Long.getLong("carom.seed", System.nanoTime());
    Random random = new Random(seed);
    start();
    transport = new KryoClientTransport();
    for (int i = 0; i < PLAYERS; i++) {
      clients.add(new GameClient(config(i), transport, new Bot(i, true)));
    }
    updateUntil("all play", this::allPlay);
    // Seats that change are on the disk a quarter of a second later; a second may be lost.
    long seatedNs = System.nanoTime() + TimeUnit.SECONDS.toNanos(1);
    updateUntil("seats are kept", () -> System.nanoTime() >= seatedNs);
    long[] startMs = new long[KILLS];
    long[] backMs = new long[KILLS];
    int[] lostTicks = new int[KILLS];
    for (int kill = 0; kill < KILLS; kill++) {
      String which = "kill=" + kill + " seed=" + seed;
      List<Long> bodies = bodies();
      int match = match();
      long untilNs = System.nanoTime() + TimeUnit.MILLISECONDS.toNanos(random.nextInt(4_000));
      updateUntil("killed", () -> System.nanoTime() >= untilNs);
      int heard = clients.stream().mapToInt(client -> client.decoder().tick()).max().getAsInt();
      int before = clients.stream().mapToInt(client -> client.stats().reconnects()).sum();
      server.destroyForcibly(); // kill -9
      assertTrue(server.waitFor(10, TimeUnit.SECONDS));
      assertEquals(137, server.exitValue());
      long killedNs = System.nanoTime();
      int proven = lastTickOnDisk();
      startMs[kill] = start();
      // The log is written behind the ready line, by a thread of its own.
      updateUntil("resumed, " + which, () -> RESUMED.matcher(read(log())).find());
      Matcher resumed = RESUMED.matcher(read(log()));
      assertTrue(resumed.find(), which);
      int tick = Integer.parseInt(resumed.group(1));
      assertEquals(proven, tick, which);
      assertEquals(hashOnDisk, resumed.group(5), which);
      assertEquals(PLAYERS, Integer.parseInt(resumed.group(4)), which);
      lostTicks[kill] = heard - tick;
      assertTrue(lostTicks[kill] <= TICK_RATE, which + " lost=" + lostTicks[kill]);
      updateUntil(
          "all are back, " + which,
          () ->
              allPlay()
                  && clients.stream().mapToInt(client -> client.stats().reconnects()).sum()
                      >= before + PLAYERS);
      backMs[kill] = TimeUnit.NANOSECONDS.toMillis(System.nanoTime() - killedNs);
      if (match() == match) {
        assertEquals(bodies, bodies(), which);
      } else { // five minutes of play are over, and the rules give all players new bodies
        assertEquals(players(bodies), players(bodies()), which);
      }
      assertFalse(read(log()).contains("join:"), () -> which + "\n" + read(log()));
    }
    report("start to play ms", startMs);
    report("kill to play ms", backMs);
    report("lost ticks", Arrays.stream(lostTicks).asLongStream().toArray());
  }

  @Test
  void aProcessThatIsStoppedGoesOnAndPlayersAreBackInTheirBodies() throws Exception {
    start();
    transport = new KryoClientTransport();
    for (int i = 0; i < PLAYERS; i++) {
      clients.add(new GameClient(config(i), transport, new Bot(i, true)));
    }
    updateUntil("all play", this::allPlay);
    List<Long> bodies = bodies();
    long stoppedNs = System.nanoTime();
    signal("STOP");
    try {
      updateUntil("all know that the server is silent", this::nonePlays);
      updateUntil(
          STOPPED_S + " s passed",
          () -> System.nanoTime() - stoppedNs >= TimeUnit.SECONDS.toNanos(STOPPED_S));
    } finally {
      signal("CONT");
    }
    updateUntil("all are back", this::allPlay);
    assertEquals(bodies, bodies());
    assertTrue(server.isAlive());
    for (String bad : List.of("ERROR", "abandoned", "left")) {
      assertFalse(read(log()).contains(bad), () -> bad + " in\n" + read(log()));
    }
  }

  private boolean nonePlays() {
    return clients.stream().noneMatch(client -> client.view().phase() == ConnectionPhase.PLAYING);
  }

  /** Sends a signal to the server's process. */
  private void signal(String name) throws Exception {
    Process kill = new ProcessBuilder("kill", "-" + name, "" + server.pid()).start();
    assertTrue(kill.waitFor(10, TimeUnit.SECONDS));
    assertEquals(0, kill.exitValue());
  }

  private String hashOnDisk = "";

  /** Reads what the killed process has left, and returns the last tick that can be computed. */
  private int lastTickOnDisk() throws IOException {
    Path room = folder.resolve("data/checkpoints/1");
    List<Integer> slots = new ArrayList<>();
    try (var files = Files.list(room)) {
      files
          .map(file -> file.getFileName().toString())
          .filter(name -> name.endsWith(".seats"))
          .forEach(name -> slots.add(Integer.valueOf(name.replace(".seats", ""))));
    }
    int newest = slots.stream().max(Integer::compare).get();
    int tick = -1;
    try (RecordingReader reader = RecordingReader.open(room.resolve(newest + ".log"))) {
      for (RecordingReader.Entry e = reader.next();
          e != RecordingReader.Entry.WAIT && e != RecordingReader.Entry.END;
          e = reader.next()) {
        if (e == RecordingReader.Entry.STATE) {
          tick = reader.stateTick();
        } else if (e == RecordingReader.Entry.STEPPED) {
          tick++;
        }
        hashOnDisk = String.format(Locale.ROOT, "%016x", reader.hash());
      }
    }
    return tick;
  }

  /** Returns the player and the body of each client. */
  private List<Long> bodies() {
    return clients.stream()
        .map(
            client ->
                (long) client.view().playerId() << 32
                    | (long) client.view().own().generation() << 16
                    | client.view().own().id())
        .toList();
  }

  private static List<Long> players(List<Long> bodies) {
    return bodies.stream().map(body -> body >> 32).toList();
  }

  /** Returns the number of the match that the clients play. */
  private int match() {
    return clients.stream().mapToInt(client -> client.view().matchNumber()).max().getAsInt();
  }

  private static void report(String what, long[] values) {
    Arrays.sort(values);
    System.out.printf(
        "%s of %d kills: median %d, p95 %d, most %d%n",
        what,
        values.length,
        values[values.length / 2],
        values[Math.min(values.length - 1, values.length * 95 / 100)],
        values[values.length - 1]);
  }
}
