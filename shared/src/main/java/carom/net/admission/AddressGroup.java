package carom.net.admission;

import java.net.Inet6Address;
import java.net.InetAddress;
import java.net.UnknownHostException;
import java.util.HexFormat;

/**
 * The group of addresses that a connection comes from. Two addresses of one household have the same
 * host, because a household gets a whole IPv6 network. Immutable; equal for equal groups.
 *
 * @param host an IPv4 address, or an IPv6 /64 network
 * @param network an IPv4 /24 network, or an IPv6 /64 network
 */
public record AddressGroup(String host, String network) {
  private static final int HOUSEHOLD_BYTES = 8;

  /** Returns the origin of an address. */
  public static AddressGroup of(InetAddress address) {
    if (address instanceof Inet6Address) {
      String household = HexFormat.of().formatHex(address.getAddress(), 0, HOUSEHOLD_BYTES) + "/64";
      return new AddressGroup(household, household);
    }
    String host = address.getHostAddress();
    return new AddressGroup(host, host.substring(0, host.lastIndexOf('.')) + "/24");
  }

  /** Returns an address and port as {@code Link.remote()} has them, see {@link #ofRemote}. */
  public static String remote(InetAddress address, int port) {
    String host = address.getHostAddress();
    return (host.indexOf(':') < 0 ? host : "[" + host + "]") + ":" + port;
  }

  /**
   * Returns the origin of a link by its {@code remote()}: {@code 192.0.2.7:5000} or {@code
   * [2001:db8::1]:5000}. A link of this process has a name instead, which is a group of its own.
   */
  public static AddressGroup ofRemote(String remote) {
    int port = remote.lastIndexOf(':');
    String text = port < 0 ? remote : remote.substring(0, port);
    boolean isAddress = text.startsWith("[") || text.matches("[0-9]{1,3}(\\.[0-9]{1,3}){3}");
    try {
      return isAddress ? of(InetAddress.getByName(text)) : new AddressGroup(text, text);
    } catch (UnknownHostException e) {
      return new AddressGroup(text, text);
    }
  }
}
