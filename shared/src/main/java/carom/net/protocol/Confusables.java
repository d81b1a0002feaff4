package carom.net.protocol;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.HashMap;
import java.util.Map;

/**
 * Characters that look like a Latin letter or a digit, such as the Cyrillic а, and marks that
 * hardly show, such as a dot below. The table is the part of Unicode's (Technical Standard 39) that
 * leads to a single Latin letter or digit, and small capitals, letters with a tail and marks below
 * beside it. All of Unicode's would be 14 MB of ICU4J, for names that imitate one another within
 * other scripts.
 */
final class Confusables {
  /** Stands for a mark that counts for nothing. */
  static final int NOTHING = -1;

  private static final String FILE = "confusables.txt";
  private static final Map<Integer, Integer> LATIN = read();

  private Confusables() {}

  /**
   * Returns the lower-case letter or the digit that a character looks like, {@link #NOTHING} for a
   * mark that hardly shows, or the character in lower case.
   */
  static int latin(int point) {
    Integer latin = LATIN.get(point);
    return latin != null ? latin : Character.toLowerCase(point);
  }

  private static Map<Integer, Integer> read() {
    Map<Integer, Integer> table = new HashMap<>();
    try (InputStream in = Confusables.class.getResourceAsStream(FILE)) {
      for (String line : new String(in.readAllBytes(), StandardCharsets.UTF_8).split("\n")) {
        String[] words = line.split(" ");
        for (int i = 1; !line.startsWith("#") && i < words.length; i++) {
          int looksLike = words[0].equals("-") ? NOTHING : words[0].charAt(0);
          table.put(Integer.parseInt(words[i], 16), looksLike);
        }
      }
    } catch (IOException e) {
      throw new UncheckedIOException(FILE + " can't be read", e);
    }
    return Map.copyOf(table);
  }
}
