package carom.client.link;

/**
 * Address of a server.
 *
 * @param host name or address
 * @param tcpPort 1..65,535; 0 for an in-process transport, which has no ports
 * @param udpPort 1..65,535, or 0 for the one that the server tells over TCP
 */
public record ServerAddress(String host, int tcpPort, int udpPort) {
  /** TCP port a server uses unless told otherwise. */
  public static final int DEFAULT_TCP_PORT = 54_555;

  /** UDP port that stands for the one that the server tells. */
  public static final int TOLD_UDP_PORT = 0;

  /** Returns the address for people: the host and, if there is one, the TCP port. */
  @Override
  public String toString() {
    return host + (tcpPort == 0 ? "" : ":" + tcpPort);
  }

  /**
   * Returns the address that a text names: {@code host}, {@code host:port} or {@code
   * host:port/udpPort}, where a host that has colons stands in brackets. The UDP port is only for
   * servers behind a router that shows another one than the server tells.
   *
   * @throws IllegalArgumentException in words for the player, when the text names no address
   */
  public static ServerAddress parse(String text) {
    String address = text.strip();
    int close = address.startsWith("[") ? address.indexOf(']') : -1;
    String bracketed = bracketed(address);
    if (bracketed != null) {
      throw new IllegalArgumentException(
          "\"" + address + "\" is ambiguous: write " + bracketed + " to name its port.");
    }
    boolean bare = close < 0 && address.indexOf(':') != address.lastIndexOf(':');
    int colon = bare ? -1 : address.indexOf(':', Math.max(0, close));
    String host = colon < 0 ? address : address.substring(0, colon);
    host = close > 0 ? host.substring(1, close) : host;
    if (host.isEmpty()
        || address.contains("//")
        || host.chars().anyMatch(c -> c <= ' ' || c == ',')) {
      throw new IllegalArgumentException(
          "Enter the server's name or address, for instance localhost or play.example.org:54555.");
    }
    if (colon < 0) {
      return new ServerAddress(host, DEFAULT_TCP_PORT, TOLD_UDP_PORT);
    }
    String[] ports = address.substring(colon + 1).split("/", -1);
    if (ports.length > 2) {
      throw badPort(address.substring(colon + 1));
    }
    int udp = ports.length == 2 ? port(ports[1]) : TOLD_UDP_PORT;
    return new ServerAddress(host, port(ports[0]), udp);
  }

  /**
   * Returns how to write a text that looks like an IPv6 address without brackets and a port, or
   * null if it doesn't: its last part is no group of an address, or there are too many.
   */
  private static String bracketed(String text) {
    int colon = text.lastIndexOf(':');
    if (text.startsWith("[") || colon < 0 || text.indexOf(':') == colon) {
      return null;
    }
    String host = text.substring(0, colon);
    String port = text.substring(colon + 1);
    boolean hasPort = port.matches("\\d{5}|\\d+/\\d+") || text.split(":", -1).length > 8;
    return hasPort ? "[" + host + "]:" + port : null;
  }

  private static int port(String text) {
    try {
      int port = Integer.parseInt(text);
      if (port >= 1 && port <= 65_535) {
        return port;
      }
    } catch (NumberFormatException notANumber) {
      // told below
    }
    throw badPort(text);
  }

  private static IllegalArgumentException badPort(String text) {
    return new IllegalArgumentException(
        "\"" + text + "\" is no port: a port is a number from 1 to 65535; the usual one is 54555.");
  }

  /** Returns the shortest text from which {@link #parse} makes this address. */
  public String toText() {
    String shown = host.contains(":") ? "[" + host + "]" : host;
    if (udpPort != TOLD_UDP_PORT) {
      return shown + ":" + tcpPort + "/" + udpPort;
    }
    return tcpPort == DEFAULT_TCP_PORT ? shown : shown + ":" + tcpPort;
  }
}
