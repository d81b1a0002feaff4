package carom.server;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.net.kryo.server.KryoLimits;
import carom.net.kryo.server.KryoServerTransport;
import carom.net.kryo.server.ServerIdentity;
import carom.net.protocol.ServerMessage;
import carom.net.seal.Encryption;
import carom.suite.Needs;
import java.net.InetAddress;
import java.net.ServerSocket;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Goal: nobody is sent to a dead end. Method: a real server, and ports that are none. */
@Needs("sockets")
@Timeout(30)
final class ServerProbeTest {
  private static String problem(String server, String fingerprint) {
    return ServerProbe.problem(new ServerMessage.Redirect(server, fingerprint, "", ""));
  }

  @Test
  void aServerAnswersWithItsKey() {
    ServerIdentity identity = ServerIdentity.temporary(Encryption.ON);
    try (KryoServerTransport server =
        new KryoServerTransport(null, 0, 0, KryoLimits.DEFAULT, identity)) {
      String address = "127.0.0.1:" + server.tcpPort();
      assertNull(problem(address, ""));
      assertNull(problem(address, identity.fingerprint()));
      String other = ServerIdentity.temporary(Encryption.ON).fingerprint();
      assertEquals(
          "server=%s doesn't answer; tried 127.0.0.1 tcp %s: its fingerprint is %s"
              .formatted(address, address.substring(10), identity.fingerprint()),
          problem(address, other));
    }
  }

  @Test
  void whatIsNoServerIsNamedWithWhatWasTried() throws Exception {
    int free;
    try (ServerSocket silent = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
      free = silent.getLocalPort();
      String said = problem("127.0.0.1:" + free, "");
      assertTrue(said.contains("tried 127.0.0.1 tcp " + free + ": "), said);
    }
    String said = problem("127.0.0.1:" + free, "");
    assertTrue(said.contains("tried 127.0.0.1 tcp " + free + ": Connection refused"), said);
    said = problem("no-such-host.invalid:5", "");
    assertTrue(said.contains("the name no-such-host.invalid has no address"), said);
  }
}
