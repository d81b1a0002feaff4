package carom.net.kryo;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import carom.net.kryo.server.KryoLimits;
import carom.net.kryo.server.KryoServerTransport;
import carom.net.kryo.server.ProxyRule;
import carom.net.kryo.server.ServerIdentity;
import carom.net.seal.Encryption;
import carom.net.transport.Impairment;
import carom.net.transport.Link;
import carom.suite.Needs;
import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Goal: ports are open where the operator said, and nowhere else. */
@Needs("sockets")
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
  void severalAddressesHaveTheSamePortsAndEachAnswersFromItself() throws Exception {
    List<InetAddress> two =
        List.of(InetAddress.getByName("127.0.0.2"), InetAddress.getByName("127.0.0.3"));
    ServerIdentity identity = ServerIdentity.temporary(Encryption.ON);
    try (KryoServerTransport server =
            new KryoServerTransport(
                two, 0, 0, KryoLimits.DEFAULT, identity, Impairment.NONE, ProxyRule.NONE);
        KryoClientTransport clients = new KryoClientTransport()) {
      for (InetAddress address : two) {
        Link link = clients.connect(address.getHostAddress(), server.tcpPort(), server.udpPort());
        Network.eventually(
            () -> link.poll(new Network.Inbox(), 1) >= 0 && link.state() == Link.State.OPEN,
            () -> address + " is " + link.state());
      }
      assertEquals(
          "false false",
          isOpen("127.0.0.1", server.tcpPort()) + " " + isOpen("127.0.0.4", server.tcpPort()));
    }
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
