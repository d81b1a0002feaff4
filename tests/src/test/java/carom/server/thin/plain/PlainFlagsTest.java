package carom.server.thin.plain;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.options.Flags;
import carom.server.config.ServerConfig;
import java.net.InetAddress;
import java.util.List;
import org.junit.jupiter.api.Test;
import picocli.CommandLine;

final class PlainFlagsTest {
  private static String problem(String bind, String... args) throws Exception {
    CommandLine program = new CommandLine(CommandLine.Model.CommandSpec.create());
    Flags.add(program.getCommandSpec(), ServerConfig.ROWS);
    ServerConfig config =
        Flags.read(new ServerConfig(), program.parseArgs(args), ServerConfig.ROWS);
    List<InetAddress> addresses = bind.isEmpty() ? List.of() : List.of(InetAddress.getByName(bind));
    return PlainFlags.problem(config, addresses);
  }

  @Test
  void portsAreOneNumberOrTwo() throws Exception {
    assertNull(problem(""));
    assertNull(problem("", "--plain-port=54560"));
    assertNull(problem("", "--plain-port=54560:54780"));
    assertNull(problem("", "--plain-port=0:0"));
    for (String bad : List.of("x", "1:2:3", "54560:", ":5", "-1", "5 6", "9999999")) {
      assertTrue(problem("", "--plain-port=" + bad).contains("neither TCP nor TCP:UDP"), bad);
    }
    assertEquals("--plain-port=65536 is outside 0..65535", problem("", "--plain-port=54560:65536"));
    assertEquals("--plain-open needs --plain-port", problem("", "--plain-open"));
  }

  @Test
  void anAddressOfTheInternetNeedsAWord() throws Exception {
    assertNull(problem("192.168.1.5", "--plain-port=0"));
    assertNull(problem("0.0.0.0", "--plain-port=0"), "each client is looked at instead");
    assertTrue(
        problem("203.0.113.5", "--plain-port=0").contains("--bind=203.0.113.5 is no address"));
    assertNull(problem("203.0.113.5", "--plain-port=0", "--plain-open"));
  }

  @Test
  void privateNetworksAreToldFromTheInternet() throws Exception {
    for (String near :
        List.of(
            "127.0.0.1",
            "10.1.2.3",
            "172.16.0.1",
            "172.31.255.255",
            "192.168.0.9",
            "169.254.1.1",
            "100.64.0.1",
            "100.127.255.255",
            "::1",
            "fe80::1",
            "fd00::5",
            "::ffff:10.0.0.1")) {
      assertTrue(PrivateNetworks.contains(InetAddress.getByName(near)), near);
    }
    for (String far :
        List.of(
            "8.8.8.8",
            "172.15.0.1",
            "172.32.0.1",
            "192.167.0.1",
            "100.63.0.1",
            "100.128.0.1",
            "2001:db8::1",
            "fec0::1",
            "0.0.0.0")) {
      assertTrue(!PrivateNetworks.contains(InetAddress.getByName(far)), far);
    }
  }
}
