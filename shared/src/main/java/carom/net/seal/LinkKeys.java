package carom.net.seal;

import java.util.Arrays;

/**
 * The keys on which the two sides of a link agreed: one for each direction. TCP and UDP share it,
 * and take their nonces from ranges of their own.
 *
 * @param streamOut seals what this side sends by TCP
 * @param streamIn opens what this side receives by TCP
 * @param datagramsOut seals what this side sends by UDP
 * @param datagramsIn opens what this side receives by UDP
 * @param binding hash of the whole handshake, 32 bytes, which no other link has; never changed
 */
@SuppressWarnings("ArrayRecordComponent") // Never compared.
public record LinkKeys(
    StreamSeal streamOut,
    StreamSeal streamIn,
    DatagramSealer datagramsOut,
    DatagramOpener datagramsIn,
    byte[] binding) {

  /** Nonce of the first datagram: beyond each frame of a stream, and room for 48 bits. */
  private static final long DATAGRAMS = 1L << 48;

  /**
   * Returns the keys of one side.
   *
   * @param keys result of {@link NoiseHandshake#split}; wiped
   * @param binding of {@link NoiseHandshake#binding}
   * @param link the link's number
   * @param maxFields largest number of bytes in a datagram's fields
   */
  static LinkKeys of(
      Encryption encryption, byte[] keys, byte[] binding, boolean server, int link, int maxFields) {
    byte[] client = Arrays.copyOf(keys, LinkCipher.KEY_BYTES);
    byte[] servers = Arrays.copyOfRange(keys, LinkCipher.KEY_BYTES, keys.length);
    byte[] out = server ? servers : client;
    byte[] in = server ? client : servers;
    LinkKeys both =
        new LinkKeys(
            new StreamSeal(LinkCipher.of(encryption, out, 0), 0),
            new StreamSeal(LinkCipher.of(encryption, in, 0), 0),
            new DatagramSealer(LinkCipher.of(encryption, out, DATAGRAMS), link, maxFields, 0),
            new DatagramOpener(LinkCipher.of(encryption, in, DATAGRAMS), link),
            binding);
    for (byte[] used : new byte[][] {keys, client, servers}) {
      Arrays.fill(used, (byte) 0);
    }
    return both;
  }
}
