package carom.server.directory;

import java.io.IOException;

/** Says that a directory didn't answer, or not in time. What was asked may have happened or not. */
public final class DirectoryException extends IOException {
  private static final long serialVersionUID = 1;

  /** Creates an exception with a message for the operator: which directory, what it said. */
  public DirectoryException(String message, Throwable cause) {
    super(message, cause);
  }
}
