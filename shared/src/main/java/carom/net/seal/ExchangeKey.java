package carom.net.seal;

import java.security.GeneralSecurityException;
import java.security.KeyFactory;
import java.security.PrivateKey;
import java.security.PublicKey;
import java.security.SecureRandom;
import java.security.spec.NamedParameterSpec;
import java.security.spec.X509EncodedKeySpec;
import java.security.spec.XECPrivateKeySpec;
import java.util.HexFormat;
import javax.crypto.KeyAgreement;

/**
 * A pair of X25519 keys (RFC 7748). Two sides that know each other's public keys compute the same
 * secret, and no third party can. Immutable; any thread may use it. Creating one and agreeing each
 * take about 0.2 ms.
 */
public final class ExchangeKey {
  /** Bytes of a private key, of a public key and of an agreed secret. */
  public static final int BYTES = 32;

  private static final String NAME = "X25519";

  /** Bytes before the 32 bytes of a public key in the JDK's own format (RFC 8410). */
  private static final byte[] ENCODED_HEAD = HexFormat.of().parseHex("302a300506032b656e032100");

  /** The public key of the private key 1: agreeing with it computes a public key. */
  private static final byte[] BASE_POINT = new byte[BYTES];

  private static final SecureRandom RANDOM = new SecureRandom();

  static {
    BASE_POINT[0] = 9;
  }

  private final PrivateKey privateKey;
  private final byte[] publicKey;

  private ExchangeKey(byte[] privateBytes) {
    try {
      privateKey =
          KeyFactory.getInstance(NAME)
              .generatePrivate(new XECPrivateKeySpec(NamedParameterSpec.X25519, privateBytes));
      publicKey = agree(BASE_POINT);
    } catch (GeneralSecurityException e) {
      throw new IllegalStateException("this Java has no " + NAME, e);
    }
  }

  /** Returns a new pair of keys. */
  public static ExchangeKey random() {
    byte[] bytes = new byte[BYTES];
    RANDOM.nextBytes(bytes);
    return new ExchangeKey(bytes);
  }

  /**
   * Returns the pair of a private key.
   *
   * @param privateBytes 32 unpredictable bytes
   * @throws IllegalArgumentException for another number of bytes
   */
  public static ExchangeKey of(byte[] privateBytes) {
    if (privateBytes.length != BYTES) {
      throw new IllegalArgumentException(
          "bytes=" + privateBytes.length + " of a private key must be " + BYTES);
    }
    return new ExchangeKey(privateBytes.clone());
  }

  /** Returns a copy of the public key. */
  public byte[] publicKey() {
    return publicKey.clone();
  }

  /**
   * Returns the secret that this pair shares with the owner of a public key.
   *
   * @param other public key of the other side, 32 bytes
   * @throws GeneralSecurityException for a key with which any secret would be 0, or that is none
   */
  public byte[] agree(byte[] other) throws GeneralSecurityException {
    byte[] encoded = new byte[ENCODED_HEAD.length + BYTES];
    System.arraycopy(ENCODED_HEAD, 0, encoded, 0, ENCODED_HEAD.length);
    System.arraycopy(other, 0, encoded, ENCODED_HEAD.length, BYTES);
    PublicKey key = KeyFactory.getInstance(NAME).generatePublic(new X509EncodedKeySpec(encoded));
    KeyAgreement agreement = KeyAgreement.getInstance(NAME);
    agreement.init(privateKey);
    agreement.doPhase(key, true);
    return agreement.generateSecret();
  }
}
