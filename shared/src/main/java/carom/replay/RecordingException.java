package carom.replay;

import java.io.IOException;

/** Failure to read or play a recording. */
public final class RecordingException extends IOException {
  private static final long serialVersionUID = 1;

  /** Creates an exception. Its message names the fault, its place, and the valid values. */
  public RecordingException(String message) {
    super(message);
  }
}
