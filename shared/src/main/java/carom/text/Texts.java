package carom.text;

import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;

/** Rule for texts of players, which appear on other players' screens. */
public final class Texts {
  /** Most accents and other marks on one character; more would spill over other lines. */
  private static final int MAX_MARKS = 3;

  private Texts() {}

  /**
   * Returns a text without what can't be shown or would change how its neighbours are shown:
   * control and format characters, line ends, lone surrogates, heaps of accents. Line ends and tabs
   * become spaces.
   */
  public static String clean(String text) {
    StringBuilder clean = null; // made only for texts that aren't clean
    int marks = 0;
    for (int i = 0, next; i < text.length(); i = next) {
      int point = text.codePointAt(i);
      next = i + Character.charCount(point);
      marks = isMark(point) ? marks + 1 : 0;
      boolean space = isLineEnd(point);
      boolean keep = !space && !isHidden(point) && marks <= MAX_MARKS;
      if (!keep && clean == null) {
        clean = new StringBuilder(text.length()).append(text, 0, i);
      }
      if (clean != null && (keep || space)) {
        clean.appendCodePoint(keep ? point : ' ');
      }
    }
    return clean == null ? text : clean.toString();
  }

  /** Returns as much of a text's beginning as fits into some bytes of UTF-8. */
  public static String cut(String text, int maxBytes) {
    String shown = text;
    while (shown.getBytes(StandardCharsets.UTF_8).length > maxBytes) {
      shown = shown.substring(0, shown.offsetByCodePoints(shown.length(), -1));
    }
    return shown;
  }

  /** Returns the text that bytes stand for, or null if they are no UTF-8. */
  public static String ofUtf8(ByteBuffer bytes) {
    try {
      return StandardCharsets.UTF_8.newDecoder().decode(bytes).toString();
    } catch (CharacterCodingException e) {
      return null;
    }
  }

  private static boolean isLineEnd(int point) {
    return point == '\n' || point == '\r' || point == '\t' || point == 0x2028 || point == 0x2029;
  }

  /**
   * Returns whether a character has no shape of its own or none that is known: control and format
   * characters, lone surrogates, private and unassigned ones, separators of lines and paragraphs.
   */
  public static boolean isInvisible(int point) {
    return switch (Character.getType(point)) {
      case Character.CONTROL,
          Character.FORMAT,
          Character.SURROGATE,
          Character.UNASSIGNED,
          Character.PRIVATE_USE,
          Character.LINE_SEPARATOR,
          Character.PARAGRAPH_SEPARATOR ->
          true;
      default -> false;
    };
  }

  private static boolean isHidden(int point) {
    return switch (Character.getType(point)) {
      case Character.CONTROL, Character.FORMAT, Character.SURROGATE, Character.PRIVATE_USE -> true;
      default -> false;
    };
  }

  /** Returns whether a character is an accent or another mark on the character before it. */
  public static boolean isMark(int point) {
    int type = Character.getType(point);
    return type == Character.NON_SPACING_MARK
        || type == Character.ENCLOSING_MARK
        || type == Character.COMBINING_SPACING_MARK;
  }
}
