package carom.net.seal;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.security.GeneralSecurityException;
import java.security.MessageDigest;
import java.util.Arrays;

/**
 * The exchange of keys when a link opens. The client offers a key made for this link. The server
 * answers with a key made for this link and proves that it has the private key of the public one
 * that it is known by. Both derive the link's keys from the two secrets that they now share: that
 * of the two new keys, which makes recordings of the link worthless to somebody who steals the
 * server's key later, and that of the client's new key and the server's lasting one.
 *
 * <pre>
 * client                                    server
 *    |  &lt;-- greeting: link, token, its key -- |
 *    |  -- offer: mode, new key -----------&gt;  |
 *    |  &lt;----------- answer: new key, proof - |
 *    |  == first sealed frame =============&gt;  |
 * </pre>
 *
 * <p>The keys depend on each byte of greeting, offer and answer, so a third party that changes one
 * ends the exchange. The steps take up to 0.6 ms: don't run them on a thread that serves others.
 */
public final class KeyExchange {
  /** Bytes of an offer: the mode, and a public key. */
  public static final int OFFER_BYTES = 1 + ExchangeKey.BYTES;

  /** Bytes of an answer: a public key, and the proof. */
  public static final int ANSWER_BYTES = ExchangeKey.BYTES + LinkKeys.PROOF_BYTES;

  private static final byte[] CONTEXT = "carom link 9".getBytes(StandardCharsets.US_ASCII);

  private KeyExchange() {}

  /** The server's side: the answer, and the keys that it leads to. */
  @SuppressWarnings("ArrayRecordComponent") // The one receiver sends the bytes at once.
  public record Answer(byte[] bytes, LinkKeys keys) {}

  /**
   * Answers an offer.
   *
   * @param key the server's lasting key
   * @param greeting what the server told this client first; it names the link and the key
   * @param link the link's number
   * @param maxFields largest number of bytes in a datagram's fields
   * @throws GeneralSecurityException when the offer's key is none
   */
  public static Answer answer(
      Encryption encryption,
      ExchangeKey key,
      byte[] greeting,
      byte[] offer,
      int link,
      int maxFields)
      throws GeneralSecurityException {
    ExchangeKey fresh = ExchangeKey.random();
    byte[] theirs = Arrays.copyOfRange(offer, 1, OFFER_BYTES);
    byte[] transcript = transcript(greeting, offer, fresh.publicKey());
    byte[] secret = secret(encryption, transcript, theirs, fresh, theirs, key);
    byte[] bytes =
        ByteBuffer.allocate(ANSWER_BYTES)
            .put(fresh.publicKey())
            .put(LinkKeys.proof(secret))
            .array();
    return new Answer(bytes, LinkKeys.derive(encryption, secret, true, link, maxFields));
  }

  /** The client's side of one exchange. */
  public static final class Offer {
    private final Encryption encryption;
    private final ExchangeKey fresh = ExchangeKey.random();
    private final byte[] serverKey;
    private final byte[] greeting;
    private final byte[] bytes;

    /**
     * Makes an offer.
     *
     * @param serverKey the server's public key, which the caller trusts
     * @param greeting what the server told first
     */
    public Offer(Encryption encryption, byte[] serverKey, byte[] greeting) {
      this.encryption = encryption;
      this.serverKey = serverKey.clone();
      this.greeting = greeting.clone();
      bytes =
          ByteBuffer.allocate(OFFER_BYTES).put(encryption.code()).put(fresh.publicKey()).array();
    }

    /** Returns a copy of the offer's bytes. */
    public byte[] bytes() {
      return bytes.clone();
    }

    /**
     * Returns the keys of the link.
     *
     * @param answer the server's answer, {@value #ANSWER_BYTES} bytes
     * @param link the link's number
     * @param maxFields largest number of bytes in a datagram's fields
     * @throws GeneralSecurityException when the answer doesn't prove that the server has its key
     */
    public LinkKeys finish(byte[] answer, int link, int maxFields) throws GeneralSecurityException {
      byte[] theirs = Arrays.copyOf(answer, ExchangeKey.BYTES);
      byte[] transcript = transcript(greeting, bytes, theirs);
      byte[] secret = secret(encryption, transcript, theirs, fresh, serverKey, fresh);
      byte[] proof = Arrays.copyOfRange(answer, ExchangeKey.BYTES, ANSWER_BYTES);
      if (!MessageDigest.isEqual(proof, LinkKeys.proof(secret))) {
        throw new GeneralSecurityException("the server doesn't have the key that it showed");
      }
      return LinkKeys.derive(encryption, secret, false, link, maxFields);
    }
  }

  /** Returns a hash of all that the two sides have told each other. */
  private static byte[] transcript(byte[] greeting, byte[] offer, byte[] answerKey)
      throws GeneralSecurityException {
    MessageDigest hash = MessageDigest.getInstance("SHA-256");
    hash.update(CONTEXT);
    hash.update(ByteBuffer.allocate(Integer.BYTES).putInt(greeting.length).array());
    hash.update(greeting);
    hash.update(offer);
    hash.update(answerKey);
    return hash.digest();
  }

  private static byte[] secret(
      Encryption encryption,
      byte[] transcript,
      byte[] theirs,
      ExchangeKey ours,
      byte[] theirLasting,
      ExchangeKey ourLasting)
      throws GeneralSecurityException {
    byte[] shared = {};
    if (encryption == Encryption.ON) {
      shared = new byte[2 * ExchangeKey.BYTES];
      System.arraycopy(ours.agree(theirs), 0, shared, 0, ExchangeKey.BYTES);
      System.arraycopy(
          ourLasting.agree(theirLasting), 0, shared, ExchangeKey.BYTES, ExchangeKey.BYTES);
    }
    byte[] secret = Hkdf.extract(transcript, shared);
    Arrays.fill(shared, (byte) 0);
    return secret;
  }
}
