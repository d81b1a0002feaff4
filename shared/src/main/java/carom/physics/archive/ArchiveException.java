package carom.physics.archive;

/** Bytes that are no state: what is wrong with them, and at which byte. */
public final class ArchiveException extends IllegalArgumentException {
  private static final long serialVersionUID = 1;

  /**
   * Makes one.
   *
   * @param message what is wrong
   */
  public ArchiveException(String message) {
    super(message);
  }
}
