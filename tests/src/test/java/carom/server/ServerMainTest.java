package carom.server;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.fixtures.Jvm;
import carom.net.kryo.KryoClientTransport;
import carom.net.protocol.ClientMessage;
import carom.net.protocol.GoodbyeReason;
import carom.net.protocol.Protocol;
import carom.net.transport.Link;
import carom.suite.Needs;
import java.io.BufferedReader;
import java.io.File;
import java.io.IOException;
import java.io.InputStream;
import java.io.Writer;
import java.lang.module.ModuleFinder;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/**
 * Goal: the program works as an operator starts it. Method: its own process, real ports, signals
 * and exit codes.
 */
@Needs("processes")
@Timeout(60)
class ServerMainTest {
  private static final Pattern READY = Pattern.compile("ready tcp=(\\d+) udp=(\\d+)");

  /** Refuses the starts of all tests, in a folder that none of them changes for another. */
  private static RefusedStarts refusing;

  @TempDir static Path common;

  @TempDir Path folder;
  private final List<Process> started = new ArrayList<>();

  /** The folder in which processes start; null for the tests' own. */
  private Path workingFolder;

  /** A folder that names more games; null for those of the class path alone. */
  private Path games;

  @BeforeAll
  static void beginToRefuse() throws IOException {
    ProcessBuilder program = new ProcessBuilder(Jvm.command(RefusedStarts.class));
    refusing = new RefusedStarts(in(common, program), common.resolve("err"));
  }

  @AfterAll
  static void endToRefuse() {
    refusing.close();
  }

  @AfterEach
  void endProcesses() {
    started.forEach(Process::destroyForcibly);
  }

  private Process start(String... args) throws IOException {
    return start(List.of(), args);
  }

  private Process start(List<String> before, String... args) throws IOException {
    Process process = startWithInput(before, args);
    process.getOutputStream().close(); // closed standard input must not matter
    return process;
  }

  private Process startWithInput(String... args) throws IOException {
    return startWithInput(List.of(), args);
  }

  private Process startWithInput(List<String> before, String... args) throws IOException {
    List<String> command = new ArrayList<>(before);
    List<String> jvm = new ArrayList<>(List.of("-XX:ActiveProcessorCount=2")); // as many may hang
    if (games != null) {
      String path = System.getProperty("java.class.path");
      jvm.addAll(List.of("-cp", path + File.pathSeparator + games));
    }
    command.addAll(Jvm.command(jvm, ServerMain.class, args));
    ProcessBuilder builder = new ProcessBuilder(command);
    builder.directory(workingFolder == null ? null : workingFolder.toFile());
    Process process = in(folder, builder).redirectError(folder.resolve("err").toFile()).start();
    started.add(process);
    return process;
  }

  private static ProcessBuilder in(Path folder, ProcessBuilder builder) {
    builder.environment().put("CAROM_DATA", folder.resolve("data").toString());
    builder.environment().put("CAROM_WEB_PORT", "0");
    builder.environment().put("CAROM_QUERY_PORT", "0");
    return builder;
  }

  private String err() throws IOException {
    return Files.readString(folder.resolve("err"));
  }

  private static String rest(InputStream in) throws IOException {
    return new String(in.readAllBytes(), StandardCharsets.UTF_8);
  }

  /** Runs until the end, which must come soon; standard output must stay empty. */
  private String fails(int exitCode, String... args) throws Exception {
    Process process = start(args);
    assertTrue(process.waitFor(30, TimeUnit.SECONDS), "still runs: " + List.of(args));
    assertEquals(exitCode, process.exitValue(), err());
    assertEquals("", rest(process.getInputStream()));
    assertFalse(err().contains("\tat "), err());
    return err();
  }

  /** Requires that the program refuses flags before it opens a port, and says why. */
  private static String assertRefused(String why, String... args) throws Exception {
    RefusedStarts.Refusal refusal = refusing.start(args);
    assertEquals(2, refusal.exitCode(), refusal.err());
    assertEquals("", refusal.out());
    assertTrue(refusal.err().contains(why), refusal.err());
    assertFalse(refusal.err().contains("\tat "), refusal.err());
    return refusal.err();
  }

