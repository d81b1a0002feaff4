package carom.net.protocol;

import java.nio.charset.StandardCharsets;

/**
 * The rule for player names: what everybody may be shown on their screens and in the operator's
 * log.
 */
public final class PlayerName {

  private PlayerName() {}

  /**
   * What is wrong with a name, in words for the player, or null when the name is fine. A name is
   * 1..{@link Limits#MAX_NAME_BYTES} UTF-8 bytes, has no control, format, surrogate or line
   * characters, and neither starts nor ends with white space.
   */
  public static String problem(String name) {
    if (name.isEmpty()) {
      return "the name is empty; choose one with 1 to " + Limits.MAX_NAME_BYTES + " bytes";
    }
    int bytes = name.getBytes(StandardCharsets.UTF_8).length;
    if (bytes > Limits.MAX_NAME_BYTES) {
      return "the name has " + bytes + " bytes; at most " + Limits.MAX_NAME_BYTES + " are allowed";
    }
    for (int i = 0; i < name.length(); i += Character.charCount(name.codePointAt(i))) {
      int point = name.codePointAt(i);
      int type = Character.getType(point);
      if (type == Character.CONTROL
          || type == Character.FORMAT
          || type == Character.SURROGATE
          || type == Character.UNASSIGNED
          || type == Character.PRIVATE_USE
          || type == Character.LINE_SEPARATOR
          || type == Character.PARAGRAPH_SEPARATOR) {
        return String.format("the name has the character U+%04X, which can't be shown", point);
      }
    }
    if (!name.equals(name.strip())) {
      return "the name starts or ends with a space";
    }
    return null;
  }
}
