package carom.scenario;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.client.InputSource;
import carom.client.bots.Bot;
import carom.client.link.ConnectionPhase;
import carom.net.transport.Impairment;
import carom.physics.Body;
import carom.sim.entity.HostEntity;
import carom.suite.Needs;
import carom.testkit.Condition;
import carom.testkit.Scripts;
import carom.testkit.SimulatedClient;
import carom.testkit.Stepper;
import java.io.IOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.Socket;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Goal: what holds in memory holds over KryoNet. Method: the same stepper over real TCP and UDP
 * sockets on loopback, on free ports, in real time; each test takes a few seconds.
 */
@Needs("sockets")
@Timeout(40)
class SocketScenarioTest {
  @ParameterizedTest
  @ValueSource(strings = {"arena", "platformer"})
  void playersJoinMoveAndLeave(String game) {
    // Goal: the way in, the way through and the way out. Method: two players; one holds the stick
    // to one side; the other leaves.
    try (Stepper stepper = Stepper.overSockets(game)) {
      SimulatedClient mover = stepper.join("mover", Impairment.NONE, InputSource.IDLE);
      SimulatedClient other = stepper.join("other", Impairment.NONE, InputSource.IDLE);
      stepper.run(0.5);
      Body<HostEntity> body = stepper.body(mover).body();
      float startX = body.x();
      mover.play(Scripts.hold(startX < 0 ? 1 : -1, 0));
      stepper.runUntil("the server moves the body", () -> Math.abs(body.x() - startX) > 0.5, 3);
      mover.play(InputSource.IDLE);
      stepper.run(0.5);
      assertEquals(body.x(), mover.view().own().x(), 0.01);
      int id = other.view().playerId();
      other.leave();
      stepper.runUntil("it is seen", () -> mover.view().players().size() == 1, 3);
      assertNull(stepper.room().simulation().player(id));
      assertEquals(ConnectionPhase.ENDED, other.view().phase());
    }
  }

  @ParameterizedTest
  @EnumSource(
      value = Condition.class,
      names = {"CLEAN", "LOSS_10_PERCENT", "LATENCY_100_JITTER_50", "MIXED"})
  void twoClientsAgreeWithTheServerExactly(Condition condition) {
    // Goal: every state decoded is the server's. Method: two bots, four seconds.
    try (Stepper stepper = Stepper.overSockets("arena")) {
      for (int i = 0; i < 2; i++) {
        stepper.join("bot" + i, condition.impairment(Stepper.SEED), new Bot(i));
      }
      stepper.run(4);
      for (SimulatedClient client : stepper.clients()) {
        String about = condition + " " + stepper.describe();
        assertEquals(ConnectionPhase.PLAYING, client.view().phase(), about);
        assertEquals(0, client.stats().malformed(), about);
        assertEquals(0, client.stats().reconnects(), about);
        assertTrue(client.compared() > 200, "compared=" + client.compared() + " " + about);
      }
    }
  }

  @Test
  void afterARestartOfTheServerTheClientsComeBack() {
    // Goal: a restart on the same ports. Method: stop, half a second, start again.
    try (Stepper stepper = Stepper.overSockets("arena")) {
      for (int i = 0; i < 2; i++) {
        stepper.join("bot" + i, Impairment.NONE, new Bot(i));
      }
      stepper.stopServer();
      stepper.run(0.5);
      for (SimulatedClient client : stepper.clients()) {
        assertEquals(ConnectionPhase.RECONNECTING, client.view().phase(), client::toString);
      }
      stepper.startServer();
      stepper.clients().forEach(stepper::awaitPlaying);
      stepper.run(0.5);
      for (SimulatedClient client : stepper.clients()) {
        assertEquals(1, client.stats().reconnects(), client::toString);
      }
    }
  }

  @Test
  void whoseLineBreaksComesBackToTheSameBody() {
    // Goal: resuming works over sockets. Method: close the client's link in the middle of play.
    try (Stepper stepper = Stepper.overSockets("arena")) {
      SimulatedClient client = stepper.join("p", Impairment.NONE, InputSource.IDLE);
      HostEntity body = stepper.body(client);
      client.cut();
      stepper.run(0.1);
      stepper.awaitPlaying(client);
      assertEquals(1, client.stats().reconnects());
      assertSame(body, stepper.body(client));
    }
  }

  @Test
  void garbageOnBothPortsGoesUnnoticed() throws IOException {
    // Goal: strangers with raw sockets disturb nobody. Method: random bytes on TCP and UDP, some
    // connections left half open, while one plays.
    try (Stepper stepper = Stepper.overSockets("arena")) {
      SimulatedClient client = stepper.join("p", Impairment.NONE, Scripts.wander(Stepper.SEED));
      stepper.run(0.5);
      Random random = new Random(Stepper.SEED);
      InetAddress loopback = InetAddress.getLoopbackAddress();
      Socket halfOpen = new Socket(loopback, stepper.tcpPort());
      try (DatagramSocket udp = new DatagramSocket()) {
        for (int round = 0; round < 30; round++) {
          byte[] bytes = new byte[1 + random.nextInt(600)];
          random.nextBytes(bytes);
          udp.send(new DatagramPacket(bytes, bytes.length, loopback, stepper.udpPort()));
          udp.send(new DatagramPacket(new byte[1], 1, loopback, stepper.udpPort()));
          try (Socket tcp = new Socket(loopback, stepper.tcpPort())) {
            tcp.getOutputStream().write(bytes);
            stepper.run(0.05);
          } catch (IOException e) {
            stepper.run(0.05); // the server was quicker to close it than we to write
          }
        }
      } finally {
        halfOpen.close();
      }
      String about = stepper.describe() + " seed=" + Stepper.SEED;
      assertEquals(ConnectionPhase.PLAYING, client.view().phase(), about);
      assertEquals(0, client.stats().reconnects(), about);
      assertEquals(0, client.stats().malformed(), about);
      assertTrue(client.stats().snapshots() > 60, about);
      assertEquals(1, client.view().players().size(), about);
    }
  }
}
