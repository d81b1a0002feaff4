package carom.net.protocol;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
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
            "Adm\u0456n")) { // Ukrainian i
      assertTrue(PlayerName.looksLike("Admin", name), name);
      assertTrue(PlayerName.looksLike(name, "Admin"), name);
    }
    assertTrue(
        PlayerName.looksLike("\u041d\u0418\u041d\u0410", "\u043d\u0438\u043d\u0430"), "case");
    assertTrue(PlayerName.looksLike("Bob", "B\u03bfb"), "Greek o");
    assertTrue(PlayerName.looksLike("Bob", "B0b"));
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
            "mux");
    for (String name : names) {
      for (String other : names) {
        if (!name.equals(other)) {
          assertFalse(PlayerName.looksLike(name, other), name + " " + other);
        }
      }
    }
  }
}
