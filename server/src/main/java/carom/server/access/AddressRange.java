package carom.server.access;

import java.net.InetAddress;
import java.net.UnknownHostException;
import java.util.Arrays;
import java.util.Optional;
import java.util.regex.Pattern;

/** An address, or the network of addresses that begin with the same bits. Immutable. */
public final class AddressRange {
  /** Pattern of an address; a name would be looked up in the network. */
  private static final Pattern LITERAL =
      Pattern.compile("\\d{1,3}(\\.\\d{1,3}){3}|[0-9a-fA-F:.]*:[0-9a-fA-F:.]*");

  /** Pattern of a text that is meant as an address, also of one with a mistake. */
  private static final Pattern MEANT =
      Pattern.compile("\\d+(\\.\\d*)+(/.*)?|[0-9a-fA-F]*(:[0-9a-fA-F.]*){2,}(/.*)?");

  /** Prefix of the network that one household has. */
  private static final int IPV6_HOUSEHOLD = 64;

  /** The address, 4 or 16 bytes, zero behind the prefix. */
  private final byte[] first;

  /** Number of bits that addresses of the range share. */
  private final int prefix;

  private AddressRange(byte[] address, int prefix) {
    this.first = address.clone();
    this.prefix = prefix;
    for (int bit = prefix; bit < first.length * Byte.SIZE; bit++) {
      first[bit / Byte.SIZE] &= (byte) ~(0x80 >>> bit % Byte.SIZE);
    }
  }

  /**
   * Returns the range of a text such as {@code 203.0.113.7} or {@code 2001:db8::/48}, if it is one.
   */
  public static Optional<AddressRange> parse(String text) {
    int slash = text.indexOf('/');
    Optional<byte[]> address = bytes(slash < 0 ? text : text.substring(0, slash));
    if (address.isEmpty()) {
      return Optional.empty();
    }
    int bits = address.get().length * Byte.SIZE;
    try {
      int prefix = slash < 0 ? bits : Integer.parseInt(text.substring(slash + 1));
      return prefix < 1 || prefix > bits
          ? Optional.empty()
          : Optional.of(new AddressRange(address.get(), prefix));
    } catch (NumberFormatException e) {
      return Optional.empty();
    }
  }

  /** Returns whether a text looks like an address or a network, be it one or not. */
  static boolean isMeant(String text) {
    return MEANT.matcher(text).matches();
  }

  /** Returns what is wrong with a text that is no address. */
  public static String problem(String text) {
    return "address=" + text + " is no address such as 203.0.113.7 or 2001:db8::/48";
  }

  private static Optional<byte[]> bytes(String text) {
    try {
      return LITERAL.matcher(text).matches()
          ? Optional.of(InetAddress.getByName(text).getAddress())
          : Optional.empty();
    } catch (UnknownHostException e) {
      return Optional.empty();
    }
  }

  /** Returns the household of a link: its IPv4 address or its IPv6 network, if it has one. */
  static Optional<AddressRange> household(String remote) {
    return addressOf(remote)
        .map(
            bytes ->
                new AddressRange(
                    bytes, bytes.length == 4 ? bytes.length * Byte.SIZE : IPV6_HOUSEHOLD));
  }

  /**
   * Returns the bytes of a link's address: {@code 203.0.113.7:5000}, {@code [2001:db8::1]:5000}.
   */
  static Optional<byte[]> addressOf(String remote) {
    int port = remote.lastIndexOf(':');
    String address = port < 0 ? remote : remote.substring(0, port);
    return bytes(address.replaceAll("^/|[\\[\\]]|%.*", ""));
  }

  /**
   * Returns the bytes of an address with or without a port, as proxies write them: {@code
   * 203.0.113.7}, {@code 203.0.113.7:5000}, {@code 2001:db8::1}, {@code [2001:db8::1]:5000}.
   */
  public static Optional<byte[]> addressIn(String text) {
    if (text.startsWith("[")) {
      return addressOf(text.endsWith("]") ? text + ":0" : text);
    }
    Optional<byte[]> bare = bytes(text);
    return bare.isPresent() ? bare : addressOf(text);
  }

  /** Returns whether an address, 4 or 16 bytes, is in the range. */
  public boolean contains(byte[] address) {
    return address.length == first.length
        && Arrays.equals(new AddressRange(address, prefix).first, first);
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof AddressRange range
        && range.prefix == prefix
        && Arrays.equals(range.first, first);
  }

  @Override
  public int hashCode() {
    return Arrays.hashCode(first) + prefix;
  }

  @Override
  public String toString() {
    try {
      String address = InetAddress.getByAddress(first).getHostAddress();
      return prefix == first.length * Byte.SIZE ? address : address + "/" + prefix;
    } catch (UnknownHostException e) {
      throw new IllegalStateException(e); // can't happen with 4 or 16 bytes
    }
  }
}
