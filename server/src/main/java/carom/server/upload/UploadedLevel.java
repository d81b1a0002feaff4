package carom.server.upload;

import carom.net.protocol.PlayerName;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * A level that a player has sent. Immutable.
 *
 * @param hash SHA-256 of the file in hexadecimal digits, by which it is kept
 * @param name the level's own name, which looks like that of no other
 * @param game name of the game that it is made for
 * @param size of the file in bytes
 * @param since seconds since 1970 at which it came
 * @param account whose it is
 * @param author name of that player, as it was then
 */
public record UploadedLevel(
    String hash, String name, String game, int size, long since, String account, String author) {
  private static final String TAB = "\t";
  private static final Pattern LINE =
      Pattern.compile(
          "([0-9a-f]{64})\t(\\d{1,9})\t(\\d{1,12})\t([^\t]+)\t([^\t]+)\t([^\t]+)\t([^\t]+)");

  /** Begins the name of a level of a player where other levels have names, too. */
  public static final String PREFIX = "uploads/";

  /** Characters that names of rotations, commands and files have for themselves. */
  private static final String RESERVED = ",:;/\\\"@\t";

  /** Returns the name by which rotations and commands find it. */
  public String title() {
    return PREFIX + name;
  }

  /** Returns why a level can't have a name, or null if it can. */
  static String problemOf(String name) {
    for (int i = 0; i < name.length(); i++) {
      if (RESERVED.indexOf(name.charAt(i)) >= 0) {
        return "its \"name\" has '%s'; leave that out".formatted(name.charAt(i));
      }
    }
    String problem = PlayerName.problem(name);
    return problem == null ? null : "its \"name\" can't be used: " + problem;
  }

  /** Returns the line of the index for this level. */
  String line() {
    return String.join(
        TAB, hash, Integer.toString(size), Long.toString(since), game, account, author, name);
  }

  /** Returns the level of a line, or null if it is none. */
  static UploadedLevel parse(String line) {
    Matcher parts = LINE.matcher(line);
    if (!parts.matches() || problemOf(parts.group(7)) != null) {
      return null;
    }
    return new UploadedLevel(
        parts.group(1),
        parts.group(7),
        parts.group(4),
        Integer.parseInt(parts.group(2)),
        Long.parseLong(parts.group(3)),
        parts.group(5),
        parts.group(6));
  }
}
