package carom.server.access;

/** Thrown for a join token that isn't valid. The message is for the player. */
public final class BadTokenException extends Exception {
  private static final long serialVersionUID = 1;

  BadTokenException(String message) {
    super(message, null, false, false);
  }
}
