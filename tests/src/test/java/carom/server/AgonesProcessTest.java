package carom.server;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.client.ClientConfig;
import carom.client.GameClient;
import carom.client.bots.Bot;
import carom.client.link.ConnectionPhase;
import carom.fixtures.Jvm;
import carom.net.kryo.KryoClientTransport;
import carom.net.transport.ClientTransport;
import carom.server.directory.EtcdProgram;
import carom.suite.Needs;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.net.ServerSocket;
import java.nio.charset.StandardCharsets;
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
 * Goal: servers in pods of Agones are a fleet without a word about addresses, and leave it as their
 * labels and signals say. Method: two server processes, an etcd, two sidecars, a real player.
 */
@Needs("processes")
@Timeout(180)
final class AgonesProcessTest {
  @TempDir private Path folder;
  private EtcdProgram etcd;
  private ClientTransport transport;
  private GameClient client;
  private final List<Pod> pods = new ArrayList<>();

  /** A server process and its sidecar. */
  private final class Pod {
    final String name;
    final FakeSidecar sidecar;
    final Process server;
    String ready;

    Pod(String name, int tcp, int udp, int fleetPort) throws IOException {
      this.name = name;
      String port = "{\"name\":\"%s\",\"port\":%d}";
      sidecar =
          new FakeSidecar(
              String.join(
                  ",",
                  String.format(port, "tcp", tcp),
                  String.format(port, "udp", udp),
                  String.format(port, "fleet", fleetPort)));
      List<String> command = Jvm.command(ServerMain.class);
      command.addAll(List.of("--fleet", "etcd:" + etcd.url()));
      command.addAll(List.of("--fleet-key", folder.resolve("fleet.key").toString()));
      command.addAll(List.of("--tcp-port", "0", "--udp-port", "0")); // those of the GameServer
      command.addAll(List.of("--fleet-port", "0", "--bind", "127.0.0.1"));
      command.addAll(List.of("--max-players", "4", "--data", folder.resolve(name).toString()));
      command.addAll(List.of("--no-web", "--no-query", "--log-keep", "0", "--max-load", "0"));
      ProcessBuilder builder = new ProcessBuilder(command).redirectError(log().toFile());
      builder.environment().put(AgonesFlags.PORT, String.valueOf(sidecar.port()));
      server = builder.start();
      pods.add(this);
      server.getOutputStream().close();
    }

    Path log() {
      return folder.resolve(name + ".log");
    }

    String logged() {
      try {
        return Files.readString(log());
      } catch (IOException e) {
        return e.toString();
      }
    }

    void awaitReady() throws IOException {
      BufferedReader out =
          new BufferedReader(
              new InputStreamReader(server.getInputStream(), StandardCharsets.UTF_8));
      do {
        ready = out.readLine();
        assertNotNull(ready, this::logged);
      } while (!ready.startsWith("ready "));
    }
  }

  @AfterEach
  void end() {
    if (client != null) {
      client.close();
      transport.close();
    }
    for (Pod pod : pods) {
      pod.server.destroyForcibly();
      pod.sidecar.close();
    }
    if (etcd != null) {
      etcd.close();
    }
  }

  private void await(String what, BooleanSupplier condition) throws InterruptedException {
    long endNs = System.nanoTime() + TimeUnit.SECONDS.toNanos(60);
    while (!condition.getAsBoolean()) {
      assertTrue(
          System.nanoTime() < endNs,
          () -> {
            StringBuilder all = new StringBuilder(what);
            pods.forEach(p -> all.append('\n').append(p.sidecar.calls).append(p.logged()));
            return all.toString();
          });
      if (client != null) {
        client.update(System.nanoTime());
      }
      Thread.sleep(2);
    }
  }

  /** Returns ports that nobody has now: the pods' sidecars tell them before the servers begin. */
  private static int[] freePorts() throws IOException {
    int[] ports = new int[6];
    List<ServerSocket> held = new ArrayList<>();
    for (int i = 0; i < ports.length; i++) {
      held.add(new ServerSocket(0));
      ports[i] = held.get(i).getLocalPort();
    }
    for (ServerSocket socket : held) {
      socket.close();
    }
    return ports;
  }

  private boolean plays() {
    return client.view().phase() == ConnectionPhase.PLAYING;
  }

  @Test
  void podsBecomeAFleetAndLeaveItAsTheirLabelsAndSignalsSay() throws Exception {
    etcd = new EtcdProgram(folder, "http");
    int[] ports = freePorts();
    Pod a = new Pod("a", ports[0], ports[1], ports[2]);
    a.awaitReady();
    assertTrue(a.logged().contains("this server is 127.0.0.1:" + ports[0]), a.logged());
    assertEquals("ready tcp=" + ports[0] + " udp=" + ports[1], a.ready);
    await("ready", () -> a.logged().contains("told /ready"));
    assertEquals(List.of("POST /ready"), a.sidecar.states());
    int open = a.logged().indexOf("ready: tcp");
    assertTrue(open > 0 && open < a.logged().indexOf("told /ready"), a.logged());
    Pod b = new Pod("b", ports[3], ports[4], ports[5]);
    b.awaitReady();

    transport = new KryoClientTransport();
    ClientConfig config = ClientConfig.of("Ann").withServer("127.0.0.1", ports[0], 0);
    client = new GameClient(config, transport, new Bot(1, true));
    await("plays", this::plays);
    await("allocated", () -> a.sidecar.states().contains("POST /allocate"));
    await("the player is listed", () -> a.sidecar.playersNow().equals("Ann"));
    await("the room is counted", () -> a.sidecar.roomsNow().equals("1/2"));

    a.sidecar.label(AgonesService.SUPERSEDED, "true");
    await("moved", () -> b.sidecar.playersNow().equals("Ann"));
    await("a is given back", () -> a.sidecar.states().contains("POST /shutdown"));
    await("b is allocated", () -> b.sidecar.states().contains("POST /allocate"));
    await("plays on", this::plays);
    assertTrue(a.server.isAlive(), "Agones ends it");
    assertEquals("0/2", a.sidecar.roomsNow());

    a.server.destroy(); // SIGTERM, as Agones does
    await("ended", () -> !a.server.isAlive());
    assertEquals(
        List.of("POST /ready", "POST /allocate", "POST /shutdown"),
        a.sidecar.states(),
        "once is enough");
    b.server.destroy();
    await("ended", () -> !b.server.isAlive());
    List<String> calls = b.sidecar.calls;
    assertEquals("POST /shutdown", calls.get(calls.size() - 1), "the last word");
  }
}
