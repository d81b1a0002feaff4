package carom.client;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.client.link.ConnectionPhase;
import carom.net.kryo.KryoMessageCodec;
import carom.net.protocol.DatagramMark;
import carom.net.protocol.GoodbyeReason;
import carom.net.protocol.PackedLevel;
import carom.net.protocol.Protocol;
import carom.net.protocol.RefusalReason;
import carom.net.protocol.ServerMessage;
import carom.net.transport.InProcessNetwork;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/**
 * Goal: a player is told why a connection succeeds, waits or ends. Method: the client against a
 * scripted server.
 */
final class ConnectionTest {
  private final InProcessNetwork network = new InProcessNetwork(new KryoMessageCodec());
  private long now = 1_000_000L;
  private ScriptedServer server;
  private GameClient client;

  @BeforeEach
  void start() throws Exception {
    server = new ScriptedServer(network.server(), PredictionScenarioTest.arena());
    client = client(true);
  }

  private GameClient client(boolean reconnect) {
    return new GameClient(
        ClientConfig.of("tester")
            .withServer("memory", 0, 0)
            .with(ClientConfig.RECONNECT, reconnect),
        network.client(),
        InputSource.IDLE);
  }

  private void run(double seconds) {
    long end = now + (long) (seconds * 1e9);
    while (now < end) {
      now += ScriptedServer.TICK_NS;
      server.tick(now);
      client.update(now);
    }
  }

  private ConnectionPhase phase() {
    return client.view().phase();
  }

  private ScriptedServer.Guest guest(int index) {
    return server.guests.get(index);
  }

  @Test
  void leavesAGameWithOtherFieldsAndSaysWhich() {
    server.fields = List.of("player.shield count 0..9 to ALL");
    run(2);
    assertEquals(ConnectionPhase.ENDED, phase());
    String text = client.view().message();
    assertTrue(text.contains("field player.shield differs"), text);
    assertTrue(text.contains("use the same build of game arena"), text);
  }

  @Test
  void findsItsWayIntoTheGame() {
    assertEquals(ConnectionPhase.IDLE, phase());
    client.update(now);
    assertEquals(ConnectionPhase.JOINING, phase());
    run(1);
    assertEquals(ConnectionPhase.PLAYING, phase());
    assertEquals("", client.view().message());
    assertEquals("tester", guest(0).hello.name());
    assertEquals(Protocol.VERSION, guest(0).hello.protocolVersion());
    assertEquals(0, guest(0).hello.resumeSecret());
    assertEquals("arena", client.view().game());
    assertEquals("empty", client.view().level().name());
    assertEquals(5, client.view().level().statics().size());
    assertNotNull(client.view().own());
    assertEquals(1, client.view().loadingProgress());
    assertTrue(client.stats().snapshots() > 30);
  }

  @Test
  void tellsWhoPlaysAndWhatHappens() {
    run(1);
    guest(0)
        .link
        .send(
            new ServerMessage.Roster(
                List.of(
                    new ServerMessage.RosterEntry(0, "tester", 0, 3, false, false, true, 0, 0),
                    new ServerMessage.RosterEntry(4, "Ada", 0, 1, false, false, true, 0, 0))));
    for (int i = 0; i < 10; i++) {
      guest(0).link.send(new ServerMessage.Notice("line " + i));
    }
    run(0.1);
    assertEquals("Ada", client.view().playerName(4));
    assertEquals("", client.view().playerName(9));
    assertEquals(8, client.view().notices().size());
    assertEquals("line 9", client.view().notices().get(7).text());
  }

  @Test
  void explainsWhyItWasRefusedAndStaysOut() {
    server.script =
        new ScriptedServer.Script() {
          @Override
          boolean hello(ScriptedServer.Guest guest) {
            guest.link.send(
                new ServerMessage.Refused(RefusalReason.NAME_INVALID, "tester is no name"));
            return false;
          }
        };
    run(2);
    assertEquals(ConnectionPhase.ENDED, phase());
    assertTrue(client.view().message().contains(RefusalReason.NAME_INVALID.playerText()));
    assertTrue(client.view().message().contains("tester is no name"));
    assertEquals(1, server.guests.size());
  }

  @Test
  void givesUpOnAServerThatSaysNothing() {
    server.script =
        new ScriptedServer.Script() {
          @Override
          boolean hello(ScriptedServer.Guest guest) {
            return false;
          }
        };
    run(9);
    assertEquals(ConnectionPhase.JOINING, phase());
    run(2);
    assertEquals(ConnectionPhase.ENDED, phase());
    assertTrue(client.view().message().contains("Is it a Carom server?"), client.view().message());
  }

  @Test
  void saysWhenNothingListens() {
    network.server().close();
    run(0.1);
    assertEquals(ConnectionPhase.ENDED, phase());
    assertTrue(client.view().message().startsWith("Can't reach the server: "));
  }

