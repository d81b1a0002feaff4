package carom.replay;

import java.io.IOException;

/** A recording that can't be read or played, and why. */
public final class RecordingException extends IOException {
  private static final long serialVersionUID = 1;

  /** Returns what is wrong, where, and what would be right. */
  public RecordingException(String message) {
    super(message);
  }
}
