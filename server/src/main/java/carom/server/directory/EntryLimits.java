package carom.server.directory;

import static java.nio.charset.StandardCharsets.UTF_8;

/** Checks what callers hand to a directory, before anything is sent. */
final class EntryLimits {
  private static final int MIN_TTL_MS = 1_000;
  private static final int MAX_TTL_MS = 600_000;

  private EntryLimits() {}

  static void checkTtl(int ttlMs) {
    require(
        ttlMs >= MIN_TTL_MS && ttlMs <= MAX_TTL_MS,
        "ttlMs=" + ttlMs + " isn't in " + MIN_TTL_MS + ".." + MAX_TTL_MS);
  }

  static void checkKey(String key) {
    require(!key.isEmpty(), "a key has one character at least");
    checkPrefix(key);
  }

  static void checkPrefix(String prefix) {
    require(
        prefix.length() <= Directory.MAX_KEY_CHARS,
        "a key of " + prefix.length() + " characters; at most " + Directory.MAX_KEY_CHARS);
    checkText("key", prefix, prefix.getBytes(UTF_8));
  }

  static void checkValue(String value) {
    byte[] bytes = value.getBytes(UTF_8);
    require(
        bytes.length <= Directory.MAX_VALUE_BYTES,
        "a value of " + bytes.length + " bytes; at most " + Directory.MAX_VALUE_BYTES);
    checkText("value", value, bytes);
  }

  /** Refuses what PostgreSQL or UTF-8 can't hold. */
  private static void checkText(String what, String text, byte[] bytes) {
    require(text.indexOf('\0') < 0, "a " + what + " with the character U+0000");
    require(
        new String(bytes, UTF_8).equals(text),
        "a " + what + " with half a surrogate pair: no UTF-8");
  }

  private static void require(boolean holds, String message) {
    if (!holds) {
      throw new IllegalArgumentException(message);
    }
  }
}