  @Test
  void refusesALevelThatIsNotTheOnePromised() {
    server.script =
        new ScriptedServer.Script() {
          @Override
          void level(ScriptedServer.Guest guest, int offset) {
            byte[] bytes = PackedLevel.pack(guest.server().level.source());
            bytes[bytes.length - 2] = ' '; // after the last bracket: parses, but is another file
            bytes[9] ^= 1;
            guest.link.send(new ServerMessage.LevelChunk(0, bytes));
          }
        };
    run(1);
    assertEquals(ConnectionPhase.ENDED, phase());
    assertFalse(client.view().message().isEmpty());
  }

  @Test
  void comesBackWithItsSecretWhenTheLinkBreaks() {
    run(1);
    guest(0).link.close("cable cut");
    run(0.1);
    assertEquals(ConnectionPhase.RECONNECTING, phase());
    assertTrue(client.view().message().contains("was lost: "), client.view().message());
    assertTrue(client.view().message().endsWith("Reconnecting ..."), client.view().message());
    assertTrue(client.view().entityCount() > 0, "the last picture stays");
    run(1);
    assertEquals(ConnectionPhase.PLAYING, phase());
    assertEquals(77, guest(1).hello.resumeSecret());
    assertEquals(0, guest(1).levelRequests, "the level is here already");
    assertEquals(1, client.stats().reconnects());
    run(1);
    assertNotNull(client.view().own());
  }

  @Test
  void noticesASilentServerAndComesBack() {
    run(1);
    server.silent = true;
    run(5.2);
    assertEquals(ConnectionPhase.PLAYING, phase(), "5 s without a datagram are survived");
    run(1);
    assertEquals(ConnectionPhase.RECONNECTING, phase());
    server.silent = false;
    run(2);
    assertEquals(ConnectionPhase.PLAYING, phase());
  }

  @Test
  void waitsLongerFromAttemptToAttemptAndGivesUpInTheEnd() {
    run(1);
    guest(0).link.close("gone");
    server.script =
        new ScriptedServer.Script() {
          @Override
          boolean hello(ScriptedServer.Guest guest) {
            guest.link.send(new ServerMessage.Refused(RefusalReason.SHUTTING_DOWN, ""));
            return false;
          }
        };
    run(20);
    int attempts = server.guests.size() - 1;
    assertTrue(attempts >= 5 && attempts <= 9, "attempts=" + attempts);
    run(80);
    assertEquals(ConnectionPhase.ENDED, phase());
    assertTrue(client.view().message().contains("did not come back"), client.view().message());
  }

  @Test
  void staysOutWhenItWasThrownOut() {
    run(1);
    guest(0).link.send(new ServerMessage.Goodbye(GoodbyeReason.KICKED, "no cheating"));
    run(2);
    assertEquals(ConnectionPhase.ENDED, phase());
    assertTrue(client.view().message().contains("no cheating"));
    assertEquals(1, server.guests.size());
  }

  @Test
  void comesBackAfterARestart() {
    run(1);
    guest(0).link.send(new ServerMessage.Goodbye(GoodbyeReason.SERVER_STOPPING, ""));
    run(3);
    assertEquals(ConnectionPhase.PLAYING, phase());
    assertEquals(2, server.guests.size());
  }

  @Test
  void endsWhenToldNotToComeBack() {
    client = client(false);
    run(1);
    guest(0).link.close("gone");
    run(1);
    assertEquals(ConnectionPhase.ENDED, phase());
  }

  @Test
  void saysGoodbyeWhenItLeaves() {
    run(1);
    client.close();
    server.tick(now);
    assertTrue(guest(0).closed);
    assertEquals(ConnectionPhase.ENDED, phase());
    client.close();
    run(1);
    assertEquals(1, server.guests.size());
  }

  @Test
  void survivesGarbage() {
    run(1);
    byte[] garbage = new byte[300];
    for (int i = 0; i < 200; i++) {
      new java.util.SplittableRandom(i).nextBytes(garbage);
      // With the right mark and a number to come, so that it is read.
      int head = (5_000 + i) << DatagramMark.BITS | DatagramMark.ofState(ScriptedServer.EPOCH);
      garbage[0] = (byte) head;
      garbage[1] = (byte) (head >> 8);
      garbage[2] = (byte) (garbage[2] & 0xf0 | head >> 16);
      if (i % 2 == 1) { // no feedback and no own section, whose baseline would be missing
        garbage[4] &= (byte) ~0x60;
      }
      guest(0).link.sendDatagram(garbage, 0, 1 + i);
    }
    run(1);
    assertEquals(ConnectionPhase.PLAYING, phase());
    assertTrue(client.stats().malformed() > 150, "malformed=" + client.stats().malformed());
  }
}
