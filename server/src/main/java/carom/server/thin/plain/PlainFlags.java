package carom.server.thin.plain;

import carom.options.Sockets;
import carom.server.config.ServerConfig;
import java.io.IOException;
import java.net.InetAddress;
import java.util.List;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** The server's flags about programs with stock KryoNet. */
public final class PlainFlags {
  private PlainFlags() {}

  /**
   * Returns what is wrong with the flags, or null.
   *
   * @param addresses of this machine on which ports are open; empty for all
   */
  public static String problem(ServerConfig config, List<InetAddress> addresses) {
    String ports = config.get(ServerConfig.PLAIN_PORT);
    boolean open = config.get(ServerConfig.PLAIN_OPEN);
    if (ports == null) {
      return open ? "--plain-open needs --plain-port" : null;
    }
    if (!ports.matches("[0-9]{1,6}(:[0-9]{1,6})?")) {
      return "--plain-port=" + ports + " is neither TCP nor TCP:UDP, such as 54560:54780";
    }
    for (String port : ports.split(":")) {
      String problem = Sockets.portProblem("--plain-port", Integer.parseInt(port));
      if (problem != null) {
        return problem;
      }
    }
    for (InetAddress address : addresses) {
      if (!open && !address.isAnyLocalAddress() && !PrivateNetworks.contains(address)) {
        return "--plain-port isn't encrypted, and --bind="
            + address.getHostAddress()
            + " is no address of a private network; bind another, or open it all the same with"
            + " --plain-open";
      }
    }
    return null;
  }

  /**
   * Returns the address of an open door as clients are told it, host:tcp or host:tcp:udp; empty
   * without one.
   *
   * @param host by which players reach this server
   */
  public static String address(String host, PlainDoor door) {
    return door == null
        ? ""
        : host + ":" + door.tcpPort() + (door.udpPort() > 0 ? ":" + door.udpPort() : "");
  }

  /**
   * Opens the door, or returns null if the operator doesn't want one.
   *
   * @param addresses of this machine; empty for all
   * @throws IOException when a port can't be opened; the message says what to do
   */
  public static PlainDoor open(ServerConfig config, List<InetAddress> addresses)
      throws IOException {
    String ports = config.get(ServerConfig.PLAIN_PORT);
    boolean open = config.get(ServerConfig.PLAIN_OPEN);
    if (ports == null) {
      return null;
    }
    // Not a constant: this class is loaded while the log starts.
    Logger log = LoggerFactory.getLogger(PlainFlags.class);
    String[] numbers = ports.split(":");
    int tcp = Integer.parseInt(numbers[0]);
    int udp = numbers.length == 1 ? -1 : Integer.parseInt(numbers[1]);
    try {
      PlainDoor door = new PlainDoor(addresses, tcp, udp, PlainLimits.DEFAULT, open);
      log.info(
          "plain: tcp {}{} for stock KryoNet, not encrypted, {}",
          door.tcpPort(),
          udp < 0 ? "" : " udp " + door.udpPort(),
          open ? "open to everybody" : "from private networks only");
      return door;
    } catch (IOException e) {
      throw new IOException(e.getMessage() + "; choose another port with --plain-port", e);
    }
  }
}
