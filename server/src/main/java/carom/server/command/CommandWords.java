package carom.server.command;

import java.util.ArrayList;
import java.util.List;

/**
 * The words of a line, by the rule of {@link Quoting}. {@code @NAME} anywhere, not in quotes, names
 * a room.
 *
 * @param all the words behind the command, without the room
 * @param room name of the room, or null if the line names none
 * @param caller who gave the line
 */
public record CommandWords(List<String> all, String room, Caller caller) {
  /** Copies the list. */
  public CommandWords {
    all = List.copyOf(all);
  }

  /**
   * Returns the words of a line, the command's name first.
   *
   * @throws IllegalArgumentException if its quotes are wrong; the message says what to do
   */
  static CommandWords parse(String line, Caller caller) {
    List<String> words = new ArrayList<>();
    String room = null;
    for (Quoting.Word word : Quoting.words(line)) {
      boolean named = !word.quoted() && word.text().length() > 1 && word.text().startsWith("@");
      if (named && !words.isEmpty()) {
        room = word.text().substring(1);
      } else {
        words.add(word.text());
      }
    }
    return new CommandWords(words, room, caller);
  }

  /** Returns the words behind the first. */
  CommandWords behindFirst() {
    return new CommandWords(all.subList(1, all.size()), room, caller);
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

  /** Returns whether the caller may name files anywhere, rather than in folders of their kind. */
  public boolean mayNameAnyFile() {
    return caller.role().includes(Role.CONSOLE);
  }
}