  @Test
  void aServerIsReadyWhenAllItsPortsAreOpen() throws Exception {
    try (ServerSocket tcp = new ServerSocket(0, 1, InetAddress.getLoopbackAddress());
        DatagramSocket datagrams = new DatagramSocket(0)) {
      String busy = Integer.toString(tcp.getLocalPort());
      assertTrue(fails(1, "--rcon", "--rcon-port", busy).contains("rcon-port=" + busy), err());
      assertTrue(fails(1, "--web-port", busy).contains("web-port=" + busy), err());
      String udp = Integer.toString(datagrams.getLocalPort());
      assertTrue(fails(1, "--query-port", udp).contains("query-port=" + udp), err());
    }
  }

  @Test
  void badFlagsGiveOneClearSentenceAndExitCode2() throws Exception {
    assertRefused("Possible solutions: --tcp-port", "--tcp-prot", "1");
    assertRefused("--tcp-port=x is not a whole number", "--tcp-port", "x");
    assertRefused("--udp-port=65536 is outside", "--udp-port", "65536");
    assertRefused("arena", "--game", "arean");
    assertRefused("did you mean \"pyramid\"", "--scene", "piramid");
    assertRefused("exclude", "--scene", "car", "--game", "arena");
    assertRefused("runs at 60 Hz", "--scene", "car", "--tick-rate", "30");
    assertRefused("rooms=513 is outside 1..512", "--rooms", "513");
    assertRefused("at most 32768", "--rooms", "512", "--max-players", "256");
    assertRefused("--max-load=1000 is outside 0..3", "--max-load", "1000");
    assertRefused("--budget=90Mbit is outside 16..80000 k", "--budget", "90Mbit");
    assertRefused("--grace=11 min is outside 0..600 s", "--grace", "11 min");
    assertRefused("Possible solutions: --tcp-port", "--port", "30");
    assertRefused("none of off, error", "--log-level", "loud");
  }

  @Test
  void roomsThatCanNotBePlayedAreRefusedWithTheFormThatWorks() throws Exception {
    assertRefused("example cup=arena,commons:16", "--room", "cup");
    assertRefused("no file level=aren", "--room", "cup=aren");
    assertRefused("name=a b must be 1..32 letters", "--room", "a b=arena");
    assertRefused("players=2000 is outside", "--room", "cup=arena:2000");
    String[] twice = {
      "--tcp-port", "0", "--udp-port", "0", "--room", "a=arena", "--room", "a=arena"
    };
    assertRefused("name=a belongs to two rooms", twice);
    assertRefused("leave --rooms out", "--room", "a=arena", "--rooms", "2");
    assertRefused("there is no room=b", "--room", "a=arena", "--room-info", "b:k=v");
    assertRefused("must have 1..48 bytes", "--room-info", "1:k=" + "v".repeat(99));
    assertRefused("leave --game out", "--levels", "arena", "--game", "x");
  }

  @Test
  void brokenLevelNamesFileAndPlaceAndMissingLevelNamesThePath() throws Exception {
    Path level = folder.resolve("broken.json");
    Files.writeString(level, "{\n  \"name\": \"x\",\n  \"gravity\": \"down\"\n}\n");
    assertRefused("broken.json", "--level", level.toString());
    assertRefused("missing.json", "--level", "missing.json");
  }

  @Test
  void aFolderWithTheNameOfALevelDoesNotHideIt() throws Exception {
    workingFolder = folder;
    Files.createDirectory(folder.resolve("platformer")); // as where a game's author works
    String error = fails(2, "--game", "arena", "--level", "platformer");
    assertTrue(error.contains("which is made for game platformer"), error);
  }

  @Test
  void levelThatLacksWhatItsGameNeedsIsRefusedInOneSentence() throws Exception {
    Path level = folder.resolve("no-flag.json");
    Files.writeString(
        level,
        """
        {"name": "No flag", "game": "platformer", "gravity": [0, -10],
         "bounds": {"min": [-9, -9], "max": [9, 9]}, "spawns": [{"at": [0, 0]}],
         "statics": [{"at": [0, -2], "shape": {"type": "box", "width": 9, "height": 1}}]}
        """);
    String why = "it needs spawns named \"player\" and \"flag\"";
    assertRefused(why, "--tcp-port", "0", "--udp-port", "0", "--level", level.toString());
  }

