package carom.server.command;

/** Failure of a command. The message tells the operator what is wrong and what to do. */
public final class CommandException extends Exception {
  private static final long serialVersionUID = 1;

  private final boolean ofWords;

  /** Creates a failure of a line that is understood. */
  public CommandException(String message) {
    this(message, false);
  }

  private CommandException(String message, boolean ofWords) {
    super(message);
    this.ofWords = ofWords;
  }

  /** Returns a failure of a line with too few or too many words; the answer shows the usage. */
  static CommandException ofWords(String message) {
    return new CommandException(message, true);
  }

  /** Returns whether the number of words is wrong. */
  boolean isOfWords() {
    return ofWords;
  }
}
