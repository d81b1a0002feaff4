package carom.server;

/**
 * Thrown when a server can't start although its flags are right: a port is taken, a file can't be
 * written. The message says all; the program ends with exit code 1.
 */
final class StartFailure extends Exception {
  private static final long serialVersionUID = 1;

  StartFailure(String message, Throwable cause) {
    super(message, cause);
  }
}
