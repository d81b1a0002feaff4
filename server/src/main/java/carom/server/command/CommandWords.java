package carom.server.command;

import java.util.ArrayList;
import java.util.List;

/**
 * The words of a line. Double quotes hold words together, and {@code @NAME} anywhere names a room.
 *
 * @param all the words behind the command, without the room
 * @param room name of the room, or null if the line names none
 */
public record CommandWords(List<String> all, String room) {
  /** Copies the list. */
  public CommandWords {
    all = List.copyOf(all);
  }

  /** Returns the words of a line, the command's name first. */
  static CommandWords parse(String line) {
    List<String> words = new ArrayList<>();
    String room = null;
    for (String word : split(line)) {
      if (word.length() > 1 && word.startsWith("@") && !words.isEmpty()) {
        room = word.substring(1);
      } else {
        words.add(word);
      }
    }
    return new CommandWords(words, room);
  }

  /** Returns the words of a line; in quotes, also empty ones and those with spaces. */
  public static List<String> split(String line) {
    List<String> words = new ArrayList<>();
    StringBuilder word = new StringBuilder();
    boolean begun = false;
    boolean quoted = false;
    for (char c : line.toCharArray()) {
      if (c == '"') {
        quoted = !quoted;
        begun = true;
      } else if (Character.isWhitespace(c) && !quoted) {
        if (begun) {
          words.add(word.toString());
        }
        word.setLength(0);
        begun = false;
      } else {
        word.append(c);
        begun = true;
      }
    }
    if (begun) {
      words.add(word.toString());
    }
    return words;
  }

  /** Returns the words behind the first. */
  CommandWords behindFirst() {
    return new CommandWords(all.subList(1, all.size()), room);
  }

  /** Returns the number of words. */
  public int count() {
    return all.size();
  }

  /** Returns whether there is a word at a place. */
  public boolean has(int place) {
    return place < all.size();
  }

  /**
   * Returns a word.
   *
   * @param what what it is, such as {@code PLAYER}
   * @throws CommandException when the line is too short
   */
  public String word(int place, String what) throws CommandException {
    if (!has(place)) {
      throw CommandException.ofWords(what + " is missing");
    }
    return all.get(place);
  }

  /** Returns the words from a place on as one text, empty if there are none. */
  public String rest(int place) {
    return has(place) ? String.join(" ", all.subList(place, all.size())) : "";
  }

  /**
   * Checks that no words are left over.
   *
   * @throws CommandException when there are more
   */
  public void requireAtMost(int count) throws CommandException {
    if (all.size() > count) {
      throw CommandException.ofWords("\"" + all.get(count) + "\" is one word too many");
    }
  }
}
