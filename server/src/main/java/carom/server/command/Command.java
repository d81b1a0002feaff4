package carom.server.command;

import java.util.List;

/**
 * A command of the operator. Immutable.
 *
 * @param name the word that it begins with
 * @param usage what may follow, such as {@code PLAYER [REASON]}; empty for nothing
 * @param doc what it does, in one line
 * @param action carries it out
 * @param completer knows words that may follow
 */
public record Command(String name, String usage, String doc, Action action, Completer completer) {
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

  /** Returns name and usage. */
  String synopsis() {
    return usage.isEmpty() ? name : name + " " + usage;
  }
}
