package carom.server.access;

import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HashMap;
import java.util.HexFormat;
import java.util.Map;

/**
 * The join tokens that count no more although they haven't expired, by their SHA-256. Any thread.
 */
final class SpentTokens {
  /** Most tokens that are remembered, about 20 MB. */
  static final int MAX = 100_000;

  private final Map<String, Long> ends = new HashMap<>(); // guarded by itself

  /** Returns whether a token is spent. */
  boolean has(byte[] token) {
    String digest = digest(token);
    synchronized (ends) {
      return ends.containsKey(digest);
    }
  }

  /**
   * Spends a token.
   *
   * @param end when it expires, seconds since 1970; it is forgotten then
   * @param now seconds since 1970
   * @return false if it is spent already, or too many are remembered
   */
  boolean add(byte[] token, long end, long now) {
    String digest = digest(token);
    synchronized (ends) {
      if (ends.size() >= MAX) {
        ends.values().removeIf(other -> other <= now);
      }
      return ends.size() < MAX && ends.putIfAbsent(digest, end) == null;
    }
  }

  private static String digest(byte[] token) {
    try {
      return HexFormat.of().formatHex(MessageDigest.getInstance("SHA-256").digest(token));
    } catch (NoSuchAlgorithmException e) {
      throw new IllegalStateException("every Java has SHA-256", e);
    }
  }
}
