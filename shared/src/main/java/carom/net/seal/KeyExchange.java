package carom.net.seal;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.security.GeneralSecurityException;
import java.util.Arrays;

/**
 * The exchange of keys when a link opens: the handshake {@code Noise_NK_25519_AESGCM_SHA256}. The
 * client offers a key made for this link. The server answers with a key made for this link, and so
 * that only the owner of the private key that it is known by can have answered. Recordings of the
 * link are worthless to somebody who steals that key later.
 *
 * <pre>
 * client                                    server
 *    |  &lt;-- greeting: link, token, its key -- |
 *    |  -- offer: mode, new key, tag ------&gt;  |
 *    |  &lt;------------- answer: new key, tag - |
 *    |  == first sealed frame =============&gt;  |
 * </pre>
 *
 * <p>The version of the link, the mode and the greeting are the handshake's prologue, so a third
 * party that changes a byte of them, of offer or answer ends the exchange. The steps take up to 0.6
 * ms: don't run them on a thread that serves others.
 */
public final class KeyExchange {
  /** Bytes of an offer: the mode, and the handshake's first message. */
  public static final int OFFER_BYTES = 1 + NoiseHandshake.EXTRA_BYTES;

  /** Bytes of an answer: the handshake's second message. */
  public static final int ANSWER_BYTES = NoiseHandshake.EXTRA_BYTES;

  private static final byte[] VERSION = "carom link 10".getBytes(StandardCharsets.US_ASCII);
  private static final byte[] NO_PAYLOAD = {};

  private KeyExchange() {}

  /** The server's side: the answer, and the keys that it leads to. */
  @SuppressWarnings("ArrayRecordComponent") // The one receiver sends the bytes at once.
  public record Answer(byte[] bytes, LinkKeys keys) {}

  /**
   * Answers an offer.
   *
   * @param key the server's lasting key
   * @param greeting what the server told this client first; it names the link and the key
   * @param offer the client's offer, {@value #OFFER_BYTES} bytes
   * @param link the link's number
   * @param maxFields largest number of bytes in a datagram's fields
   * @throws GeneralSecurityException when the offer isn't for this key and greeting
   */
  public static Answer answer(
      Encryption encryption,
      ExchangeKey key,
      byte[] greeting,
      byte[] offer,
      int link,
      int maxFields)
      throws GeneralSecurityException {
    byte[] first = Arrays.copyOfRange(offer, 1, OFFER_BYTES);
    NoiseHandshake handshake =
        new NoiseHandshake(prologue(offer[0], greeting), key.publicKey(), ExchangeKey.random());
    handshake.readFirst(key, first);
    byte[] bytes = handshake.writeSecond(first, NO_PAYLOAD);
    return new Answer(
        bytes,
        LinkKeys.of(encryption, handshake.split(), handshake.binding(), true, link, maxFields));
  }

  /** The client's side of one exchange. */
  public static final class Offer {
    private final Encryption encryption;
    private final NoiseHandshake handshake;
    private final byte[] bytes;

    /**
     * Makes an offer.
     *
     * @param serverKey the server's public key, which the caller trusts
     * @param greeting what the server told first
     * @throws GeneralSecurityException when the server's key is none
     */
    public Offer(Encryption encryption, byte[] serverKey, byte[] greeting)
        throws GeneralSecurityException {
      this.encryption = encryption;
      byte mode = encryption.code();
      handshake = new NoiseHandshake(prologue(mode, greeting), serverKey, ExchangeKey.random());
      byte[] first = handshake.writeFirst(serverKey, NO_PAYLOAD);
      bytes = ByteBuffer.allocate(OFFER_BYTES).put(mode).put(first).array();
    }

    /** Returns a copy of the offer's bytes. */
    public byte[] bytes() {
      return bytes.clone();
    }

    /**
     * Returns the keys of the link. Call it once.
     *
     * @param answer the server's answer, {@value #ANSWER_BYTES} bytes
     * @param link the link's number
     * @param maxFields largest number of bytes in a datagram's fields
     * @throws GeneralSecurityException when the answer doesn't prove that the server has its key
     */
    public LinkKeys finish(byte[] answer, int link, int maxFields) throws GeneralSecurityException {
      handshake.readSecond(answer);
      return LinkKeys.of(
          encryption, handshake.split(), handshake.binding(), false, link, maxFields);
    }
  }

  private static byte[] prologue(byte mode, byte[] greeting) {
    return ByteBuffer.allocate(VERSION.length + 1 + greeting.length)
        .put(VERSION)
        .put(mode)
        .put(greeting)
        .array();
  }
}
