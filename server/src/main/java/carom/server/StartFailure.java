package carom.server;

/**
 * Thrown when a server can't start although its flags are right, for example because a port is
 * taken. The message alone tells the operator what is wrong. The program ends with exit code 1.
 */
final class StartFailure extends Exception {
  private static final long serialVersionUID = 1;

  StartFailure(String message, Throwable cause) {
    super(message, cause);
  }
}
