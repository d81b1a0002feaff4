package carom.net.seal;

import java.io.IOException;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;

/** The lasting key by which clients know a server: its file and its fingerprint. */
public final class ServerKey {
  private ServerKey() {}

  /**
   * Returns the key in a file, or makes one and writes the file, which only its owner may read.
   *
   * @throws IOException when the file can't be read or written; the message says what to do
   */
  public static ExchangeKey load(Path file) throws IOException {
    return KeyFile.load(
        file,
        ExchangeKey::of,
        () -> KeyFile.random(ExchangeKey.BYTES),
        "server key; restore it from a backup, or delete it and tell the players the new"
            + " fingerprint");
  }

  /**
   * Returns the fingerprint of a public key, 43 letters, digits, {@code -} and {@code _}: the
   * SHA-256 hash of its 32 bytes in Base64.
   */
  public static String fingerprint(byte[] publicKey) {
    try {
      return KeyFile.text(MessageDigest.getInstance("SHA-256").digest(publicKey));
    } catch (NoSuchAlgorithmException e) {
      throw new IllegalStateException("this Java has no SHA-256", e);
    }
  }
}
