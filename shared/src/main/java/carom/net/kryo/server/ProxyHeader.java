package carom.net.kryo.server;

import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.UnknownHostException;
import java.nio.ByteBuffer;
import java.util.Arrays;

/**
 * The header by which a proxy tells where a connection comes from: the PROXY protocol, version 2,
 * for TCP. It is 12 bytes of signature, version and command (1), family (1), the length of the rest
 * (2), and the rest: both addresses, both ports, and whatever else the proxy likes to tell.
 */
final class ProxyHeader {
  /** Bytes up to the rest. */
  static final int HEAD_BYTES = 16;

  /** Most bytes of the rest. Addresses take 36; proxies add names and checksums. */
  static final int MOST_REST_BYTES = 520;

  private static final byte[] SIGNATURE = {
    0x0d, 0x0a, 0x0d, 0x0a, 0x00, 0x0d, 0x0a, 0x51, 0x55, 0x49, 0x54, 0x0a
  };
  private static final int LOCAL = 0x20;
  private static final int PROXY = 0x21;
  private static final int TCP_IPV4 = 0x11;
  private static final int TCP_IPV6 = 0x21;

  private final ByteBuffer bytes = ByteBuffer.allocate(HEAD_BYTES + MOST_REST_BYTES);

  /** Creates a header of which nothing has come. */
  ProxyHeader() {
    bytes.limit(HEAD_BYTES);
  }

  /** Returns where the next bytes go. No byte behind the header fits in. */
  ByteBuffer target() {
    return bytes;
  }

  /**
   * Looks at what has come.
   *
   * @return whether the header is there as a whole
   * @throws IllegalArgumentException if this is no such header; the message says why
   */
  boolean isWhole() {
    if (bytes.position() < HEAD_BYTES) {
      int length = Math.min(bytes.position(), SIGNATURE.length);
      require(
          Arrays.equals(bytes.array(), 0, length, SIGNATURE, 0, length),
          "it doesn't begin with the signature of the PROXY protocol, version 2");
      return false;
    }
    if (bytes.limit() == HEAD_BYTES) {
      require(
          Arrays.equals(bytes.array(), 0, SIGNATURE.length, SIGNATURE, 0, SIGNATURE.length),
          "it doesn't begin with the signature of the PROXY protocol, version 2");
      int command = bytes.get(12);
      require(command == LOCAL || command == PROXY, "version and command=" + command);
      int rest = Short.toUnsignedInt(bytes.getShort(14));
      require(rest <= MOST_REST_BYTES, "length=" + rest + ", limit=" + MOST_REST_BYTES);
      require(command == LOCAL || rest >= leastRest(bytes.get(13)), "length=" + rest);
      bytes.limit(HEAD_BYTES + rest);
    }
    return !bytes.hasRemaining();
  }

  private static int leastRest(int family) {
    require(family == TCP_IPV4 || family == TCP_IPV6, "family=" + family + " is not TCP");
    return family == TCP_IPV4 ? 12 : 36;
  }

  /**
   * Returns where the client is; null if the proxy speaks for itself, as it does to ask whether the
   * server is there. The header must be there as a whole.
   */
  InetSocketAddress client() {
    if (bytes.get(12) == LOCAL) {
      return null;
    }
    boolean isIpv4 = bytes.get(13) == TCP_IPV4;
    byte[] address = Arrays.copyOfRange(bytes.array(), HEAD_BYTES, HEAD_BYTES + (isIpv4 ? 4 : 16));
    int port = Short.toUnsignedInt(bytes.getShort(HEAD_BYTES + 2 * address.length));
    try {
      return new InetSocketAddress(InetAddress.getByAddress(address), port);
    } catch (UnknownHostException e) {
      throw new IllegalStateException(e); // can't happen with 4 or 16 bytes
    }
  }

  private static void require(boolean condition, String otherwise) {
    if (!condition) {
      throw new IllegalArgumentException(otherwise);
    }
  }
}
