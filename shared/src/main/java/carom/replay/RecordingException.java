package carom.replay;

import java.io.IOException;

/** Failure to read or play a recording. */
public final class RecordingException extends IOException {
  private static final long serialVersionUID = 1;

  /**
   * Creates an exception with a message that says what is wrong, where, and what would be right.
   */
  public RecordingException(String message) {
    super(message);
  }
}
