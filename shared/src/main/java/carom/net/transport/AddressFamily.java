package carom.net.transport;

import java.net.Inet4Address;
import java.net.InetAddress;
import java.net.ProtocolFamily;
import java.net.StandardProtocolFamily;

/** The family of addresses at which a port is open. */
public final class AddressFamily {
  private AddressFamily() {}

  /**
   * Returns the family for a port at an address of this machine: of {@code 0.0.0.0} and other IPv4
   * addresses IPv4 alone. Java would take {@code 0.0.0.0} for all addresses, also those of IPv6.
   *
   * @param address the address that was named, or null if none was
   * @return null for all families that the system has
   */
  public static ProtocolFamily of(InetAddress address) {
    return address instanceof Inet4Address ? StandardProtocolFamily.INET : null;
  }
}
