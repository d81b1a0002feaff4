package carom.server.thin.plain;

import java.net.Inet4Address;
import java.net.Inet6Address;
import java.net.InetAddress;

/** Tells addresses that only machines nearby can have from those of the whole internet. */
final class PrivateNetworks {
  private PrivateNetworks() {}

  /**
   * Returns whether an address is of this machine, of a private network (10.0.0.0/8, 172.16.0.0/12,
   * 192.168.0.0/16, fc00::/7), of the link, or of a provider's or VPN's shared range
   * (100.64.0.0/10).
   */
  public static boolean contains(InetAddress address) {
    if (address.isLoopbackAddress() || address.isLinkLocalAddress()) {
      return true;
    }
    byte[] bytes = address.getAddress();
    if (address instanceof Inet6Address) {
      return (bytes[0] & 0xfe) == 0xfc;
    }
    return address instanceof Inet4Address
        && (address.isSiteLocalAddress() || ((bytes[0] & 0xff) == 100 && (bytes[1] & 0xc0) == 64));
  }
}
