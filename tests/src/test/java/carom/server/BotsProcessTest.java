package carom.server;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.client.ClientConfig;
import carom.client.GameClient;
import carom.client.InputSource;
import carom.client.link.ConnectionPhase;
import carom.fixtures.Jvm;
import carom.net.kryo.KryoClientTransport;
import carom.net.transport.ClientTransport;
import carom.suite.Needs;
import java.io.BufferedReader;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Goal: a server with {@code --bots} has bots in a process of their own, that takes seats of people
 * and ends with the server. Method: a real server, which starts its bots, and people's clients over
 * sockets; then the bots are killed, and then the server.
 */
@Needs("processes")
class BotsProcessTest {
  private static final Pattern READY = Pattern.compile("ready tcp=(\\d+) udp=(\\d+)");
  private static final int PATIENCE_S = 60;

  @TempDir Path folder;
  private final List<GameClient> clients = new ArrayList<>();
  private Process server;
  private ClientTransport transport;

  @AfterEach
  void end() {
    clients.forEach(GameClient::close);
    if (transport != null) {
      transport.close();
    }
    if (server != null) {
      server.descendants().forEach(ProcessHandle::destroyForcibly);
      server.destroyForcibly();
    }
  }

  private Process start() throws Exception {
    return new ProcessBuilder(
            Jvm.command(
                ServerMain.class,
                "--bots=1=3:strong",
                "--data=" + folder.resolve("data"),
                "--bind=127.0.0.1",
                "--tcp-port=0",
                "--udp-port=0",
                "--no-web",
                "--no-query"))
        .redirectError(folder.resolve("err").toFile())
        .start();
  }

  private void await(String what, BooleanSupplier condition) throws Exception {
    long begin = System.nanoTime();
    while (!condition.getAsBoolean()) {
      if (System.nanoTime() - begin > TimeUnit.SECONDS.toNanos(PATIENCE_S)) {
        throw new AssertionError(what + " isn't so; " + Files.readString(folder.resolve("err")));
      }
      clients.forEach(client -> client.update(System.nanoTime()));
      Thread.sleep(5);
    }
  }

  private GameClient join(String name, Matcher ready) throws Exception {
    ClientConfig config =
        ClientConfig.of(name)
            .withServer(
                "127.0.0.1", Integer.parseInt(ready.group(1)), Integer.parseInt(ready.group(2)));
    GameClient client = new GameClient(config, transport, InputSource.IDLE);
    clients.add(client);
    await(name + " plays", () -> client.view().phase() == ConnectionPhase.PLAYING);
    return client;
  }

  private static int players(GameClient client) {
    return client.view().players().size();
  }

  @Test
  void botsComeFromAProcessOfTheirOwnThatEndsWithTheServer() throws Exception {
    transport = new KryoClientTransport();
    server = start();
    BufferedReader out =
        new BufferedReader(new InputStreamReader(server.getInputStream(), StandardCharsets.UTF_8));
    Matcher ready = READY.matcher(String.valueOf(out.readLine()));
    assertTrue(ready.matches(), () -> folder.resolve("err").toString());
    assertEquals(0, server.descendants().count(), "nobody is here to play with");
    GameClient ann = join("Ann", ready);
    GameClient bob = join("Bob", ready);
    await("a bot plays", () -> players(bob) == 3);
    int seat = ann.view().playerId();
    clients.remove(ann);
    ann.close();
    await("a bot has Ann's seat", () -> "Ann (bot)".equals(bob.view().playerName(seat)));
    ProcessHandle first = server.descendants().findAny().orElseThrow();
    first.destroyForcibly();
    await("the bots are gone", () -> players(bob) == 1);
    await("others come", () -> players(bob) == 3);
    ProcessHandle second =
        server.descendants().filter(p -> !p.equals(first)).findAny().orElseThrow();
    server.destroyForcibly();
    second.onExit().get(PATIENCE_S, TimeUnit.SECONDS);
  }
}
