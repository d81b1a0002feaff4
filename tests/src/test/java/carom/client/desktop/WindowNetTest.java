package carom.client.desktop;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import carom.client.ClientConfig;
import carom.client.PredictionMode;
import carom.client.bots.BotFarm;
import carom.fixtures.Jvm;
import carom.fixtures.Slice;
import carom.fixtures.VirtualDisplay;
import carom.net.kryo.KryoClientTransport;
import carom.net.transport.ClientTransport;
import carom.physics.threads.WorkerThreads;
import carom.server.ServerMain;
import carom.server.match.MatchLibrary;
import carom.sim.Game;
import carom.sim.level.Level;
import carom.suite.Needs;
import java.io.BufferedReader;
import java.io.File;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.ServiceLoader;
import java.util.TreeMap;
import java.util.concurrent.TimeUnit;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/**
 * Goal: no key, no button and no network ends a player's window, whatever the game. Method: the
 * real server with a room for each game that is listed, bots in each, levels that change all the
 * time, and real windows on virtual displays, in which {@link WindowPlayer} presses everything: two
 * play, over a mobile network and over one of 60 ms, each in one half of the rooms, which a seed
 * draws; a third watches the rooms, the recordings and scenes. Their output and logs must be free
 * of failures. With {@code -Dcarom.all=true} each goes everywhere, and stays longer.
 */
@Needs("windows")
@Timeout(900)
final class WindowNetTest {
  /** Whether both networks go to each room, for longer, and all scenes are seen. */
  private static final boolean ALL = Slice.WHOLE;

  /** Time in each room, s: a key is held 0.1 s, and there are about 45. */
  private static final double SECONDS = ALL ? 30 : 9;

  /** Number of scenes to see. */
  private static final int SCENES = ALL ? Integer.MAX_VALUE : 8;

  private static final int BOTS = 1;
  private static final long LEVEL_EVERY_MS = 3_500;

  /** Most memory that a window may have gained from its first to its last room, MB. */
  private static final int MOST_GAIN_MB = 48;

  private static final Pattern READY = Pattern.compile("ready tcp=(\\d+) udp=(\\d+)");

  @TempDir private Path folder;
  private final long seed = Long.getLong("carom.seed", System.nanoTime());
  private final List<Process> processes = new ArrayList<>();
  private final List<AutoCloseable> open = new ArrayList<>();

  @AfterEach
  void end() throws Exception {
    for (AutoCloseable one : open) {
      one.close();
    }
    processes.forEach(Process::destroyForcibly);
  }

  @Test
  void everyKeyInEveryGameOnEveryScreen() throws Exception {
    assumeTrue(VirtualDisplay.available(), "Xvfb is not installed (Debian: apt-get install xvfb)");
    Map<String, List<String>> rooms = rooms();
    assertTrue(rooms.size() >= 3, rooms.toString());
    int port = startServer(rooms);
    Thread bots = startBots(rooms, port);
    List<String> names = new ArrayList<>(rooms.keySet());
    Collections.shuffle(names, new Random(seed));
    int half = names.size() / 2;
    List<String> some = ALL ? names : names.subList(0, half);
    List<String> others = ALL ? names : names.subList(half, names.size());
    Window mobile = play("mobile", port, some, "--network", "mobile");
    Window slow = play("slow", port, others, "--latency", "30", "--net-graph");
    mobile.requireSound(bots);
    slow.requireSound(bots);
    String recordings = folder.resolve("recordings").toString();
    Window viewer = open("viewer", port, List.of("view", recordings, "" + SCENES));
    viewer.requireSound(bots);
    assertFalse(read("server").contains(" ERROR "), () -> read("server"));
    for (String game : rooms.keySet()) {
      boolean shown =
          viewer.output().lines().anyMatch(l -> l.startsWith("replays") && l.contains(game));
      assertTrue(shown, viewer::output);
    }
  }

  /** Returns the levels of each game that is listed as a service. */
  private static Map<String, List<String>> rooms() throws Exception {
    Map<String, List<String>> rooms = new TreeMap<>();
    for (Game game : ServiceLoader.load(Game.class)) {
      List<String> levels = new ArrayList<>(List.of(game.defaultLevel()));
      for (String name : MatchLibrary.builtInLevels()) {
        boolean ofThis = Level.builtIn(name).gameName().equals(game.name());
        if (ofThis && !levels.contains(name)) {
          levels.add(name);
        }
      }
      rooms.put(game.name(), levels);
    }
    return new LinkedHashMap<>(rooms);
  }

  private int startServer(Map<String, List<String>> rooms) throws Exception {
    List<String> flags = new ArrayList<>();
    rooms.forEach((game, levels) -> flags.addAll(List.of("--room", game + "=" + levels.get(0))));
    flags.addAll(List.of("--data", folder.resolve("data").toString(), "--bind", "127.0.0.1"));
    flags.addAll(List.of("--tcp-port", "0", "--udp-port", "0", "--no-web", "--no-query"));
    flags.addAll(List.of("--spectator-delay", "1", "--log-keep", "0", "--max-load", "0"));
    flags.addAll(List.of("--record", folder.resolve("recordings") + "/", "--network-share", "100"));
    ProcessBuilder builder = java("server", ServerMain.class, flags);
    builder.redirectErrorStream(false).redirectOutput(ProcessBuilder.Redirect.PIPE);
    builder.redirectError(folder.resolve("server.txt").toFile());
    Process server = builder.start();
    processes.add(server);
    BufferedReader out =
        new BufferedReader(new InputStreamReader(server.getInputStream(), StandardCharsets.UTF_8));
    Matcher ready = READY.matcher(String.valueOf(out.readLine()));
    assertTrue(ready.matches(), () -> read("server"));
    changeLevels(rooms, new PrintStream(server.getOutputStream(), true, StandardCharsets.UTF_8));
    return Integer.parseInt(ready.group(1));
  }

