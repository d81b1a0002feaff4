package carom.server.fleet;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import carom.client.ClientConfig;
import carom.client.GameClient;
import carom.client.PredictionMode;
import carom.client.bots.Bot;
import carom.client.link.ConnectionPhase;
import carom.fixtures.Jvm;
import carom.net.kryo.KryoClientTransport;
import carom.net.transport.ClientTransport;
import carom.server.Backend;
import carom.server.CaromMain;
import carom.server.ServerMain;
import carom.server.directory.EtcdProgram;
import carom.server.web.Chromium;
import carom.suite.Needs;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Goal: three server processes and an etcd are one service, which survives {@code kill -9}, moves
 * rooms and lets servers go. Method: the programs as an operator starts them, clients over sockets
 * that all join at one server.
 */
@Needs("processes")
class FleetProcessTest {
  private static final Pattern READY = Pattern.compile("ready tcp=(\\d+) udp=(\\d+).*");
  private static final Pattern PLAY = Pattern.compile("play: (http://127.0.0.1:\\d+/play)");
  private static final int PLAYERS = 5;

  @TempDir Path folder;
  private EtcdProgram etcd;
  private final Map<String, Process> servers = new LinkedHashMap<>();
  private final Map<String, Integer> ports = new HashMap<>();
  private final List<GameClient> clients = new ArrayList<>();
  private ClientTransport transport;

  @AfterEach
  void end() {
    clients.forEach(GameClient::close);
    if (transport != null) {
      transport.close();
    }
    servers.values().forEach(Process::destroyForcibly);
    if (etcd != null) {
      etcd.close();
    }
  }

  private String fleet() {
    return "etcd:" + etcd.url();
  }

  private Path log(String name) {
    return folder.resolve(name + ".log");
  }

  private void start(String name, String... more) throws Exception {
    List<String> command = Jvm.command(ServerMain.class);
    command.addAll(List.of("--fleet", fleet(), "--fleet-key", key().toString()));
    command.addAll(List.of("--advertise", "127.0.0.1", "--fleet-port", "0"));
    command.addAll(List.of("--tcp-port", "0", "--udp-port", "0", "--bind", "127.0.0.1"));
    command.addAll(List.of("--max-players", "2", "--data", folder.resolve(name).toString()));
    command.addAll(List.of("--no-web", "--no-query", "--log-keep", "0", "--max-load", "0"));
    command.addAll(List.of("--play-port", "0"));
    command.addAll(List.of(more));
    Process server = new ProcessBuilder(command).redirectError(log(name).toFile()).start();
    servers.put(name, server);
    server.getOutputStream().close();
    BufferedReader out =
        new BufferedReader(new InputStreamReader(server.getInputStream(), StandardCharsets.UTF_8));
    for (String line = out.readLine(); ; line = out.readLine()) {
      assertNotNull(line, () -> read(name));
      Matcher ready = READY.matcher(line);
      if (ready.matches()) {
        ports.put(name, Integer.parseInt(ready.group(1)));
        return;
      }
    }
  }

  private Path key() {
    return folder.resolve("fleet.key");
  }

  private String read(String name) {
    try {
      return Files.readString(log(name));
    } catch (IOException e) {
      return e.toString();
    }
  }

  private String logs() {
    StringBuilder all = new StringBuilder();
    servers
        .keySet()
        .forEach(name -> all.append("--- ").append(name).append('\n').append(read(name)));
    return all.toString();
  }

  private void updateUntil(String what, BooleanSupplier done) throws Exception {
    long endNs = System.nanoTime() + TimeUnit.SECONDS.toNanos(60);
    while (!done.getAsBoolean()) {
      assertTrue(
          System.nanoTime() < endNs,
          () -> what + " isn't so after 60 s: " + places() + "\n" + logs());
      clients.forEach(client -> client.update(System.nanoTime()));
      Thread.sleep(8);
    }
  }

