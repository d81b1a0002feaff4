package carom.client;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.client.app.ClientMain;
import carom.client.bots.BotFarm;
import carom.client.link.ConnectionPhase;
import carom.client.link.RoomBrowser;
import carom.client.link.ServerAddress;
import carom.fixtures.Jvm;
import carom.game.Games;
import carom.net.kryo.KryoClientTransport;
import carom.net.kryo.server.KryoServerTransport;
import carom.net.protocol.ClientMessage;
import carom.net.protocol.GoodbyeReason;
import carom.net.protocol.Protocol;
import carom.net.protocol.RefusalReason;
import carom.net.protocol.ServerMessage;
import carom.net.transport.Link;
import carom.net.transport.LinkHandler;
import carom.physics.threads.WorkerThreads;
import carom.server.Server;
import carom.server.config.ServerConfig;
import carom.sim.level.Level;
import carom.suite.Needs;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/**
 * Goal: a player reads why a connection ended, in the words that the server said. Method: real
 * sockets; a scripted server says each reason there is, and a real one is full, stopped or doesn't
 * let anybody watch.
 */
@Needs("sockets")
@Timeout(120)
final class EndingWordsTest {
  private static final String DETAILS = "These are the details.";

  private final KryoClientTransport transport = new KryoClientTransport();
  private ScriptedServer server;
  private GameClient client;

  @AfterEach
  void close() {
    if (client != null) {
      client.close();
    }
    transport.close();
  }

  private GameClient client(int tcpPort, int udpPort) {
    return new GameClient(
        ClientConfig.of("tester").withServer("127.0.0.1", tcpPort, udpPort),
        transport,
        InputSource.IDLE);
  }

  private String words() {
    return client.view().message();
  }

  private void await(BooleanSupplier condition, String what) throws InterruptedException {
    long deadline = System.nanoTime() + TimeUnit.SECONDS.toNanos(20);
    while (!condition.getAsBoolean()) {
      assertTrue(System.nanoTime() < deadline, () -> what + ": " + words());
      long now = System.nanoTime();
      if (server != null) {
        server.tick(now);
      }
      if (client != null) {
        client.update(now);
      }
      Thread.sleep(8);
    }
  }

  @Test
  void eachRefusalIsReadAsItWasSaid() throws Exception {
    try (KryoServerTransport sockets = new KryoServerTransport(0, 0)) {
      for (RefusalReason reason : RefusalReason.values()) {
        server = new ScriptedServer(sockets, PredictionScenarioTest.arena());
        server.script =
            new ScriptedServer.Script() {
              @Override
              boolean hello(ScriptedServer.Guest guest) {
                guest.link.send(new ServerMessage.Refused(reason, DETAILS));
                return false;
              }
            };
        client = client(sockets.tcpPort(), sockets.udpPort());
        String said = reason.playerText() + " " + DETAILS;
        if (reason == RefusalReason.FLEET_UNSETTLED) { // the client tries again by itself
          await(() -> words().startsWith(said + " Trying again"), reason.name());
          client.close();
          continue;
        }
        await(() -> client.view().phase() == ConnectionPhase.ENDED, reason.name());
        assertEquals(said, words());
        assertEquals(reason.retryUseful(), client.isRetryUseful(), reason.name());
        client.close();
      }
    }
  }

  @Test
  void eachGoodbyeIsReadAsItWasSaidAlsoWhileTheServerIsGone() throws Exception {
    for (GoodbyeReason reason : GoodbyeReason.values()) {
      try (KryoServerTransport sockets = new KryoServerTransport(0, 0)) {
        server = new ScriptedServer(sockets, PredictionScenarioTest.arena());
        client = client(sockets.tcpPort(), sockets.udpPort());
        await(() -> client.view().phase() == ConnectionPhase.PLAYING, reason.name());
        server.guests.get(0).link.send(new ServerMessage.Goodbye(reason, DETAILS));
        await(() -> client.view().phase() != ConnectionPhase.PLAYING, reason.name());
      }
      server = null; // nothing listens any more
      String said = reason.playerText() + " " + DETAILS;
      if (reason.retryUseful()) {
        await(() -> words().contains("(attempt 3)"), reason.name());
        assertTrue(words().startsWith(said + " Reconnecting"), words());
      } else {
        assertEquals(ConnectionPhase.ENDED, client.view().phase());
        assertEquals(said, words());
      }
      client.close();
      client = null;
    }
  }

  private static Server real(int places) throws Exception {
    Server real =
        new Server(
            ServerConfig.defaults().with(ServerConfig.MAX_PLAYERS, places),
            () -> Games.create("arena"),
            Level.builtIn("arena"),
            new KryoServerTransport(0, 0),
            System::nanoTime);
    real.start();
    return real;
  }

