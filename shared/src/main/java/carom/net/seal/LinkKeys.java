package carom.net.seal;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;

/**
 * The keys on which the two sides of a link agreed: one for each direction of TCP and of UDP, and
 * the server's proof. No key serves two purposes.
 *
 * @param streamOut seals what this side sends by TCP
 * @param streamIn opens what this side receives by TCP
 * @param datagramsOut seals what this side sends by UDP
 * @param datagramsIn opens what this side receives by UDP
 */
public record LinkKeys(
    StreamSeal streamOut,
    StreamSeal streamIn,
    DatagramSealer datagramsOut,
    DatagramOpener datagramsIn) {

  /** Bytes of the proof that the server has the private keys. */
  static final int PROOF_BYTES = 32;

  /**
   * Returns the keys of one side.
   *
   * @param secret result of {@link Hkdf#extract}
   * @param link the link's number
   * @param maxFields largest number of bytes in a datagram's fields
   */
  static LinkKeys derive(
      Encryption encryption, byte[] secret, boolean server, int link, int maxFields) {
    String out = server ? "server" : "client";
    String in = server ? "client" : "server";
    return new LinkKeys(
        new StreamSeal(seal(encryption, secret, out + " stream"), 0),
        new StreamSeal(seal(encryption, secret, in + " stream"), 0),
        new DatagramSealer(seal(encryption, secret, out + " datagrams"), link, maxFields, 0),
        new DatagramOpener(seal(encryption, secret, in + " datagrams"), link));
  }

  private static LinkCipher seal(Encryption encryption, byte[] secret, String use) {
    byte[] material = expand(secret, use, LinkCipher.KEY_BYTES);
    LinkCipher seal = LinkCipher.of(encryption, material);
    Arrays.fill(material, (byte) 0);
    return seal;
  }

  /** Returns the proof that the server computed the same secret. */
  static byte[] proof(byte[] secret) {
    return expand(secret, "server proof", PROOF_BYTES);
  }

  private static byte[] expand(byte[] secret, String use, int bytes) {
    return Hkdf.expand(secret, use.getBytes(StandardCharsets.US_ASCII), bytes);
  }
}
