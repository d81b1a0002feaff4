package carom.net.kryo;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import carom.net.kryo.server.KryoLimits;
import carom.net.kryo.server.KryoServerTransport;
import carom.net.kryo.server.ServerIdentity;
import carom.net.seal.Encryption;
import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import org.junit.jupiter.api.Test;

/** Goal: ports are open where the operator said, and nowhere else. */
final class BindTest {
  private static boolean isOpen(String host, int port) {
    try (Socket socket = new Socket(host, port)) {
      return socket.isConnected();
    } catch (IOException e) {
      return false;
    }
  }

  private static KryoServerTransport at(String address) throws IOException {
    return new KryoServerTransport(
        address == null ? null : InetAddress.getByName(address),
        0,
        0,
        KryoLimits.DEFAULT,
        ServerIdentity.temporary(Encryption.ON));
  }

  @Test
  void allAddressesOfIpv4AreNoneOfIpv6() throws IOException {
    try (ServerSocket probe = new ServerSocket(0, 1, InetAddress.getByName("::1"))) {
      assumeTrue(isOpen("::1", probe.getLocalPort()));
    } catch (IOException noIpv6) {
      assumeTrue(false, "no IPv6 here");
    }
    try (KryoServerTransport all = at(null);
        KryoServerTransport four = at("0.0.0.0");
        KryoServerTransport one = at("127.0.0.1")) {
      assertEquals(
          "true true", isOpen("127.0.0.1", all.tcpPort()) + " " + isOpen("::1", all.tcpPort()));
      assertEquals(
          "true false", isOpen("127.0.0.2", four.tcpPort()) + " " + isOpen("::1", four.tcpPort()));
      assertEquals(
          "true false",
          isOpen("127.0.0.1", one.tcpPort()) + " " + isOpen("127.0.0.2", one.tcpPort()));
    }
  }
}
