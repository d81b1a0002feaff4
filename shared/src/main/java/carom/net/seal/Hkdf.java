package carom.net.seal;

import java.security.GeneralSecurityException;
import java.util.Arrays;
import javax.crypto.Mac;
import javax.crypto.spec.SecretKeySpec;

/** Key derivation of RFC 5869 with SHA-256: makes independent keys from one secret. */
final class Hkdf {
  private static final String HMAC = "HmacSHA256";
  private static final int HASH_BYTES = 32;

  /** Longest output of one {@link #expand}, bytes. */
  static final int MAX_BYTES = 255 * HASH_BYTES;

  private Hkdf() {}

  /**
   * Returns a key of 32 bytes that depends on each bit of the secret.
   *
   * @param salt any bytes, not empty; it need not be secret
   * @param secret any bytes, at least one of them unpredictable
   */
  static byte[] extract(byte[] salt, byte[] secret) {
    return mac(salt).doFinal(secret);
  }

  /**
   * Returns bytes for one use of a key. Different uses get independent bytes.
   *
   * @param key result of {@link #extract}
   * @param use names what the bytes are for
   * @param bytes 1..{@value #MAX_BYTES}
   */
  static byte[] expand(byte[] key, byte[] use, int bytes) {
    if (bytes < 1 || bytes > MAX_BYTES) {
      throw new IllegalArgumentException("bytes=" + bytes + " must be from 1 to " + MAX_BYTES);
    }
    Mac mac = mac(key);
    byte[] out = new byte[bytes];
    byte[] block = {};
    for (int at = 0, number = 1; at < bytes; at += HASH_BYTES, number++) {
      mac.update(block);
      mac.update(use);
      mac.update((byte) number);
      block = mac.doFinal();
      System.arraycopy(block, 0, out, at, Math.min(HASH_BYTES, bytes - at));
    }
    Arrays.fill(block, (byte) 0);
    return out;
  }

  private static Mac mac(byte[] key) {
    try {
      Mac mac = Mac.getInstance(HMAC);
      mac.init(new SecretKeySpec(key, HMAC));
      return mac;
    } catch (GeneralSecurityException e) {
      throw new IllegalStateException("this Java has no " + HMAC, e);
    }
  }
}