  @Test
  void recordingFlagsThatDoNotFitTogetherAreRefused() throws Exception {
    Path file = Files.writeString(folder.resolve("file"), "");
    String here = folder.toString();
    assertRefused("no folder", "--rooms", "2", "--record", file.toString());
    assertRefused("needs a folder", "--record-rotate", "5");
    assertRefused("needs --record-rotate", "--record-keep", "5");
    String[] both = {"--record", here, "--record-rotate", "5", "--spectator-delay", "5"};
    assertRefused("leave one of them out", both);
  }

  @Test
  void settingsOfRconNeedRcon() throws Exception {
    assertTrue(fails(2, "--rcon-port", "5").contains("--rcon-port=5 needs --rcon"), err());
    assertTrue(fails(2, "--rcon-bind", "::1").contains("--rcon-bind=::1 needs --rcon"), err());
  }

  @Test
  void recordingThatCannotBeWrittenClosesThePortsAndEndsTheProgram() throws Exception {
    Path file = Files.writeString(folder.resolve("file"), "");
    String[] taken = {"--tcp-port", "0", "--udp-port", "0", "--record", file.toString()};
    assertRefused("is there already; name a new file", taken);
    String[] inside = {"--tcp-port", "0", "--udp-port", "0", "--record", file + "/"};
    assertRefused("is there already; name a new file", inside);
    String nowhere = folder.resolve("no").resolve("file").toString();
    String[] lost = {"--tcp-port", "0", "--udp-port", "0", "--record", nowhere};
    assertTrue(fails(1, lost).contains("can't be written: there is no " + nowhere), err());
  }

  @Test
  void aFolderForRecordingsThatEndsWithASlashIsMade() throws Exception {
    Path games = folder.resolve("new").resolve("games");
    Process process =
        start("--tcp-port", "0", "--udp-port", "0", "--rooms", "2", "--record", games + "/");
    String line = process.inputReader(StandardCharsets.UTF_8).readLine();
    assertTrue(READY.matcher(String.valueOf(line)).matches(), err());
    process.toHandle().destroy();
    assertTrue(process.waitFor(10, TimeUnit.SECONDS), "doesn't stop");
    try (Stream<Path> files = Files.list(games)) {
      assertEquals(2, files.filter(file -> file.toString().endsWith(".carom")).count(), err());
    }
  }

  @Test
  void settingsOfTheFileAreCheckedAndErrorsNameTheirLine() throws Exception {
    Path data = Files.createDirectory(folder.resolve("data"));
    Path file = Files.writeString(data.resolve("carom.conf"), "\ntick-rate = 300\n");
    String error = assertRefused("--tick-rate=300 is outside 10..240 Hz", "--data=" + data);
    assertTrue(error.contains("tick-rate is set by " + file + ": 2"), error);
    Files.writeString(file, "tick-rat = 30\n");
    assertRefused("did you mean \"tick-rate\"?", "--data=" + data);
    assertRefused("config=no.conf can't be read", "--config", "no.conf");
    Files.writeString(file, "");
    assertRefused("--bind=no such is no address", "--data=" + data, "--bind", "no such");
    String noFolder = file.toString();
    assertTrue(fails(1, "--data", noFolder).contains("name another folder with --data"), err());
  }

  @Test
  void commandsOnAPipeAreAnsweredAndStopEndsWithExitCode0() throws Exception {
    Process process = startWithInput("--tcp-port", "0", "--udp-port", "0");
    BufferedReader out = process.inputReader(StandardCharsets.UTF_8);
    assertTrue(READY.matcher(String.valueOf(out.readLine())).matches(), err());
    try (Writer in = process.outputWriter(StandardCharsets.UTF_8)) {
      in.write("say hello\nstopp\nstop\n");
    }
    assertEquals("said to 0 players", out.readLine());
    assertTrue(out.readLine().contains("did you mean \"stop\"?"));
    assertEquals("stopping", out.readLine());
    assertTrue(process.waitFor(10, TimeUnit.SECONDS));
    assertEquals(0, process.exitValue(), err());
    assertTrue(err().contains("stopped: 0 of 64 players"), err());
  }

  @Test
  void anIdleServerPausesUnlessToldToRun() throws Exception {
    assertTrue(stateOfTheRoom("--log-level", "off").contains("paused"));
    assertTrue(stateOfTheRoom("--idle", "run").contains("runs"));
  }

