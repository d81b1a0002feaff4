package carom.text;

import java.io.IOException;
import java.nio.charset.CharacterCodingException;
import java.nio.file.AccessDeniedException;
import java.nio.file.DirectoryNotEmptyException;
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
    if (e instanceof CharacterCodingException) {
      return "it isn't text in UTF-8";
    }
    if (e instanceof DirectoryNotEmptyException full) {
      return full.getFile() + " is a folder that isn't empty";
    }
    boolean ofSystem = e instanceof FileSystemException;
    String reason = ofSystem ? ((FileSystemException) e).getReason() : e.getMessage();
    if (reason == null || reason.isBlank()) {
      return "it failed as " + e.getClass().getSimpleName();
    }
    if (reason.equals("Is a directory")) {
      return "it is a folder";
    }
    return ofSystem ? "the system says: " + reason : reason;
  }
}