  private boolean allPlay() {
    return clients.stream().allMatch(c -> c.view().phase() == ConnectionPhase.PLAYING);
  }

  /** Returns where each player is: room and seat. */
  private List<String> places() {
    return clients.stream().map(c -> c.view().room() + "#" + c.view().playerId()).toList();
  }

  /** Returns the name of the server that owns a room, by the address that the fleet says. */
  private String owner(String room) {
    for (String line : carom("rooms").split("\n")) {
      String[] words = line.trim().split("\\s+");
      for (Map.Entry<String, Integer> server : ports.entrySet()) {
        boolean isOwner =
            words[words.length - 1].contains("yet")
                ? words[words.length - 3].endsWith(":" + server.getValue())
                : words[words.length - 2].endsWith(":" + server.getValue());
        if (words[0].equals(room) && isOwner) {
          return server.getKey();
        }
      }
    }
    return "nobody";
  }

  private String carom(String... words) {
    StringWriter text = new StringWriter();
    PrintWriter out = new PrintWriter(text);
    List<String> args = new ArrayList<>(List.of("fleet", "--fleet", fleet()));
    args.addAll(List.of("--fleet-key", key().toString()));
    args.addAll(List.of(words));
    int code = CaromMain.run(out, out, args.toArray(new String[0]));
    assertEquals(0, code, text.toString());
    return text.toString();
  }

  private int ticksLost() {
    return clients.stream().mapToInt(c -> c.stats().ticksLost()).sum();
  }

  /** Waits until each room that is played in has a follower, to which each client has a link. */
  private void awaitFollowers() throws Exception {
    updateUntil("followed", () -> !carom("rooms").contains("none yet"));
    long endNs = System.nanoTime() + TimeUnit.SECONDS.toNanos(2);
    updateUntil("stands by", () -> System.nanoTime() >= endNs);
  }

  /** Returns the address of the page on which browsers play at a server. */
  private String page(String name) {
    Matcher play = PLAY.matcher(read(name));
    assertTrue(play.find(), () -> read(name));
    return play.group(1);
  }

  @Test
  @Needs("processes, a browser")
  void aPageGoesWithItsRoomFromServerToServer() throws Exception {
    Path program = Chromium.find();
    assertTrue(program != null || System.getenv("CI") == null, "CI has no Chromium");
    assumeTrue(program != null, "no Chromium");
    etcd = new EtcdProgram(folder, "http");
    Path password = Files.writeString(folder.resolve("password"), "open sesame, open\n");
    start("a", "--password-file", password.toString());
    start("b", "--password-file", password.toString());
    try (Chromium browser = Chromium.start(program, folder.resolve("profile"))) {
      browser.open(page("a") + "#room=2&party=duo"); // b's room: a sends the page there
      browser.await("window.caromPlay");
      browser.evaluate("document.getElementById('password').value = 'open sesame, open'");
      browser.evaluate("document.getElementById('name').value = 'Zo\u00eb'");
      browser.click("document.getElementById('go')");
      String there = "location.href.startsWith('%s') && window.caromPlay && caromPlay.world.own";
      browser.await(there.formatted(page("b")));
      browser.await("caromPlay.link.standby");
      String seat = "caromPlay.link.secret + caromPlay.world.match.room";
      String before = browser.evaluate(seat);
      assertTrue(before.endsWith("2"), before);
      assertFalse(browser.evaluate("location.href").contains(before.substring(0, 16)));

      carom("move", "2");
      browser.await(there.formatted(page("a")));
      assertEquals(before, browser.evaluate(seat), "the same seat");
      browser.await("caromPlay.link.standby");
      servers.get("a").destroyForcibly(); // kill -9
      browser.await(there.formatted(page("b")));
      assertEquals(before, browser.evaluate(seat), "the same seat");
      assertTrue(read("b").contains("back: Zo\u00eb"), () -> read("b"));
    }
  }

