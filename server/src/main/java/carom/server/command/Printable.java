package carom.server.command;

import carom.text.Texts;
import java.util.Locale;

/**
 * Makes text from players and files safe for a terminal: escape sequences would move its cursor or
 * change its title, and marks of writing direction would turn a line around.
 */
public final class Printable {
  private Printable() {}

  /**
   * Returns a text in which control, format and other invisible characters are written as {@code
   * U+001B}. Line feeds stay.
   */
  public static String text(String text) {
    StringBuilder safe = new StringBuilder(text.length());
    text.codePoints()
        .forEach(
            point -> {
              if (point == '\n' || !Texts.isInvisible(point)) {
                safe.appendCodePoint(point);
              } else {
                safe.append(String.format(Locale.ROOT, "U+%04X", point));
              }
            });
    return safe.toString();
  }
}
