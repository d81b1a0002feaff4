package carom.client;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.client.link.ConnectionPhase;
import carom.net.kryo.KryoMessageCodec;
import carom.net.protocol.ServerMessage;
import carom.net.transport.ClientTransport;
import carom.net.transport.InProcessNetwork;
import carom.net.transport.Link;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/**
 * Goal: a client that is sent to another server plays there, and takes nothing of the session
 * along. Method: the client and two scripted servers, whose addresses differ by the port.
 */
final class RedirectTest {
  private static final String FINGERPRINT = "a".repeat(43);

  private final List<InProcessNetwork> networks = new ArrayList<>();
  private final List<ScriptedServer> servers = new ArrayList<>();
  private final List<String> expected = new ArrayList<>();
  private long now = 1_000_000L;
  private GameClient client;

  private final ClientTransport transport =
      new ClientTransport() {
        @Override
        public Link connect(String host, int tcpPort, int udpPort) {
          return networks.get(tcpPort - 1).client().connect(host, tcpPort, udpPort);
        }

        @Override
        public void expect(String server, String fingerprint) {
          expected.add(server + " " + fingerprint);
        }

        @Override
        public void close() {}
      };

  @BeforeEach
  void start() throws Exception {
    for (int i = 0; i < 2; i++) {
      networks.add(new InProcessNetwork(new KryoMessageCodec()));
      servers.add(new ScriptedServer(networks.get(i).server(), PredictionScenarioTest.arena()));
    }
    client =
        new GameClient(
            ClientConfig.of("tester")
                .withServer("a.example.org", 1, 0)
                .with(ClientConfig.TOKEN, "for-a"),
            transport,
            InputSource.IDLE);
    run(1);
    assertEquals(ConnectionPhase.PLAYING, client.view().phase(), client.view().message());
  }

  private void run(double seconds) {
    long end = now + (long) (seconds * 1e9);
    while (now < end) {
      now += ScriptedServer.TICK_NS;
      servers.forEach(server -> server.tick(now));
      client.update(now);
    }
  }

  private ScriptedServer.Guest newest(int server) {
    List<ScriptedServer.Guest> guests = servers.get(server).guests;
    return guests.get(guests.size() - 1);
  }

  private void redirect(int from, int to, String token) {
    newest(from)
        .link
        .send(
            new ServerMessage.Redirect(
                "a.example.org:" + (to + 1), to == 1 ? FINGERPRINT : "", "cup", token));
  }

  @Test
  void itPlaysThereAsANewcomer() {
    assertEquals("for-a", newest(0).hello.token());
    redirect(0, 1, "for-b");
    now += ScriptedServer.TICK_NS;
    servers.get(0).tick(now);
    client.update(now);
    String text = client.view().message();
    assertTrue(text.startsWith("The server at a.example.org:1 sends you to a.example.org:2"), text);
    run(1);
    assertEquals(ConnectionPhase.PLAYING, client.view().phase());
    assertEquals("", client.view().message());
    assertEquals(List.of("a.example.org:2 " + FINGERPRINT), expected);
    assertEquals("tester", newest(1).hello.name());
    assertEquals("cup", newest(1).hello.room());
    assertEquals("for-b", newest(1).hello.token());
    assertEquals(0, newest(1).hello.resumeSecret(), "the secret is the first server's");
    assertTrue(newest(0).closed, "the first link is closed");
    int heard = client.view().tick();
    run(0.5);
    assertNotEquals(heard, client.view().tick(), "it goes on");
  }

  @Test
  void aTokenIsNeverPassedOn() {
    redirect(0, 1, "");
    run(1);
    assertEquals("", newest(1).hello.token());
  }

  @Test
  void itEndsWhenServersSendItAround() {
    for (int i = 0; i < 3; i++) {
      redirect(i % 2, (i + 1) % 2, "");
      run(1);
      assertEquals(ConnectionPhase.PLAYING, client.view().phase(), "redirect " + i);
    }
    redirect(1, 0, "");
    run(1);
    assertEquals(ConnectionPhase.ENDED, client.view().phase());
    String text = client.view().message();
    assertTrue(text.contains("4 times within a minute, last to a.example.org:1"), text);
  }

  @Test
  void aServerThatIsDownIsTriedAgain() {
    networks.set(1, new InProcessNetwork(new KryoMessageCodec()));
    networks.get(1).server().close();
    redirect(0, 1, "");
    run(3);
    assertEquals(ConnectionPhase.RECONNECTING, client.view().phase());
    String text = client.view().message();
    assertTrue(text.startsWith("The server at a.example.org:1 sends you to a.example.org:2"), text);
    networks.set(1, new InProcessNetwork(new KryoMessageCodec()));
    servers.set(1, new ScriptedServer(networks.get(1).server(), servers.get(0).level));
    run(6);
    assertEquals(ConnectionPhase.PLAYING, client.view().phase());
  }
}
