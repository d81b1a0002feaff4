package carom.server.access;

import java.io.IOException;
import java.util.Map;

/**
 * A list of {@link AccessLists} as lines, so that it can be kept the same on several servers. Each
 * line is about one subject: an address, a name or an account. Any thread.
 */
public interface SharedList {

  /** Returns the list's name, such as {@code bans}. */
  String name();

  /** Returns the lines by their subjects, as the file had them when it was read last. */
  Map<String, String> lines();

  /**
   * Returns the subject of a line.
   *
   * @throws IllegalArgumentException if the line is none of this list
   */
  String subjectOf(String line);

  /**
   * Puts lines into the list, and takes others out of it.
   *
   * @param lines by subject; null takes the subject's line out
   * @throws IOException if the file can't be written; the message says what to do
   */
  void change(Map<String, String> lines) throws IOException;
}
