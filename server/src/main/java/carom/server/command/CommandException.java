package carom.server.command;

/** Failure of a command. The message tells the operator what is wrong and what to do. */
public final class CommandException extends Exception {
  private static final long serialVersionUID = 1;

  /** Creates a failure. */
  public CommandException(String message) {
    super(message);
  }
}