  @Test
  void aPlayerAndABotReadThatAServerIsFull() throws Exception {
    String said = RefusalReason.SERVER_FULL.playerText() + " The only place is taken.";
    try (Server real = real(1);
        GameClient first = client(real.tcpPort(), real.udpPort());
        WorkerThreads workers = new WorkerThreads(1);
        BotFarm bots = new BotFarm(config(real), transport, 1, 1, false, 0, workers)) {
      await(
          () -> {
            first.update(System.nanoTime());
            return first.view().phase() == ConnectionPhase.PLAYING;
          },
          "the first player joins");
      client = client(real.tcpPort(), real.udpPort());
      await(
          () -> {
            first.update(System.nanoTime());
            bots.update(System.nanoTime());
            return client.view().phase() == ConnectionPhase.ENDED && bots.problem().equals(said);
          },
          "the second player and the bot are refused");
      assertEquals(said, words());
    }
  }

  private static ClientConfig config(Server real) {
    return ClientConfig.of("bot").withServer("127.0.0.1", real.tcpPort(), real.udpPort());
  }

  @Test
  void aVersionThatDiffersIsSaidByARealServer() throws Exception {
    try (Server real = real(4)) {
      Link link = transport.connect("127.0.0.1", real.tcpPort(), real.udpPort());
      List<Object> received = new ArrayList<>();
      LinkHandler handler = keep(received);
      await(() -> link.state() == Link.State.OPEN, "no link");
      link.send(
          new ClientMessage.Hello(
              Protocol.VERSION - 1, Protocol.physicsDigest(), "old", 0, "", "", "", ""));
      await(
          () -> {
            link.poll(handler, 10);
            return !received.isEmpty();
          },
          "no answer");
      String said = ((ServerMessage.Refused) received.get(0)).playerText();
      assertTrue(said.startsWith(RefusalReason.PROTOCOL_VERSION.playerText()), said);
      assertTrue(said.contains("your game " + (Protocol.VERSION - 1)), said);
    }
  }

  private static LinkHandler keep(List<Object> received) {
    return new LinkHandler() {
      @Override
      public void message(Link from, Object message) {
        received.add(message);
      }

      @Override
      public void datagram(Link from, byte[] bytes, int length) {}

      @Override
      public void closed(Link from, String reason) {}
    };
  }

  @Test
  void aProgramWithoutAWindowSaysThatTheServerWasStopped(@TempDir Path folder) throws Exception {
    Process program;
    Path output = folder.resolve("output.txt");
    try (Server real = real(4)) {
      program = headless(output, real, "--seconds", "12");
      await(() -> text(output).contains("playing tick="), "the program plays");
      server = null;
    }
    try {
      await(() -> text(output).contains("(attempt 2)"), "the program tries to come back");
      String said = text(output);
      assertTrue(said.contains("The server is shutting down. Reconnecting"), said);
      assertFalse(said.contains("No answer"), said);
    } finally {
      program.destroy();
    }
  }

  @Test
  void aProgramThatMayNotWatchSaysSo(@TempDir Path folder) throws Exception {
    Path output = folder.resolve("output.txt");
    try (Server real = real(4)) {
      Process program = headless(output, real, "--watch");
      assertTrue(program.waitFor(30, TimeUnit.SECONDS));
      assertEquals(1, program.exitValue());
      String said = text(output).strip();
      assertEquals(
          "carom-client: "
              + RefusalReason.NOT_SHOWN.playerText()
              + " Its operator can change that by --spectator-delay.",
          said);
    }
  }

  @Test
  void aListOfRoomsThatCannotBeHadSaysWhy() throws Exception {
    int tcp;
    int udp;
    try (KryoServerTransport closed = new KryoServerTransport(0, 0)) {
      tcp = closed.tcpPort();
      udp = closed.udpPort();
    }
    try (RoomBrowser browser =
        new RoomBrowser(new ServerAddress("127.0.0.1", tcp, udp), transport)) {
      await(
          () -> {
            browser.update(System.nanoTime());
            return browser.isDone();
          },
          "an answer");
      assertTrue(browser.problem().startsWith("Can't reach 127.0.0.1:" + tcp), browser.problem());
    }
  }

  private static Process headless(Path output, Server real, String... flags) throws Exception {
    List<String> command =
        Jvm.command(ClientMain.class, "--headless", "--host", "localhost:" + real.tcpPort());
    command.addAll(List.of(flags));
    return new ProcessBuilder(command)
        .redirectErrorStream(true)
        .redirectOutput(output.toFile())
        .start();
  }

  private static String text(Path file) {
    try {
      return Files.exists(file) ? Files.readString(file) : "";
    } catch (IOException e) {
      return e.toString();
    }
  }
}
