package carom.physics.archive;

/** Failure to read bytes as a state. The message says what is wrong, and at which byte. */
public final class ArchiveException extends IllegalArgumentException {
  private static final long serialVersionUID = 1;

  /**
   * Creates an exception.
   *
   * @param message what is wrong
   */
  public ArchiveException(String message) {
    super(message);
  }
}
