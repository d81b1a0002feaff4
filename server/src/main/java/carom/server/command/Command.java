package carom.server.command;

import java.util.List;

/**
 * A command of the operator. Immutable. A new one is for operators, and the log says who gave it.
 *
 * @param name the word that it begins with
 * @param usage what may follow, such as {@code PLAYER [REASON]}; empty for nothing
 * @param doc what it does, in one line
 * @param least the role that may give it, with those above
 * @param changes whether it may change something, so that the log tells of it
 * @param logged how many of its words the log tells; those behind may be secret
 * @param action carries it out
 * @param completer knows words that may follow
 */
public record Command(
    String name,
    String usage,
    String doc,
    Role least,
    boolean changes,
    int logged,
    Action action,
    Completer completer) {
  /** Carries out a command. Any thread but a room's; it may take seconds. */
  @FunctionalInterface
  public interface Action {
    /**
     * Returns the answer, one or more lines.
     *
     * @throws CommandException when the command can't be carried out; its message says why
     */
    String run(CommandWords words) throws CommandException;
  }

  /** Knows words for a place behind the command. */
  @FunctionalInterface
  public interface Completer {
    /**
     * Returns all words that may stand at a place.
     *
     * @param place 0 for the first word behind the command
     */
    List<String> words(int place);
  }

  /** A completer that knows no word. */
  public static final Completer NONE = place -> List.of();

  /** Creates a command for operators that changes something. */
  public Command(String name, String usage, String doc, Action action, Completer completer) {
    this(name, usage, doc, Role.OPERATOR, true, Integer.MAX_VALUE, action, completer);
  }

  /** Returns this command, for moderators as well. */
  public Command forModerators() {
    return new Command(name, usage, doc, Role.MODERATOR, changes, logged, action, completer);
  }

  /** Returns this command, which only shows something. */
  public Command thatShows() {
    return new Command(name, usage, doc, least, false, logged, action, completer);
  }

  /** Returns this command, of whose words the log tells only the first ones. */
  public Command logging(int words) {
    return new Command(name, usage, doc, least, changes, words, action, completer);
  }

  /** Returns name and usage. */
  String synopsis() {
    return usage.isEmpty() ? name : name + " " + usage;
  }

  /** Returns the line of the log for this command and some words. */
  String line(CommandWords words) {
    StringBuilder line = new StringBuilder(name);
    if (words.room() != null) {
      line.append(" @").append(words.room());
    }
    words.all().stream()
        .limit(logged)
        .forEach(word -> line.append(' ').append(Quoting.shown(word)));
    return line.append(words.count() > logged ? " ..." : "").toString();
  }
}
