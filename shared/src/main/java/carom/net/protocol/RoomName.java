package carom.net.protocol;

import java.nio.charset.StandardCharsets;
import java.util.Locale;
import java.util.Map;
import java.util.regex.Pattern;

/**
 * Rules for names and metadata of rooms, and for names of parties. Names go into logs, commands and
 * file names, so they are plain; values of metadata are for people, too.
 */
public final class RoomName {
  private static final Pattern PLAIN = Pattern.compile("[A-Za-z0-9][A-Za-z0-9._-]*");

  private RoomName() {}

  /** Returns what is wrong with the name of a room, as {@code name=value} and the rule, or null. */
  public static String problem(String name) {
    return plainProblem("name", name, ProtocolLimits.MAX_ROOM_NAME_BYTES);
  }

  /** Returns what is wrong with the name of a party, as {@link #problem}, or null. */
  public static String partyProblem(String name) {
    return plainProblem("party", name, ProtocolLimits.MAX_PARTY_NAME_BYTES);
  }

  /**
   * Returns what is wrong with metadata, or null. There are at most {@value
   * ProtocolLimits#MAX_ROOM_METADATA} entries with plain keys, and values of 1 to {@value
   * ProtocolLimits#MAX_METADATA_VALUE_BYTES} bytes that can be shown in a line.
   */
  public static String metadataProblem(Map<String, String> metadata) {
    if (metadata.size() > ProtocolLimits.MAX_ROOM_METADATA) {
      return "metadata has entries="
          + metadata.size()
          + ", limit="
          + ProtocolLimits.MAX_ROOM_METADATA;
    }
    for (Map.Entry<String, String> entry : metadata.entrySet()) {
      String problem = plainProblem("key", entry.getKey(), ProtocolLimits.MAX_METADATA_KEY_BYTES);
      if (problem == null && !isLine(entry.getValue())) {
        problem =
            entry.getKey()
                + "="
                + entry.getValue()
                + " must have 1.."
                + ProtocolLimits.MAX_METADATA_VALUE_BYTES
                + " bytes and no control character";
      }
      if (problem != null) {
        return problem;
      }
    }
    return null;
  }

  private static String plainProblem(String what, String text, int maxBytes) {
    if (text.length() <= maxBytes && PLAIN.matcher(text).matches()) {
      return null;
    }
    return String.format(
        Locale.ROOT,
        "%s=%s must be 1..%d letters, digits, dots, dashes and underlines, and begin with a letter"
            + " or a digit",
        what,
        text,
        maxBytes);
  }

  private static boolean isLine(String text) {
    int bytes = text.getBytes(StandardCharsets.UTF_8).length;
    return bytes >= 1
        && bytes <= ProtocolLimits.MAX_METADATA_VALUE_BYTES
        && !text.isBlank()
        && text.codePoints().noneMatch(Character::isISOControl);
  }
}