  /**
   * Returns what the command {@code rooms} says of a server without players after half a second.
   */
  private String stateOfTheRoom(String... flags) throws Exception {
    List<String> all = new ArrayList<>(List.of("--tcp-port", "0", "--udp-port", "0"));
    all.addAll(List.of(flags));
    Process process = startWithInput(all.toArray(String[]::new));
    BufferedReader out = process.inputReader(StandardCharsets.UTF_8);
    assertTrue(READY.matcher(String.valueOf(out.readLine())).matches(), err());
    Thread.sleep(500);
    try (Writer in = process.outputWriter(StandardCharsets.UTF_8)) {
      in.write("rooms\nstop\n");
    }
    assertTrue(out.readLine().startsWith("room "), "a heading");
    String room = out.readLine();
    assertTrue(process.waitFor(10, TimeUnit.SECONDS));
    return room;
  }

  /** Nobody is in them, so that the process has its usual threads. */
  @Test
  @Timeout(240)
  void of512RoomsOneWakesForItsPlayerAndTheOthersRest() throws Exception {
    Process process =
        startWithInput(
            "--tcp-port=0", "--udp-port=0", "--rooms=512", "--idle=pause", "--log-level=warn");
    BufferedReader out = process.inputReader(StandardCharsets.UTF_8);
    Matcher ready = READY.matcher(String.valueOf(out.readLine()));
    assertTrue(ready.matches(), err());
    int tcp = Integer.parseInt(ready.group(1));
    int udp = Integer.parseInt(ready.group(2));
    try (KryoClientTransport transport = new KryoClientTransport();
        Writer in = process.outputWriter(StandardCharsets.UTF_8)) {
      FakeClient client = new FakeClient(transport.connect("127.0.0.1", tcp, udp));
      for (int i = 0; i < 4_000 && client.link.state() == Link.State.CONNECTING; i++) {
        Thread.sleep(5);
      }
      client.link.send(
          new ClientMessage.Hello(
              Protocol.VERSION, Protocol.physicsDigest(), "Ann", 0, "300", "", "", ""));
      for (int i = 0; i < 4_000 && (client.decoder == null || !client.decoder.hasAck()); i++) {
        client.step(0);
        Thread.sleep(5);
      }
      assertEquals("300", client.welcome.room());
      assertTrue(client.decoder.hasAck(), "the room plays");
      int running = 0;
      for (int attempt = 0; attempt < 100 && running != 1; attempt++) {
        Thread.sleep(
            attempt == 0 ? 0 : 200); // on a busy machine the first turns of all take a while
        in.write("rooms\n");
        in.flush();
        assertTrue(out.readLine().startsWith("room "), "a heading");
        running = 0;
        for (int i = 1; i <= 512; i++) {
          String room = out.readLine();
          assertTrue(room.startsWith("@" + i + " "), room);
          assertTrue(room.endsWith("runs") || (room.endsWith("paused") && i != 300), room);
          running += room.endsWith("runs") ? 1 : 0;
        }
        client.step(0);
      }
      assertEquals(1, running, "only the room that is played in runs");
      Path status = Path.of("/proc", Long.toString(process.pid()), "status");
      if (Files.exists(status)) {
        Map<String, Integer> lines = new HashMap<>();
        for (String line : Files.readAllLines(status)) {
          String[] words = line.split("\\s+");
          if (List.of("Threads:", "VmRSS:").contains(words[0])) {
            lines.put(words[0], Integer.valueOf(words[1]));
          }
        }
        System.out.println("512 rooms: " + lines);
        assertTrue(lines.get("Threads:") < 60, "" + lines);
      }
    }
  }

  @Test
  void settingsAndRoomsChangeWithoutARestart() throws Exception {
    Process process =
        startWithInput(
            "--tcp-port", "0", "--udp-port", "0", "--room", "cup=arena", "--max-load", "0.5");
    BufferedReader out = process.inputReader(StandardCharsets.UTF_8);
    assertTrue(READY.matcher(String.valueOf(out.readLine())).matches(), err());
    try (Writer in = process.outputWriter(StandardCharsets.UTF_8)) {
      for (String line :
          List.of(
              "set max-load 0.7",
              "set max-players 8",
              "set name \"My house\"",
              "set welcome \"Be kind\"",
              "set budget 1Mbit",
              "set snapshot-rate 30",
              "set budget 1",
              "set tick-rate 30",
              "room add jump=platformer:3",
              "room remove @cup",
              "config max-load",
              "rooms",
              "stop")) {
        in.write(line + "\n");
      }
    }
    String answers = String.join("\n", out.lines().toList());
    assertTrue(process.waitFor(10, TimeUnit.SECONDS));
    for (String expected :
        List.of(
            "max-load = 0.7, was 0.5: holds now",
            "max-players = 8, was 64: holds now",
            "name = My house, was Carom: holds now",
            "welcome = Be kind, was -: holds now",
            "budget = 1Mbit, was 512: holds now",
            "snapshot-rate = 30, was -: holds now",
            "nothing has changed: --budget=1 is outside 16..80000 kbit",
            "setting=tick-rate can't change while the server runs",
            "added room=jump levels=platformer players=3",
            "removed room=cup, moved players=0, dismissed players=0",
            "from: the command set",
            "@jump")) {
      assertTrue(answers.contains(expected), expected + " isn't in: " + answers);
    }
    assertFalse(answers.contains("@cup"), answers);
    assertTrue(err().contains("console: room @cup remove -> removed room=cup"), err());
  }

