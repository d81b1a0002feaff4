package carom.net.field;

import carom.net.protocol.Limits;
import carom.sim.field.Schema;
import java.util.List;

/**
 * How server and client agree on the fields of a game: the server tells the digest and the
 * declarations, and a client whose game has others leaves with a text that names the first
 * difference. Any thread.
 */
public final class FieldAgreement {
  private static final char LAST_ASCII = 0x7e;

  private FieldAgreement() {}

  /**
   * Returns the declarations as they are told: the first {@value Limits#MAX_FIELD_LINES}, each cut
   * to {@value Limits#MAX_FIELD_LINE_BYTES} ASCII characters.
   */
  public static List<String> tell(Schema schema) {
    return schema.lines().stream().limit(Limits.MAX_FIELD_LINES).map(FieldAgreement::cut).toList();
  }

  private static String cut(String line) {
    StringBuilder text = new StringBuilder();
    for (int i = 0; i < Math.min(line.length(), Limits.MAX_FIELD_LINE_BYTES); i++) {
      text.append(line.charAt(i) <= LAST_ASCII ? line.charAt(i) : '?');
    }
    return text.toString();
  }

  /**
   * Returns how the fields of a client's game differ from the server's.
   *
   * @param game the game's name
   * @param digest of the server's fields
   * @param told the server's declarations, as {@link #tell} gives them
   * @return a sentence for the player, or null if the fields are the same
   */
  public static String difference(Schema mine, String game, long digest, List<String> told) {
    if (digest == mine.digest()) {
      return null;
    }
    return describe(tell(mine), told) + "; use the same build of game " + game;
  }

  private static String describe(List<String> mine, List<String> told) {
    for (int i = 0; i < Math.max(mine.size(), told.size()); i++) {
      String here = i < mine.size() ? mine.get(i) : "";
      String there = i < told.size() ? told.get(i) : "";
      if (!here.equals(there)) {
        boolean same = path(here).equals(path(there));
        String field = same || there.isEmpty() ? path(here) : path(there);
        return "field %s differs: server %s, client %s"
            .formatted(field, show(there, same), show(here, same));
      }
    }
    return "the fields differ beyond what the server tells of them";
  }

  /** Returns a declaration in quotes, without its name if both sides have the same. */
  private static String show(String line, boolean named) {
    if (line.isEmpty()) {
      return "none";
    }
    return "\"" + (named ? line.substring(path(line).length()).trim() : line) + "\"";
  }

  private static String path(String line) {
    int end = line.indexOf(' ');
    return end < 0 ? line : line.substring(0, end);
  }
}
