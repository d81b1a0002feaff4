package carom.server.command;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.fixtures.AnyText;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** Goal: whatever a text is, a line can say it. Method: random texts, written and read again. */
final class QuotingTest {
  private static List<String> read(String line) {
    return Quoting.words(line).stream().map(Quoting.Word::text).toList();
  }

  @Test
  void anyWordsAreReadAsTheyWereWritten() {
    long seed = Long.getLong("carom.seed", System.nanoTime());
    Random random = new Random(seed);
    for (int i = 0; i < 20_000; i++) {
      List<String> words = new ArrayList<>();
      StringBuilder line = new StringBuilder();
      for (int n = random.nextInt(5); n > 0; n--) {
        String word = AnyText.of(random);
        words.add(word);
        line.append(random.nextBoolean() ? Quoting.quoted(word) : Quoting.shown(word)).append(' ');
      }
      assertEquals(words, read(line.toString()), () -> "seed=" + seed + " line=" + line);
      List<String> begun =
          Quoting.begunWords(line.toString()).stream().map(Quoting.Word::text).toList();
      assertEquals(words, begun, () -> "seed=" + seed + " line=" + line);
    }
  }

  @Test
  void anyLineIsReadOrRefusedAndNothingOfItIsLost() {
    long seed = Long.getLong("carom.seed", System.nanoTime());
    Random random = new Random(seed);
    for (int i = 0; i < 20_000; i++) {
      String line = AnyText.of(random) + AnyText.of(random);
      try {
        List<String> words = read(line);
        StringBuilder again = new StringBuilder();
        words.forEach(word -> again.append(Quoting.quoted(word)).append(' '));
        assertEquals(words, read(again.toString()), () -> "seed=" + seed + " line=" + line);
        int letters = (int) line.chars().filter(Character::isLetter).count();
        int kept =
            words.stream().mapToInt(w -> (int) w.chars().filter(Character::isLetter).count()).sum();
        assertEquals(letters, kept, () -> "seed=" + seed + " line=" + line);
      } catch (IllegalArgumentException e) {
        assertTrue(line.contains("\""), () -> "seed=" + seed + " line=" + line);
      }
    }
  }

  @Test
  void quotesMeanSomethingAtTheBeginOfAWordOnly() {
    assertEquals(List.of("a\"b", "c\"", "d e", "f\"g"), read("a\"b c\" \"d e\" \"f\"\"g\""));
    assertEquals(List.of("C:\\games\\", "", "\""), read("C:\\games\\ \"\" \"\"\"\""));
    assertThrows(IllegalArgumentException.class, () -> read("\"a\"b"));
    assertThrows(IllegalArgumentException.class, () -> read("kick \"Bob"));
  }
}