  @Test
  void printsItsSettingsAsAFile() throws Exception {
    Process process = start("--print-config", "--grace", "1 min");
    String printed = rest(process.getInputStream());
    assertEquals(0, process.waitFor());
    assertTrue(printed.contains("\ngrace = 1 min\n"), printed);
    assertTrue(printed.contains("\n#tick-rate = 60 Hz\n"), printed);
    assertEquals("", err());
    assertFalse(Files.exists(folder.resolve("data/logs")), "only printed");
  }

  /** Goal: the server takes links without {@code sun.misc.Unsafe}, which newer JDKs warn of. */
  @Test
  void itNeedsNoUnsafe() throws Exception {
    String modules = "java.se,jdk.crypto.ec,jdk.httpserver,jdk.management,jdk.zipfs";
    assertTrue(ModuleFinder.ofSystem().find("jdk.unsupported").isPresent(), "it is left out");
    List<String> limited = List.of("env", "JDK_JAVA_OPTIONS=--limit-modules=" + modules);
    Process process = start(limited, "--tcp-port=0", "--udp-port=0", "--log-keep=0");
    Matcher ready = READY.matcher(String.valueOf(process.inputReader().readLine()));
    assertTrue(ready.matches(), err());
    try (KryoClientTransport transport = new KryoClientTransport()) {
      int tcp = Integer.parseInt(ready.group(1));
      Link link = transport.connect("localhost", tcp, Integer.parseInt(ready.group(2)));
      for (int i = 0; i < 2_000 && link.state() == Link.State.CONNECTING; i++) {
        Thread.sleep(5);
      }
      assertEquals(Link.State.OPEN, link.state(), link.closeReason());
    }
    assertFalse(err().contains("WARN"), err());
  }

  /** Returns the log of a server with the exit code of failures, by which a supervisor acts. */
  private List<String> hangs(boolean atStart) throws Exception {
    games = folder.resolve("games");
    Path services = Files.createDirectories(games.resolve("META-INF/services"));
    Files.writeString(services.resolve("carom.sim.Game"), LoopingGame.class.getName());
    Path level = folder.resolve("level.json");
    Files.writeString(level, LoopingGame.level(atStart));
    Process process =
        start("--tcp-port=0", "--udp-port=0", "--log-keep=0", "--level=" + level, "--idle=run");
    assertTrue(process.waitFor(50, TimeUnit.SECONDS), err());
    assertEquals(1, process.exitValue(), err());
    return err().lines().toList();
  }

  @Test
  void aGameThatHangsTwiceEndsTheProcessWithExitCode1() throws Exception {
    List<String> lines = hangs(false);
    String hangs = "game looping hangs in beforeStep of " + LoopingGame.class.getName();
    assertEquals(2, lines.stream().filter(line -> line.contains(hangs)).count(), err());
    String why = "2 threads are abandoned, as many as rooms have: the server ends; start it again";
    assertTrue(err().contains(why), err());
    assertTrue(lines.get(lines.size() - 1).contains("stopped: "), err());
  }

  @Test
  void aGameThatHangsBeforeAnyRoomRunsEndsTheStartWithExitCode1() throws Exception {
    List<String> lines = hangs(true);
    String hangs = "the start hangs in beforeStep of " + LoopingGame.class.getName();
    assertTrue(lines.get(0).contains(hangs), err());
    assertTrue(lines.get(1).endsWith("thread main"), err());
    String callback = LoopingGame.class.getName() + ".beforeStep("; // or in what that calls
    assertTrue(lines.subList(2, 6).stream().anyMatch(l -> l.contains(callback)), err());
  }