  private GameClient come(String server, String name, int skill) throws Exception {
    long expires = System.currentTimeMillis() / 1_000 + 600;
    ClientConfig config =
        ClientConfig.of(name)
            .with(ClientConfig.TOKEN, Backend.token(name, skill, expires))
            .withServer("127.0.0.1", ports.get(server), 0);
    GameClient client = new GameClient(config, transport, new Bot(clients.size(), true));
    clients.add(client);
    return client;
  }

  @Test
  void playersGetToThoseWhoAreAsGoodOnWhicheverServer() throws Exception {
    etcd = new EtcdProgram(folder, "http");
    Backend.rule(folder); // writes the key
    String key = folder.resolve("join.pem").toString();
    start("a", "--join-key", key, "--room-rule", "skill", "--skill-wait", "30");
    start("b", "--join-key", key, "--room-rule", "skill", "--skill-wait", "30");
    transport = new KryoClientTransport();
    GameClient low = come("a", "low", 1_000);
    updateUntil("the first plays", this::allPlay);
    updateUntil("its skill is told", () -> carom("rooms").contains(" 1000 "));
    GameClient high = come("a", "high", 2_000);
    updateUntil("told to wait", () -> high.view().message().startsWith("Looking for players"));
    GameClient equal = come("b", "equal", 2_050);
    updateUntil("equals play", this::allPlay);
    assertEquals(high.view().room(), equal.view().room());
    assertNotEquals(low.view().room(), high.view().room());
    GameClient between = come("b", "between", 1_400); // (400 - 100) / 40 s
    updateUntil("all play", this::allPlay);
    assertEquals(low.view().room(), between.view().room());
  }

  @Test
  void threeServersAreOneThatSurvivesTheLossOfEach() throws Exception {
    etcd = new EtcdProgram(folder, "http");
    start("a");
    start("b");
    start("c");
    transport = new KryoClientTransport();
    for (int i = 0; i < PLAYERS; i++) {
      ClientConfig config = // one predicts: where a room is doesn't concern prediction
          ClientConfig.of("p" + i)
              .withServer("127.0.0.1", ports.get("a"), 0)
              .with(ClientConfig.PREDICTION, i == 0 ? PredictionMode.ISLAND : PredictionMode.NONE);
      clients.add(new GameClient(config, transport, new Bot(i, true)));
      updateUntil("plays", this::allPlay);
    }
    List<String> places = places();
    assertEquals(3, places.stream().map(place -> place.split("#")[0]).distinct().count());
    awaitFollowers();

    String killed = owner("2");
    servers.get(killed).destroyForcibly(); // kill -9
    updateUntil("killed", () -> !servers.get(killed).isAlive());
    Pattern tookOver = Pattern.compile("took over room=2 claim=\\d+ tick=[1-9]\\d* lost=0");
    updateUntil("taken over", () -> tookOver.matcher(logs()).find());
    updateUntil("all play on", this::allPlay);
    assertNotEquals(killed, owner("2"));
    assertEquals(places, places(), "each is back in the own body");
    awaitFollowers();
    String from = owner("2");
    int lostByTheKill = ticksLost(); // what was on its way when the process was killed
    assertTrue(carom("move", "2").contains("room=2 moves to"));
    updateUntil("moved", () -> !owner("2").equals(from) && !owner("2").equals("nobody"));
    updateUntil("all play after a move", this::allPlay);
    assertEquals(places, places());
    assertEquals(lostByTheKill, ticksLost(), "a move loses nothing");

    awaitFollowers();
    String stopped = owner("2");
    servers.get(stopped).destroy(); // SIGTERM
    updateUntil("stopped", () -> !servers.get(stopped).isAlive());
    updateUntil("all play on", () -> allPlay() && !owner("2").equals("nobody"));
    assertNotEquals(stopped, owner("2"));
    assertEquals(places, places());
    assertEquals(lostByTheKill, ticksLost(), "nor does a server that stops");
  }
}