  /** Lets each room go on with its next level again and again. */
  private void changeLevels(Map<String, List<String>> rooms, PrintStream console) {
    Thread operator =
        new Thread(
            () -> {
              try {
                for (int i = 1; ; i++) {
                  for (Map.Entry<String, List<String>> room : rooms.entrySet()) {
                    Thread.sleep(LEVEL_EVERY_MS);
                    List<String> levels = room.getValue();
                    String level = levels.get(i % levels.size());
                    console.println("level @" + room.getKey() + " " + level);
                  }
                }
              } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
              }
            },
            "operator");
    operator.start();
    open.add(
        () -> {
          operator.interrupt();
          operator.join();
        });
  }

  private Thread startBots(Map<String, List<String>> rooms, int port) {
    ClientTransport transport = new KryoClientTransport();
    WorkerThreads alone = new WorkerThreads(1);
    List<BotFarm> farms = new ArrayList<>();
    for (String room : rooms.keySet()) {
      ClientConfig config =
          ClientConfig.of("bot")
              .withServer("127.0.0.1", port, 0)
              .with(ClientConfig.ROOM, room)
              .with(ClientConfig.PREDICTION, PredictionMode.NONE); // they are only company
      farms.add(new BotFarm(config, transport, BOTS, seed, false, 0, alone));
    }
    Thread bots =
        new Thread(
            () -> {
              try {
                while (true) {
                  farms.forEach(farm -> farm.update(System.nanoTime()));
                  Thread.sleep(16);
                }
              } catch (InterruptedException e) {
                farms.forEach(BotFarm::close);
              }
            },
            "bots");
    bots.start();
    open.add(
        () -> {
          bots.interrupt();
          bots.join();
          transport.close();
          alone.close();
        });
    return bots;
  }

  /** A window on a display of its own. */
  private final class Window {
    private final String name;
    private final Process process;

    Window(String name, Process process) {
      this.name = name;
      this.process = process;
    }

    String output() {
      return "seed=" + seed + "\n" + read(name);
    }

    /** Requires that it ends by itself and that nothing failed. */
    void requireSound(Thread bots) throws Exception {
      assertTrue(process.waitFor((long) (100 + 20 * SECONDS), TimeUnit.SECONDS), this::output);
      assertEquals(0, process.exitValue(), this::output);
      assertTrue(bots.isAlive(), "the bots play");
      List<String> failures =
          output()
              .lines()
              .filter(
                  line ->
                      line.startsWith("problem")
                          || line.contains(" ERROR ")
                          || line.contains("Exception")
                          || line.contains("Error:")
                          || line.contains("failed"))
              .toList();
      assertEquals(List.of(), failures, this::output);
      assertTrue(output().contains("\ndone"), this::output);
      Matcher heap = Pattern.compile("heap before (\\d+) after (\\d+)").matcher(output());
      if (heap.find()) {
        int gain = Integer.parseInt(heap.group(2)) - Integer.parseInt(heap.group(1));
        assertTrue(gain <= MOST_GAIN_MB, this::output);
      }
    }
  }

  private Window play(String name, int port, List<String> rooms, String... more) throws Exception {
    List<String> how = List.of("play", String.join(",", rooms), "" + SECONDS);
    List<String> flags = new ArrayList<>(List.of("--host", "localhost:" + port));
    flags.addAll(List.of(more));
    return open(name, port, how, flags.toArray(String[]::new));
  }

  private Window open(String name, int port, List<String> how, String... more) throws Exception {
    VirtualDisplay display = VirtualDisplay.open();
    open.add(display);
    List<String> args = new ArrayList<>(how);
    args.addAll(List.of("" + port, "" + (seed + processes.size())));
    args.addAll(List.of("--settings", Files.createDirectories(folder.resolve(name)) + "/p.conf"));
    args.addAll(List.of("--volume", "0", "--name", name));
    args.addAll(List.of(more));
    ProcessBuilder builder = java(name, WindowPlayer.class, args);
    display.show(builder);
    builder.directory(folder.resolve(name).toFile());
    Process process = builder.start();
    processes.add(process);
    return new Window(name, process);
  }

  private ProcessBuilder java(String name, Class<?> program, List<String> args) {
    List<String> command =
        Jvm.command(
            List.of("-Xmx512m", "-Dcarom.all=" + ALL), program, args.toArray(new String[0]));
    File log = folder.resolve(name + ".txt").toFile();
    return new ProcessBuilder(command).redirectErrorStream(true).redirectOutput(log);
  }

  private String read(String name) {
    try {
      return Files.readString(folder.resolve(name + ".txt"));
    } catch (IOException e) {
      return "no output: " + e;
    }
  }
}