  @Test
  void ctrlCEndsItInGoodOrderWithTheExitCodeOfShells() throws Exception {
    assertEndsByCtrlC(130, "TERM=dumb");
  }

  @Test
  void ctrlCIsNoFailureOfABuildWhereGradlewStartedIt() throws Exception {
    assertEndsByCtrlC(0, "JAVA_TOOL_OPTIONS=-Dcarom.terminal=true");
  }

  private void assertEndsByCtrlC(int exitCode, String variable) throws Exception {
    // A shell without job control starts background jobs with SIGINT ignored, which Java keeps.
    List<String> reset = List.of("env", "--default-signal=INT", variable);
    Process process = start(reset, "--tcp-port", "0", "--udp-port", "0", "--log-keep", "0");
    BufferedReader out = process.inputReader(StandardCharsets.UTF_8);
    assertTrue(READY.matcher(out.readLine()).find(), err());
    String pid = Long.toString(process.pid());
    assertEquals(0, new ProcessBuilder("kill", "-INT", pid).start().waitFor());
    assertTrue(process.waitFor(20, TimeUnit.SECONDS), err());
    assertEquals(exitCode, process.exitValue(), err());
    assertTrue(err().contains("stop: asked to"), err());
    assertTrue(err().contains("stopped: "), err());
  }

  @Test
  void saysReadyOnceServesPlayersAndSigtermTellsThem() throws Exception {
    Process process = start("--tcp-port", "0", "--udp-port", "0", "--seed", "7");
    BufferedReader out = process.inputReader(StandardCharsets.UTF_8);
    Matcher ready = READY.matcher(String.valueOf(out.readLine()));
    assertTrue(ready.matches(), err());
    try (KryoClientTransport transport = new KryoClientTransport()) {
      int tcp = Integer.parseInt(ready.group(1));
      int udp = Integer.parseInt(ready.group(2));
      FakeClient client = new FakeClient(transport.connect("localhost", tcp, udp));
      boolean greeted = false;
      for (int i = 0; i < 1_000 && (client.decoder == null || !client.decoder.hasAck()); i++) {
        if (!greeted && client.link.state() == Link.State.OPEN) {
          client.hello("Ann");
          greeted = true;
        }
        client.step(0);
        Thread.sleep(5);
      }
      assertTrue(client.ready, () -> "not in: " + client.messages);
      assertTrue(client.decoder.hasAck());

      long begin = System.nanoTime();
      process.toHandle().destroy(); // SIGTERM; Process.destroy would close the streams as well
      assertTrue(process.waitFor(2, TimeUnit.SECONDS), "takes longer than 2 s to stop");
      long tookMs = (System.nanoTime() - begin) / 1_000_000;
      for (int i = 0; i < 400 && client.goodbye == null; i++) {
        client.step(0);
        Thread.sleep(5);
      }
      assertNotNull(client.goodbye, "after " + tookMs + " ms");
      assertEquals(GoodbyeReason.SERVER_STOPPING, client.goodbye.reason());
    }
    assertNull(out.readLine(), "one line on standard output");
    assertEquals(143, process.exitValue(), "128 and the number of SIGTERM");
    String log = err();
    assertTrue(log.contains("seed 7"), log);
    assertTrue(log.contains("join: Ann as player 0"), log);
    assertTrue(log.contains("stopped: "), log);
    assertFalse(log.contains("WARN") || log.contains("ERROR"), log);
    assertEquals(log, Files.readString(folder.resolve("data/logs/carom.log")));
  }

  @Test
  void busyPortGivesOneClearSentenceAndExitCode1() throws Exception {
    Process first = start("--tcp-port", "0", "--udp-port", "0", "--log-level", "off");
    Matcher ready =
        READY.matcher(String.valueOf(first.inputReader(StandardCharsets.UTF_8).readLine()));
    assertTrue(ready.matches(), err());
    String tcp = ready.group(1);
    String other = folder.resolve("other").toString();
    String error =
        fails(1, "--tcp-port", tcp, "--udp-port", "0", "--log-level", "off", "--data", other);
    assertTrue(error.contains(tcp), error);
    assertTrue(error.contains("--tcp-port"), error);
    assertTrue(first.isAlive());
  }
}
