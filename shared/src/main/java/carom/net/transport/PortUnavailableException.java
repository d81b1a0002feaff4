package carom.net.transport;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.util.List;

/**
 * Failure to open a server's port. The message tells the operator which port, why, and which flag
 * chooses another one.
 */
public final class PortUnavailableException extends UncheckedIOException {
  private static final long serialVersionUID = 1;

  private final String protocol;
  private final int port;

  private PortUnavailableException(String protocol, int port, String message, IOException cause) {
    super(message, cause);
    this.protocol = protocol;
    this.port = port;
  }

  /**
   * Returns an exception that names the port that failed, of the two that a server opens. A second
   * attempt on TCP finds out which.
   *
   * @param failure what the system said, which needn't name the port
   * @param addresses of this machine, or empty for all of them
   * @param tcp the TCP port, 0..65,535
   * @param udp the UDP port, 0..65,535
   */
  public static PortUnavailableException of(
      IOException failure, List<InetAddress> addresses, int tcp, int udp) {
    for (InetAddress address : addresses) {
      if (isOurs(address)) {
        continue;
      }
      String name = address.getHostAddress();
      String text = name + " is no address of this machine; choose one with --bind";
      return new PortUnavailableException("TCP", tcp, text, failure);
    }
    try {
      if (addresses.isEmpty()) {
        new ServerSocket(tcp).close();
      }
      for (InetAddress address : addresses) {
        new ServerSocket(tcp, 1, address).close();
      }
    } catch (IOException x) {
      return explain("TCP", tcp, "--tcp-port", failure);
    }
    return explain("UDP", udp, "--udp-port", failure);
  }

  private static boolean isOurs(InetAddress address) {
    try {
      new ServerSocket(0, 1, address).close();
      return true;
    } catch (IOException x) {
      return false;
    }
  }

  private static PortUnavailableException explain(
      String protocol, int port, String flag, IOException failure) {
    String name = protocol + " port " + port;
    String text =
        String.valueOf(failure.getMessage()).contains("in use")
            ? name + " is busy: another server is probably running; stop it, or choose another port"
            : name + " can't be opened (" + failure.getMessage() + "); choose another port";
    return new PortUnavailableException(protocol, port, text + " with " + flag, failure);
  }

  /** Returns the protocol, {@code TCP} or {@code UDP}. */
  public String protocol() {
    return protocol;
  }

  /** Returns the requested port, 1..65,535, or 0 when the system had no free one. */
  public int port() {
    return port;
  }
}
