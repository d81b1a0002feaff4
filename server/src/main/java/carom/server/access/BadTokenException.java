package carom.server.access;

/** A join token that lets nobody in. The message is for the player. */
public final class BadTokenException extends Exception {
  private static final long serialVersionUID = 1;

  BadTokenException(String message) {
    super(message, null, false, false);
  }
}
