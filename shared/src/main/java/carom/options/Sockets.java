package carom.options;

import java.net.InetAddress;
import java.net.UnknownHostException;

/** Checks of the flags that say where a socket listens, or where others reach it. */
public final class Sockets {
  /** Highest port. */
  public static final int MAX_PORT = 65_535;

  /** Part of a pattern: a name, an IPv4 address, or an IPv6 address in brackets. */
  public static final String HOST = "\\[[\\da-fA-F:.]+]|[-.\\w]+";

  private Sockets() {}

  /**
   * Returns whether others can connect to a port, 1..65,535; no port at all is right, too.
   *
   * @param digits one to five of them, or null
   */
  public static boolean isReachable(String digits) {
    int port = digits == null ? 1 : Integer.parseInt(digits);
    return port >= 1 && port <= MAX_PORT;
  }

  /**
   * Returns what is wrong with a port, or null.
   *
   * @param flag name of the flag, such as {@code --tcp-port}
   * @param port its value; 0 asks for any free port
   */
  public static String portProblem(String flag, int port) {
    return port >= 0 && port <= MAX_PORT ? null : flag + "=" + port + " is outside 0.." + MAX_PORT;
  }

  /** Returns what is wrong with an address or host name of this machine, or null. */
  public static String addressProblem(String flag, String address) {
    try {
      InetAddress.getByName(address);
      return null;
    } catch (UnknownHostException e) {
      return flag + "=" + address + " is no address; give one such as 127.0.0.1 or ::1";
    }
  }

  /** Returns the first problem that isn't null, or null. */
  public static String first(String... problems) {
    for (String problem : problems) {
      if (problem != null) {
        return problem;
      }
    }
    return null;
  }
}
