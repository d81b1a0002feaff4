package carom.server.command;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.List;

/**
 * The files that a line may name: any at the server's console, and those inside the folders of
 * their kind for everybody else. No link leads out of the folders.
 */
final class NamedFiles {
  private NamedFiles() {}

  /**
   * Returns the file that a word names. Callers that may not name any file may give it as the
   * console would, or as it is called in one of the folders.
   *
   * @param what what the word is, such as {@code FILE}
   * @param folders folders of files of this kind
   * @throws CommandException if it is missing, can't be a file, or is outside the folders
   */
  static Path file(CommandWords words, int place, String what, List<Path> folders)
      throws CommandException {
    String text = words.word(place, what);
    try {
      Path named = Path.of(text);
      if (words.mayNameAnyFile()) {
        return named;
      }
      for (Path folder : folders) {
        for (Path file : List.of(named.toAbsolutePath(), folder.toAbsolutePath().resolve(named))) {
          if (isInside(folder.toAbsolutePath().normalize(), file.normalize())) {
            return file.normalize();
          }
        }
      }
    } catch (InvalidPathException e) {
      throw new CommandException(what + "=" + text + " can't be the name of a file");
    }
    throw new CommandException(
        "%s=%s isn't inside %s; only the server's console names other files"
            .formatted(
                what, text, String.join(", ", folders.stream().map(Path::toString).toList())));
  }

  /** Returns whether a file, or the place where it would be, really is in a folder or below. */
  private static boolean isInside(Path folder, Path file) {
    if (!file.startsWith(folder)) {
      return false;
    }
    try {
      Path there = file;
      while (!Files.exists(there) && !Files.isSymbolicLink(there) && !there.equals(folder)) {
        there = there.getParent();
      }
      return !Files.exists(folder) || there.toRealPath().startsWith(folder.toRealPath());
    } catch (IOException e) {
      return false; // a link to nowhere, or a folder that can't be read
    }
  }
}
