package carom.net.protocol;

import carom.text.Texts;
import java.nio.charset.StandardCharsets;
import java.text.Normalizer;
import java.util.Locale;

/** Rule for player names, which appear on the screens of all players and in the operator's log. */
public final class PlayerName {
  /**
   * Largest number of accents and other marks on one character. More would spill over neighbouring
   * characters.
   */
  private static final int MAX_MARKS = 3;

  /**
   * Characters that Unicode classes as letters or symbols, but that leave nothing on the screen.
   */
  private static final String BLANKS = "\u034f\u115f\u1160\u17b4\u17b5\u2800\u3164\uffa0";

  private static final int DOT_ABOVE = 0x307;

  private PlayerName() {}

  /**
   * Returns the form of a name that comparisons use. It is equal for names that look alike except
   * for case, width or the encoding of an accent.
   */
  public static String folded(String name) {
    return Normalizer.normalize(name, Normalizer.Form.NFKC).toLowerCase(Locale.ROOT);
  }

  /**
   * Returns a form of a name that is equal for names that look alike on a screen. Letters of other
   * scripts and small capitals count as the Latin ones that they resemble, and the differences
   * between {@code I}, {@code l} and {@code 1}, {@code O} and {@code 0}, {@code m} and {@code rn}
   * don't count. Nor do marks below letters, and how many spaces are between two words.
   */
  public static String skeleton(String name) {
    StringBuilder skeleton = new StringBuilder();
    Normalizer.normalize(name, Normalizer.Form.NFKD)
        .codePoints()
        .map(Confusables::latin)
        .filter(point -> point != Confusables.NOTHING && !isLostBehind(skeleton, point))
        .forEachOrdered(skeleton::appendCodePoint);
    return skeleton
        .toString()
        .replace('1', 'l')
        .replace('i', 'l')
        .replace('|', 'l')
        .replace('0', 'o')
        .replace("rn", "m")
        .replace("vv", "w");
  }

  /** Returns whether a second space, or the dot of an i that has one, doesn't show. */
  private static boolean isLostBehind(StringBuilder text, int point) {
    char last = text.isEmpty() ? ' ' : text.charAt(text.length() - 1);
    return point == ' ' ? last == ' ' : point == DOT_ABOVE && (last == 'i' || last == 'j');
  }

  /** Returns whether a player could take one name for the other. */
  public static boolean looksLike(String name, String other) {
    return folded(name).equals(folded(other)) || skeleton(name).equals(skeleton(other));
  }

  /**
   * Returns what is wrong with a name, in words for the player, or null when the name is valid. A
   * valid name has 1..{@link ProtocolLimits#MAX_NAME_BYTES} UTF-8 bytes and starts with something
   * visible. It has no control, format, surrogate, line or blank characters and no space except
   * U+0020, which it does not end with. It carries at most {@value #MAX_MARKS} marks (accents) on a
   * character. All that holds for its composed form, too: some marks are two in one.
   */
  public static String problem(String name) {
    String problem = problemAsWritten(name);
    return problem != null
        ? problem
        : problemAsWritten(Normalizer.normalize(name, Normalizer.Form.NFC));
  }

  private static String problemAsWritten(String name) {
    if (name.isEmpty()) {
      return "the name is empty; choose one with 1 to " + ProtocolLimits.MAX_NAME_BYTES + " bytes";
    }
    int bytes = name.getBytes(StandardCharsets.UTF_8).length;
    if (bytes > ProtocolLimits.MAX_NAME_BYTES) {
      return "the name has "
          + bytes
          + " bytes; at most "
          + ProtocolLimits.MAX_NAME_BYTES
          + " are allowed";
    }
    int marks = MAX_MARKS; // no mark may come first
    for (int i = 0; i < name.length(); i += Character.charCount(name.codePointAt(i))) {
      int point = name.codePointAt(i);
      if (isHidden(point)) {
        return String.format(
            Locale.ROOT, "the name has the character U+%04X, which can't be shown", point);
      }
      marks = Texts.isMark(point) ? marks + 1 : 0;
      if (marks > MAX_MARKS) {
        return "the name has an accent with nothing below it, or too many of them on one letter";
      }
    }
    if (!name.equals(name.strip())) {
      return "the name starts or ends with a space";
    }
    return null;
  }

  /**
   * Returns the valid name that is nearest to a text, or "" if nothing of it can be shown. What a
   * name can't have is left out, other spaces become U+0020, and what is too long is cut.
   */
  public static String fitted(String text) {
    StringBuilder shown = new StringBuilder();
    text.codePoints()
        .map(point -> Character.getType(point) == Character.SPACE_SEPARATOR ? ' ' : point)
        .filter(point -> !isHidden(point))
        .forEach(shown::appendCodePoint);
    String composed = Normalizer.normalize(shown, Normalizer.Form.NFC);
    StringBuilder name = new StringBuilder();
    int bytes = 0;
    int marks = MAX_MARKS; // no mark may come first
    for (int i = 0, next; i < composed.length(); i = next) {
      int point = composed.codePointAt(i);
      next = i + Character.charCount(point);
      boolean mark = Texts.isMark(point);
      if ((mark && marks == MAX_MARKS) || (point == ' ' && name.isEmpty())) {
        continue;
      }
      bytes += Character.toString(point).getBytes(StandardCharsets.UTF_8).length;
      if (bytes > ProtocolLimits.MAX_NAME_BYTES) {
        break;
      }
      marks = mark ? marks + 1 : 0;
      name.appendCodePoint(point);
    }
    return name.toString().strip();
  }

  private static boolean isHidden(int point) {
    return Texts.isInvisible(point)
        || (Character.getType(point) == Character.SPACE_SEPARATOR && point != ' ')
        || BLANKS.indexOf(point) >= 0
        || isVariationSelector(point);
  }

  private static boolean isVariationSelector(int point) {
    return point >= 0xfe00 && point <= 0xfe0f || point >= 0xe0100 && point <= 0xe01ef;
  }
}
