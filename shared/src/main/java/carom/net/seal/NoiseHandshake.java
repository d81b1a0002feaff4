package carom.net.seal;

import java.nio.charset.StandardCharsets;
import java.security.GeneralSecurityException;
import java.security.MessageDigest;
import java.util.Arrays;

/**
 * One side of a handshake {@code Noise_NK_25519_AESGCM_SHA256}, as "The Noise Protocol Framework",
 * revision 34, defines it. The client knows the server's lasting key beforehand; the server knows
 * nothing of the client. There are two messages:
 *
 * <pre>
 * client                            server
 *    |  -- e, es: new key, tag --&gt;   |
 *    |  &lt;-- e, ee: new key, tag --   |
 * </pre>
 *
 * <p>A message opens only if both sides have heard the same so far, and only the owner of the
 * lasting key opens the first one and answers it. Use it from one thread, each method once, in the
 * order of the messages.
 */
final class NoiseHandshake {
  /** Bytes that a message adds to its payload: a public key, and a tag. */
  static final int EXTRA_BYTES = ExchangeKey.BYTES + LinkCipher.TAG_BYTES;

  private static final byte[] NAME =
      "Noise_NK_25519_AESGCM_SHA256".getBytes(StandardCharsets.US_ASCII);
  private static final byte[] NOTHING = {};

  private final ExchangeKey fresh;
  private byte[] hash = Arrays.copyOf(NAME, LinkCipher.KEY_BYTES);
  private byte[] chain = hash;
  private byte[] key;

  /**
   * Begins a handshake.
   *
   * @param prologue what both sides must know to be the same, in the clear
   * @param serverKey the server's lasting public key
   * @param fresh this side's pair, made for this handshake alone
   */
  NoiseHandshake(byte[] prologue, byte[] serverKey, ExchangeKey fresh) {
    this.fresh = fresh;
    mix(prologue);
    mix(serverKey);
  }

  /** Returns the client's message. */
  byte[] writeFirst(byte[] serverKey, byte[] payload) throws GeneralSecurityException {
    mix(fresh.publicKey());
    mixSecret(fresh.agree(serverKey));
    return message(payload);
  }

  /**
   * Returns the payload of the client's message.
   *
   * @throws GeneralSecurityException when it isn't for this server's key and prologue
   */
  byte[] readFirst(ExchangeKey lasting, byte[] message) throws GeneralSecurityException {
    byte[] theirs = theirs(message);
    mix(theirs);
    mixSecret(lasting.agree(theirs));
    return payload(message);
  }

  /** Returns the server's message, which answers the client's. */
  byte[] writeSecond(byte[] first, byte[] payload) throws GeneralSecurityException {
    mix(fresh.publicKey());
    mixSecret(fresh.agree(theirs(first)));
    return message(payload);
  }

  /**
   * Returns the payload of the server's message.
   *
   * @throws GeneralSecurityException when it isn't from the owner of the lasting key
   */
  byte[] readSecond(byte[] message) throws GeneralSecurityException {
    byte[] theirs = theirs(message);
    mix(theirs);
    mixSecret(fresh.agree(theirs));
    return payload(message);
  }

  /**
   * Returns the two keys that the handshake leads to, one behind the other: that of the client's
   * frames, then that of the server's.
   */
  byte[] split() {
    return derive(NOTHING);
  }

  /** Returns the hash of the whole handshake, after the last message ("channel binding"). */
  byte[] binding() {
    return hash.clone();
  }

  private static byte[] theirs(byte[] message) {
    return Arrays.copyOf(message, ExchangeKey.BYTES);
  }

  private void mix(byte[] data) {
    hash = sha256(hash, data);
  }

  private void mixSecret(byte[] secret) {
    byte[] both = derive(secret);
    Arrays.fill(secret, (byte) 0);
    chain = Arrays.copyOf(both, LinkCipher.KEY_BYTES);
    key = Arrays.copyOfRange(both, LinkCipher.KEY_BYTES, both.length);
  }

  private byte[] derive(byte[] secret) {
    return Hkdf.expand(Hkdf.extract(chain, secret), NOTHING, 2 * LinkCipher.KEY_BYTES);
  }

  private byte[] message(byte[] payload) {
    byte[] frame = new byte[hash.length + payload.length + LinkCipher.TAG_BYTES];
    System.arraycopy(hash, 0, frame, 0, hash.length);
    System.arraycopy(payload, 0, frame, hash.length, payload.length);
    cipher().seal(0, frame, 0, hash.length, payload.length);
    byte[] message = new byte[EXTRA_BYTES + payload.length];
    System.arraycopy(fresh.publicKey(), 0, message, 0, ExchangeKey.BYTES);
    System.arraycopy(
        frame, hash.length, message, ExchangeKey.BYTES, message.length - ExchangeKey.BYTES);
    mix(Arrays.copyOfRange(frame, hash.length, frame.length));
    return message;
  }

  private byte[] payload(byte[] message) throws GeneralSecurityException {
    byte[] sealed = Arrays.copyOfRange(message, ExchangeKey.BYTES, message.length);
    byte[] frame = Arrays.copyOf(hash, hash.length + sealed.length);
    System.arraycopy(sealed, 0, frame, hash.length, sealed.length);
    int length = sealed.length - LinkCipher.TAG_BYTES;
    if (!cipher().open(0, frame, 0, hash.length, length)) {
      throw new GeneralSecurityException("a message of the handshake isn't genuine");
    }
    mix(sealed);
    return Arrays.copyOfRange(frame, hash.length, hash.length + length);
  }

  private LinkCipher cipher() {
    return LinkCipher.of(Encryption.ON, key, 0);
  }

  private static byte[] sha256(byte[] first, byte[] second) {
    try {
      MessageDigest digest = MessageDigest.getInstance("SHA-256");
      digest.update(first);
      return digest.digest(second);
    } catch (GeneralSecurityException e) {
      throw new IllegalStateException("this Java has no SHA-256", e);
    }
  }
}
