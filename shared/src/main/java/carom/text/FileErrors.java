package carom.text;

import java.io.IOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.FileSystemException;
import java.nio.file.NoSuchFileException;
import java.nio.file.NotDirectoryException;

/** Words for what the system says about files, as its exceptions name classes. */
public final class FileErrors {
  private FileErrors() {}

  /** Returns why a file can't be read or written, to stand in brackets or behind a colon. */
  public static String reason(IOException e) {
    if (e instanceof AccessDeniedException) {
      return "the user " + System.getProperty("user.name") + " may not";
    }
    if (e instanceof NoSuchFileException missing) {
      return "there is no " + missing.getFile();
    }
    if (e instanceof NotDirectoryException || e instanceof FileAlreadyExistsException) {
      return ((FileSystemException) e).getFile() + " is in the way";
    }
    String reason = e instanceof FileSystemException file ? file.getReason() : e.getMessage();
    return reason == null || reason.isBlank() ? e.getClass().getSimpleName() : reason;
  }
}
