package carom.net.protocol;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/**
 * Goal: nobody passes for somebody else by his name. Method: names that people made up for that.
 */
final class PlayerNameTest {

  @Test
  void namesThatLookAlikeAreFound() {
    for (String name :
        List.of(
            "\u0410dmin", // Cyrillic A
            "\u0430dmin", // Cyrillic a
            "ADMIN",
            "Adm\u0131n", // i without a dot
            "AdmIn",
            "Adm1n",
            "Adrnin",
            "\u0391dmi\u03bf".replace("\u03bf", "n"), // Greek alpha
            "\uff21dmin", // full width
            "\ud835\udc00dmin", // mathematical bold
            "Adm\u0456n", // Ukrainian i
            "\u1d00\u1d05\u1d0d\u026a\u0274", // small capitals
            "A\u1e0dmin", // d with a dot below
            "Ad\u0323min", // the same, in two characters
            "\u1ea0d\u0331m\u1ecbn\u0328", // several marks below
            "Adm\u0269\u0272", // iota, n with a hook
            "Admi\u0307n", // an i with two dots, of which one shows
            "Ad\u043cin", // a small Cyrillic m
            "Admi\u03b7", // eta
            "\ud83c\udd50\ud83c\udd53\ud83c\udd5c\ud83c\udd58\ud83c\udd5d", // in black circles
            "\ud83c\udd70\ud83c\udd73\ud83c\udd7c\ud83c\udd78\ud83c\udd7d", // in black squares
            "\ud83c\udde6\ud83c\udde9\ud83c\uddf2\ud83c\uddee\ud83c\uddf3", // letters of flags
            "\u0130DMIN".replace("\u0130", "A"))) {
      assertTrue(PlayerName.looksLike("Admin", name), name);
      assertTrue(PlayerName.looksLike(name, "Admin"), name);
    }
    assertTrue(
        PlayerName.looksLike("\u041d\u0418\u041d\u0410", "\u043d\u0438\u043d\u0430"), "case");
    assertTrue(PlayerName.looksLike("Bob", "B\u03bfb"), "Greek o");
    assertTrue(PlayerName.looksLike("Bob", "B0b"));
    assertTrue(PlayerName.looksLike("Bob", "\u0432o\u0432"), "small Cyrillic v");
    assertTrue(PlayerName.looksLike("Hawk", "\u043da\u0461\u043a"), "small Cyrillic n and k");
    assertTrue(PlayerName.looksLike("Tom", "\u0442\u043e\u043c"), "small Cyrillic t, o and m");
    assertTrue(PlayerName.looksLike("Will", "\u03bd\u03bdi11"), "two nu");
    assertTrue(PlayerName.looksLike("Will", "vviLL"));
    assertTrue(PlayerName.looksLike("The Boss", "The  Boss"), "two spaces");
    assertTrue(PlayerName.looksLike("The Boss", "The \u0323Boss"), "a mark on a space");
  }

  @Test
  void aMarkThatIsTwoInOneCountsAsTwo() {
    assertNull(PlayerName.problem("\u060a\u0335\u0344"));
    assertNotNull(PlayerName.problem("\u060a\u0335\u0347\u0344"));
    assertNotNull(PlayerName.problem("\u0344".repeat(2)));
    assertNotNull(PlayerName.problem("a\u0344".repeat(10)), "30 bytes, and 40 composed");
  }

  @Test
  void differentNamesStayDifferent() {
    List<String> names =
        List.of(
            "Ann",
            "Anna",
            "Zoe",
            "Zo\u00eb",
            "Bob",
            "Rob",
            "\u041d\u0438\u043d\u0430",
            "Nina",
            "\u674e",
            "\u738b",
            "Player 1",
            "Player 2",
            "Player 12",
            "max",
            "mux",
            "Ren\u00e9",
            "Rene",
            "S\u00f8ren",
            "Soren",
            "\u03a3\u03bf\u03c6\u03af\u03b1", // Sofia in Greek
            "Sofia",
            "Nguy\u1ec5n",
            "Ng\u00f4",
            "\u05d3\u05d5\u05d3",
            "\u0645\u062d\u0645\u062f",
            "\u0930\u093e\u092e",
            "\u0930\u092e\u093e",
            "\ud0dc\ud76c",
            "\ud0dc\ud788",
            "\u30cf\u30eb",
            "\u30d0\u30eb", // with a voiced sound mark
            "a-b",
            "ab",
            "a b");
    for (String name : names) {
      for (String other : names) {
        if (!name.equals(other)) {
          assertFalse(PlayerName.looksLike(name, other), name + " " + other);
        }
      }
    }
  }

  @Test
  void anyTextHasASkeletonAndTwoThatDifferInWhatCountsForNothingHaveTheSame() {
    long seed = Long.getLong("carom.seed", System.nanoTime());
    SplittableRandom random = new SplittableRandom(seed);
    for (int i = 0; i < 20_000; i++) {
      StringBuilder name = new StringBuilder();
      for (int length = random.nextInt(12); length > 0; length--) {
        name.append((char) random.nextInt(1 << (random.nextBoolean() ? 16 : 9))); // any half, too
      }
      String skeleton = PlayerName.skeleton(name.toString());
      assertTrue(skeleton.length() <= 18 * name.length(), "seed=" + seed); // NFKD's most, U+FDFA
      String last = name.append('x').toString();
      assertTrue(PlayerName.looksLike(last, last + "\u0323"), "seed=" + seed + " " + last);
      assertTrue(PlayerName.looksLike(last + " y", last + "   Y"), "seed=" + seed + " " + last);
    }
  }
}
