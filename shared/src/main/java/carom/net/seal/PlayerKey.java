package carom.net.seal;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.security.GeneralSecurityException;
import java.security.KeyFactory;
import java.security.KeyPair;
import java.security.KeyPairGenerator;
import java.security.PrivateKey;
import java.security.Signature;
import java.security.spec.PKCS8EncodedKeySpec;
import java.security.spec.X509EncodedKeySpec;
import java.util.Arrays;
import java.util.Base64;
import java.util.HexFormat;

/**
 * A key of a player's own (Ed25519, RFC 8032), by which servers know the player again without
 * anybody's register. A proof is good for one link: it signs what the handshake of that link came
 * to, so no server can show it to another.
 *
 * <pre>
 *   key.PUBLIC.SIGNATURE      Base64 for URLs, of 32 and 64 bytes
 *   signed:   "carom player key 1", and the 32 bytes of {@code Link.binding}
 *   account:  key:FINGERPRINT, 43 characters, SHA-256 of PUBLIC
 * </pre>
 *
 * <p>Immutable; any thread.
 */
public final class PlayerKey {
  /** Begins each account that a key proves; no token may claim one. */
  public static final String ACCOUNT = "key:";

  /** Begins each proof, so that it can't be taken for a join token. */
  public static final String PROOF = "key.";

  private static final String ALGORITHM = "Ed25519";
  private static final int BYTES = 32;
  private static final int SIGNATURE_BYTES = 64;
  private static final byte[] CONTEXT = "carom player key 1".getBytes(StandardCharsets.US_ASCII);

  /** Bytes before those of a private and a public key in the JDK's own formats (RFC 8410). */
  private static final byte[] PRIVATE_HEAD =
      HexFormat.of().parseHex("302e020100300506032b657004220420");

  private static final byte[] PUBLIC_HEAD = HexFormat.of().parseHex("302a300506032b6570032100");

  private final PrivateKey secret;
  private final byte[] publicKey;

  /** Creates a key of its private bytes and its public ones behind them. */
  private PlayerKey(byte[] both) {
    if (both.length != 2 * BYTES) {
      throw new IllegalArgumentException("bytes=" + both.length + " of a key, not " + 2 * BYTES);
    }
    try {
      publicKey = Arrays.copyOfRange(both, BYTES, both.length);
      byte[] encoded = joined(PRIVATE_HEAD, Arrays.copyOf(both, BYTES));
      secret = KeyFactory.getInstance(ALGORITHM).generatePrivate(new PKCS8EncodedKeySpec(encoded));
    } catch (GeneralSecurityException e) {
      throw new IllegalArgumentException(e);
    }
  }

  /**
   * Returns the key in a file, or makes one and writes the file, which only its owner may read.
   *
   * @throws IOException when the file can't be read or written; the message says what to do
   */
  public static PlayerKey load(Path file) throws IOException {
    return KeyFile.load(
        file,
        PlayerKey::new,
        PlayerKey::fresh,
        "player's key; restore it from a backup, or delete it and be a stranger again");
  }

  /** Returns a key that no file has. */
  public static PlayerKey random() {
    return new PlayerKey(fresh());
  }

  private static byte[] fresh() {
    try {
      KeyPair pair = KeyPairGenerator.getInstance(ALGORITHM).generateKeyPair();
      byte[] secret = pair.getPrivate().getEncoded();
      byte[] known = pair.getPublic().getEncoded();
      return joined(
          Arrays.copyOfRange(secret, secret.length - BYTES, secret.length),
          Arrays.copyOfRange(known, known.length - BYTES, known.length));
    } catch (GeneralSecurityException e) {
      throw new IllegalStateException("this Java has no " + ALGORITHM, e);
    }
  }

  /** Returns the account that the key proves. */
  public String account() {
    return ACCOUNT + ServerKey.fingerprint(publicKey);
  }

  /**
   * Returns what proves the key on one link, for {@code Hello}.
   *
   * @param binding what the link's handshake came to
   */
  public String proof(byte[] binding) {
    try {
      Signature signature = Signature.getInstance(ALGORITHM);
      signature.initSign(secret);
      signature.update(CONTEXT);
      signature.update(binding);
      return PROOF + KeyFile.text(publicKey) + "." + KeyFile.text(signature.sign());
    } catch (GeneralSecurityException e) {
      throw new IllegalStateException("an own key signs", e);
    }
  }

  /**
   * Returns the account that a proof proves on a link, or null if it proves none there. The text is
   * not trusted.
   *
   * @param binding what the link's handshake came to
   */
  public static String account(String proof, byte[] binding) {
    String[] parts = proof.split("\\.", -1);
    if (parts.length != 3 || !proof.startsWith(PROOF)) {
      return null;
    }
    try {
      byte[] known = Base64.getUrlDecoder().decode(parts[1]);
      byte[] signed = Base64.getUrlDecoder().decode(parts[2]);
      if (known.length != BYTES || signed.length != SIGNATURE_BYTES) {
        return null;
      }
      Signature signature = Signature.getInstance(ALGORITHM);
      signature.initVerify(
          KeyFactory.getInstance(ALGORITHM)
              .generatePublic(new X509EncodedKeySpec(joined(PUBLIC_HEAD, known))));
      signature.update(CONTEXT);
      signature.update(binding);
      return signature.verify(signed) ? ACCOUNT + ServerKey.fingerprint(known) : null;
    } catch (GeneralSecurityException | IllegalArgumentException e) {
      return null;
    }
  }

  private static byte[] joined(byte[] first, byte[] second) {
    return ByteBuffer.allocate(first.length + second.length).put(first).put(second).array();
  }

  /** Leaves the key out. */
  @Override
  public String toString() {
    return account();
  }
}
